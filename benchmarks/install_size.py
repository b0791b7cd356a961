"""MB that a core install takes in a new virtual environment: ``python benchmarks/install_size.py``."""

import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).parents[1]


def size(folder: Path) -> float:
    return sum(path.lstat().st_size for path in folder.rglob("*")) / 1e6


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.executable, "-m", "venv", folder], check=True)
        subprocess.run([Path(folder, "bin/python"), "-m", "pip", "install", "--quiet", ROOT], check=True)
        packages = next(Path(folder).glob("lib/python*/site-packages"))
        for path in sorted(packages.iterdir(), key=size, reverse=True)[:8]:
            print(f"{size(path):8.1f} MB  {path.name}")
        print(f"{size(Path(folder)):8.1f} MB  in all, with pip")

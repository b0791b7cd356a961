"""Build and installation of the package in `third_party`, without an index or a build tool."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

SOURCE = Path(__file__).parent / "third_party"


def installed(folder: Path) -> Path:
    """Build and install the package by pip below `folder`, and return the directory to add to the path."""
    source, target = folder / "source", folder / "site"
    shutil.copytree(SOURCE, source)
    options = ["--no-index", "--no-deps", "--no-build-isolation", "--quiet", "--disable-pip-version-check"]
    command = [sys.executable, "-m", "pip", "install", *options, "--target", str(target), str(source)]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=120)
    assert done.returncode == 0, done.stderr
    return target


def environment(target: Path) -> dict[str, str]:
    """Return the environment variables of a process in which the package is installed."""
    before = os.environ.get("PYTHONPATH", "")
    return {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, (str(target), before)))}

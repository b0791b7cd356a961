"""Minimal build backend (PEP 517) that packs the contents named in pyproject.toml into a wheel."""

import tomllib
from pathlib import Path
from zipfile import ZipFile


def build_wheel(folder: str, config_settings: object = None, metadata_directory: object = None) -> str:
    """Pack the wheel of the project in the current directory into `folder`, and return its name."""
    del config_settings, metadata_directory
    project = tomllib.loads(Path("pyproject.toml").read_text())["project"]
    stem = f"{project['name'].replace('-', '_')}-{project['version']}"
    points = ""
    for group, held in project["entry-points"].items():
        points += f"[{group}]\n" + "".join(f"{name} = {module}\n" for name, module in held.items())
    info = {
        "METADATA": f"Metadata-Version: 2.1\nName: {project['name']}\nVersion: {project['version']}\n",
        "WHEEL": "Wheel-Version: 1.0\nGenerator: backend\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
        "entry_points.txt": points,
    }
    files = {str(path): path.read_text() for path in sorted(Path("sledges").glob("*.py"))}
    files |= {f"{stem}.dist-info/{name}": text for name, text in info.items()}
    record = f"{stem}.dist-info/RECORD"
    files[record] = "".join(f"{name},,\n" for name in (*files, record))
    name = f"{stem}-py3-none-any.whl"
    with ZipFile(Path(folder) / name, "w") as wheel:
        for path, text in files.items():
            wheel.writestr(path, text)
    return name

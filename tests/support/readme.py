"""Run the commands that a Markdown file shows, in order, in one new folder: ``python readme.py README.md``.

A command is a line that begins with ``$ `` inside a block fenced as ``console``; what follows it is output.
Lines of set-up (pip, git, make, cd) are left out: whoever runs this has done them.
"""

import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

SET_UP = ("pip", "git", "make", "cd", "python3 -m venv", "source")


def commands(text: str) -> Iterator[str]:
    """The commands of `text` in order."""
    inside = False
    for line in text.splitlines():
        if line.startswith("```"):
            inside = line == "```console"
        elif inside and line.startswith("$ ") and not line[2:].startswith(SET_UP):
            yield line[2:]


def main(path: str) -> int:
    """Run them; the exit code of the first that fails, or 0."""
    environ = os.environ | {"PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"}
    with tempfile.TemporaryDirectory() as folder:
        for command in commands(Path(path).read_text(encoding="utf-8")):
            sys.stdout.write(f"$ {command}\n")
            sys.stdout.flush()
            code = subprocess.run(command, shell=True, cwd=folder, env=environ, check=False).returncode
            if code:
                sys.stdout.write(f"{path}: this command failed with exit code {code}: {command}\n")
                return code
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))

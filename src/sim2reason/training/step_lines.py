"""Log of a run: one JSON line per step, synced to disk before the next begins."""

import json
import os
from pathlib import Path

from sim2reason.base.atomic_files import put_text

__all__ = ["StepLines"]


class StepLines:
    """The lines of a log file."""

    def __init__(self, path: Path) -> None:
        """Store the path in the folder of the run, which need not exist."""
        self.path = path

    def rewind(self, step: int) -> None:
        """Remove from the log the lines after a step, and an incomplete line."""
        kept = [line for line in self.read() if json.loads(line)["step"] <= step]
        self.path.parent.mkdir(parents=True, exist_ok=True)
        put_text(self.path, "".join(f"{line}\n" for line in kept), self.path.parent)

    def add(self, line: str) -> None:
        """Write a line and sync it to disk."""
        with self.path.open("a", encoding="utf-8", newline="\n") as file:
            file.write(f"{line}\n")
            file.flush()
            os.fsync(file.fileno())

    def read(self) -> list[str]:
        """Return the complete lines so far."""
        whole = self.path.read_bytes().split(b"\n")[:-1] if self.path.is_file() else []
        return [line.decode() for line in whole]

"""A log of a run: one line of JSON with its step, on disk before the next begins."""

import json
import os
from pathlib import Path

from sim2reason.base.atomic_files import put_text

__all__ = ["StepLines"]


class StepLines:
    """The lines of one file."""

    def __init__(self, path: Path) -> None:
        """In the folder of the run, which need not be there yet."""
        self.path = path

    def rewind(self, step: int) -> None:
        """Forget what came after a step, and a line that a kill cut: the run goes on from there."""
        kept = [line for line in self.read() if json.loads(line)["step"] <= step]
        self.path.parent.mkdir(parents=True, exist_ok=True)
        put_text(self.path, "".join(f"{line}\n" for line in kept), self.path.parent)

    def add(self, line: str) -> None:
        """Write one; it is on disk when this returns."""
        with self.path.open("a", encoding="utf-8", newline="\n") as file:
            file.write(f"{line}\n")
            file.flush()
            os.fsync(file.fileno())

    def read(self) -> list[str]:
        """Return the whole lines so far."""
        whole = self.path.read_bytes().split(b"\n")[:-1] if self.path.is_file() else []
        return [line.decode() for line in whole]

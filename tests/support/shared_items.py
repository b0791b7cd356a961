"""Numeric items shared by several tests, made once by the first process that needs them."""

import fcntl
from collections.abc import Mapping
from pathlib import Path

from sim2reason.generation.item import Item
from sim2reason.generation.make import make
from sim2reason.generation.request import Request

SEED = 77
NONE = "null"
Cell = tuple[str, str]
"""A recipe and a difficulty."""


class SharedItems:
    """First items of each cell, in a folder that all processes of a test run share."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        folder.mkdir(exist_ok=True)

    def of(self, cell: Cell, count: int) -> list[Item]:
        """Return the first `count` items of a cell, except those for which no draw passes the filters."""
        found = self._first(cell, count, wait=True)
        assert found is not None
        return found

    def of_all(self, counts: Mapping[Cell, int]) -> list[Item]:
        """Return the first items of each cell; those that another process is making are awaited, not made again."""
        found = dict[Cell, list[Item]]()
        for wait in (False, True):
            for cell, count in counts.items():
                if cell not in found and (held := self._first(cell, count, wait=wait)) is not None:
                    found[cell] = held
        return [item for cell in counts for item in found[cell]]

    def _first(self, cell: Cell, count: int, *, wait: bool) -> list[Item] | None:
        """Return the first items of a cell, or None if `wait` is false and another process is making them."""
        with (self.folder / "-".join(cell)).open("a+", encoding="utf-8") as file:
            try:
                fcntl.flock(file, fcntl.LOCK_EX | (0 if wait else fcntl.LOCK_NB))  # until it is closed
            except BlockingIOError:
                return None
            file.seek(0)
            lines = file.read().splitlines()
            for index in range(len(lines), count):
                item = make(Request(*cell, "numeric", SEED, index)).item
                lines.append(NONE if item is None else item.model_dump_json())
                file.write(f"{lines[-1]}\n")
            file.flush()
        return [Item.model_validate_json(line) for line in lines[:count] if line != NONE]

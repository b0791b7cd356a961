"""Numeric items that several tests look at, made once for all of them by whichever process comes first."""

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
    """The first items of each cell, in a folder that all processes of a run share."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        folder.mkdir(exist_ok=True)

    def of(self, cell: Cell, count: int) -> list[Item]:
        """The first so many of a cell, without those of which no draw passes the filters."""
        found = self._first(cell, count, wait=True)
        assert found is not None
        return found

    def of_all(self, counts: Mapping[Cell, int]) -> list[Item]:
        """The first so many of each cell; those that another process makes meanwhile are not made again."""
        found = dict[Cell, list[Item]]()
        for wait in (False, True):
            for cell, count in counts.items():
                if cell not in found and (held := self._first(cell, count, wait=wait)) is not None:
                    found[cell] = held
        return [item for cell in counts for item in found[cell]]

    def _first(self, cell: Cell, count: int, *, wait: bool) -> list[Item] | None:
        """None if nobody shall wait, and another process is at this cell."""
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

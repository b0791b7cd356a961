"""Exports: datasets in the formats of libraries for training and evaluation."""

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, ClassVar, NamedTuple, TypeVar

from sim2reason.base.registry import Registry
from sim2reason.generation.item import Item

FILES = Path(__file__).parent / "files"
Row = Mapping[str, Any]
Column = type[str] | type[int] | type[float] | list["Column"] | dict[str, "Column"]
"""What a column of a Parquet file holds: a plain type, a list of one, or a record of several."""


class RowPosition(NamedTuple):
    """The place of a row in an export: its split, and the number of rows before it in that split's file."""

    split: str
    number: int


class Export(ABC):
    """A format in which a library for training or evaluation reads problems.

    The output folder contains a file of rows for each split, and a copy of all files in `files`: Python unchanged,
    other texts with ``{training}`` and ``{split}`` (the splits for training and evaluation), ``{splits}`` (a list of
    all with their rows), ``{license}`` (of the data), ``{repository}`` (the pip requirement of this library) and
    ``{source}`` filled in.

    Class data:
        name: under which it is registered.
        also: what else it may be looked for by.
        data: the name of a split's file; ``{split}`` stands for the split.
        columns: those of a Parquet file; empty for JSON lines.
        lacks: why `row` leaves an item out, in words; empty where it never does.
        files: the folder whose content is copied; by default that of its name in ``sim2reason/exports/files``.
    """

    name: ClassVar[str]
    also: ClassVar[Sequence[str]] = ()
    data: ClassVar[str] = "data/{split}.jsonl"
    columns: ClassVar[Mapping[str, Column]] = {}
    lacks: ClassVar[str] = ""
    files: ClassVar[Path | None] = None

    @abstractmethod
    def row(self, item: Item, place: RowPosition) -> Row | None:
        """Return the row of an item; None to omit it."""

    def license(self, name: str) -> str:
        """Return the export's name for a licence, given by its name on the Hugging Face Hub."""
        return name

    @property
    def folder(self) -> Path:
        """Return the folder of the files that are copied beside the data."""
        return self.files or FILES / self.name


def check_data(name: str, member: object) -> None:
    """Raise ValueError for an export that would write all splits to one file."""
    if "{split}" not in getattr(member, "data", ""):
        raise ValueError(f"exports: {name!r} writes all splits to one file; say {{split}} in its `data`")


E = TypeVar("E", bound=Export)
EXPORTS: Registry[Export] = Registry("exports", check_data, package="sim2reason.datasets.exports")


def target(cls: type[E]) -> type[E]:
    """Register an export class under its name."""
    EXPORTS.add(cls.name, cls())
    return cls

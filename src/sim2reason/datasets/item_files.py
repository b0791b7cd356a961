"""The items in some files of a dataset by their place, as a list has them."""

from collections.abc import Iterator, Sequence
from importlib import import_module
from itertools import accumulate
from pathlib import Path
from typing import Any, overload

from sim2reason.datasets import shard_files, store
from sim2reason.datasets.item import Item
from sim2reason.datasets.manifest import ShardFile
from sim2reason.errors import MissingExtraError

__all__ = ["ItemFiles"]


class ItemFiles(Sequence[Item]):
    """Items by their place, from 0 on, in the order in which a dataset or one of its splits has them.

    They are read file by file, and those of the file that was read last are kept. What damaged files give is a
    DatasetError that names them.
    """

    def __init__(self, path: Path, files: Sequence[ShardFile], split: str = "") -> None:
        """Read nothing yet; `split` is what they are called, if they are those of one split."""
        self.path, self.split = path, split
        self._files = tuple(files)
        self._ends = list(accumulate(file.rows for file in self._files))
        self._last: tuple[int, list[Item]] = -1, []

    def __repr__(self) -> str:
        """Their folder, their split and their number."""
        return f"<{len(self)} items of {str(self.path)!r}{f', split {self.split}' if self.split else ''}>"

    def __len__(self) -> int:
        """Their number."""
        return self._ends[-1] if self._ends else 0

    def __iter__(self) -> Iterator[Item]:
        """All of them in order, one file in memory at a time."""
        return (item for file in self._files for item in shard_files.read(self.path, file))

    @overload
    def __getitem__(self, place: int) -> Item: ...
    @overload
    def __getitem__(self, place: slice) -> list[Item]: ...
    def __getitem__(self, place: int | slice) -> Item | list[Item]:
        """The item at a place, or those of a slice in a list; IndexError for a place that there is not."""
        if isinstance(place, slice):
            return [self._at(number) for number in range(*place.indices(len(self)))]
        number = place + len(self) if place < 0 else place
        if not 0 <= number < len(self):
            raise IndexError(f"there is no place {place} among {len(self)} items")
        return self._at(number)

    def to_pandas(self) -> Any:  # noqa: ANN401 - pandas is no package that the library needs
        """A DataFrame of pandas with a row for each item, and the columns of the files.

        Raises:
            MissingExtraError: pandas is not installed.
        """
        try:
            pandas: Any = import_module("pandas")
        except ImportError as error:
            raise MissingExtraError("pandas") from error
        rows = [row for file in self._files for row in shard_files.rows(self.path, file, store.COLUMNS)]
        return pandas.DataFrame(rows, columns=store.COLUMNS)

    def _at(self, number: int) -> Item:
        place = next(n for n, end in enumerate(self._ends) if number < end)
        if self._last[0] != place:
            self._last = place, shard_files.read(self.path, self._files[place])
        return self._last[1][number - self._ends[place]]

"""Lazy sequence of the items that are stored in the files of a dataset."""

from collections.abc import Iterator, Sequence
from itertools import accumulate
from pathlib import Path
from typing import Any, overload

from sim2reason.base.optional import optional
from sim2reason.datasets import shard_files, store
from sim2reason.datasets.manifest import ShardFile
from sim2reason.generation.item import Item

__all__ = ["ItemFiles"]


class ItemFiles(Sequence[Item]):
    """Lazy sequence of the items of a dataset or of one of its splits, in their order in the dataset.

    The files are read one at a time, and the items of the last file are kept. A damaged file raises a DatasetError
    that names it.
    """

    def __init__(self, path: Path, files: Sequence[ShardFile], split: str = "") -> None:
        """Store the files without reading them; `split` is the name of the split if all items belong to one split."""
        self.path, self.split = path, split
        self._files = tuple(files)
        self._ends = list(accumulate(file.rows for file in self._files))
        self._last: tuple[int, list[Item]] = -1, []

    def __repr__(self) -> str:
        """Return a text with the number of items, the folder and the split."""
        return f"<{len(self)} items of {str(self.path)!r}{f', split {self.split}' if self.split else ''}>"

    def __len__(self) -> int:
        """Return the number of items."""
        return self._ends[-1] if self._ends else 0

    def __iter__(self) -> Iterator[Item]:
        """Return an iterator over all items in order, which keeps a single file in memory."""
        return (item for file in self._files for item in shard_files.read(self.path, file))

    @overload
    def __getitem__(self, place: int) -> Item: ...
    @overload
    def __getitem__(self, place: slice) -> list[Item]: ...
    def __getitem__(self, place: int | slice) -> Item | list[Item]:
        """Return the item at an index, or a list of the items in a slice; IndexError if the index is out of range."""
        if isinstance(place, slice):
            return [self._at(number) for number in range(*place.indices(len(self)))]
        number = place + len(self) if place < 0 else place
        if not 0 <= number < len(self):
            raise IndexError(f"there is no place {place} among {len(self)} items")
        return self._at(number)

    def to_pandas(self) -> Any:  # noqa: ANN401 - pandas is no package that the library needs
        """Return a pandas DataFrame with a row for each item and the columns of the dataset's files.

        Raises:
            MissingExtraError: pandas is not installed.
        """
        pandas = optional("pandas")
        rows = [row for file in self._files for row in shard_files.rows(self.path, file, store.COLUMNS)]
        return pandas.DataFrame(rows, columns=store.COLUMNS)

    def _at(self, number: int) -> Item:
        place = next(n for n, end in enumerate(self._ends) if number < end)
        if self._last[0] != place:
            self._last = place, shard_files.read(self.path, self._files[place])
        return self._last[1][number - self._ends[place]]

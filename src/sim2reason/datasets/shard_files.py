"""Shards of a dataset: writing, reading and extension of their files and records, and faults in its folder."""

from collections.abc import Collection, Generator, Iterator, Mapping, Sequence
from contextlib import contextmanager
from itertools import accumulate
from pathlib import Path
from typing import Any, overload

from sim2reason.base.atomic_files import FOLDER, checksum, write_atomically
from sim2reason.base.optional import optional
from sim2reason.base.records import format_count
from sim2reason.datasets import store
from sim2reason.datasets.card_content import count_histograms
from sim2reason.datasets.duplicates import Marks, marks
from sim2reason.datasets.journal import Journal
from sim2reason.datasets.manifest import (
    MANIFEST,
    REFUSALS,
    SHARDS,
    Counts,
    Manifest,
    Shard,
    ShardFile,
    load,
    merge_cells,
    merge_counts,
    shards,
    table,
)
from sim2reason.datasets.plan import DATA, file_name
from sim2reason.errors import DatasetError
from sim2reason.generation.item import Item, Record
from sim2reason.generation.splits import choose_split

COUNTED = "recipe", "difficulty", "mode", "kind", "needs"
BySplit = Mapping[str, Sequence[Item]]


def write(out: Path, scratch: Path, number: int, total: int, items: BySplit) -> tuple[ShardFile, ...]:
    """Write the files of a shard, one for each split with items, since the Hub rejects files without rows."""
    named = {split: file_name(number, total, split) for split in items}
    for split, split_items in items.items():
        if not split_items:
            (out / named[split]).unlink(missing_ok=True)
    return tuple(
        _write(out, scratch, named[split], split, split_items) for split, split_items in items.items() if split_items
    )


def _write(out: Path, scratch: Path, name: str, split: str, items: Sequence[Item]) -> ShardFile:
    write_atomically(out / name, lambda path: store.write(path, items), scratch)
    return ShardFile(name=name, split=split, rows=len(items), sha256=checksum(out / name))


def counts(items: BySplit) -> dict[str, Counts]:
    """Return the numbers of items by recipe, difficulty, mode, kind, needs, quantity and split."""
    of_items = [
        {by: str(getattr(item, by)) for by in COUNTED} | {"quantity": item.asked.quantity} for item in flat(items)
    ]
    tallies = (merge_counts({by: {name: 1}} for by, name in each.items()) for each in of_items)
    return merge_counts([*tallies, {"split": {name: len(split_items) for name, split_items in items.items()}}])


def flat(items: BySplit) -> list[Item]:
    """Return the items of all splits."""
    return [item for split_items in items.values() for item in split_items]


def read(out: Path, file: ShardFile, places: Sequence[int] | None = None) -> list[Item]:
    """Return the items of one file, or those at some indices, in order; DatasetError if the file is damaged."""
    with _checked(out, file) as path:
        return store.read(path, places)


def rows(
    out: Path, file: ShardFile, columns: Sequence[str], places: Sequence[int] | None = None
) -> Iterator[store.Row]:
    """Yield some columns of one file, row by row, at all or some indices; DatasetError if damaged."""
    with _checked(out, file) as path:
        yield from store.rows(path, columns, places)


@contextmanager
def _checked(out: Path, file: ShardFile) -> Generator[Path, None, None]:
    remedy = f"see: sim2reason verify {out}; the same sim2reason generate makes it again"
    if checksum(out / file.name) != file.sha256:
        state = "damaged" if (out / file.name).is_file() else "missing"
        raise DatasetError(f"{out / file.name}: {state}; {remedy}")
    try:
        yield out / file.name
    except (OSError, ValueError) as error:
        why = " ".join(str(error).split())
        raise DatasetError(f"{out / file.name}: not readable ({why}); {remedy}") from None


def items(out: Path, shard: Shard, split: str | None = None) -> Iterator[Item]:
    """Yield the items of one shard, of one split or all."""
    return (item for file in shard.files if split in (None, file.split) for item in read(out, file))


Placed = Sequence[tuple[int, Item]]
"""Items with their positions, in order."""


def write_shard(journal: Journal, shard: Shard, items: Placed) -> None:
    """Write the files of a shard with these items, then its record with their counts and hashes."""
    config = journal.plan.config
    homes = [(choose_split(item, config.split), item) for _, item in items]
    by_split = {name: [item for home, item in homes if home == name] for name in config.split}
    requested = [((cell.mode, cell.kind, cell.recipe), cell.asked) for cell in shard.cells]
    changed = {
        "files": write(journal.out, journal.folder, shard.number, journal.shards, by_split),
        "counts": counts(by_split),
        "histograms": count_histograms(item for _, item in items),
        "cells": table(requested, ((item.mode, kind, item.recipe) for _, item in items for kind in item.kinds)),
    }
    journal.note(shard.model_copy(update=changed), marks(items, scenes=len(config.split) > 1))


def lengthened(shard: Shard, by: Shard) -> Shard:
    """Return the record of two adjacent ranges as one shard, still without files and counts of items."""
    refused = {kind: (*getattr(shard, kind), *getattr(by, kind)) for kind in REFUSALS}
    changed = {
        "positions": (shard.positions[0], by.positions[1]),
        "rejected": merge_counts([shard.rejected, by.rejected]),
        "cells": merge_cells([shard.cells, by.cells]),
    }
    return shard.model_copy(update=refused | changed)


def read_shard(journal: Journal, number: int) -> Shard:
    """Return the record of a finished shard."""
    shard = journal.shard(number)
    if shard is None:
        raise DatasetError(f"{journal.folder}: the record of shard {number} is gone; give the same command again")
    return shard


def read_items(journal: Journal, shard: Shard) -> list[tuple[int, Item]]:
    """Return the items of a shard with their positions, in order."""
    config = journal.plan.config
    named = ((config.position(config.named(item.id)), item) for item in items(journal.out, shard))
    return sorted(named, key=lambda pair: pair[0])


def read_marks(journal: Journal, number: int) -> Marks:
    """Return the hashes and numbers of a shard's items, for the detection of duplicates, computed if not stored."""
    known, shard = journal.marks(number), read_shard(journal, number)
    if known is None or len(known.table) != shard.rows:
        known = marks(read_items(journal, shard), scenes=len(journal.plan.config.split) > 1)
        journal.keep(number, known)
    return known


class ItemFiles(Sequence[Item]):
    """A lazy sequence of the items of a dataset or of one of its splits, in order.

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
        """Return an iterator over all items in order, with a single file in memory."""
        return (item for file in self._files for item in read(self.path, file))

    @overload
    def __getitem__(self, place: int) -> Item: ...
    @overload
    def __getitem__(self, place: slice) -> list[Item]: ...
    def __getitem__(self, place: int | slice) -> Item | list[Item]:
        """Return the item at an index, or a list of the items in a slice; IndexError if the index is out of range."""
        if isinstance(place, slice):
            return [self._item_at(number) for number in range(*place.indices(len(self)))]
        number = place + len(self) if place < 0 else place
        if not 0 <= number < len(self):
            raise IndexError(f"there is no place {place} among {len(self)} items")
        return self._item_at(number)

    def to_pandas(self) -> Any:  # noqa: ANN401 - pandas is no package that the library needs
        """Return a pandas DataFrame with a row for each item and the columns of the dataset's files.

        Raises:
            MissingExtraError: pandas is not installed.
        """
        pandas = optional("pandas")
        records = [row for file in self._files for row in rows(self.path, file, store.COLUMNS)]
        return pandas.DataFrame(records, columns=store.COLUMNS)

    def _item_at(self, number: int) -> Item:
        index = next(n for n, end in enumerate(self._ends) if number < end)
        if self._last[0] != index:
            self._last = index, read(self.path, self._files[index])
        return self._last[1][number - self._ends[index]]


class Findings(Record):
    """Result of `verify`: the numbers of rows and shards in the manifest, and a line for each fault."""

    rows: int
    shards: int
    faults: tuple[str, ...]

    def __str__(self) -> str:
        """Return the numbers of rows and shards, and a line for each fault."""
        about = f"{format_count(self.rows, 'row')} in {format_count(self.shards, 'shard')}"
        return "\n".join(
            [f"{about}: {format_count(len(self.faults), 'fault')}", *(f"  {fault}" for fault in self.faults)]
        )


def check_folder(out: Path) -> Findings:
    """Check the folder of a dataset; DatasetError if it is missing, unfinished or without a manifest."""
    if not out.is_dir():
        raise DatasetError(f"{out}: no such folder; give one that sim2reason generate has made")
    if not (out / MANIFEST).is_file() and (out / FOLDER).is_dir():
        raise DatasetError(f"{out}: not finished; run the same sim2reason generate again to go on")
    if not (out / MANIFEST).is_file():
        load(out)  # says that there is none
    try:
        manifest = load(out)
    except DatasetError as error:
        return Findings(rows=0, shards=0, faults=(str(error),))
    faults = *_manifest(out, manifest), *_files(out, manifest), *_shards(out, manifest), *manifest.empty_cells()
    return Findings(rows=manifest.rows, shards=manifest.shards, faults=faults)


def _manifest(out: Path, manifest: Manifest) -> Iterator[str]:
    if manifest.text().encode() != (out / MANIFEST).read_bytes() or not manifest.is_whole:
        yield f"{MANIFEST}: damaged, it is not as it was written"
    if manifest.config.digest(manifest.versions) != manifest.config_hash:
        yield f"{MANIFEST}: the configuration or the versions don't fit their hash"
    if manifest.shards != manifest.config.shards(manifest.positions):
        yield f"{MANIFEST}: the number of shards doesn't fit the configuration"


def _files(out: Path, manifest: Manifest) -> Iterator[str]:
    for name, sha256 in manifest.files.items():
        if checksum(out / name) != sha256:
            yield f"{name}: {'damaged' if (out / name).is_file() else 'missing'}"


def _shards(out: Path, manifest: Manifest) -> Iterator[str]:
    """Yield the faults in the list of shards and in the shard files, and each extra Parquet file."""
    rows, numbers, known = 0, 0, set[str]()
    try:
        for shard in shards(out):
            rows, numbers = rows + shard.rows, numbers + 1
            known.update(file.name for file in shard.files)
            splits = [split for split in manifest.config.split if any(file.split == split for file in shard.files)]
            names = tuple(file_name(shard.number, manifest.shards, split) for split in splits)
            if shard.number != numbers - 1 or tuple(file.name for file in shard.files) != names:
                yield f"{SHARDS}: line {numbers} doesn't fit the configuration"
            for file in shard.files:
                yield from _file(out, file)
    except DatasetError as error:
        yield str(error)
        return
    if numbers != manifest.shards:
        yield f"{SHARDS}: {numbers} shards instead of {manifest.shards}"
    if manifest.rows != rows:
        yield f"{MANIFEST}: the number of rows is not the sum over the shards"
    yield from _strangers(out, known)


def _file(out: Path, file: ShardFile) -> Iterator[str]:
    path = out / file.name
    if not path.is_file():
        yield f"{file.name}: missing"
        return
    if checksum(path) != file.sha256:
        yield f"{file.name}: damaged, its SHA-256 is not that of the list of shards"
    try:
        rows = store.count(path)
    except (OSError, ValueError) as error:
        yield f"{file.name}: not readable as Parquet ({' '.join(str(error).split())})"
        return
    if rows != file.rows:
        yield f"{file.name}: {rows} rows instead of {file.rows}"


def _strangers(out: Path, known: Collection[str]) -> Iterator[str]:
    """Yield a fault for each Parquet file that is not part of the dataset."""
    for path in sorted((out / DATA).glob("*.parquet")):
        if (name := f"{DATA}/{path.name}") not in known:
            yield f"{name}: an extra file that the dataset does not know"

"""The files of a shard: written, and read back as items."""

from collections.abc import Generator, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path

from sim2reason.base.atomic_files import checksum, put
from sim2reason.datasets import store
from sim2reason.datasets.manifest import Counts, Shard, ShardFile, merged
from sim2reason.datasets.plan import file_name
from sim2reason.errors import DatasetError
from sim2reason.generation.item import Item

COUNTED = "recipe", "difficulty", "mode", "kind", "needs"
BySplit = Mapping[str, Sequence[Item]]


def write(out: Path, scratch: Path, number: int, total: int, items: BySplit) -> tuple[ShardFile, ...]:
    """Put the files of the `number`-th of so many shards: one for each split that has an item in it.

    Readers of the Hugging Face hub refuse a dataset that has a file without rows.
    """
    named = {split: file_name(number, total, split) for split in items}
    for split, found in items.items():
        if not found:
            (out / named[split]).unlink(missing_ok=True)
    return tuple(_write(out, scratch, named[split], split, found) for split, found in items.items() if found)


def _write(out: Path, scratch: Path, name: str, split: str, items: Sequence[Item]) -> ShardFile:
    put(out / name, lambda path: store.write(path, items), scratch)
    return ShardFile(name=name, split=split, rows=len(items), sha256=checksum(out / name))


def counts(items: BySplit) -> dict[str, Counts]:
    """Return how many items there are of each recipe, difficulty, mode, kind, needs, quantity and split."""
    of_items = [
        {by: str(getattr(item, by)) for by in COUNTED} | {"quantity": item.asked.quantity} for item in flat(items)
    ]
    found = (merged({by: {name: 1}} for by, name in each.items()) for each in of_items)
    return merged([*found, {"split": {name: len(held) for name, held in items.items()}}])


def flat(items: BySplit) -> list[Item]:
    """Return the items of all splits."""
    return [item for held in items.values() for item in held]


def read(out: Path, file: ShardFile, places: Sequence[int] | None = None) -> list[Item]:
    """Return the items of one file, or those at some places, in order; DatasetError if it is not as it was written."""
    with _checked(out, file) as path:
        return store.read(path, places)


def rows(
    out: Path, file: ShardFile, columns: Sequence[str], places: Sequence[int] | None = None
) -> Iterator[store.Row]:
    """Some columns of one file, row by row, at all its places or some; DatasetError if it is not as it was written."""
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
    """Return the items of one shard, by default of all its splits, one after the other."""
    return (item for file in shard.files if split in (None, file.split) for item in read(out, file))

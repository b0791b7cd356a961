"""A finished dataset, opened: its items one after the other, any one by its id, or a few from all over it."""

from collections.abc import Iterator
from pathlib import Path

from sim2reason.datasets import shard_files
from sim2reason.datasets.item import Item
from sim2reason.datasets.manifest import Manifest, load, shard, shards
from sim2reason.errors import DatasetError, DrawError

STRIDE = 7919  # a prime, in step with no number of recipes and difficulties


class Dataset:
    """A folder that `generate` has finished. It reads one file at a time, and checks each before it is believed.

    What damaged files give is a DatasetError that names them.
    """

    def __init__(self, path: Path | str) -> None:
        """DatasetError if it is no finished dataset."""
        self.path = Path(path)
        self.manifest: Manifest = load(self.path)

    def __len__(self) -> int:
        """The number of its items."""
        return self.manifest.rows

    def __iter__(self) -> Iterator[Item]:
        """All items, shard by shard."""
        return self.items()

    def items(self, split: str | None = None) -> Iterator[Item]:
        """All items, or those of one split, shard by shard; DatasetError if there is no such split."""
        splits = self.manifest.config.split
        if split is not None and split not in splits:
            raise DatasetError(f"{self.path}: has no split {split!r}; there is {', '.join(splits)}")
        return (item for shard in shards(self.path) for item in shard_files.items(self.path, shard, split))

    def item(self, name: str) -> Item:
        """The item of an id, at once; DatasetError if there is none."""
        config = self.manifest.config
        try:
            number = config.position(config.named(name)) // config.shard
        except DrawError:
            number = None
        found = shard_files.items(self.path, shard(self.path, number)) if number is not None else ()
        item = next((item for item in found if item.id == name), None)
        if item is None:
            raise DatasetError(f"{self.path}: holds no problem {name!r}; see: sim2reason show {self.path}")
        return item

    def some(self, count: int) -> Iterator[Item]:
        """As many items from all over the dataset; never in step with the round robin of its plan."""
        rows = len(self)
        wide = rows // max(count, 1)  # one is taken from each stretch of so many
        places = iter([n * rows // count + n * STRIDE % wide for n in range(count)] if wide else range(rows))
        place, behind = next(places, None), 0
        for held in shards(self.path):
            items: list[Item] = []
            while place is not None and place < behind + held.rows:
                items = items or list(shard_files.items(self.path, held))
                yield items[place - behind]
                place = next(places, None)
            behind += held.rows
            if place is None:
                return

"""Problems generated on request: a bounded dataset that is never written."""

from dataclasses import replace

from sim2reason.datasets.contamination import Benchmarks
from sim2reason.datasets.plan import TRAIN, Config
from sim2reason.errors import DatasetError, DrawError
from sim2reason.generation.item import Item
from sim2reason.generation.request import Request, load_maker
from sim2reason.generation.splits import split_of

__all__ = ["INDEX_STRIDE", "LazyProblems"]

INDEX_STRIDE = 2**40
"""The most problems, and how far apart the indices are at which one position looks for its problem."""
TRIES = 200
"""How many indices a position looks at. Of a split with a tenth of all problems, it misses one position in 10⁹."""


class LazyProblems:
    """The problems of one split of a configuration by position, each a pure function of both.

    Positions cycle through recipes, difficulties and modes as in a dataset. If a request gives no problem of the split
    (no draw passes the filters, the problem belongs to another split, or it shares words with a benchmark), the request
    with the index increased by `INDEX_STRIDE` replaces it, so that no two positions share a request. It is small, and
    can be pickled.

    Args:
        config: what `generate` would make; `items` is the length. Items are not compared with each other.
        split: the name of one of its splits.
        benchmarks: with which no problem may share a run of words.

    Raises:
        DatasetError: too many items, no such split, or no such maker.
    """

    def __init__(self, config: Config, split: str = TRAIN, benchmarks: Benchmarks | None = None) -> None:
        """Store the configuration without generating a problem."""
        if config.items > INDEX_STRIDE:
            raise DatasetError(f"items: {config.items} are too many; give {INDEX_STRIDE} at most")
        if split not in config.split:
            raise DatasetError(f"there is no split {split!r}; there is {', '.join(config.split)}")
        load_maker(config.maker)
        self.config, self.split, self._benchmarks = config, split, benchmarks

    def __len__(self) -> int:
        """Return the number of positions."""
        return self.config.items

    def __getitem__(self, position: int) -> Item:
        """Return the problem at a position, counted from 0.

        Raises:
            IndexError: there is no such position.
            DrawError: none of `TRIES` requests gave a problem of the split.
        """
        if not 0 <= position < len(self):
            raise IndexError(f"position {position} of {len(self)}")
        first = self.config.request(position)
        for attempt in range(TRIES):
            found = self._drawn(replace(first, index=first.index + attempt * INDEX_STRIDE))
            if found is not None:
                return found
        raise DrawError(
            f"{first.id}: none of {TRIES} draws gave a problem of the split {self.split!r}; give it a larger share, or "
            f"leave {first.recipe} out"
        )

    def _drawn(self, request: Request) -> Item | None:
        item = load_maker(self.config.maker)(request).item
        if item is None or split_of(item, self.config.split) != self.split:
            return None
        shared = self._benchmarks.overlap(item.prompt) if self._benchmarks is not None else None
        return item if shared is None else None

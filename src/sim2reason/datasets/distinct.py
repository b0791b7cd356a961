"""Leave out what a dataset already holds: the lower position stays.

An item never looks at another while it is made, so this is a pass over what was kept of each when it was made. Two
items are the same if they have the same words, or ask the same of the same scene; in a dataset of several splits, if
they have the same scene. They are alike if they are variants of one problem whose numbers are too close (`variants`).

Of each item some hashes are held in memory, of 8 bytes, and numbers only where others have the same problem, for a
stretch of all problems at a time. Of 10⁷ items, two that differ have the same hash with a probability of 1e-5.
"""

from collections.abc import Callable, Iterator, Sequence
from hashlib import blake2b
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sim2reason.datasets.variants import Logarithms, Variants, hashed, holds, too_close, twice, variant
from sim2reason.generation.item import Item

Table = NDArray[np.uint64]
POSITION, PROBLEM, COUNT, OWN = 0, 1, 2, 3
"""Columns of a table: the position, the problem that the item is a variant of, how many numbers it has, its marks."""
HELD = 2_000_000  # numbers of variants that are compared at once, in some 200 MB, if no problem has more
NOBODY = -1


class Marks(NamedTuple):
    """What is kept of the items of a shard."""

    table: Table
    """A row for each item, see `POSITION`."""
    logarithms: Logarithms
    """Of the numbers of all items."""


class Double(NamedTuple):
    """An item that is left out."""

    position: int
    first: int
    """The position of one before it, which stays."""
    alike: bool
    """Whether they are only alike, and not the same."""


Read = Callable[[int], Marks]
"""The marks of a shard by its number; they are asked for several times."""
Others = NDArray[np.int64]
"""For each position another one, or nobody."""


def marks(items: Sequence[tuple[int, Item]], *, scenes: bool) -> Marks:
    """Return those of items at their positions; with one of the whole scene if no two may share it."""
    columns = OWN + (3 if scenes else 2)
    found = [variant(item) for _, item in items]
    rows = [
        (position, hashed(each), len(each.logarithms), *map(_hash, _keys(item)))[:columns]
        for (position, item), each in zip(items, found, strict=True)
    ]
    logarithms = [number for each in found for number in each.logarithms]
    return Marks(np.array(rows, np.uint64).reshape(len(rows), columns), np.array(logarithms, np.float32))


def doubles(read: Read, shards: int, items: int, distance: float) -> Iterator[tuple[int, list[Double]]]:
    """For each of so many shards that has some, what is to be left out of as many positions as there are `items`.

    An item goes if one before it that stays is the same, or closer than `distance`. So the pass gives the same if it is
    repeated over shards of which some went through it already, and for the first shards of a larger dataset.
    """
    alike = same = np.full(items, NOBODY, dtype=np.int64)
    while True:  # each round is right for a longer beginning of all positions; the second one nearly always ends it
        before, same = same, _same(read, shards, alike)
        if distance == 0.0 or (before is not alike and np.array_equal(before, same)):
            break
        alike = _alike(read, shards, distance, same)
    for number in range(shards):
        positions = read(number).table[:, POSITION].astype(np.int64)
        gone = positions[(same[positions] != NOBODY) | (alike[positions] != NOBODY)].tolist()
        if gone:
            pairs = ((place, int(same[place]), int(alike[place])) for place in gone)
            yield number, [Double(at, first if first != NOBODY else near, first == NOBODY) for at, first, near in pairs]


def _same(read: Read, shards: int, alike: Others) -> Others:
    """For each item that is the same as one before it which stays, that one."""
    columns = range(OWN, read(0).table.shape[1]) if shards else range(0)
    repeated = [_repeated(read, shards, column) for column in columns]
    first = [np.full(len(values), NOBODY, dtype=np.int64) for values in repeated]
    same = np.full(len(alike), NOBODY, dtype=np.int64)
    for number in range(shards):
        table = read(number).table
        places = [np.searchsorted(values, table[:, column]) for values, column in zip(repeated, columns, strict=True)]
        shared = [holds(values, table[:, column]) for values, column in zip(repeated, columns, strict=True)]
        for row in np.flatnonzero(np.any(shared, axis=0)).tolist():
            at = [(n, int(places[n][row])) for n in range(len(columns)) if shared[n][row]]
            seen = next((int(first[n][place]) for n, place in at if first[n][place] != NOBODY), NOBODY)
            position = int(table[row, POSITION])
            same[position] = seen
            for n, place in at if seen == NOBODY and alike[position] == NOBODY else ():
                first[n][place] = position
    return same


def _alike(read: Read, shards: int, distance: float, same: Others) -> Others:
    """For each item that is too close to one before it which stays, that one; what is the same as another is gone."""
    problems = _repeated(read, shards, PROBLEM)
    alike = np.full(len(same), NOBODY, dtype=np.int64)
    for begin, end in _stretches(read, shards, problems):
        for position, first in too_close(_variants(read, shards, problems[begin:end], same), distance):
            alike[position] = first
    return alike


def _stretches(read: Read, shards: int, problems: Table) -> Iterator[tuple[int, int]]:
    """Cut problems into stretches whose variants may be held in memory, as first and last one and behind it."""
    numbers = np.zeros(len(problems), dtype=np.int64)
    for number in range(shards):
        table = read(number).table
        table = table[holds(problems, table[:, PROBLEM])]
        np.add.at(numbers, np.searchsorted(problems, table[:, PROBLEM]), table[:, COUNT].astype(np.int64) + 1)
    stretch = np.cumsum(numbers) // HELD
    edges = [*np.flatnonzero(np.diff(stretch, prepend=-1)).tolist(), len(problems)]
    yield from pairwise(edges)


def _variants(read: Read, shards: int, problems: Table, same: Others) -> Variants:
    """Return the variants of some problems that may stay."""
    tables: list[Table] = []
    held: list[Logarithms] = []
    for number in range(shards):
        table, logarithms = read(number)
        wanted = holds(problems, table[:, PROBLEM]) & (same[table[:, POSITION].astype(np.int64)] == NOBODY)
        tables.append(table[wanted, : COUNT + 1])
        held.append(logarithms[np.repeat(wanted, table[:, COUNT].astype(np.int64))])
    table = np.concatenate(tables)
    counts = table[:, COUNT].astype(np.int32)
    return Variants(table[:, POSITION].astype(np.int64), table[:, PROBLEM], counts, np.concatenate(held))


def _keys(item: Item) -> tuple[str, str, str]:
    """Return its words; its scene together with its question; its scene."""
    asked = item.asked.model_dump_json()
    words = " ".join(item.prompt.split()).casefold()
    return words, f"{item.mode} {item.kind} {asked}\n{item.scene}", item.scene


def _hash(key: str) -> int:
    return int.from_bytes(blake2b(key.encode(), digest_size=8).digest(), "little")


def _repeated(read: Read, shards: int, column: int) -> Table:
    """Return the values of a column that more than one item has, in order."""
    return twice(np.concatenate([np.zeros(0, np.uint64), *(read(n).table[:, column] for n in range(shards))]))

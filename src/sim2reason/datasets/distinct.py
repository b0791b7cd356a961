"""Leave out what a dataset already holds: the lower position stays.

An item never looks at another while it is made, so this is a pass over what was kept of each when it was made: hashes
of what no other may share. Two items are the same if they have the same words, or ask the same of the same scene; in a
dataset of several splits, if they have the same scene.

The pass needs 8 bytes for each mark of each item, and as much again to sort them: 10⁷ items fit into half a gigabyte.
Of so many, two that differ have the same hash of 64 bits with a probability of 1e-5.
"""

from collections.abc import Callable, Iterator, Sequence
from hashlib import blake2b

import numpy as np
from numpy.typing import NDArray

from sim2reason.datasets.item import Item

Marks = NDArray[np.uint64]
"""For each item of a shard a row: its position, then its marks."""
Double = tuple[int, int]
"""The position of an item that is left out, and of the one that says the same."""
NOBODY = -1


def marks(items: Sequence[tuple[int, Item]], *, scenes: bool) -> Marks:
    """Those of items at their positions; with one of the whole scene if no two may share it."""
    columns = 4 if scenes else 3
    rows = [(position, *map(_hash, _keys(item)))[:columns] for position, item in items]
    return np.array(rows, dtype=np.uint64).reshape(len(rows), columns)


def doubles(read: Callable[[int], Marks], count: int) -> Iterator[tuple[int, list[Double]]]:
    """For each of `count` shards that has some, what is to be left out; `read` gives the marks of a shard, twice.

    Only what is kept counts as seen, so the pass gives the same if it is repeated over shards of which some went
    through it already.
    """
    columns = read(0).shape[1] - 1 if count else 0
    repeated = [_repeated(read, count, column) for column in range(1, columns + 1)]
    first = [np.full(len(values), NOBODY, dtype=np.int64) for values in repeated]
    for number in range(count):
        found = read(number)
        wanted = [found[:, column] for column in range(1, columns + 1)]
        places = [np.searchsorted(values, each) for values, each in zip(repeated, wanted, strict=True)]
        shared = [_holds(*each) for each in zip(repeated, places, wanted, strict=True)]
        left_out: list[Double] = []
        for row in np.flatnonzero(np.any(shared, axis=0)).tolist():
            at = [(column, int(places[column][row])) for column in range(columns) if shared[column][row]]
            seen = next((int(first[column][place]) for column, place in at if first[column][place] != NOBODY), NOBODY)
            if seen != NOBODY:
                left_out.append((int(found[row, 0]), seen))
                continue
            for column, place in at:
                first[column][place] = int(found[row, 0])
        if left_out:
            yield number, left_out


def _keys(item: Item) -> tuple[str, str, str]:
    """Its words; its scene together with its question; its scene."""
    asked = item.asked.model_dump_json()
    words = " ".join(item.prompt.split()).casefold()
    return words, f"{item.mode} {item.kind} {asked}\n{item.scene}", item.scene


def _hash(key: str) -> int:
    return int.from_bytes(blake2b(key.encode(), digest_size=8).digest(), "little")


def _repeated(read: Callable[[int], Marks], count: int, column: int) -> Marks:
    """The marks of a column that more than one item has, in order."""
    values = np.concatenate([read(number)[:, column] for number in range(count)])
    values.sort()
    return np.unique(values[1:][values[1:] == values[:-1]])


def _holds(values: Marks, places: NDArray[np.intp], wanted: Marks) -> NDArray[np.bool_]:
    """Which of the wanted ones stand where they would."""
    if not len(values):
        return np.zeros(len(wanted), dtype=np.bool_)
    inside = np.minimum(places, len(values) - 1)
    return values[inside] == wanted

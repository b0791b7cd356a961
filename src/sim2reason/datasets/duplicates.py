"""Duplicates in a dataset: equal problems, and variants whose numbers are too close."""

from collections.abc import Callable, Iterator, Sequence
from hashlib import blake2b
from itertools import pairwise
from math import log, log1p
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sim2reason.errors import SceneError
from sim2reason.generation.item import Item
from sim2reason.generation.splits import parse_numbers, problem, question
from sim2reason.scenes.files import load

Logarithms = NDArray[np.float32]
"""Of the sizes of numbers: ratios are differences, to six digits."""
BLOCK_ITEMS = 500_000  # items whose cells are computed at once
CELL_WIDENING = 1e-5  # relative widening of cells against rounding errors
_MIX_MULTIPLIER = 0x9E3779B97F4A7C15  # odd, so that multiplication is reversible
_SECOND_MULTIPLIER = 0xBF58476D1CE4E5B9


class Variant(NamedTuple):
    """A problem's text without the magnitudes of its numbers, and the logarithms of those magnitudes."""

    problem: str
    logarithms: tuple[float, ...]


class Variants(NamedTuple):
    """The items whose problems differ from another item's only in numbers, with the logarithms of their numbers."""

    positions: NDArray[np.int64]
    problems: NDArray[np.uint64]
    counts: NDArray[np.int32]
    """How many numbers each has; all of one problem have as many."""
    logarithms: Logarithms
    """Of all items, one after the other."""


def variant(item: Item) -> Variant:
    """Return an item's problem without the magnitudes of its numbers, and the logarithms of these magnitudes."""
    if item.answer.formula is not None and not item.parts:
        return Variant(problem(item), ())
    values = *_stated(item), *_asked(item)
    signs = "".join("?" if value is None else "0-+"[(value > 0) - (value < 0)] for value in values)
    return Variant(f"{problem(item)}\n{signs}", tuple(log(abs(value)) for value in values if value))


def _asked(item: Item) -> list[float | None]:
    """Return the numbers of the question and the answer; for several parts, in a canonical order."""
    if not item.parts:
        return [item.asked.time, item.asked.given, item.answer.value]
    pairs = zip(item.parts, item.answer.parts, strict=True)
    ordered = sorted(pairs, key=lambda pair: (question(pair[0].kind, pair[0].asked), pair[0].asked.time or 0.0))
    return [value for part, answer in ordered for value in (part.asked.time, part.asked.given, answer.value)]


def _stated(item: Item) -> list[float | None]:
    """Return the scene's numbers that the text states; all numbers if the scene cannot be read."""
    try:
        parameters = load(item.scene).parameters
    except SceneError:
        return [*parse_numbers(item.scene)]
    left_open = item.asked.unknown, item.asked.limit_of
    return [each.value for each in parameters if not each.hidden and each.path not in left_open]


def hashed(variant: Variant) -> int:
    """Return the 64-bit hash of a variant's problem."""
    return int.from_bytes(blake2b(variant.problem.encode(), digest_size=8, person=b"variant").digest(), "little")


def too_close(variants: Variants, distance: float) -> Iterator[tuple[int, int]]:
    """Yield pairs of positions: an item whose numbers are too close to those of an earlier kept item, and that item."""
    starts = np.concatenate([[0], np.cumsum(variants.counts, dtype=np.int64)])
    limit = np.float32(log1p(distance))
    stay: dict[int, list[int]] = {}
    for row, cells in _neighbours(variants, starts, float(limit) * (1.0 + CELL_WIDENING)):
        near = _first(variants, starts, row, sorted({other for cell in cells for other in stay.get(cell, ())}), limit)
        if near is not None:
            yield int(variants.positions[row]), int(variants.positions[near])
            continue
        for cell in cells:
            stay.setdefault(cell, []).append(row)


def _first(variants: Variants, starts: NDArray[np.int64], row: int, others: list[int], limit: np.float32) -> int | None:
    """Return the first of some rows with the same problem whose numbers all differ by less than the limit."""
    rows = np.array(others, dtype=np.int64)
    rows = rows[variants.problems[rows] == variants.problems[row]]  # two problems may meet in a cell by chance
    places = np.arange(int(variants.counts[row]))
    differences = np.abs(
        variants.logarithms[starts[rows][:, None] + places] - variants.logarithms[starts[row] + places]
    )
    close = np.flatnonzero(differences.max(axis=1, initial=0.0) < limit)
    return int(rows[close[0]]) if len(close) else None


def _neighbours(variants: Variants, starts: NDArray[np.int64], limit: float) -> Iterator[tuple[int, list[int]]]:
    """Yield each item that shares a grid cell of numbers with another, with the hashes of its shared cells.

    For d numbers there are d + 1 grids with cells of d + 1 times the limit, each shifted by the limit from the previous
    one. Along each axis at most one grid has an edge between two numbers within the limit, so such items share a cell
    in at least one grid (T. M. Chan, Approximate nearest neighbor queries revisited, 1998).
    """
    rows: list[NDArray[np.int64]] = []
    shared: list[NDArray[np.uint64]] = []
    for grid in range(int(variants.counts.max(initial=0)) + 1):
        inside = np.flatnonzero(variants.counts >= grid)
        parts = [
            _cells(variants, starts, inside[n : n + BLOCK_ITEMS], grid, limit)
            for n in range(0, max(len(inside), 1), BLOCK_ITEMS)
        ]
        cells = np.concatenate(parts)
        repeated = repeated_values(cells.copy())
        mask = contains_sorted(repeated, cells)
        rows.append(inside[mask])
        shared.append(cells[mask])
    all_rows, all_cells = np.concatenate(rows), np.concatenate(shared)
    order = np.argsort(all_rows, kind="stable")
    all_rows, all_cells = all_rows[order], all_cells[order]
    edges = [*np.flatnonzero(np.diff(all_rows, prepend=-1)).tolist(), len(all_rows)]
    for start, stop in pairwise(edges):
        yield int(all_rows[start]), all_cells[start:stop].tolist()


def _cells(
    variants: Variants, starts: NDArray[np.int64], rows: NDArray[np.int64], grid: int, limit: float
) -> NDArray[np.uint64]:
    """Return, for each item, a hash of its problem and of the cell of its numbers' logarithms in one grid."""
    counts = variants.counts[rows]
    ends = np.cumsum(counts, dtype=np.int64)
    offsets = np.arange(ends[-1] if len(ends) else 0) - np.repeat(ends - counts, counts)  # of a number among its item's
    values = variants.logarithms[np.repeat(starts[rows], counts) + offsets].astype(np.float64)
    width = np.repeat((counts + 1) * limit, counts)
    cell = np.floor((values + grid * limit) / width).astype(np.int64).astype(np.uint64)
    mixed = (
        cell * np.uint64(_MIX_MULTIPLIER) ^ (offsets.astype(np.uint64) + np.uint64(1)) * np.uint64(_SECOND_MULTIPLIER)
    ) * np.uint64(_MIX_MULTIPLIER)
    mixed ^= mixed >> np.uint64(29)
    sums = np.concatenate([np.zeros(1, np.uint64), np.cumsum(mixed * np.uint64(_SECOND_MULTIPLIER), dtype=np.uint64)])
    total = sums[ends] - sums[ends - counts]  # whole numbers of 64 bits overflow, and differences are right again
    return total ^ (variants.problems[rows] + np.uint64(grid * _MIX_MULTIPLIER % 2**64))


def repeated_values(values: NDArray[np.uint64]) -> NDArray[np.uint64]:
    """Return the sorted values that occur more than once; `values` is sorted in place."""
    values.sort()
    return np.unique(values[1:][values[1:] == values[:-1]])


def contains_sorted(ordered: NDArray[np.uint64], wanted: NDArray[np.uint64]) -> NDArray[np.bool_]:
    """Return, for each wanted value, whether a sorted array contains it."""
    if not len(ordered):
        return np.zeros(len(wanted), dtype=np.bool_)
    places = np.minimum(np.searchsorted(ordered, wanted), len(ordered) - 1)
    return ordered[places] == wanted


Table = NDArray[np.uint64]
POSITION, PROBLEM, COUNT, OWN = 0, 1, 2, 3
"""Columns of a table: the position, the problem that the item is a variant of, how many numbers it has, its marks."""
HELD = 2_000_000  # numbers of variants compared at once, in some 200 MB
NO_ITEM = -1


class Marks(NamedTuple):
    """Hashes of the items of a shard, and the logarithms of their numbers, for the detection of duplicates."""

    table: Table
    """A row for each item, see `POSITION`."""
    logarithms: Logarithms
    """Of the numbers of all items."""


class Duplicate(NamedTuple):
    """An item removed as a duplicate or variant of an earlier one."""

    position: int
    first: int
    """The position of one before it, which stays."""
    alike: bool
    """Whether they are only alike, and not the same."""


Read = Callable[[int], Marks]
"""The marks of a shard by its number; they are asked for several times."""
EarlierItems = NDArray[np.int64]
"""For each position another one, or nobody."""


def marks(items: Sequence[tuple[int, Item]], *, scenes: bool) -> Marks:
    """Return the hashes and numbers of items for the detection of duplicates; `scenes` adds hashes of scenes."""
    columns = OWN + (3 if scenes else 2)
    variants = [variant(item) for _, item in items]
    rows = [
        (position, hashed(each), len(each.logarithms), *map(_hash, _keys(item)))[:columns]
        for (position, item), each in zip(items, variants, strict=True)
    ]
    logarithms = [number for each in variants for number in each.logarithms]
    return Marks(np.array(rows, np.uint64).reshape(len(rows), columns), np.array(logarithms, np.float32))


def find_duplicates(read: Read, shards: int, items: int, distance: float) -> Iterator[tuple[int, list[Duplicate]]]:
    """Yield the duplicates to remove, shard by shard.

    An item is removed if an earlier kept item is equal, or closer than `distance`. Hence the result is the same if the
    pass is repeated on partly processed shards, and for the first shards of a larger dataset.
    """
    alike = same = np.full(items, NO_ITEM, dtype=np.int64)
    while True:  # each round is right for a longer beginning of all positions; the second one nearly always ends it
        before, same = same, _same(read, shards, alike)
        if distance == 0.0 or (before is not alike and np.array_equal(before, same)):
            break
        alike = _alike(read, shards, distance, same)
    for number in range(shards):
        positions = read(number).table[:, POSITION].astype(np.int64)
        gone = positions[(same[positions] != NO_ITEM) | (alike[positions] != NO_ITEM)].tolist()
        if gone:
            pairs = ((position, int(same[position]), int(alike[position])) for position in gone)
            yield (
                number,
                [Duplicate(at, first if first != NO_ITEM else near, first == NO_ITEM) for at, first, near in pairs],
            )


def _same(read: Read, shards: int, alike: EarlierItems) -> EarlierItems:
    """Return, for each item, the position of an equal item that comes before it and is kept; −1 if none."""
    columns = range(OWN, read(0).table.shape[1]) if shards else range(0)
    repeated = [_repeated(read, shards, column) for column in columns]
    first = [np.full(len(values), NO_ITEM, dtype=np.int64) for values in repeated]
    same = np.full(len(alike), NO_ITEM, dtype=np.int64)
    for number in range(shards):
        table = read(number).table
        places = [np.searchsorted(values, table[:, column]) for values, column in zip(repeated, columns, strict=True)]
        shared = [contains_sorted(values, table[:, column]) for values, column in zip(repeated, columns, strict=True)]
        for row in np.flatnonzero(np.any(shared, axis=0)).tolist():
            at = [(n, int(places[n][row])) for n in range(len(columns)) if shared[n][row]]
            seen = next((int(first[n][index]) for n, index in at if first[n][index] != NO_ITEM), NO_ITEM)
            position = int(table[row, POSITION])
            same[position] = seen
            for n, index in at if seen == NO_ITEM and alike[position] == NO_ITEM else ():
                first[n][index] = position
    return same


def _alike(read: Read, shards: int, distance: float, same: EarlierItems) -> EarlierItems:
    """Return, for each item, the position of an earlier kept item with the same problem and close numbers, else −1."""
    problems = _repeated(read, shards, PROBLEM)
    alike = np.full(len(same), NO_ITEM, dtype=np.int64)
    for begin, end in _stretches(read, shards, problems):
        for position, first in too_close(_variants(read, shards, problems[begin:end], same), distance):
            alike[position] = first
    return alike


def _stretches(read: Read, shards: int, problems: Table) -> Iterator[tuple[int, int]]:
    """Yield ranges of problems (first, last + 1) whose variants fit into memory together."""
    numbers = np.zeros(len(problems), dtype=np.int64)
    for number in range(shards):
        table = read(number).table
        table = table[contains_sorted(problems, table[:, PROBLEM])]
        np.add.at(numbers, np.searchsorted(problems, table[:, PROBLEM]), table[:, COUNT].astype(np.int64) + 1)
    stretch = np.cumsum(numbers) // HELD
    edges = [*np.flatnonzero(np.diff(stretch, prepend=-1)).tolist(), len(problems)]
    yield from pairwise(edges)


def _variants(read: Read, shards: int, problems: Table, same: EarlierItems) -> Variants:
    """Return the items of some problems with the logarithms of their numbers, without exact duplicates."""
    tables: list[Table] = []
    kept_logarithms: list[Logarithms] = []
    for number in range(shards):
        table, logarithms = read(number)
        wanted = contains_sorted(problems, table[:, PROBLEM]) & (same[table[:, POSITION].astype(np.int64)] == NO_ITEM)
        tables.append(table[wanted, : COUNT + 1])
        kept_logarithms.append(logarithms[np.repeat(wanted, table[:, COUNT].astype(np.int64))])
    table = np.concatenate(tables)
    counts = table[:, COUNT].astype(np.int32)
    return Variants(table[:, POSITION].astype(np.int64), table[:, PROBLEM], counts, np.concatenate(kept_logarithms))


def _keys(item: Item) -> tuple[str, str, str]:
    """Return the text of an item, its scene with its question, and its scene."""
    query = item.asked.model_dump_json()
    words = " ".join(item.prompt.split()).casefold()
    return words, f"{item.mode} {item.kind} {query}\n{item.scene}", item.scene


def _hash(key: str) -> int:
    return int.from_bytes(blake2b(key.encode(), digest_size=8).digest(), "little")


def _repeated(read: Read, shards: int, column: int) -> Table:
    """Return the values, sorted, that occur more than once in a column of the hashes of all items."""
    return repeated_values(np.concatenate([np.zeros(0, np.uint64), *(read(n).table[:, column] for n in range(shards))]))

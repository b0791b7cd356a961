"""Variants of a problem, which differ in numbers only: how far apart these are, and which come too close.

The distance of two variants is the greatest ratio of two numbers at one place, less 1. What counts is what the text
says, the time or value that is asked about, and the answer. Numbers of other signs, and zero, make another problem, as
words tell them (*smooth*, *at rest*). A problem in symbols says no number: two with one formula have the distance 0.
"""

from collections.abc import Iterator
from hashlib import blake2b
from itertools import pairwise
from math import log, log1p
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sim2reason.errors import SceneError
from sim2reason.generation.item import Item
from sim2reason.generation.splits import numbers_in, problem, question
from sim2reason.scenes.files import load

Logarithms = NDArray[np.float32]
"""Of the sizes of numbers: ratios are differences, to six digits."""
BLOCK = 500_000  # items whose cells are computed at once
ROUNDING = 1e-5  # by which cells are wider than they need be
_MIX = 0x9E3779B97F4A7C15  # odd, so that no bit of a cell's number is lost
_AGAIN = 0xBF58476D1CE4E5B9


class Variant(NamedTuple):
    """A problem up to the sizes of its numbers, and their logarithms."""

    problem: str
    logarithms: tuple[float, ...]


class Variants(NamedTuple):
    """Items of problems that more than one item has, in order of their positions."""

    positions: NDArray[np.int64]
    problems: NDArray[np.uint64]
    counts: NDArray[np.int32]
    """How many numbers each has; all of one problem have as many."""
    logarithms: Logarithms
    """Of all items, one after the other."""


def variant(item: Item) -> Variant:
    """Return what an item is a variant of, and by which numbers."""
    if item.answer.formula is not None and not item.parts:
        return Variant(problem(item), ())
    values = *_stated(item), *_asked(item)
    signs = "".join("?" if value is None else "0-+"[(value > 0) - (value < 0)] for value in values)
    return Variant(f"{problem(item)}\n{signs}", tuple(log(abs(value)) for value in values if value))


def _asked(item: Item) -> list[float | None]:
    """Return the numbers of the question and the answer; of several parts, in the order of what they ask."""
    if not item.parts:
        return [item.asked.time, item.asked.given, item.answer.value]
    pairs = zip(item.parts, item.answer.parts, strict=True)
    ordered = sorted(pairs, key=lambda pair: (question(pair[0].kind, pair[0].asked), pair[0].asked.time or 0.0))
    return [value for part, answer in ordered for value in (part.asked.time, part.asked.given, answer.value)]


def _stated(item: Item) -> list[float | None]:
    """Return the numbers of the scene that the text says; all of them where the scene is none that can be read."""
    try:
        parameters = load(item.scene).parameters
    except SceneError:
        return [*numbers_in(item.scene)]
    left_open = item.asked.unknown, item.asked.limit_of
    return [each.value for each in parameters if not each.hidden and each.path not in left_open]


def hashed(variant: Variant) -> int:
    """Return the name of its problem, in 64 bits."""
    return int.from_bytes(blake2b(variant.problem.encode(), digest_size=8, person=b"variant").digest(), "little")


def too_close(found: Variants, distance: float) -> Iterator[tuple[int, int]]:
    """Yield the positions of items that come too close to one before them, each with the first such one that stays."""
    starts = np.concatenate([[0], np.cumsum(found.counts, dtype=np.int64)])
    limit = np.float32(log1p(distance))
    stay: dict[int, list[int]] = {}
    for row, cells in _neighbours(found, starts, float(limit) * (1.0 + ROUNDING)):
        near = _first(found, starts, row, sorted({other for cell in cells for other in stay.get(cell, ())}), limit)
        if near is not None:
            yield int(found.positions[row]), int(found.positions[near])
            continue
        for cell in cells:
            stay.setdefault(cell, []).append(row)


def _first(found: Variants, starts: NDArray[np.int64], row: int, others: list[int], limit: np.float32) -> int | None:
    """Return the first of some items whose numbers are all within the limit."""
    rows = np.array(others, dtype=np.int64)
    rows = rows[found.problems[rows] == found.problems[row]]  # two problems may meet in a cell by chance
    places = np.arange(int(found.counts[row]))
    apart = np.abs(found.logarithms[starts[rows][:, None] + places] - found.logarithms[starts[row] + places])
    close = np.flatnonzero(apart.max(axis=1, initial=0.0) < limit)
    return int(rows[close[0]]) if len(close) else None


def _neighbours(found: Variants, starts: NDArray[np.int64], limit: float) -> Iterator[tuple[int, list[int]]]:
    """Items that share a cell with another, in order, each with those of its cells that are shared.

    For d numbers there are d + 1 grids with cells of d + 1 times the limit, each moved by the limit from the last one.
    Of all their edges along one axis at most one lies between two numbers within the limit, so such items share a cell
    in one of the grids at least (T. M. Chan, Approximate nearest neighbor queries revisited, 1998).
    """
    rows: list[NDArray[np.int64]] = []
    shared: list[NDArray[np.uint64]] = []
    for grid in range(int(found.counts.max(initial=0)) + 1):
        inside = np.flatnonzero(found.counts >= grid)
        parts = [
            _cells(found, starts, inside[n : n + BLOCK], grid, limit) for n in range(0, max(len(inside), 1), BLOCK)
        ]
        cells = np.concatenate(parts)
        repeated = twice(cells.copy())
        held = holds(repeated, cells)
        rows.append(inside[held])
        shared.append(cells[held])
    all_rows, all_cells = np.concatenate(rows), np.concatenate(shared)
    order = np.argsort(all_rows, kind="stable")
    all_rows, all_cells = all_rows[order], all_cells[order]
    edges = [*np.flatnonzero(np.diff(all_rows, prepend=-1)).tolist(), len(all_rows)]
    for start, stop in pairwise(edges):
        yield int(all_rows[start]), all_cells[start:stop].tolist()


def _cells(
    found: Variants, starts: NDArray[np.int64], rows: NDArray[np.int64], grid: int, limit: float
) -> NDArray[np.uint64]:
    """Return the names of the cells of some items in one grid, which hang on the problem as well."""
    counts = found.counts[rows]
    ends = np.cumsum(counts, dtype=np.int64)
    place = np.arange(ends[-1] if len(ends) else 0) - np.repeat(ends - counts, counts)  # of a number among its item's
    values = found.logarithms[np.repeat(starts[rows], counts) + place].astype(np.float64)
    width = np.repeat((counts + 1) * limit, counts)
    cell = np.floor((values + grid * limit) / width).astype(np.int64).astype(np.uint64)
    mixed = (cell * np.uint64(_MIX) ^ (place.astype(np.uint64) + np.uint64(1)) * np.uint64(_AGAIN)) * np.uint64(_MIX)
    mixed ^= mixed >> np.uint64(29)
    sums = np.concatenate([np.zeros(1, np.uint64), np.cumsum(mixed * np.uint64(_AGAIN), dtype=np.uint64)])
    total = sums[ends] - sums[ends - counts]  # whole numbers of 64 bits overflow, and differences are right again
    return total ^ (found.problems[rows] + np.uint64(grid * _MIX % 2**64))


def twice(values: NDArray[np.uint64]) -> NDArray[np.uint64]:
    """Return what occurs more than once, in order; sorts `values`."""
    values.sort()
    return np.unique(values[1:][values[1:] == values[:-1]])


def holds(ordered: NDArray[np.uint64], wanted: NDArray[np.uint64]) -> NDArray[np.bool_]:
    """Return which of the wanted values are among some in order."""
    if not len(ordered):
        return np.zeros(len(wanted), dtype=np.bool_)
    places = np.minimum(np.searchsorted(ordered, wanted), len(ordered) - 1)
    return ordered[places] == wanted

"""The table of modes, kinds and recipes of a dataset: numbers of requests and of kept items."""

from collections.abc import Iterable, Iterator
from math import ceil, log

from sim2reason.generation.item import Record

LEAST_KEPT = 0.25
"""The share of the questions asked for in a cell that a sound library keeps as such, at least."""
FALSE_ALARM = 1e-3
"""The probability that a dataset from a sound library has an empty cell that counts as an error, at most."""


class Cell(Record):
    """The counts for one mode, kind and recipe.

    `asked` counts the requests that the weights assigned to this kind, among kinds that the scenes offer and that are
    not rejected as textbook problems (`few laws`); `kept` counts the items, including those that replaced a kind whose
    questions were all rejected. An item with several parts counts for each of its kinds.
    """

    mode: str
    kind: str
    recipe: str
    asked: int
    kept: int


Key = tuple[str, str, str]
"""Mode, kind and recipe."""


def table(asked: Iterable[tuple[Key, int]], kept: Iterable[Key]) -> tuple[Cell, ...]:
    """Return all cells with requests or items, in alphabetical order."""
    return _summed([*((key, number, 0) for key, number in asked), *((key, 0, 1) for key in kept)])


def together(tables: Iterable[Iterable[Cell]]) -> tuple[Cell, ...]:
    """Return the cells of several tables in one table, with the counts of equal cells added."""
    cells = (cell for table in tables for cell in table)
    return _summed(((cell.mode, cell.kind, cell.recipe), cell.asked, cell.kept) for cell in cells)


def _summed(found: Iterable[tuple[Key, int, int]]) -> tuple[Cell, ...]:
    counts: dict[Key, tuple[int, int]] = {}
    for key, asked, kept in found:
        before = counts.get(key, (0, 0))
        counts[key] = before[0] + asked, before[1] + kept
    return tuple(
        Cell(mode=mode, kind=kind, recipe=recipe, asked=asked, kept=kept)
        for (mode, kind, recipe), (asked, kept) in sorted(counts.items())
    )


def enough(cells: int) -> int:
    """Return how many failed requests of a cell are too many for an accident, given the number of cells.

    If each request is kept with probability at least p, all n fail with probability at most (1 − p)^n, the binomial
    distribution's P(0). The sum over all cells is limited to `FALSE_ALARM`, by Bonferroni's inequality.
    """
    return ceil(log(FALSE_ALARM / max(cells, 1)) / log(1.0 - LEAST_KEPT))


def empty(cells: Iterable[Cell]) -> Iterator[str]:
    """Yield a line for each mode, kind and recipe without an item, after too many requests for an accident."""
    found = tuple(cells)
    for cell in found:
        if cell.kept == 0 and cell.asked >= enough(len(found)):
            name = f"{cell.recipe}.{cell.mode}.{cell.kind}"
            yield (
                f"{name}: asked for {cell.asked} times, and none was kept; see which filters refuse them, "
                f"or order no more of them with the weight {name}=0"
            )

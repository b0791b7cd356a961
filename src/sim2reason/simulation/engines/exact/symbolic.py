"""Elimination on symbols: the pivots are chosen by the values at one point, and stay where they were chosen."""

from typing import NamedTuple

from sim2reason.dsl.triples import Number
from sim2reason.simulation.engines.exact.linear import NEGLIGIBLE
from sim2reason.simulation.engines.exact.tape import value_of

Equation = list[Number]  # coefficients, the right side last


class Unknowns(NamedTuple):
    """The solution of one mode; `pivots` are what was divided by, `free` how forces can change without effect."""

    x: list[Number]
    rows: dict[int, Number]  # multipliers of the acting rows
    friction: dict[int, Number]  # of the rough contacts that stick
    pivots: list[Number]
    free: "tuple[FreeForces, ...]" = ()


class FreeForces(NamedTuple):
    """One way in which forces can change that no motion shows."""

    rows: dict[int, Number]
    friction: dict[int, Number]


def eliminated(equations: list[Equation], size: int, active: list[int], sticking: list[int]) -> Unknowns:
    """Solve for `size` accelerations, then the multipliers of `active` rows, then the friction of `sticking` contacts.

    An unknown that the equations leave free, since something is held twice, is zero.
    """
    width = len(equations[0]) - 1 if equations else 0
    scales = [max((abs(value_of(entry)) for entry in row[:width]), default=0.0) or 1.0 for row in equations]
    pending = list(zip(equations, scales, strict=True))
    solved: list[tuple[int, Equation]] = []
    left: list[int] = []
    for column in range(width):
        best = max(pending, key=lambda item, c=column: abs(value_of(item[0][c])) / item[1], default=None)
        if best is None or abs(value_of(best[0][column])) / best[1] <= NEGLIGIBLE:
            left.append(column)
            continue
        pending = [item for item in pending if item is not best]
        for row, _ in pending:
            _reduce(row, best[0], column)
        solved.append((column, best[0]))
    found = _substituted(solved, [0.0] * width, load=True)
    free = [_substituted(solved, [float(i == column) for i in range(width)], load=False) for column in left]
    free = [numbers for column, numbers in zip(left, free, strict=True) if column >= size]
    rows, friction = _named(found, size, active, sticking)
    spare = tuple(FreeForces(*_named(numbers, size, active, sticking)) for numbers in free)
    return Unknowns(found[:size], rows, friction, [row[column] for column, row in solved], spare)


def _substituted(solved: list[tuple[int, Equation]], found: list[Number], *, load: bool) -> list[Number]:
    """All unknowns, given the free ones; without the `load` the right sides are zero."""
    width = len(found)
    for column, row in reversed(solved):
        total: Number = row[width] if load else 0.0
        for other in range(column + 1, width):
            if not _is_zero(row[other]) and not _is_zero(found[other]):
                total = total - row[other] * found[other]
        found[column] = total / row[column]
    return found


def _named(
    found: list[Number], size: int, active: list[int], sticking: list[int]
) -> tuple[dict[int, Number], dict[int, Number]]:
    """Multipliers by row, and friction by rough contact."""
    rows = dict(zip(active, found[size : size + len(active)], strict=True))
    return rows, dict(zip(sticking, found[size + len(active) :], strict=True))


def _reduce(row: Equation, pivot: Equation, column: int) -> None:
    """Free a row of the unknown that the pivot settles."""
    if _is_zero(row[column]):
        return
    factor = row[column] / pivot[column]
    row[column] = 0.0
    for other in range(column + 1, len(row)):
        if not _is_zero(pivot[other]):
            row[other] = row[other] - factor * pivot[other]


def _is_zero(entry: Number) -> bool:
    return type(entry) is float and entry == 0.0

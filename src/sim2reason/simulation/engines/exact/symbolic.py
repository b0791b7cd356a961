"""Elimination on symbols: the pivots are chosen by the values at one point, and stay where they were chosen."""

from typing import NamedTuple

from sim2reason.dsl.triples import Number
from sim2reason.simulation.engines.exact.linear import NEGLIGIBLE
from sim2reason.simulation.engines.exact.tape import value_of

Equation = list[Number]  # coefficients, the right side last


class Unknowns(NamedTuple):
    """The solution of one mode; `pivots` are what was divided by."""

    x: list[Number]
    rows: dict[int, Number]  # multipliers of the acting rows
    friction: dict[int, Number]  # of the rough contacts that stick
    pivots: list[Number]


def eliminated(equations: list[Equation], size: int, active: list[int], sticking: list[int]) -> Unknowns:
    """Solve for `size` accelerations, then the multipliers of `active` rows, then the friction of `sticking` contacts.

    An unknown that the equations leave free, since something is held twice, is zero.
    """
    width = len(equations[0]) - 1 if equations else 0
    scales = [max((abs(value_of(entry)) for entry in row[:width]), default=0.0) or 1.0 for row in equations]
    pending = list(zip(equations, scales, strict=True))
    solved: list[tuple[int, Equation]] = []
    for column in range(width):
        best = max(pending, key=lambda item, c=column: abs(value_of(item[0][c])) / item[1], default=None)
        if best is None or abs(value_of(best[0][column])) / best[1] <= NEGLIGIBLE:
            continue
        pending = [item for item in pending if item is not best]
        for row, _ in pending:
            _reduce(row, best[0], column)
        solved.append((column, best[0]))
    found: list[Number] = [0.0] * width
    for column, row in reversed(solved):
        total = row[width]
        for other in range(column + 1, width):
            total = total - row[other] * found[other] if not _is_zero(row[other]) else total
        found[column] = total / row[column]
    rows = dict(zip(active, found[size : size + len(active)], strict=True))
    friction = dict(zip(sticking, found[size + len(active) :], strict=True))
    return Unknowns(found[:size], rows, friction, [row[column] for column, row in solved])


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

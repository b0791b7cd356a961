"""Small linear systems that may be singular, and the linear complementarity problem of forces at one instant."""

from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import reduce
from math import inf
from operator import add, mul
from typing import NamedTuple

from sim2reason.scenes.dsl.vectors import Number
from sim2reason.simulation.engines.exact.native import core
from sim2reason.simulation.engines.exact.tape import float_value
from sim2reason.simulation.trace import Budget

Row = list[float]
PIVOT_RTOL = 1e-11  # fraction of a row's largest entry: a smaller pivot counts as zero


@dataclass(slots=True)
class LinearSolution:
    """All solutions of a linear system: one solution `x` plus any combination of the null vectors `nulls`."""

    x: Row
    nulls: list[Row]
    consistent: bool


def dot(a: Row, b: Row) -> float:
    """Return the scalar product of two rows; the shorter row determines the number of terms."""
    return reduce(add, map(mul, a, b), 0.0)


def total(values: Iterable[float]) -> float:
    """Return the sum of numbers from left to right; `sum` compensates rounding from Python 3.12 on."""
    return reduce(add, values, 0.0)


def solve(rows: list[Row]) -> LinearSolution:
    """Solve the equations `row[:-1] · x = row[-1]` by Gaussian elimination with row pivoting.

    There may be more or fewer equations than unknowns. Free unknowns are 0 in `x`, and each is 1 in one of the `nulls`.
    The list of rows is modified.
    """
    if core is not None:
        return LinearSolution(*core.solve(rows))
    return eliminated(rows)


def eliminated(rows: list[Row]) -> LinearSolution:
    """Solve as `solve` does, in Python."""
    size = len(rows[0]) - 1 if rows else 0
    pending = [_scaled(row, size) for row in rows]
    pivots: list[tuple[int, Row]] = []
    free: list[int] = []
    for column in range(size):
        best, largest = None, PIVOT_RTOL
        for row in pending:
            entry = abs(row[column])
            if entry > largest:
                best, largest = row, entry
        if best is None:
            free.append(column)
            continue
        pending = [_freed(row, best, column) if row[column] else row for row in pending if row is not best]
        pivots.append((column, best))
    consistent = all(abs(row[size]) <= 100.0 * PIVOT_RTOL * (1.0 + abs(row[size + 1])) for row in pending)
    x = _substituted_back(pivots, [0.0] * size, 1.0)
    return LinearSolution(x, [_null(pivots, size, column) for column in free], consistent)


def _scaled(row: Row, size: int) -> Row:
    """Return the row divided by its largest coefficient; an extra last entry keeps the scale of the right side."""
    largest = max(map(abs, row[:size]))
    if largest in (0.0, 1.0):  # as of a string's row
        return [*row, row[size]]
    factor = 1.0 / largest
    scaled = [factor * entry for entry in row]
    scaled.append(scaled[size])
    return scaled


def _freed(row: Row, pivot: Row, column: int) -> Row:
    """Return a row with one unknown eliminated by a pivot row."""
    factor = row[column] / pivot[column]
    freed = [a - factor * b for a, b in zip(row, pivot, strict=True)]
    freed[column], freed[-1] = 0.0, max(abs(row[-1]), abs(factor * pivot[-1]))
    return freed


def _substituted_back(pivots: list[tuple[int, Row]], x: Row, load: float) -> Row:
    size = len(x)
    for column, row in reversed(pivots):
        x[column] = (load * row[size] - dot(x, row)) / row[column]
    return x


def _null(pivots: list[tuple[int, Row]], size: int, column: int) -> Row:
    x = [0.0] * size
    x[column] = 1.0
    return _substituted_back(pivots, x, 0.0)


@dataclass(slots=True)
class Gradient:
    """The gradient of a length with respect to the coordinates and to distances of bodies from their faces."""

    along: Row  # (n,)
    lift: Row  # (c,)
    terms: tuple[tuple[int, float], ...]  # the nonzero entries of `along`

    def rate(self, values: Row) -> float:
        """Return the rate of change for given velocities, or the second derivative for accelerations."""
        total = 0.0
        for number, factor in self.terms:
            total += factor * values[number]
        return total


def gradient(along: Row, lift: Row) -> Gradient:
    """Return a gradient with its nonzero terms precomputed."""
    return Gradient(along, lift, tuple([(number, part) for number, part in enumerate(along) if part]))


@dataclass(frozen=True, slots=True)
class RoughContact:
    """A contact with friction: its index among the contacts, gradient of slip, and friction coefficients."""

    contact: int
    slip: Gradient
    friction: float
    coordinate: int = -1  # the index of the coordinate whose rate equals the slip; −1 for none
    both: bool = False  # whether the face holds in both directions; a negative normal force rubs too
    holds: float = 0.0  # the coefficient of static friction

    @property
    def never(self) -> bool:
        """Return whether friction is unbounded, so that the contact never slips and any residual slip is round-off."""
        return self.friction == inf

    def side(self, slip: float, least: float = 0.0) -> int:
        """Return the direction of slip as −1, 0 or 1; speeds up to `least` count as zero."""
        return 0 if self.never else (slip > least) - (slip < -least)


class ContactMode(NamedTuple):
    """A contact mode: which constraint rows act, and how each rough contact rubs: 0 sticks, ±1 slips."""

    acting: tuple[bool, ...]
    rubbing: tuple[int, ...]


@dataclass(slots=True)
class Problem:
    """Loads, constraint rows and rough contacts at one instant, as a linear complementarity problem."""

    mass: list[Row]
    lifted: list[Row]
    force: Row
    press: Row
    rows: tuple[Gradient, ...]
    targets: Row
    grips: tuple[RoughContact, ...]
    sliding: tuple[int, ...]  # the prescribed direction of slip of a sliding contact; 0 if the search may choose
    held: tuple[bool, ...]  # the rows that act whatever the sign of λ
    follows: tuple[int, ...]  # the index of the row with which each row acts, or −1
    guided: tuple[int, ...]  # the contacts that hold in both directions
    budget: Budget = field(default_factory=Budget)  # of the motion to which the instant belongs
    load: float = field(init=False)  # the largest of the given loads

    def __post_init__(self) -> None:
        """Compute the largest given load."""
        self.load = max(map(abs, (*self.force, *self.press)), default=0.0)


class Forces(NamedTuple):
    """The constraint forces of one solution, or one combination of them that does not affect the motion."""

    rows: Row
    friction: Row
    normal: Row


@dataclass(slots=True)
class Solution:
    """Accelerations x and forces of one contact mode, with the force patterns (`spare`) that do not change x."""

    mode: ContactMode
    x: Row
    forces: Forces
    spare: list[Forces]
    loose: bool  # whether nothing holds some massless part, so that its x is meaningless
    consistent: bool = True
    obeys: bool | None = None  # whether the forces obey the inequalities of the mode; None if not checked


Equation = list[Number]  # coefficients, the right side last


class Unknowns(NamedTuple):
    """The symbolic solution of one contact mode, with the pivots (divisors) and the undetermined force patterns."""

    x: list[Number]
    rows: dict[int, Number]  # multipliers of the acting rows
    friction: dict[int, Number]  # of the sticking rough contacts
    pivots: list[Number]
    free: "tuple[FreeForces, ...]" = ()


class FreeForces(NamedTuple):
    """A pattern of constraint forces that does not affect the motion."""

    rows: dict[int, Number]
    friction: dict[int, Number]


def solve_symbolic(equations: list[Equation], size: int, active: list[int], sticking: list[int]) -> Unknowns:
    """Solve for `size` accelerations, then the multipliers of `active` rows, then the friction of `sticking` contacts.

    An unknown that redundant constraints leave undetermined is zero.
    """
    solve = core.solve_symbols if core is not None and equations else eliminated_symbols
    unknowns, free, pivots = solve(equations)
    rows, friction = _named(unknowns, size, active, sticking)
    spare = tuple(FreeForces(*_named(numbers, size, active, sticking)) for column, numbers in free if column >= size)
    return Unknowns(unknowns[:size], rows, friction, pivots, spare)


def eliminated_symbols(
    equations: list[Equation],
) -> tuple[list[Number], list[tuple[int, list[Number]]], list[Number]]:
    """Return all unknowns, the unknowns for each free one, with its index, if that is 1, and the pivots.

    The equations are modified.
    """
    width = len(equations[0]) - 1 if equations else 0
    scales = [max((abs(float_value(entry)) for entry in row[:width]), default=0.0) or 1.0 for row in equations]
    pending = list(zip(equations, scales, strict=True))
    solved: list[tuple[int, Equation]] = []
    left: list[int] = []
    for column in range(width):
        best = max(pending, key=lambda item, c=column: abs(float_value(item[0][c])) / item[1], default=None)
        if best is None or abs(float_value(best[0][column])) / best[1] <= PIVOT_RTOL:
            left.append(column)
            continue
        pending = [item for item in pending if item is not best]
        for row, _ in pending:
            _reduce(row, best[0], column)
        solved.append((column, best[0]))
    found = _symbols_substituted(solved, [0.0] * width, load=True)
    free = [
        (column, _symbols_substituted(solved, [float(i == column) for i in range(width)], load=False))
        for column in left
    ]
    return found, free, [row[column] for column, row in solved]


def _symbols_substituted(solved: list[tuple[int, Equation]], unknowns: list[Number], *, load: bool) -> list[Number]:
    """Return all unknowns by back substitution, given the free ones; without `load` the right sides are zero."""
    width = len(unknowns)
    for column, row in reversed(solved):
        total: Number = row[width] if load else 0.0
        for other in range(column + 1, width):
            if not _is_zero(row[other]) and not _is_zero(unknowns[other]):
                total = total - row[other] * unknowns[other]
        unknowns[column] = total / row[column]
    return unknowns


def _named(
    unknowns: list[Number], size: int, active: list[int], sticking: list[int]
) -> tuple[dict[int, Number], dict[int, Number]]:
    """Return the multipliers by row index, and the friction by index of the rough contact."""
    rows = dict(zip(active, unknowns[size : size + len(active)], strict=True))
    return rows, dict(zip(sticking, unknowns[size + len(active) :], strict=True))


def _reduce(row: Equation, pivot: Equation, column: int) -> None:
    """Eliminate one unknown from a row in place by a pivot row."""
    if _is_zero(row[column]):
        return
    factor = row[column] / pivot[column]
    row[column] = 0.0
    for other in range(column + 1, len(row)):
        if not _is_zero(pivot[other]):
            row[other] = row[other] - factor * pivot[other]


def _is_zero(entry: Number) -> bool:
    return type(entry) is float and entry == 0.0

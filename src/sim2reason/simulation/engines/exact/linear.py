"""Small linear systems, of about ten unknowns, that may be singular.

Plain lists beat arrays at this size, above all since most rows are nearly empty, and elimination by hand
says what a library call hides: which unknowns the equations leave free.
"""

from dataclasses import dataclass
from operator import mul

Row = list[float]
NEGLIGIBLE = 1e-11  # of a row's largest entry: what rounding leaves of a pivot that should be zero


@dataclass(slots=True)
class Solved:
    """All solutions of a linear system: `x` + any combination of `nulls`."""

    x: Row
    nulls: list[Row]
    consistent: bool


def dot(a: Row, b: Row) -> float:
    """The scalar product; the shorter one sets the length."""
    return sum(map(mul, a, b))


def solve(rows: list[Row]) -> Solved:
    """Solve the equations `row[:-1] · x = row[-1]` by Gaussian elimination with row pivoting.

    There may be more or fewer equations than unknowns. Unknowns that are free are 0 in `x`, and 1, one
    after the other, in the `nulls`. The list of rows is used up.
    """
    size = len(rows[0]) - 1 if rows else 0
    pending = [_scaled(row, size) for row in rows]
    pivots: list[tuple[int, Row]] = []
    free: list[int] = []
    for column in range(size):
        best, largest = None, NEGLIGIBLE
        for row in pending:
            entry = abs(row[column])
            if entry > largest:
                best, largest = row, entry
        if best is None:
            free.append(column)
            continue
        pending = [_freed(row, best, column) if row[column] else row for row in pending if row is not best]
        pivots.append((column, best))
    consistent = all(abs(row[size]) <= 100.0 * NEGLIGIBLE * (1.0 + abs(row[size + 1])) for row in pending)
    x = _substituted(pivots, [0.0] * size, 1.0)
    return Solved(x, [_null(pivots, size, column) for column in free], consistent)


def _scaled(row: Row, size: int) -> Row:
    """Divide by the largest coefficient; a last entry keeps the right side for scale, as elimination shrinks it."""
    largest = max(map(abs, row[:size]))
    if largest in (0.0, 1.0):  # as of a string's row
        return [*row, row[size]]
    factor = 1.0 / largest
    scaled = [factor * entry for entry in row]
    scaled.append(scaled[size])
    return scaled


def _freed(row: Row, pivot: Row, column: int) -> Row:
    """A row freed of the unknown that the pivot settles."""
    factor = row[column] / pivot[column]
    freed = [a - factor * b for a, b in zip(row, pivot, strict=True)]
    freed[column], freed[-1] = 0.0, max(abs(row[-1]), abs(factor * pivot[-1]))
    return freed


def _substituted(pivots: list[tuple[int, Row]], x: Row, load: float) -> Row:
    size = len(x)
    for column, row in reversed(pivots):
        x[column] = (load * row[size] - dot(x, row)) / row[column]
    return x


def _null(pivots: list[tuple[int, Row]], size: int, column: int) -> Row:
    x = [0.0] * size
    x[column] = 1.0
    return _substituted(pivots, x, 0.0)

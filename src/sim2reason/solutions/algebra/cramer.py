"""Linear equations with symbols as coefficients, by determinants (G. Cramer, 1750)."""

from collections.abc import Iterator, Sequence
from itertools import permutations

from sim2reason.solutions.algebra.expressions import ZERO, Expression
from sim2reason.solutions.algebra.fractions import over
from sim2reason.solutions.algebra.polynomials import Polynomial, total

Rows = Sequence[Sequence[Polynomial]]


def cramer(rows: Rows, right: Sequence[Polynomial]) -> list[Expression]:
    """The unknowns, (n,), of as many equations whose determinant is not zero."""
    below = determinant(rows)
    found: list[Expression] = []
    for n in range(len(rows)):
        above = determinant([_put(row, n, held) for row, held in zip(rows, right, strict=True)])
        found.append(over(above, below) if above else ZERO)
    return found


def _put(row: Sequence[Polynomial], place: int, held: Polynomial) -> list[Polynomial]:
    return [held if n == place else part for n, part in enumerate(row)]


def determinant(rows: Rows) -> Polynomial:
    """By Leibniz's formula."""
    parts: list[Polynomial] = []
    for sign, order in signed_permutations(len(rows)):
        product = Polynomial.of(sign)
        for row, j in zip(rows, order, strict=True):
            product = product * row[j]
        parts.append(product)
    return total(parts)


def signed_permutations(size: int) -> Iterator[tuple[float, tuple[int, ...]]]:
    """All orders of so many numbers, each with its sign: 1 if it takes an even number of swaps, else −1."""
    for order in permutations(range(size)):
        swaps = sum(a > b for n, a in enumerate(order) for b in order[n + 1 :])
        yield (-1.0 if swaps % 2 else 1.0), order

"""Equations with one unknown, all else in numbers: solved in closed form where that is possible.

Formulas put into each other may be too long to be written. In numbers, many of them are still quotients of polynomials
of the second degree in the unknown, or of sums of its sine and cosine. Which of these they are shows in their values:
those at a few points determine the coefficients, and those at further points must agree.
"""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from sim2reason.dsl.state import Array
from sim2reason.solutions.algebra.evaluated import Chain, ClosedRoot, NumericRoot
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Number, Symbol, added, ratio
from sim2reason.solutions.algebra.functions import Call, Power, summed
from sim2reason.solutions.algebra.inverse import solved_for

WINDOWS = (0.3, 3.0), (0.7, 1.4)  # times the unknown: where formulas are looked at, the second if they end before
POINTS = 14
EXACT = 1e-11  # relative: how well the values must agree
SHOWN = 1e-9  # of the largest term: what is less has no place in an equation that is told
MEANS = 1e-13  # of the largest coefficient: what is less is left by rounding

Basis = Sequence[Expression]


def closed_root(chain: Chain, at: Symbol, unknown: str, values: Mapping[str, float]) -> ClosedRoot | None:
    """Return the unknown for which a chain of formulas has the value of `at`; None if no closed form is found."""
    target, near = values[at.name], values[unknown]
    for power in (1, 2):  # the square of a speed may be simple where the speed is not
        for basis in _bases(Symbol(unknown)):
            seen = _sampled(chain, unknown, values)
            equation = _equation(seen, basis, unknown, power, target) if seen is not None else None
            closed = solved_for(unknown, equation, ZERO, {unknown: near}) if equation is not None else None
            if equation is not None and closed is not None and not isinstance(closed, NumericRoot):
                return ClosedRoot(added(chain, -at), unknown, near, equation, closed)
    return None


def _bases(x: Symbol) -> Iterator[Basis]:
    """The functions of the unknown of which both sides of a fraction are sums."""
    yield ONE, x
    yield ONE, Call("sin", x), Call("cos", x)
    yield ONE, x, Power(x, 2)


def _sampled(chain: Chain, unknown: str, values: Mapping[str, float]) -> tuple[Array, Array] | None:
    """Values of the unknown about its own, and those of the chain; None where it has none."""
    for first, last in WINDOWS:
        points = values[unknown] * np.geomspace(first, last, POINTS)
        try:
            found = [chain.value({**values, unknown: x}) for x in points.tolist()]
        except (ValueError, ArithmeticError):
            continue
        if all(isinstance(value, float) for value in found):
            return points, np.array(found)
    return None


def fraction_in(chain: Chain, at: Symbol, unknown: str, values: Mapping[str, float]) -> tuple[Expression, Expression]:
    """Return both sides of the equation whose root `closed_root` found: `at`, or its square, and a fraction."""
    seen = _sampled(chain, unknown, values)
    assert seen is not None
    for power in (1, 2):
        for basis in _bases(Symbol(unknown)):
            if (parts := _parts(seen, basis, unknown, power)) is not None:
                sizes = [max(abs(held.value({unknown: x})) for x in seen[0].tolist()) for held in basis]
                sums = [_summed(basis, part, np.array(sizes)) for part in (p / _largest(parts[1]) for p in parts)]
                return Power(at, power) if power > 1 else at, ratio(*sums)
    raise ValueError("the chain is no fraction of such sums")


def _equation(seen: tuple[Array, Array], basis: Basis, unknown: str, power: int, target: float) -> Expression | None:
    """What vanishes at the root, if the values are those of a quotient of two sums of functions; else None."""
    parts = _parts(seen, basis, unknown, power)
    if parts is None:
        return None
    found = parts[0] - target**power * parts[1]
    return _summed(basis, found / np.abs(found).max())


def _summed(basis: Basis, parts: Array, sizes: Array | None = None) -> Expression:
    """Return a sum of functions, by their `sizes` if these are given, without those that are left by rounding."""
    terms = np.abs(parts if sizes is None else parts * sizes)
    kept = terms > (MEANS if sizes is None else SHOWN) * terms.max()
    return summed(Number(part) * held for held, part, keeps in zip(basis, parts.tolist(), kept, strict=True) if keeps)


def _largest(parts: Array) -> float:
    return float(parts[np.abs(parts).argmax()])


def _parts(seen: tuple[Array, Array], basis: Basis, unknown: str, power: int) -> tuple[Array, Array] | None:
    """The coefficients of both sums, if the values are those of a quotient of two sums of functions; else None."""
    points, values = seen
    columns = np.array([[held.value({unknown: x}) for held in basis] for x in points.tolist()])
    whole = np.hstack([columns, -(values**power)[:, None] * columns])
    sizes = np.abs(whole).max(axis=0)
    if not np.all(np.isfinite(whole)) or np.any(sizes == 0.0):
        return None
    _, singular, rows = np.linalg.svd(whole / sizes)
    if singular[-1] > EXACT * singular[0] or singular[-2] <= EXACT * singular[0]:
        return None
    above, below = np.split(rows[-1] / sizes, 2)
    return above, below

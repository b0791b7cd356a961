"""Standard forms of equations that reduce to a quadratic, or to a linear one in the sine and cosine of an angle."""

from functools import reduce

from sim2reason.solutions.algebra.closed_roots import (
    Written,
    atoms_worked,
    coefficient,
    fraction,
    raised,
    without_radicals,
)
from sim2reason.solutions.algebra.expressions import Expression, Symbol, added, multiplied
from sim2reason.solutions.algebra.functions import Call
from sim2reason.solutions.algebra.polynomials import Polynomial, common, divided


def stated_equation(
    name: str, formula: Expression, value: Expression, written: Written
) -> tuple[Expression, Expression] | None:
    """Reduce an equation to a x² + b x = c or a sin x + b cos x = c; return both sides, or None if it is neither.

    The first may also be one in the sine or in the cosine of x.
    """
    try:
        zero = without_radicals((fraction(atoms_worked(formula, name)) + fraction(-value)).above, name)
    except OverflowError:
        return None
    zero = divided(zero, common([*zero.terms]), 1.0) or zero
    symbol, sine, cosine = Symbol(name), Call("sin", Symbol(name)), Call("cos", Symbol(name))
    squares = ((atom, atom, (2, 1)) for atom in (symbol, sine, cosine))
    for first, second, powers in (*squares, (sine, cosine, (1, 1))):
        parts = [coefficient(zero, atom, power) for atom, power in zip((first, second), powers, strict=True)]
        rest = zero
        for part, atom, power in zip(parts, (first, second), powers, strict=True):
            rest = rest - part * Polynomial({((atom, power),): 1.0})
        if (
            not all(parts)
            or name in rest.expression().symbols()
            or any(name in p.expression().symbols() for p in parts)
        ):
            continue
        sign = -1.0 if written(parts[0]).negative else 1.0
        terms = (
            multiplied(written(part.scaled(sign)), raised(atom, power))
            for part, atom, power in zip(parts, (first, second), powers, strict=True)
        )
        return reduce(added, terms), written(rest.scaled(-sign))
    return None

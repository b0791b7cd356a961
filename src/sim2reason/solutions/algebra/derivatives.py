"""Symbolic derivatives of formulas."""

from functools import reduce

from sim2reason.solutions.algebra.expressions import (
    ONE,
    ZERO,
    Expression,
    Number,
    Product,
    Quotient,
    Sum,
    Symbol,
    added,
    multiplied,
)
from sim2reason.solutions.algebra.functions import Call, Function, Power, Root


def derivative(held: Expression, name: str) -> Expression:
    """Return the derivative of a formula with respect to a symbol; TypeError for a part without a known rule."""
    if name not in held.symbols():
        return ZERO
    match held:
        case Symbol():
            found = ONE
        case Sum():
            found = reduce(added, (derivative(term, name) for term in held.terms))
        case Product():
            found = reduce(added, (_by_one(held, number, name) for number in range(len(held.factors))))
        case Quotient():
            above, below = derivative(held.above, name), derivative(held.below, name)
            top = added(multiplied(above, held.below), -multiplied(held.above, below))
            found = above / held.below if below == ZERO else top / Power(held.below, 2)
        case Power():
            rest = held.base if held.exponent == 2 else Power(held.base, held.exponent - 1)
            found = multiplied(Number(float(held.exponent)), multiplied(rest, derivative(held.base, name)))
        case Root():
            found = derivative(held.inside, name) / multiplied(Number(2.0), held)
        case Call():
            found = multiplied(_outer(held), derivative(held.argument, name))
        case _:
            raise TypeError(f"no rule for the derivative of {type(held).__name__}")
    return found


def _by_one(held: Product, number: int, name: str) -> Expression:
    """Return a product with one factor replaced by its derivative."""
    factors = (derivative(f, name) if n == number else f for n, f in enumerate(held.factors))
    return reduce(multiplied, factors)


def _outer(held: Call) -> Expression:
    """Return the derivative of a function with respect to its argument."""
    x = held.argument
    arc = Root(ONE - Power(x, 2))
    rules: dict[Function, Expression] = {
        "sin": Call("cos", x),
        "cos": -Call("sin", x),
        "tan": ONE / Power(Call("cos", x), 2),
        "arctan": ONE / (ONE + Power(x, 2)),
        "arcsin": ONE / arc,
        "arccos": -(ONE / arc),
        "ln": ONE / x,
        "exp": held,
    }
    return rules[held.function]

"""Equations a sin x + b cos x = c, solved as one of a single sine: which sine that is, and what else x may be."""

from collections.abc import Sequence
from math import pi

from sim2reason.solutions.algebra.expressions import Expression, Number, Product, Sum
from sim2reason.solutions.algebra.functions import Call
from sim2reason.solutions.solution import with_unit
from sim2reason.solutions.writing.unit_latex import DEGREES


def single_sine(name: str, found: Expression) -> str:
    """Write a sin x + b cos x as a multiple of one sine if x is arcsin(…) ± arctan(…); return "" for any other x."""
    if not isinstance(found, Sum) or len(found.terms) != 2:
        return ""
    signed = {pair[1].function: pair for term in found.terms if (pair := _signed(term)) is not None}
    if signed.keys() != {"arcsin", "arctan"}:
        return ""
    sign, inner = signed["arctan"]
    argument = inner.argument
    if argument.negative:
        sign, argument = -sign, -argument
    turn = Call("arctan", argument).latex()
    return rf"The left side is a multiple of $\sin\left({name} {'-' if sign > 0.0 else '+'} {turn}\right)$"


def beyond_right_angle(others: Sequence[float], value: float) -> str:
    """State that the other solution for an angle exceeds 90°; return "" if it does not."""
    if len(others) != 1 or not 0.0 < value <= 0.5 * pi < others[0]:
        return ""
    return f"The other solution, ${with_unit(others[0], DEGREES)}$, is more than $90^\\circ$."


def _signed(held: Expression) -> tuple[float, Call] | None:
    """Return the sign of a term ± f(…) and the function without it; None for other terms."""
    match held:
        case Call():
            return 1.0, held
        case Product((Number(-1.0), Call() as inner)):
            return -1.0, inner
        case _:
            return None

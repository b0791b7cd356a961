"""The last touch to a formula: no minus sign that a square takes away, no fraction under a root under a fraction."""

from sim2reason.solutions.expressions import Expression, Quotient, multiplied, ratio
from sim2reason.solutions.functions import Absolute, Power, Root


def tidied(held: Expression) -> Expression:
    """A formula with the same value, in each of whose parts signs and fractions stand as one would write them."""
    if not held.parts:
        return held
    found = held.built_of([tidied(part) for part in held.parts])
    match found:
        case Power(base, exponent) if exponent % 2 == 0 and base.negative:
            return Power(-base, exponent)
        case Absolute(inside) if inside.negative:
            return Absolute(-inside)
        case Quotient(above, Root(Quotient(over, under))):
            return multiplied(above, Root(ratio(under, over)))
        case _:
            return found

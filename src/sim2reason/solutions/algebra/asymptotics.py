"""Limits of formulas as one symbol tends to infinity or to zero."""

from collections.abc import Mapping
from functools import reduce

from sim2reason.solutions.algebra.expressions import (
    ONE,
    Expression,
    Product,
    Quotient,
    Sum,
    Symbol,
    added,
    multiplied,
)
from sim2reason.solutions.algebra.functions import Absolute, Call, Power, Root

CANCELLATION_RTOL = 1e-9  # relative: a smaller sum of leading terms counts as zero


class CancelledError(Exception):
    """An error raised if the leading terms of a sum cancel, so that the limit needs terms of higher order."""


def limit(held: Expression, name: str, at: Mapping[str, float], *, large: bool) -> Expression | None:
    """Return the limit of a formula as a symbol tends to infinity (`large`) or zero; None if it is zero or infinite.

    `at` has values of the other symbols, which show the terms that cancel.

    Raises:
        CancelledError: leading terms cancel.
        TypeError: no rule is known for a part of the formula.
    """
    leading, power = _leading(held, name, at, 1.0 if large else -1.0)
    return leading if power == 0.0 else None


def _leading(held: Expression, name: str, at: Mapping[str, float], sense: float) -> tuple[Expression, float]:
    """Return coefficient and exponent of a formula's leading term for a symbol going to infinity (`sense` 1) or 0."""
    if name not in held.symbols():
        return held, 0.0
    match held:
        case Symbol():
            found: tuple[Expression, float] = ONE, 1.0
        case Sum():
            found = _of_sum(held, name, at, sense)
        case Product():
            parts = [_leading(factor, name, at, sense) for factor in held.factors]
            found = reduce(multiplied, (part for part, _ in parts)), sum(power for _, power in parts)
        case Quotient():
            (above, high), (below, low) = (_leading(part, name, at, sense) for part in (held.above, held.below))
            found = above / below, high - low
        case Power():
            base, power = _leading(held.base, name, at, sense)
            found = Power(base, held.exponent), held.exponent * power
        case Root() | Absolute():
            inside, power = _leading(held.inside, name, at, sense)
            found = held.built_of([inside]), power if isinstance(held, Absolute) else 0.5 * power
        case Call():
            argument, power = _leading(held.argument, name, at, sense)
            if power != 0.0:
                raise TypeError("no rule for a function of what grows or vanishes")
            found = Call(held.function, argument), 0.0
        case _:
            raise TypeError(f"no rule for the limit of {type(held).__name__}")
    return found


def _of_sum(held: Sum, name: str, at: Mapping[str, float], sense: float) -> tuple[Expression, float]:
    """Return coefficient and exponent of a sum's leading term; CancelledError if its leading terms cancel."""
    parts = [_leading(term, name, at, sense) for term in held.terms]
    most = max(sense * power for _, power in parts)
    kept = [part for part, power in parts if sense * power == most]
    values = [part.value(at).real for part in kept]
    if abs(sum(values)) <= CANCELLATION_RTOL * max(map(abs, values)):
        raise CancelledError("leading terms cancel")
    return reduce(added, kept), sense * most

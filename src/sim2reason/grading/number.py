"""Numbers: one finite value, in the asked unit or converted to it, within a relative tolerance."""

import math

from sim2reason.dsl.units import Dimension, Unit, parse_unit
from sim2reason.grading import arithmetic
from sim2reason.grading.extract import boxed, last_number
from sim2reason.grading.parser import parse
from sim2reason.grading.score import Outcome, Refused, Score
from sim2reason.grading.statement import last_side, unit_of

__all__ = ["number"]


def number(
    response: str,
    reference: float,
    unit: str | None = None,
    *,
    tolerance: float = 0.05,
    lenient: bool = False,
) -> Score:
    """Grade a boxed number against `reference`, which is in `unit`.

    Args:
        response: the whole text, with its thinking.
        reference: the true value, finite.
        unit: a unit of the table; "" for a pure number, None where the unit is not known and a stated one is
            ignored (but for per cent).
        tolerance: of |x - reference| relative to |reference|, inclusive; there is no absolute slack.
        lenient: without a box, take the last number. For evaluation, never for a reward.

    Raises:
        ValueError: for a reference that is not finite, a tolerance outside [0, 1), or a unit outside the table.
    """
    if not math.isfinite(reference) or not 0 <= tolerance < 1:
        raise ValueError("the reference must be finite and the tolerance in [0, 1)")
    asked = None if unit is None else parse_unit(unit)
    try:
        value, stated = _answer(response, lenient=lenient)
        return _judge(value, stated, reference, asked, tolerance)
    except Refused as refused:
        return refused.score


def _answer(response: str, *, lenient: bool) -> tuple[float, Unit | None]:
    """The value in the box and the unit stated with it, if one is."""
    try:
        return _quantity(boxed(response))
    except Refused as refused:
        if not lenient or refused.outcome is not Outcome.NO_ANSWER:
            raise
    digits, tail = last_number(response)
    try:
        return _quantity(f"{digits} {tail}")
    except Refused:
        return _quantity(digits)


def _quantity(content: str) -> tuple[float, Unit | None]:
    tokens = last_side(content, frozenset())
    node, taken, refusal = parse(tokens, unit_follows=True)
    stated = unit_of(content, tokens[taken:], refusal) if taken < len(tokens) else None
    value = arithmetic.value(node, {})
    if value is None:
        raise Refused(Outcome.WRONG, "the value is not a finite real number")
    return value, stated


def _judge(value: float, stated: Unit | None, reference: float, asked: Unit | None, tolerance: float) -> Score:
    factor = _factor(stated, asked)
    expected = f"expected {_show(reference, asked)} within {100 * tolerance:g} %"
    said = _show(value, stated or asked)
    if factor is None:
        kind = f"quantity in {asked.display}" if asked and asked.name else "pure number"
        return Score.of(Outcome.WRONG_UNIT, value, f"{said} is no {kind}; {expected}")
    found = value * factor
    close = abs(found - reference) <= tolerance * abs(reference)
    converted = f"{said} is {_show(found, asked)}" if factor != 1 else f"the answer is {said}"
    return Score.of(Outcome.CORRECT if close else Outcome.WRONG, found, f"{converted}; {expected}")


def _factor(stated: Unit | None, asked: Unit | None) -> float | None:
    if stated is None:
        return 1.0
    if asked is None:
        return stated.factor if stated.dimension == Dimension() else 1.0
    return stated.factor_to(asked)


def _show(value: float, unit: Unit | None) -> str:
    return unit.quantity(f"{value:.6g}") if unit else f"{value:.6g}"

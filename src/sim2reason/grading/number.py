"""Grading of numbers: one finite value, in the requested unit or converted to it, within a relative tolerance."""

import math
import re
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

from sim2reason.grading import arithmetic, labels, remarks
from sim2reason.grading.extract import boxed
from sim2reason.grading.lenient import last_quantity
from sim2reason.grading.number_units import find_left_unit, may_be, smaller_part
from sim2reason.grading.parser import parse
from sim2reason.grading.remarks import Remark
from sim2reason.grading.score import Outcome, Refused, Score
from sim2reason.grading.sides import (
    Statement,
    flatten,
    is_signed,
    more_or_less,
    statement,
    two_values,
    unwrap,
)
from sim2reason.grading.spelling import normalize_spelling, strip_unmatched_braces
from sim2reason.grading.tokens import Token, tokenize
from sim2reason.grading.units import parse_answer_unit
from sim2reason.scenes.dsl.units import Dimension, Unit, UnitError, parse_unit

__all__ = ["number", "unit_stated"]

SIDES_RTOL = 0.05  # relative difference between two sides that count as equal
_NO_REMARK = Remark()
_PART = re.compile(r"\s*\\text\s*\{\s*\((?:[a-dA-D]|i{1,3}|iv)\)\s*\}(?=\s*[-−+.0-9])")
"""The letter of a part of a problem. An e would be a number, and one in italics a symbol."""
_TO_ONE = re.compile(r":\s*1")
"""How a ratio may end: *0.42 : 1*."""
_RECIPROCAL = re.compile(r"1\s*/")


class _Quantity(NamedTuple):
    """A value parsed from an answer, with its unit if one is stated, and the remark after it."""

    value: float
    unit: Unit | None = None
    signed: bool = False
    remark: Remark = _NO_REMARK

    def signed_by(self, positive: str, *, below_zero: bool) -> "_Quantity":
        """Return the quantity with the sign given by the direction in its remark; Refused if the sign is undefined."""
        sign = remarks.sign_for(self.remark.directions, positive, written=self.signed, below_zero=below_zero)
        return self._replace(value=sign * self.value)


def number(
    response: object,
    reference: float,
    unit: str | Unit | None = None,
    *,
    tolerance: float = 0.05,
    positive: str = "",
    lenient: bool = False,
) -> Score:
    r"""Grade the number in the box of a response.

    Args:
        response: The whole text with its thinking, or a list of messages, of which the last counts. Any other object
            has no answer.
        reference: The right value, finite, in `unit`.
        unit: A unit or its name, such as ``m/s^2``; "" for a pure number. If it is None, a stated unit is ignored,
            except for per cent.
        tolerance: Greatest |x - reference| relative to |reference|; there is no absolute tolerance.
        positive: Direction that counts as positive, in the words of the question; empty for a magnitude.
        lenient: Whether to take the last number if there is no box; for evaluation, never for a reward.

    Returns:
        The score, with the number that was read in `unit`.

    Raises:
        ValueError: The reference is not finite, the tolerance is outside [0, 1), or the unit is unknown.

    Examples:
        >>> from sim2reason.grading import number
        >>> number(r"The speed is \boxed{36 km/h}.", 10.0, "m/s")
        <Score 1: correct, parsed=10.0>
        >>> number(r"\boxed{10 kg}", 10.0, "m/s").outcome.value
        'wrong unit'
    """
    if not math.isfinite(reference) or not 0 <= tolerance < 1:
        raise ValueError("the reference must be finite and the tolerance in [0, 1)")
    target_unit = parse_unit(unit) if isinstance(unit, str) else unit
    try:
        quantity = _answer(response, target_unit, lenient=lenient)
        signed = quantity.signed_by(positive, below_zero=reference < 0) if quantity.remark.directions else quantity
        if quantity.remark.again:
            _check_again(quantity, signed, target_unit, positive)
        return _judge(signed.value, quantity.unit, reference, target_unit, tolerance)
    except Refused as refused:
        return refused.score


def unit_stated(content: str) -> Unit | None:
    """Return the unit stated in an answer; None if there is none, or if the answer is not a number."""
    try:
        return _stated(content, None).unit
    except Refused:
        return None


def _answer(response: object, target_unit: Unit | None, *, lenient: bool) -> _Quantity:
    """Return the quantity in the box of a response."""
    try:
        return _stated(boxed(response), target_unit)
    except Refused as refused:
        if not lenient or refused.outcome is not Outcome.NO_ANSWER:
            raise
    first: Refused | None = None
    for content in last_quantity(response):
        try:
            return _stated(content, target_unit)
        except Refused as refused:
            first = first or refused
    raise first or Refused(Outcome.NO_ANSWER, "there is neither a box nor a number")


def _stated(content: str, target_unit: Unit | None) -> _Quantity:
    """Return the quantity after the last equals sign of an answer, if the sides before it agree with it."""
    content = normalize_spelling(content.rstrip(" \t\n."))
    part = _PART.match(content)
    content = content[part.end() :] if part is not None else content
    stated = statement(flatten(tokenize(content, frozenset())))
    try:
        quantity = _quantity(content, stated.value, target_unit)
    except Refused as refused:
        if stated.doubt is None or refused.outcome is not Outcome.UNREADABLE:
            raise
        raise more_or_less(stated.doubt) from refused
    if quantity.unit is None:
        quantity = quantity._replace(unit=find_left_unit(content, stated.before, target_unit))
    _check(content, stated, quantity, target_unit)
    return quantity


def _quantity(content: str, tokens: Sequence[Token], target_unit: Unit | None) -> _Quantity:
    node, taken, refusal = parse(tokens, unit_follows=True)
    value = arithmetic.value(node, {})
    if value is None:
        raise Refused(Outcome.WRONG, "the value is not a finite real number")
    unit, remark = None, _NO_REMARK
    if taken < len(tokens):
        tail = strip_unmatched_braces(content[tokens[taken].begin : tokens[-1].finish])
        try:
            unit, remark = _behind(tail, target_unit, refusal)
        except Refused:
            two = smaller_part(tokens[taken - 1].text, tail, target_unit) if taken <= 2 else None
            if two is None:
                raise
            unit, value = two[0], value + math.copysign(two[1], value)
    return _Quantity(value, unit, is_signed(tokens) or value < 0, remark)


def _behind(tail: str, target_unit: Unit | None, refusal: Refused | None) -> tuple[Unit | None, Remark]:
    """Return the unit and the remark in the text after a value."""
    if tail[0] == ":" and _TO_ONE.fullmatch(tail) and (target_unit is None or not any(target_unit.dimension)):
        return None, _NO_REMARK
    if tail[0].isdigit() and not _RECIPROCAL.match(tail):
        raise refusal or Refused(Outcome.UNREADABLE, "two numbers stand side by side")
    try:
        return parse_answer_unit(tail, target_unit), _NO_REMARK
    except UnitError as error:
        problem = error
    name, remark_text = remarks.cut(tail)
    if not remark_text and name.strip(" .}\\"):
        raise refusal or Refused(Outcome.UNREADABLE, f"{tail!r} after the value: {problem}")
    remark = remarks.read(remark_text)
    if not remarks.is_blank(name):
        try:
            return parse_answer_unit(name, target_unit), remark
        except UnitError as error:
            raise Refused(Outcome.UNREADABLE, f"{name.strip()!r} after the value: {error}") from error
    return None, remark


def _check(content: str, stated: Statement, quantity: _Quantity, target_unit: Unit | None) -> None:
    """Raise Refused if a side of the equation before the value has another value."""
    for side in map(unwrap, stated.before):
        shown = content[side[0].begin : side[-1].finish]
        try:
            claim = _claim(content, side, target_unit)
        except Refused as refused:
            stated.refuse_unsolved(side)
            raise Refused(Outcome.UNREADABLE, f"{shown!r} before the value: {refused.why}") from refused
        if claim is None:
            stated.refuse_unsolved(side)
            _refuse_others(shown, stated, side, target_unit)
        elif not _agree(claim, quantity, target_unit):
            raise Refused(Outcome.WRONG, f"{shown!r} does not agree with the value behind it")
    for side in stated.others:
        if (other := _step(content, side, target_unit)) is not None and not _agree(other, quantity, target_unit):
            raise two_values()


def _step(content: str, side: Sequence[Token], target_unit: Unit | None) -> _Quantity | None:
    """Return the value that an intermediate step assigns to another name; None for an expression of symbols.

    None also if the unit shows that the value cannot be the answer.
    """
    try:
        claim = _claim(content, side, target_unit)
    except Refused:
        if labels.is_symbolic(side):
            return None
        raise
    if (
        claim is not None
        and claim.unit is not None
        and target_unit is not None
        and claim.unit.factor_to(target_unit) is None
    ):
        return None
    return claim


def _check_again(quantity: _Quantity, signed: _Quantity, target_unit: Unit | None, positive: str) -> None:
    """Raise Refused if a remark after the value, as in *9.8 N (10 N)*, repeats it with another value."""
    for text in quantity.remark.again:
        again = _quantity(text, statement(flatten(tokenize(text, frozenset()))).value, target_unit)
        has_direction = again.remark.directions and not again.signed
        if has_direction and positive:
            agrees = _agree(again.signed_by(positive, below_zero=False), signed, target_unit)
        elif has_direction:
            agrees = _agree(again, quantity._replace(value=abs(quantity.value)), target_unit)
        else:
            agrees = _agree(again, signed if again.signed else quantity, target_unit)
        if not agrees:
            raise Refused(Outcome.WRONG, f"{text!r} in brackets does not agree with the value before it")


def _refuse_others(shown: str, stated: Statement, side: Sequence[Token], target_unit: Unit | None) -> None:
    """Raise Refused for a side of the equation that names a quantity of another dimension than the requested one."""
    if target_unit is None:
        return
    pure = any(target_unit.dimension) and labels.is_pure(side)
    if pure or not (stated.named or may_be(side, target_unit)):
        raise Refused(
            Outcome.UNREADABLE, f"{shown!r} before the value is no quantity in {target_unit.display or 'numbers'}"
        )


def _claim(content: str, side: Sequence[Token], target_unit: Unit | None) -> _Quantity | None:
    """Return the quantity on a side of an equation with numbers; None for a name or an expression of symbols.

    Raises `Refused` for unreadable numbers.
    """
    if not labels.has_numbers(side) or labels.is_bare(side):
        return None
    try:
        return _quantity(content, side, target_unit)
    except Refused:
        if labels.is_plain(side) or not any(token.kind == "word" for token in side):
            raise
        return None


def _agree(one: _Quantity, other: _Quantity, target_unit: Unit | None) -> bool:
    """Return whether two quantities are equal: bare numbers in either's unit, SI units or the requested unit."""
    if one.unit is not None and other.unit is not None:
        factor = one.unit.factor_to(other.unit)
        return factor is not None and _is_close(one.value * factor, other.value)
    units = [unit for unit in (one.unit, other.unit, target_unit) if unit is not None]
    return any(_is_close(mine, yours) for mine in _readings(one, units) for yours in _readings(other, units))


def _readings(quantity: _Quantity, units: Sequence[Unit]) -> list[float]:
    """Return the values in SI units that a quantity may have, a bare number in any of some units or in SI units."""
    if quantity.unit is not None:
        return [quantity.value * quantity.unit.factor]
    return [quantity.value, *(quantity.value * unit.factor for unit in units)]


def _is_close(one: float, other: float) -> bool:
    return abs(one - other) <= SIDES_RTOL * max(abs(one), abs(other))


def _judge(value: float, stated: Unit | None, reference: float, target_unit: Unit | None, tolerance: float) -> Score:
    factor = _factor(stated, target_unit)
    expected = f"expected {_show(reference, target_unit)} within {100 * tolerance:g} %"
    shown = _show(value, stated or target_unit)
    if factor is None:
        kind = f"quantity in {target_unit.display}" if target_unit and target_unit.name else "pure number"
        return Score.of(Outcome.WRONG_UNIT, value, f"{shown} is no {kind}; {expected}")
    actual = value * factor
    close = abs(actual - reference) <= tolerance * abs(reference)
    converted = f"{shown} is {_show(actual, target_unit)}" if factor != 1 else f"the answer is {shown}"
    return Score.of(Outcome.CORRECT if close else Outcome.WRONG, actual, f"{converted}; {expected}")


def _factor(stated: Unit | None, target_unit: Unit | None) -> float | None:
    if stated is None:
        return 1.0
    if target_unit is None:
        return stated.factor if stated.dimension == Dimension() else 1.0
    return stated.factor_to(target_unit)


def _show(value: float, unit: Unit | None) -> str:
    return _template(unit).replace("#", f"{value:.6g}") if unit else f"{value:.6g}"


@lru_cache(maxsize=256)
def _template(unit: Unit) -> str:
    """Return the format of a number in a unit, with # for the number."""
    return unit.quantity("#")

"""Grading of numbers: one finite value, in the requested unit or converted to it, within a relative tolerance."""

import math
import re
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

from sim2reason.grading import arithmetic, labels, remarks
from sim2reason.grading.extract import boxed
from sim2reason.grading.lenient import last_quantity
from sim2reason.grading.number_units import may_be, smaller_part, unit_on_left
from sim2reason.grading.parser import parse
from sim2reason.grading.remarks import Remark
from sim2reason.grading.score import Outcome, Refused, Score
from sim2reason.grading.sides import (
    Statement,
    flattened,
    is_signed,
    more_or_less,
    statement,
    two_values,
    unwrapped,
)
from sim2reason.grading.spelling import balanced, spelled
from sim2reason.grading.tokens import Token, tokenize
from sim2reason.grading.units import unit_in
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
    asked = parse_unit(unit) if isinstance(unit, str) else unit
    try:
        said = _answer(response, asked, lenient=lenient)
        signed = said.signed_by(positive, below_zero=reference < 0) if said.remark.directions else said
        if said.remark.again:
            _check_again(said, signed, asked, positive)
        return _judge(signed.value, said.unit, reference, asked, tolerance)
    except Refused as refused:
        return refused.score


def unit_stated(content: str) -> Unit | None:
    """Return the unit stated in an answer; None if there is none, or if the answer is not a number."""
    try:
        return _stated(content, None).unit
    except Refused:
        return None


def _answer(response: object, asked: Unit | None, *, lenient: bool) -> _Quantity:
    """Return the quantity in the box of a response."""
    try:
        return _stated(boxed(response), asked)
    except Refused as refused:
        if not lenient or refused.outcome is not Outcome.NO_ANSWER:
            raise
    first: Refused | None = None
    for content in last_quantity(response):
        try:
            return _stated(content, asked)
        except Refused as refused:
            first = first or refused
    raise first or Refused(Outcome.NO_ANSWER, "there is neither a box nor a number")


def _stated(content: str, asked: Unit | None) -> _Quantity:
    """Return the quantity after the last equals sign of an answer, if the sides before it agree with it."""
    content = spelled(content.rstrip(" \t\n."))
    part = _PART.match(content)
    content = content[part.end() :] if part is not None else content
    said = statement(flattened(tokenize(content, frozenset())))
    try:
        found = _quantity(content, said.value, asked)
    except Refused as refused:
        if said.doubt is None or refused.outcome is not Outcome.UNREADABLE:
            raise
        raise more_or_less(said.doubt) from refused
    if found.unit is None:
        found = found._replace(unit=unit_on_left(content, said.before, asked))
    _check(content, said, found, asked)
    return found


def _quantity(content: str, tokens: Sequence[Token], asked: Unit | None) -> _Quantity:
    node, taken, refusal = parse(tokens, unit_follows=True)
    value = arithmetic.value(node, {})
    if value is None:
        raise Refused(Outcome.WRONG, "the value is not a finite real number")
    unit, remark = None, _NO_REMARK
    if taken < len(tokens):
        tail = balanced(content[tokens[taken].begin : tokens[-1].finish])
        try:
            unit, remark = _behind(tail, asked, refusal)
        except Refused:
            two = smaller_part(tokens[taken - 1].text, tail, asked) if taken <= 2 else None
            if two is None:
                raise
            unit, value = two[0], value + math.copysign(two[1], value)
    return _Quantity(value, unit, is_signed(tokens) or value < 0, remark)


def _behind(tail: str, asked: Unit | None, refusal: Refused | None) -> tuple[Unit | None, Remark]:
    """Return the unit and the remark in the text after a value."""
    if tail[0] == ":" and _TO_ONE.fullmatch(tail) and (asked is None or not any(asked.dimension)):
        return None, _NO_REMARK
    if tail[0].isdigit() and not _RECIPROCAL.match(tail):
        raise refusal or Refused(Outcome.UNREADABLE, "two numbers stand side by side")
    try:
        return unit_in(tail, asked), _NO_REMARK
    except UnitError as error:
        problem = error
    name, said = remarks.cut(tail)
    if not said and name.strip(" .}\\"):
        raise refusal or Refused(Outcome.UNREADABLE, f"{tail!r} after the value: {problem}")
    remark = remarks.read(said)
    if not remarks.is_blank(name):
        try:
            return unit_in(name, asked), remark
        except UnitError as error:
            raise Refused(Outcome.UNREADABLE, f"{name.strip()!r} after the value: {error}") from error
    return None, remark


def _check(content: str, said: Statement, found: _Quantity, asked: Unit | None) -> None:
    """Raise Refused if a side of the equation before the value has another value."""
    for side in map(unwrapped, said.before):
        shown = content[side[0].begin : side[-1].finish]
        try:
            claim = _claim(content, side, asked)
        except Refused as refused:
            said.refuse_unsolved(side)
            raise Refused(Outcome.UNREADABLE, f"{shown!r} before the value: {refused.why}") from refused
        if claim is None:
            said.refuse_unsolved(side)
            _refuse_others(shown, said, side, asked)
        elif not _agree(claim, found, asked):
            raise Refused(Outcome.WRONG, f"{shown!r} does not agree with the value behind it")
    for side in said.others:
        if (other := _step(content, side, asked)) is not None and not _agree(other, found, asked):
            raise two_values()


def _step(content: str, side: Sequence[Token], asked: Unit | None) -> _Quantity | None:
    """Return the value that an intermediate step assigns to another name; None for an expression of symbols.

    None also if the unit shows that the value cannot be the answer.
    """
    try:
        claim = _claim(content, side, asked)
    except Refused:
        if labels.is_symbolic(side):
            return None
        raise
    if claim is not None and claim.unit is not None and asked is not None and claim.unit.factor_to(asked) is None:
        return None
    return claim


def _check_again(said: _Quantity, signed: _Quantity, asked: Unit | None, positive: str) -> None:
    """Raise Refused if a remark after the value, as in *9.8 N (10 N)*, repeats it with another value."""
    for text in said.remark.again:
        again = _quantity(text, statement(flattened(tokenize(text, frozenset()))).value, asked)
        told = again.remark.directions and not again.signed
        if told and positive:
            agrees = _agree(again.signed_by(positive, below_zero=False), signed, asked)
        elif told:
            agrees = _agree(again, said._replace(value=abs(said.value)), asked)
        else:
            agrees = _agree(again, signed if again.signed else said, asked)
        if not agrees:
            raise Refused(Outcome.WRONG, f"{text!r} in brackets does not agree with the value before it")


def _refuse_others(shown: str, said: Statement, side: Sequence[Token], asked: Unit | None) -> None:
    """Raise Refused for a side of the equation that names a quantity of another dimension than the requested one."""
    if asked is None:
        return
    pure = any(asked.dimension) and labels.is_pure(side)
    if pure or not (said.named or may_be(side, asked)):
        raise Refused(Outcome.UNREADABLE, f"{shown!r} before the value is no quantity in {asked.display or 'numbers'}")


def _claim(content: str, side: Sequence[Token], asked: Unit | None) -> _Quantity | None:
    """Return the quantity on a side of an equation with numbers; None for a name or an expression of symbols.

    Raises `Refused` for unreadable numbers.
    """
    if not labels.has_numbers(side) or labels.is_bare(side):
        return None
    try:
        return _quantity(content, side, asked)
    except Refused:
        if labels.is_plain(side) or not any(token.kind == "word" for token in side):
            raise
        return None


def _agree(one: _Quantity, other: _Quantity, asked: Unit | None) -> bool:
    """Return whether two quantities are equal: bare numbers in either's unit, SI units or the requested unit."""
    if one.unit is not None and other.unit is not None:
        factor = one.unit.factor_to(other.unit)
        return factor is not None and _near(one.value * factor, other.value)
    return any(_near(mine, yours) for mine in _readings(one, asked) for yours in _readings(other, asked))


def _readings(said: _Quantity, asked: Unit | None) -> list[float]:
    unit = said.unit or asked
    factor = said.unit.factor_to(asked) if said.unit is not None and asked is not None else None
    found = [said.value, said.value * unit.factor if unit is not None else said.value]
    return [*found, said.value * factor] if factor is not None else found


def _near(one: float, other: float) -> bool:
    return abs(one - other) <= SIDES_RTOL * max(abs(one), abs(other))


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
    return _template(unit).replace("#", f"{value:.6g}") if unit else f"{value:.6g}"


@lru_cache(maxsize=256)
def _template(unit: Unit) -> str:
    """Return the format of a number in a unit, with # for the number."""
    return unit.quantity("#")

"""Units of a numeric answer: several in one value, to its left, and letters of another dimension.

A value such as *1 h 5 min 20 s* or 26°30′ has several units in decreasing order; headings have one to the left. Usual
meanings of letters show that *xy* is not a length, and *a/g* not an acceleration. The table contains only meanings
common to textbooks; a letter with several meanings has all of them, and other letters may mean anything.
"""

import re
from collections.abc import Iterable, Sequence
from itertools import product
from typing import Final

from sim2reason.grading import arithmetic, labels
from sim2reason.grading.arithmetic import Node
from sim2reason.grading.parser import parse
from sim2reason.grading.remarks import printed_text
from sim2reason.grading.score import Outcome, Refused
from sim2reason.grading.spelling import strip_unmatched_braces
from sim2reason.grading.tokens import Token
from sim2reason.grading.units import parse_answer_unit
from sim2reason.scenes.dsl.units import Dimension, Unit, UnitError, parse_unit

__all__ = ["find_left_unit", "may_be", "smaller_part"]

MINUTES_PER_DEGREE: Final = 60  # minutes in a degree, and seconds in a minute

_PARTS: Final = re.compile(
    r"\s*(?P<unit>[A-Za-z]{1,12})(?P<rest>(?:\s*[0-9]{1,4}(?:\.[0-9]{1,6})?\s*[A-Za-z]{1,12}){1,3})\s*"
)
_PART: Final = re.compile(r"([0-9.]+)\s*([A-Za-z]+)")
_ARC: Final = re.compile(
    r"\s*(?:\^\s*\\circ|\^\s*\{\s*\\circ\s*\}|\^?°|\\degree)\s*(?P<minutes>[0-9]{1,2}(?:\.[0-9]{1,6})?)"
    r"\s*(?:['′]|\^?\s*\{?\s*\\prime\s*\}?)"
    r"(?:\s*(?P<seconds>[0-9]{1,2}(?:\.[0-9]{1,6})?)\s*(?:''|″|′′|\"|\^?\s*\{?\s*\\prime\s*\\prime\s*\}?))?\s*"
)


def smaller_part(amount: str, tail: str, target_unit: Unit | None) -> tuple[Unit, float] | None:
    """Return the first unit of a value such as 1 h 5 min, and the amount of the smaller parts in that unit.

    None if there is no such value, or if the same number occurs with two units, which is ambiguous.
    """
    if not amount.isdecimal():
        return None
    if arc := _ARC.fullmatch(re.sub(r"\\[ ,;:!]", " ", tail)):
        return _of_arc(arc)
    match = _PARTS.fullmatch(printed_text(tail))
    if match is None:
        return None
    parts = _PART.findall(match["rest"])
    return None if len(parts) == 1 and parts[0][0] == amount else _added(match["unit"], parts, target_unit)


def _added(first_unit: str, parts: list[tuple[str, str]], target_unit: Unit | None) -> tuple[Unit, float] | None:
    """Return the first unit and the sum of the smaller parts in that unit; None if a part is not smaller than one."""
    try:
        unit, *smaller = [parse_answer_unit(word, target_unit) for word in (first_unit, *(word for _, word in parts))]
    except UnitError:
        return None
    total, last = 0.0, 1.0
    for (number, _), below in zip(parts, smaller, strict=True):
        factor = below.factor_to(unit)
        share = float(number) * factor if factor is not None else last
        if share >= last:  # more than one of the unit before it
            return None
        total, last = total + share, factor or last
    return unit, total


def _of_arc(match: re.Match[str]) -> tuple[Unit, float] | None:
    """Return the degree as a unit, and the minutes and seconds of arc in degrees; None if either is 60 or more."""
    minutes, seconds = float(match["minutes"]), float(match["seconds"] or 0)
    return (parse_unit("deg"), minutes / 60 + seconds / 3600) if max(minutes, seconds) < MINUTES_PER_DEGREE else None


_LABELS: Final = frozenset("ABC")  # of bodies and points, unless the asked unit says that they are units
_BEHIND: Final = frozenset({"of", "for", "at", "on"})  # words that may follow a unit: *speed in m/s of A*
_MAX_UNIT_TOKENS: Final = 16  # tokens of a unit


def find_left_unit(content: str, sides: Iterable[Sequence[Token]], target_unit: Unit | None) -> Unit | None:
    """Return the unit stated before the equals sign for a value without one; Refused if two are stated."""
    stated_unit: Unit | None = None
    for side in sides:
        for tokens in _candidates(content, side):
            text = strip_unmatched_braces(content[tokens[0].begin : tokens[-1].finish])
            try:
                unit = parse_answer_unit(text, target_unit)
            except UnitError:
                continue
            if text in _LABELS and (target_unit is None or unit.factor_to(target_unit) is None):
                continue
            if stated_unit is not None and stated_unit.factor_to(unit) != 1:
                raise Refused(
                    Outcome.UNREADABLE, f"the units {stated_unit.display} and {unit.display} before the value"
                )
            stated_unit = unit
    return stated_unit


def _candidates(content: str, side: Sequence[Token]) -> Iterable[Sequence[Token]]:
    """Yield the tokens before a value that may be its unit: in brackets, after *in*, or upright after a name."""
    named = False
    for at, token in enumerate(side):
        if token.kind == "open" and token.text in "([":
            inside = _take_until_closed(side, at + 1)
            slashed = any(piece.kind == "slash" for piece in inside)
            if inside and (token.text == "[" or slashed or inside[0].upright):
                yield inside
        elif token.kind == "word" and token.text == "in":
            rest = _take_until_closed(side, at + 1)
            end = next((n for n, word in enumerate(rest) if word.text in _BEHIND), len(rest))
            if end:
                yield rest[:end]
        elif named and _stands_apart(content, side, at):
            yield side[at : at + _MAX_UNIT_TOKENS]
            return
        named = named or (not token.upright and bool(labels.names([token])) and not labels.is_change(token))


def _take_until_closed(side: Sequence[Token], start: int) -> Sequence[Token]:
    depth = 0
    for at in range(start, min(len(side), start + _MAX_UNIT_TOKENS)):
        depth += (side[at].kind == "open") - (side[at].kind == "close")
        if depth < 0:
            return side[start:at]
    return side[start : start + _MAX_UNIT_TOKENS]


def _stands_apart(content: str, side: Sequence[Token], at: int) -> bool:
    """Return whether a token may be a unit: a percent or degree sign, or an upright word apart from the name before."""
    token = side[at]
    if token.kind in {"percent", "degree"}:
        return True
    spaced = token.apart or side[at - 1].kind == "slash" or content[token.begin - 1].isspace()
    return token.kind == "word" and token.upright and bool(spaced)


_USUAL: Final[dict[str, tuple[Dimension, ...]]] = {
    letter: tuple(parse_unit(unit).dimension for unit in units.split())
    for units, letters in (
        ("kg", "m M"),
        ("m", "x y z h H d D r R l L"),
        ("m s", "s"),
        ("s", "t"),
        ("m/s", "v u"),
        ("m/s^2", "g"),
        ("m/s^2 m", "a"),
        ("N", "F"),
        ("kg*m/s Pa", "p"),
        ("J", "E K"),
    )
    for letter in letters.split()
}
_MAX_LETTERS: Final = 6  # letters of an expression
_UNIT_SCALES: Final = (1.9, 2.3, 3.1)  # factors by which the units of length, mass and time are enlarged
_SCALING_RTOL: Final = 1e-9


def may_be(side: Sequence[Token], unit: Unit) -> bool:
    """Return whether an expression may be a quantity in `unit`; False if its letters have another dimension."""
    symbols = labels.names(side)
    letters = list(dict.fromkeys(letter for letter, _ in symbols))
    if len(symbols) <= 1 or len(letters) > _MAX_LETTERS or any(letter not in _USUAL for letter in letters):
        return True
    node = _expression(side)
    if node is None:
        return True
    meanings = [
        dict(zip(letters, dimensions, strict=True)) for dimensions in product(*(_USUAL[letter] for letter in letters))
    ]
    return any(_has_dimension(node, dimensions, unit.dimension) for dimensions in meanings)


def _expression(side: Sequence[Token]) -> Node | None:
    """Parse a side as an expression of letters and numbers; None if it is not one."""
    tokens = list[Token]()
    for token in side:
        letters = labels.names([token])
        if token.kind in {"word", "symbol"} and not letters:
            return None
        if token.kind == "mark":
            continue
        named = (token._replace(kind="symbol", text=letter) for letter, _ in letters)
        tokens += named if letters else [token]
    try:
        node, taken, _ = parse(tokens, unit_follows=False)
    except Refused:
        return None
    return node if taken == len(tokens) else None


def _has_dimension(node: Node, dimensions: dict[str, Dimension], wanted: Dimension) -> bool:
    """Return whether an expression has a dimension, by its scaling with the units of length, mass and time."""
    here = arithmetic.value(node, {letter: 1.0 + 0.3 * index for index, letter in enumerate(dimensions)})
    if not here:
        return True
    for axis, scale in enumerate(_UNIT_SCALES):
        larger = {letter: (1.0 + 0.3 * n) * scale ** dimensions[letter][axis] for n, letter in enumerate(dimensions)}
        there = arithmetic.value(node, larger)
        if there is not None and abs(there - here * scale ** wanted[axis]) > _SCALING_RTOL * abs(there):
            return False
    return True

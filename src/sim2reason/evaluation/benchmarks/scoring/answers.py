"""Answers in a response: boxes, letters, numbers, and expressions compared by value, one or several."""

import re
from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import Final, TypeVar

from sim2reason.grading import FormulaError, Outcome, arithmetic, formula, number
from sim2reason.grading.arithmetic import Node, draw_points
from sim2reason.grading.extract import MAX_ANSWER_LENGTH, closed_boxes, content, fault_of_box, response_text
from sim2reason.grading.number import unit_stated
from sim2reason.grading.parser import parse
from sim2reason.grading.score import Refused
from sim2reason.grading.sides import flatten
from sim2reason.grading.spelling import normalize_spelling
from sim2reason.grading.tokens import Token, tokenize
from sim2reason.grading.units import parse_answer_unit
from sim2reason.scenes.dsl.units import Unit, UnitError, parse_unit

__all__ = [
    "after_thinking",
    "agrees",
    "chosen",
    "equal_expressions",
    "equivalent_equations",
    "find_boxes",
    "has_perfect_matching",
    "is_equation",
    "parts",
    "read",
    "same_text",
    "unboxed_options",
    "unit_or_none",
    "value_name",
    "wrap_in_box",
]

MAX_BOXES: Final = 64  # boxes examined, the last ones
_AND: Final = re.compile(r"\\text\s*\{\s*and\s*\}|(?<![A-Za-z\\])and(?![A-Za-z])|\\quad|\\qquad")
_BLANK: Final = re.compile(r"(?<!\\)\\[,;: ]|\$")
_THOUSANDS: Final = re.compile(r"(?<=\d)(?:,|\{,\})(?=\d{3}(?!\d))")
OPENS, CLOSES = "([{", ")]}"


def after_thinking(response: str) -> str:
    """Return the text after the thinking; empty if that never ends or the response is far too long."""
    try:
        return response_text(response)
    except Refused:
        return ""


def find_boxes(response: str) -> list[str]:
    """Return the contents of all outermost, visible, undenied boxes after the thinking, in order."""
    text = after_thinking(response)
    spans: list[tuple[int, int]] = []
    for begin, end in closed_boxes(text):
        while spans and spans[-1][0] > begin:  # boxes within this one
            spans.pop()
        spans.append((begin, end))
    contents = (content(text, span) for span in spans[-MAX_BOXES:] if not fault_of_box(text, *span))
    return [answer for answer in contents if answer.strip() and len(answer) <= MAX_ANSWER_LENGTH]


def wrap_in_box(answer: str) -> str:
    """Return a response that consists only of this answer in a box."""
    return rf"\boxed{{{answer}}}"


def parts(answer: str, *, thousands: bool = True) -> list[str]:
    """Return the parts between commas, semicolons or *and* outside brackets, without dollar signs.

    With `thousands`, a comma before three digits belongs to a number.
    """
    text = _AND.sub(",", _BLANK.sub(" ", answer))
    text = _THOUSANDS.sub("", text) if thousands else text
    pieces, depth, start = list[str](), 0, 0
    for position, sign in enumerate(text):
        depth += (sign in OPENS) - (sign in CLOSES)
        if sign in ",;" and depth <= 0:
            pieces.append(text[start:position])
            start = position + 1
    pieces.append(text[start:])
    return [part.strip().rstrip(".") for part in pieces if part.strip(" .")]


TAIL_LENGTH: Final = 1000  # characters at the end that are searched for an answer without a box
_DRESS: Final = re.compile(
    r"\\(?:text|textbf|textrm|mathrm|mathbf|bf|rm|boldsymbol|mathsf)(?![A-Za-z])|\\[,;: &]|[{}$*~]"
)
_WORDS: Final = re.compile(r"\b(?:and|only|options?|answers?|choices?|is|are|the|correct)\b|&", re.IGNORECASE)
_LETTERS: Final = re.compile(r"[\s(),;./\[\]|]*([A-D](?:[\s(),;./\[\]|]*[A-D])*)[\s(),;./\[\]|:]*")
_LABELLED: Final = re.compile(r"\s*(?:\(([A-D])\)|([A-D])[).:])\s*\S.*", re.DOTALL)
_LABEL: Final = re.compile(r"\([A-D]\)|(?<![A-Za-z])[A-D][).:]")
_NONE: Final = re.compile(r"\s*none(?: of (?:the|these)(?: above| options)?)?\s*", re.IGNORECASE)
_SAID: Final = re.compile(
    r"(?:[Aa]nswers?|[Oo]ptions?|[Cc]hoices?)\b[^A-Za-z\n]{0,4}(?:(?:is|are|would be|must be)\b)?"
    r"[\s:*]{0,6}(?:options?\b)?[\s:*]{0,4}"
    r"((?:[(\[]?[A-D][)\]]?(?![a-z])(?:\s*(?:,|and|&)?\s*(?=[(\[]?[A-D][)\]]?(?![a-z])))?)+)"
)


def chosen(content: str) -> frozenset[str] | None:
    """Return the options in an answer such as ``A``, ``(A), (C)``, ``ABD`` or ``B) 6.4 J``; None if it is not one.

    *None* and *none of these* give an empty set.
    """
    if _NONE.fullmatch(content):
        return frozenset()
    plain = _DRESS.sub(" ", content)
    match = _LETTERS.fullmatch(_WORDS.sub(" ", plain))
    if match is not None:
        return frozenset(re.findall("[A-D]", match[1]))
    match = _LABELLED.fullmatch(plain)
    if match is not None and len(_LABEL.findall(plain)) == 1:
        return frozenset(match[1] or match[2])
    return None


def unboxed_options(response: str) -> frozenset[str] | None:
    """Return the options in the last *answer is …* near the end of a response; None if there is none."""
    *_, last = [None, *_SAID.finditer(after_thinking(response)[-TAIL_LENGTH:])]
    return None if last is None else frozenset(re.findall("[A-D]", last[1]))


def read(content: str, unit: str | Unit | None = None, *, expected: float = 1.0) -> float | None:
    """Return the only number in an answer, in `unit` if given; None if there is none, or in another unit.

    `expected`, a reference value, determines the sign of a direction without one.
    """
    score = number(wrap_in_box(content), expected, unit)
    return (
        score.parsed if score.outcome in {Outcome.CORRECT, Outcome.WRONG} and isinstance(score.parsed, float) else None
    )


def agrees(right: str, submitted: str, tolerance: float) -> bool | None:
    """Return whether two answers give the same number, within a tolerance relative to the right answer.

    None if the correct answer is not a number. Its unit applies to both; without a unit, the other's is ignored.
    """
    stated = unit_stated(right)
    unit = stated if stated is not None and any(stated.dimension) else None
    value, other = read(right, unit), read(submitted, unit)
    if value is None:
        return None
    return other is not None and abs(other - value) <= tolerance * abs(value)


def unit_or_none(text: object) -> str | None:
    """Return the name of a unit of the library's table; None for an unknown or missing unit."""
    if not isinstance(text, str) or not text.strip(" $"):
        return None
    try:
        return parse_unit(parse_answer_unit(text.strip(" $"), None).name).name
    except UnitError:
        return None


EQUALITY_RTOL = 1e-6  # relative tolerance at each test point
_UPRIGHT: Final = re.compile(r"\\(?:text|textrm|textbf|mathrm|mbox)\{([^{}]*)\}")
_NAME: Final = re.compile(
    r"(?:[A-Za-z]|\\[A-Za-z]+)(?:\s*_(?:[A-Za-z0-9]|\{[^{}=]*(?:\{[^{}=]*\})?\}))?(?:\s*\([^()=]*\))?"
)


def same_text(one: str, other: str) -> bool:
    """Return whether two answers are the same text, apart from blanks, dollars, upright fonts and bracket sizes."""
    return bool(one.strip()) and _squeezed(one) == _squeezed(other)


def _squeezed(text: str) -> str:
    for mark in (r"\left", r"\right", r"\,", r"\;", r"\!", "$", "~", " ", "\n", "\t"):
        text = text.replace(mark, "")
    text = text.rstrip(".")
    upright = _UPRIGHT.fullmatch(text)
    return upright[1] if upright else text


def value_name(text: str) -> str:
    """Return the name of the value in an answer, as in *v = …*; empty for a value alone and for an equation."""
    left, equals, _ = text.replace("$", "").partition("=")
    return left.replace("{", "").replace("}", "") if equals and _NAME.fullmatch(left.strip()) else ""


def is_equation(text: str) -> bool:
    """Return whether an answer is an equation between symbols, not only a named value."""
    return "=" in text and not value_name(text)


def equal_expressions(right: str, submitted: str) -> bool | None:
    """Return whether two expressions have equal values at all test points; None if one does not parse."""
    if same_text(right, submitted):
        return True
    try:
        score = formula(wrap_in_box(submitted), right.replace("$", ""))
    except FormulaError:
        return None
    if score.outcome in {Outcome.UNREADABLE, Outcome.NO_ANSWER, Outcome.TOO_LONG}:
        return None
    return score.outcome is Outcome.CORRECT


def equivalent_equations(right: str, submitted: str) -> bool | None:
    """Return whether two equations are equivalent: left minus right sides in constant ratio; None if unparsable."""
    if same_text(right, submitted):
        return True
    difference = _difference(right, None)
    if difference is None:
        return None
    node, symbols = difference
    other = _difference(submitted, symbols)
    points = list(draw_points(node, symbols, [], {}, right))
    if other is None or not points:
        return None
    pairs = [(arithmetic.value(other[0], point), arithmetic.value(node, point)) for point in points]
    ratios = [up / down if up is not None and down else 0.0 for up, down in pairs]
    first = ratios[0]
    return first != 0.0 and all(abs(ratio - first) <= EQUALITY_RTOL * abs(first) for ratio in ratios)


@lru_cache(maxsize=1024)
def _difference(equation: str, symbols: frozenset[str] | None) -> tuple[Node, frozenset[str]] | None:
    """Return the left side minus the right one, with the symbols in them; None unless it is one equation."""
    left, equals, right = equation.replace("&", "").replace("$", "").partition("=")
    if not equals or "=" in right:
        return None
    try:
        sides = [flatten(tokenize(normalize_spelling(side.strip()), symbols)) for side in (left, right)]
        nodes = [_whole(side) for side in sides]
    except (Refused, ValueError):
        return None
    used_symbols = frozenset(token.text for side in sides for token in side if token.kind == "symbol")
    return arithmetic.total([(nodes[0], False), (nodes[1], True)]), used_symbols


def _whole(tokens: Sequence[Token]) -> Node:
    node, taken, refusal = parse(list(tokens), unit_follows=False)
    if taken < len(tokens):
        raise refusal or Refused(Outcome.UNREADABLE, "there is more than one value")
    return node


T = TypeVar("T")


def has_perfect_matching(right: Sequence[T], submitted: Sequence[str], fits: Callable[[T, str], bool]) -> bool:
    """Return whether `right` and `submitted` can be matched one to one by `fits` (Kuhn's algorithm)."""
    if len(right) != len(submitted):
        return False
    good = [[place for place, answer in enumerate(submitted) if fits(each, answer)] for each in right]
    taken: dict[int, int] = {}

    def place(number: int, tried: set[int]) -> bool:
        for spot in good[number]:
            if spot not in tried:
                tried.add(spot)
                if spot not in taken or place(taken[spot], tried):
                    taken[spot] = number
                    return True
        return False

    return all(place(number, set()) for number in range(len(right)))

"""Expressions and equations in answers, compared by value wherever their symbols are set."""

import re
from collections.abc import Sequence
from functools import lru_cache
from typing import Final

from sim2reason.evaluation.benchmarks.scoring.parts.answers import in_box
from sim2reason.grading import FormulaError, Outcome, arithmetic, formula
from sim2reason.grading.arithmetic import Node
from sim2reason.grading.parser import parse
from sim2reason.grading.points import drawn
from sim2reason.grading.score import Refused
from sim2reason.grading.sides import flattened
from sim2reason.grading.spelling import spelled
from sim2reason.grading.tokens import Token, tokenize

__all__ = [
    "equal_expressions",
    "equivalent_equations",
    "is_equation",
    "name_of",
    "same_text",
]

EQUAL = 1e-6  # relative, at each point that is tried
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


def name_of(text: str) -> str:
    """Return what an answer calls its value, as in *v = …*; empty for a value alone and for an equation."""
    left, equals, _ = text.replace("$", "").partition("=")
    return left.replace("{", "").replace("}", "") if equals and _NAME.fullmatch(left.strip()) else ""


def is_equation(text: str) -> bool:
    """Return whether an answer relates its symbols, and does not merely name a value."""
    return "=" in text and not name_of(text)


def equal_expressions(right: str, said: str) -> bool | None:
    """Whether `said` has the value of `right` wherever their symbols are set; None if one of them can't be read."""
    if same_text(right, said):
        return True
    try:
        score = formula(in_box(said), right.replace("$", ""))
    except FormulaError:
        return None
    if score.outcome in {Outcome.UNREADABLE, Outcome.NO_ANSWER, Outcome.TOO_LONG}:
        return None
    return score.outcome is Outcome.CORRECT


def equivalent_equations(right: str, said: str) -> bool | None:
    """Whether two equations say the same: the differences of their sides have one ratio; None if one can't be read."""
    if same_text(right, said):
        return True
    held = _difference(right, None)
    if held is None:
        return None
    node, symbols = held
    other = _difference(said, symbols)
    points = list(drawn(node, symbols, [], {}, right))
    if other is None or not points:
        return None
    pairs = [(arithmetic.value(other[0], point), arithmetic.value(node, point)) for point in points]
    ratios = [up / down if up is not None and down else 0.0 for up, down in pairs]
    first = ratios[0]
    return first != 0.0 and all(abs(ratio - first) <= EQUAL * abs(first) for ratio in ratios)


@lru_cache(maxsize=1024)
def _difference(equation: str, symbols: frozenset[str] | None) -> tuple[Node, frozenset[str]] | None:
    """Return the left side less the right one, and the symbols in them; None for what is no single equation."""
    left, equals, right = equation.replace("&", "").replace("$", "").partition("=")
    if not equals or "=" in right:
        return None
    try:
        sides = [flattened(tokenize(spelled(side.strip()), symbols)) for side in (left, right)]
        nodes = [_whole(side) for side in sides]
    except (Refused, ValueError):
        return None
    found = frozenset(token.text for side in sides for token in side if token.kind == "symbol")
    return arithmetic.total([(nodes[0], False), (nodes[1], True)]), found


def _whole(tokens: Sequence[Token]) -> Node:
    node, taken, refusal = parse(list(tokens), unit_follows=False)
    if taken < len(tokens):
        raise refusal or Refused(Outcome.UNREADABLE, "there is more than one value")
    return node

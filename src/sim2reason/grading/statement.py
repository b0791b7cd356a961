"""What an answer states: one value, freed from wrappers and from the left-hand sides that led to it."""

from collections.abc import Collection, Sequence

from sim2reason.dsl.units import Unit, UnitError, parse_unit
from sim2reason.grading.alphabet import CLOSES
from sim2reason.grading.score import Outcome, Refused
from sim2reason.grading.tokens import Token, tokenize

__all__ = ["last_side", "unit_of"]


def last_side(content: str, symbols: Collection[str] | None) -> list[Token]:
    """The tokens of the last right-hand side of `content`, without the wrappers around it.

    Raises `Refused`: wrong where anything in `content` hedges (a list, a range, ±, "or", an inequality), and
    unreadable where nothing is left.
    """
    tokens = tokenize(content.rstrip(" \t\n."), symbols)
    for token in tokens:
        if token.kind == "hedge":
            raise Refused(Outcome.WRONG, f"{token.text!r} makes it more, or less, than one value")
    tokens = _unwrapped(tokens)
    depth = start = 0
    for position, token in enumerate(tokens):
        depth += (token.kind == "open") - (token.kind == "close")
        if token.kind == "relation" and depth == 0:
            start = position + 1
    tokens = _unwrapped(tokens[start:])
    if not tokens:
        raise Refused(Outcome.UNREADABLE, "there is nothing in the box that could be a value")
    return tokens


def _unwrapped(tokens: list[Token]) -> list[Token]:
    """Without the groups that enclose all of it: braces, parentheses, upright or bold text."""
    closings: dict[int, int] = {}
    stack: list[int] = []
    for position, token in enumerate(tokens):
        if token.kind == "open":
            stack.append(position)
        elif token.kind == "close" and stack and CLOSES[tokens[stack[-1]].text] == token.text:
            closings[stack.pop()] = position
    first, last = 0, len(tokens) - 1
    while first < last and closings.get(first) == last:
        first, last = first + 1, last - 1
    return tokens[first : last + 1]


def unit_of(content: str, rest: Sequence[Token], refusal: Refused | None) -> Unit:
    """The unit that the tokens after a value spell; raises `Refused` (unreadable) if they spell none."""
    text = content[rest[0].begin : rest[-1].finish]
    try:
        return parse_unit(text)
    except UnitError as error:
        raise refusal or Refused(Outcome.UNREADABLE, f"{text!r} after the value: {error}") from error

r"""Units to the left of a value, as in headings: ``\text{Speed (km/h): }9.8``, ``v\ [\text{m/s}] = 9.8``."""

from collections.abc import Iterable, Sequence
from typing import Final

from sim2reason.grading import labels
from sim2reason.grading.score import Outcome, Refused
from sim2reason.grading.spelling import balanced
from sim2reason.grading.tokens import Token
from sim2reason.grading.unit_spelling import unit_in
from sim2reason.scenes.dsl.units import Unit, UnitError

__all__ = ["unit_on_left"]

_LABELS: Final = frozenset("ABC")  # of bodies and points, unless the asked unit says that they are units
_BEHIND: Final = frozenset({"of", "for", "at", "on"})  # words that may follow a unit: *speed in m/s of A*
_LONGEST: Final = 16  # tokens of a unit


def unit_on_left(content: str, sides: Iterable[Sequence[Token]], asked: Unit | None) -> Unit | None:
    """Return the unit stated before the equals sign for a value without one; Refused if two are stated."""
    found: Unit | None = None
    for side in sides:
        for tokens in _candidates(content, side):
            text = balanced(content[tokens[0].begin : tokens[-1].finish])
            try:
                unit = unit_in(text, asked)
            except UnitError:
                continue
            if text in _LABELS and (asked is None or unit.factor_to(asked) is None):
                continue
            if found is not None and found.factor_to(unit) != 1:
                raise Refused(Outcome.UNREADABLE, f"the units {found.display} and {unit.display} before the value")
            found = unit
    return found


def _candidates(content: str, side: Sequence[Token]) -> Iterable[Sequence[Token]]:
    """Yield the tokens before a value that may be its unit: in brackets, after *in*, or upright after a name."""
    named = False
    for at, token in enumerate(side):
        if token.kind == "open" and token.text in "([":
            inside = _until_closed(side, at + 1)
            slashed = any(piece.kind == "slash" for piece in inside)
            if inside and (token.text == "[" or slashed or inside[0].upright):
                yield inside
        elif token.kind == "word" and token.text == "in":
            rest = _until_closed(side, at + 1)
            end = next((n for n, word in enumerate(rest) if word.text in _BEHIND), len(rest))
            if end:
                yield rest[:end]
        elif named and _stands_apart(content, side, at):
            yield side[at : at + _LONGEST]
            return
        named = named or (not token.upright and bool(labels.names([token])) and not labels.is_change(token))


def _until_closed(side: Sequence[Token], start: int) -> Sequence[Token]:
    depth = 0
    for at in range(start, min(len(side), start + _LONGEST)):
        depth += (side[at].kind == "open") - (side[at].kind == "close")
        if depth < 0:
            return side[start:at]
    return side[start : start + _LONGEST]


def _stands_apart(content: str, side: Sequence[Token], at: int) -> bool:
    """Return whether a token may be a unit: a percent or degree sign, or an upright word apart from the name before."""
    token = side[at]
    if token.kind in {"percent", "degree"}:
        return True
    spaced = token.apart or side[at - 1].kind == "slash" or content[token.begin - 1].isspace()
    return token.kind == "word" and token.upright and bool(spaced)

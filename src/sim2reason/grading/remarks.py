r"""Remarks after a value and its unit: a direction, a comment, or the same value in another unit.

The vocabulary is a closed list without denials or alternatives, so that no remark changes the value. A direction never
changes a written sign, but gives one to a bare magnitude.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from sim2reason.grading.alphabet import COMMANDS, SIGNS, SPACES, alternatives_pattern
from sim2reason.grading.score import Outcome, Refused
from sim2reason.grading.units import is_unit

__all__ = [
    "APPROXIMATELY",
    "STARTERS",
    "Direction",
    "Remark",
    "begins",
    "cut",
    "find_direction",
    "is_blank",
    "printed_text",
    "read",
    "sign_for",
]

_DIRECTION_WORDS: Final[dict[str, tuple[str, int]]] = {
    word: (axis, sign)
    for axis, ahead, back in (
        ("up", "up upward upwards uphill upslope", "down downward downwards downhill downslope"),
        ("right", "right rightward rightwards", "left leftward leftwards"),
        ("forward", "forward forwards", "backward backwards back"),
        ("north", "north northward northwards", "south southward southwards"),
        ("east", "east eastward eastwards", "west westward westwards"),
        ("out", "outward outwards", "inward inwards"),
        ("turn", "counterclockwise anticlockwise ccw", "clockwise cw"),
        ("toward", "toward towards", "away opposite opposing against"),
        ("tension", "tension tensile stretched", "compression compressive compressed"),
        ("attraction", "attraction attractive", "repulsion repulsive"),
        ("increase", "increase gain gained", "decrease loss lost"),
        ("level", "above", "below"),
        ("any", "positive", "negative"),
        ("x", "+x", "-x"),
        ("y", "+y", "-y"),
        ("z", "+z", "-z"),
    )
    for words, sign in ((ahead, 1), (back, -1))
    for word in words.split()
}
_AXES: Final = {f"{axis}-axis": (axis, 1) for axis in "xyz"}
APPROXIMATELY: Final = frozenset({"approximately", "approx", "about", "roughly", "around", "circa", "ca"})
_THINGS: Final = """
    slope incline inclined plane ramp hill wall floor ground ceiling string rope cable rod spring surface horizontal
    vertical vertically horizontally axis center centre motion magnitude size speed velocity acceleration force momentum
    rounded exact exactly final answer net total angle equilibrium origin
    bottom top rest release collision impact start instantaneous average maximum minimum static kinetic friction normal
    pulley block cart mass ball bob wedge track face edge wire pivot hinge wheel disc disk line circle circular
    tangential tangentially radial radially object body initial initially
    same dimensionless unitless work energy heat done system earth
"""
_BETWEEN: Final = """
    the of in on along with into onto to from by at after before its direction directed directions pointing pointed
    acting moving going sense relative respect parallel perpendicular side both is it this that which
    straight given value component due
"""
_CONTENT: Final = frozenset(_THINGS.split()) | APPROXIMATELY | _DIRECTION_WORDS.keys() | _AXES.keys()
_FILLERS: Final = frozenset(_BETWEEN.split())
_WORDS: Final = _CONTENT | _FILLERS
STARTERS: Final = _WORDS | {"counter", "anti"} - {"is", "it", "this", "that", "which", "value"}
_ALTERNATIVES: Final = frozenset({"or", "and", "either", "not"})

_BREAK: Final = re.compile(
    rf"(?P<comma>(?<!\\)[,;])|(?P<bracket>[(\[])|(?P<arrow>\\(?:{alternatives_pattern('arrow')})(?![A-Za-z])|[→←↑↓])"
    r"|(?P<word>(?<![\\A-Za-z])[A-Za-z]{2,})"
)
_WRAPPER: Final = re.compile(
    rf"\\(?:{alternatives_pattern('open', '{')}|{'|'.join(SPACES)})(?![A-Za-z])|[{{}}$~]|\\[ ,;:!>]"
)
_ARROWS: Final = re.compile(rf"\\({alternatives_pattern('arrow')})(?![A-Za-z])|([→←↑↓])")
_COUNT: Final = r"(?:[0-9]{1,2}|one|two|three|four|five|six)"
_ACCURACY: Final = re.compile(
    rf"(?:(?:rounded|correct|given|accurate)\s+)?(?:to\s+)?{_COUNT}[\s-]*(?:s\.?\s?f\.?|sig(?:nificant)?\.?[\s-]*"
    r"(?:fig(?:ure)?s?|digits?)?\.?|d\.?\s?p\.?|decimal(?:\s(?:place|figure|digit)s?)?|decimals|digits?|figures?)"
    r"|no units?"
)
_AXIS: Final = re.compile(
    r"(?:(positive|negative|[-−–+])\s?|(positive|negative) (?:direction|sense) (?:of|along) (?:the )?)"
    r"([xyz])(?:[\s-]{1,4}(?:axis|direction))?\b"
)
_AGAIN: Final = re.compile(r"(?:=|≈|\\approx|\\simeq|\\sim|(?:about|approximately|approx\.?|roughly)(?=[\s\d]))\s*")
_AT_ANGLE: Final = re.compile(
    r"(?:\b(?:at|by|making)\s+)?(?:\ban?\s+angle\s+(?:of\s+)?)?\b[0-9]{1,3}(?:\.[0-9]{1,4})?\s*"
    r"(?:\^\s*\\circ|\^?°|degrees?\b|deg\b)(?=\s*(?:above|below|to|from|with|north|south|east|west|up|down)\b)"
)
"""The angle of the direction that a magnitude has: *at 30° above the horizontal*."""
_LETTER_AXIS: Final = re.compile(r"\b([xyz])[\s-]{1,4}(?:axis|direction)\b")


@dataclass(frozen=True, slots=True)
class Direction:
    """A direction stated after a value, such as *upwards* or *to the left*: an axis and a sign, +1 or −1."""

    axis: str
    sign: int


@dataclass(frozen=True, slots=True)
class Remark:
    """A parsed remark after a value: the directions in it, and the value as repeated in other units."""

    directions: tuple[Direction, ...] = ()
    again: tuple[str, ...] = ()


def begins(word: str) -> bool:
    """Return whether a word can begin a remark after a value, such as *upwards*; no unit can."""
    return word.lower() in STARTERS


def cut(tail: str) -> tuple[str, str]:
    """Split the text after a value into the unit and the remark."""
    for match in _BREAK.finditer(tail):
        kind = match.lastgroup
        if kind in {"comma", "arrow"} or (kind == "word" and begins(match[0])):
            return tail[: match.start()], tail[match.start() :]
        if kind == "bracket" and _remarks(tail[match.end() :]):
            return tail[: match.start()], tail[match.start() :]
    return tail, ""


def _remarks(inside: str) -> bool:
    """Return whether a bracket contains a remark and no unit."""
    plain = printed_text(inside).lstrip()
    word = re.match(r"[A-Za-zµΩ]+|[-−+≈=0-9]|\\approx", plain)
    if word is None or plain.startswith("1/"):
        return False
    return not word[0].isalpha() or begins(word[0]) or not is_unit(word[0])


def is_blank(text: str) -> bool:
    """Return whether a text is empty without its braces, spaces and full stops."""
    return not printed_text(text).strip(" \t\n.")


def printed_text(text: str) -> str:
    """Return a text with invisible commands and signs replaced by spaces."""
    return _WRAPPER.sub(" ", text)


def read(text: str) -> Remark:
    """Parse a remark.

    Raises `Refused`: wrong for a second value, unreadable for a word outside the vocabulary.
    """
    directions: list[Direction] = []
    again: list[str] = []
    for bracket, piece in _pieces(text):
        plain = printed_text(piece).strip(" \t\n.:")
        if not plain:
            continue
        if bracket and re.match(r"[-−+0-9\\.]", bare := _AGAIN.sub("", plain, count=1)) and not _accuracy(plain):
            again.append(bare)
            continue
        directions += _directions(plain)
    return Remark(tuple(directions), tuple(again))


def _pieces(text: str) -> list[tuple[bool, str]]:
    """Return the parts between commas and brackets, each with whether it was in brackets."""
    pieces: list[tuple[bool, str]] = []
    bracket, start = False, 0
    for match in re.finditer(r"(?<!\\)[,;]|[()\[\]]", text):
        if match[0] in ",;" and bracket:
            continue
        pieces.append((bracket, text[start : match.start()]))
        bracket, start = match[0] in "([", match.end()
    return [*pieces, (bracket, text[start:])]


def _accuracy(plain: str) -> bool:
    return _ACCURACY.fullmatch(plain.lower()) is not None


def _directions(plain: str) -> list[Direction]:
    """Return the directions in a phrase; every word must be in the vocabulary, and one must have a meaning."""
    if _accuracy(plain):
        return []
    words = _lowered(_AT_ANGLE.sub(" ", plain, count=1))
    if any(word in _ALTERNATIVES or re.search(r"[0-9]", word) for word in words):
        raise Refused(Outcome.WRONG, f"{plain!r} behind the value offers another")
    unknown = next((word for word in words if word not in _WORDS), None)
    if unknown is not None or not any(word in _CONTENT for word in words):
        shown = unknown or plain
        raise Refused(
            Outcome.UNREADABLE, f"{shown!r} after the value is neither a unit nor a remark that is known here"
        )
    return [Direction(*_DIRECTION_WORDS[word]) for word in words if word in _DIRECTION_WORDS]


def _lowered(plain: str) -> list[str]:
    """Return the words of a phrase in lower case: directions as keys of `_DIRECTION_WORDS`, axes as *x-axis*."""
    lowered = _ARROWS.sub(lambda arrow: f" {(COMMANDS[arrow[1]] if arrow[1] else SIGNS[arrow[2]])[1]} ", plain).lower()
    lowered = re.sub(r"\b(?:counter|anti)[\s-]clockwise\b", "counterclockwise", lowered)
    lowered = _AXIS.sub(lambda axis: f" {'-' if (axis[1] or axis[2]) in 'negative-−–' else '+'}{axis[3]} ", lowered)
    words = (word.strip(".,:;()") for word in re.split(r"[\s/]+", _LETTER_AXIS.sub(r"\1-axis", lowered)))
    return [word for word in words if word.strip("-")]


def find_direction(text: str) -> Direction | None:
    """Return the only direction in a text; None if there is none, or more than one."""
    words = _lowered(printed_text(text))
    directions = {_DIRECTION_WORDS[word] for word in words if word in _DIRECTION_WORDS} | {
        _AXES[word] for word in words if word in _AXES
    }
    return Direction(*directions.pop()) if len(directions) == 1 else None


def sign_for(directions: Sequence[Direction], positive: str, *, written: bool, below_zero: bool = False) -> int:
    """Return the sign, +1 or −1, that stated directions give to a value without a sign.

    `written` means that the value has a sign, `below_zero` that the reference is negative.
    """
    denied = any(direction.axis == "any" and direction.sign < 0 for direction in directions)
    if written or not directions or not (positive or below_zero or denied):
        return 1
    return _sign_of(directions, positive)


def _sign_of(directions: Sequence[Direction], positive: str) -> int:
    """Return the sign of a magnitude with a stated direction, given the positive direction; Refused if undefined."""
    sense = find_direction(positive)
    signs: set[int] = set()
    for direction in directions:
        if positive and direction.axis == "any":  # the positive or negative one, whichever that is
            signs.add(direction.sign)
        elif sense is not None and direction.axis == sense.axis:
            signs.add(direction.sign * sense.sign)
        else:
            signs |= {1, -1}
    if len(signs) != 1:
        convention = f"{positive!r} is positive" if positive else "nothing tells which way is positive"
        raise Refused(Outcome.UNREADABLE, f"directions stand in place of a sign, and {convention}")
    return signs.pop()

"""The last number of a response without a box, with what belongs to it: for evaluation, never for a reward.

As a reward it could be farmed by ending on a likely number.
"""

import re
from collections.abc import Iterator
from typing import Final

from sim2reason.dsl.units import UnitError
from sim2reason.grading.alphabet import HEDGES, SOFT_HEDGES
from sim2reason.grading.extract import MAX_ANSWER, spoken
from sim2reason.grading.score import Outcome, Refused
from sim2reason.grading.unit_spelling import unit_in

__all__ = ["last_quantity"]

MOST_WORDS: Final = 6  # of a unit

_NUMBER: Final = re.compile(
    r"(?<![\w.^{\\])(?<![\^{][-+−–])[-+−–]?(?:[0-9]{1,3}(?:,[0-9]{3})+|[0-9]+)(?:\.[0-9]+)?(?:[eE][-+]?[0-9]{1,4})?(?![0-9])"
    r"(?:[ ]?(?:\\times|\\cdot|×|·|\*|x)[ ]?10(?:\^\{?[-+−]?[0-9]{1,4}\}?|[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]{1,5}))?"
)
_OPERATES: Final = re.compile(
    r"(?:[/×·÷√^±<>≤≥(_]|(?<!\*)\*|[0-9})]\s*[-−–+]|\\(?:times|cdot|pm|frac|sqrt|to|leq?|geq?))\s*\Z"
)
_SENTENCE: Final = re.compile(r"[.!?](?=\s|\Z)|\n")


def last_quantity(response: object) -> Iterator[str]:
    """What the last number may stand for, the fullest first: with the rest of its sentence, or with its unit alone.

    Raises `Refused`: no answer where there is no number, unreadable where it is part of an expression.
    """
    text = spoken(response)[-MAX_ANSWER:]
    *_, last = [None, *_NUMBER.finditer(text)]
    if last is None:
        raise Refused(Outcome.NO_ANSWER, "there is neither a box nor a number")
    if _OPERATES.search(text[max(0, last.start() - 12) : last.start()]):
        raise Refused(Outcome.UNREADABLE, f"{last[0]} is a part of something longer")
    tail = _SENTENCE.split(text[last.end() :], maxsplit=1)[0].replace("**", " ").strip().rstrip("*$ ")
    yield f"{last[0]} {tail}"
    unit = _unit_before_prose(tail)
    if unit is not None:
        yield f"{last[0]} {unit}"


def _unit_before_prose(tail: str) -> str | None:
    """The unit that a sentence goes on with, empty after a comma; None where it may be about another value."""
    if tail.startswith(","):
        return "" if _is_prose(tail.split()) else None
    words = tail.split()
    for count in range(min(MOST_WORDS, len(words)), 0, -1):
        unit = " ".join(words[:count]).rstrip(",;:*$")
        try:
            unit_in(unit, None)
        except UnitError:
            continue
        return unit if _is_prose(words[count:]) else None
    return None


def _is_prose(words: list[str]) -> bool:
    """Whether words have no number and nothing that offers another value."""
    plain = {word.strip(",.;:()").lower() for word in words}
    return not plain & (HEDGES | SOFT_HEDGES - {"to", "and"}) and not any(
        re.search(r"[0-9<>±~]", word) for word in words
    )

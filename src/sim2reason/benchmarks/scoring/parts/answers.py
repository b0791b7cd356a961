r"""Where answers stand in a response: in its boxes, after the thinking."""

import re
from typing import Final

from sim2reason.grading.extract import MAX_ANSWER, closed_boxes, content, spoken
from sim2reason.grading.hiding import fault_of_box
from sim2reason.grading.score import Refused

__all__ = ["after_thinking", "boxes", "in_box", "parts"]

MOST: Final = 64  # boxes that are looked at, the last ones
_AND: Final = re.compile(r"\\text\s*\{\s*and\s*\}|(?<![A-Za-z\\])and(?![A-Za-z])|\\quad|\\qquad")
_BLANK: Final = re.compile(r"(?<!\\)\\[,;: ]|\$")
_THOUSANDS: Final = re.compile(r"(?<=\d)(?:,|\{,\})(?=\d{3}(?!\d))")
OPENS, CLOSES = "([{", ")]}"


def after_thinking(response: str) -> str:
    """What is said after the thinking; empty if that never ends or the response is far too long."""
    try:
        return spoken(response)
    except Refused:
        return ""


def boxes(response: str) -> list[str]:
    """The contents of all outermost boxes after the thinking, in order; none is longer than 1000 characters.

    Those that print hides or words deny are left out.
    """
    text = after_thinking(response)
    spans: list[tuple[int, int]] = []
    for begin, end in closed_boxes(text):
        while spans and spans[-1][0] > begin:  # boxes within this one
            spans.pop()
        spans.append((begin, end))
    found = (content(text, span) for span in spans[-MOST:] if not fault_of_box(text, *span))
    return [answer for answer in found if answer.strip() and len(answer) <= MAX_ANSWER]


def in_box(answer: str) -> str:
    """A response that has nothing but this answer."""
    return rf"\boxed{{{answer}}}"


def parts(answer: str, *, thousands: bool = True) -> list[str]:
    """What stands between commas, semicolons or *and* outside all brackets, without dollars.

    With `thousands` a comma before three digits belongs to a number.
    """
    text = _AND.sub(",", _BLANK.sub(" ", answer))
    text = _THOUSANDS.sub("", text) if thousands else text
    found, depth, start = list[str](), 0, 0
    for place, sign in enumerate(text):
        depth += (sign in OPENS) - (sign in CLOSES)
        if sign in ",;" and depth <= 0:
            found.append(text[start:place])
            start = place + 1
    found.append(text[start:])
    return [part.strip().rstrip(".") for part in found if part.strip(" .")]

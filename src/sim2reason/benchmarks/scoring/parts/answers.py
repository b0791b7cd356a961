r"""Where answers stand in a response: in its boxes, after the thinking."""

import re
from typing import Final

from sim2reason.grading.extract import MAX_ANSWER, spoken
from sim2reason.grading.score import Refused

__all__ = ["after_thinking", "boxes", "in_box", "parts"]

MOST: Final = 64  # boxes that are looked at, the last ones
_BRACE: Final = re.compile(r"\\boxed[ \t\n]{0,8}\{|\\[\\{}]|[{}]")
_AND: Final = re.compile(r"\\text\s*\{\s*and\s*\}|(?<![A-Za-z\\])and(?![A-Za-z])|\\quad|\\qquad")
_BLANK: Final = re.compile(r"(?<!\\)\\[,;: ]|\$")
OPENS, CLOSES = "([{", ")]}"


def after_thinking(response: str) -> str:
    """What is said after the thinking; empty if that never ends or the response is far too long."""
    try:
        return spoken(response)
    except Refused:
        return ""


def boxes(response: str) -> list[str]:
    """The contents of all outermost boxes after the thinking, in order; none is longer than 1000 characters."""
    text = after_thinking(response)
    found: list[str] = []
    depth: list[int] = []
    for match in _BRACE.finditer(text, max(text.find(r"\boxed"), 0)):
        brace = match[0]
        if brace == "}":
            begin = depth.pop() if depth else -1
            if begin >= 0 and not any(outer >= 0 for outer in depth):
                found.append(text[begin : match.start()])
        elif brace == "{" or brace.startswith(r"\boxed"):
            depth.append(match.end() if brace != "{" else -1)
    return [content for content in found[-MOST:] if content.strip() and len(content) <= MAX_ANSWER]


def in_box(content: str) -> str:
    """A response that has nothing but this answer."""
    return rf"\boxed{{{content}}}"


def parts(content: str) -> list[str]:
    """What stands between commas, semicolons or *and* outside all brackets, without dollars."""
    text = _AND.sub(",", _BLANK.sub(" ", content))
    text = re.sub(r"(?<=\d),(?=\d{3}(?!\d))", "", text)  # thousands
    found, depth, start = list[str](), 0, 0
    for place, sign in enumerate(text):
        depth += (sign in OPENS) - (sign in CLOSES)
        if sign in ",;" and depth <= 0:
            found.append(text[start:place])
            start = place + 1
    found.append(text[start:])
    return [part.strip().rstrip(".") for part in found if part.strip(" .")]

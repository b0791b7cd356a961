r"""Boxes that do not count as answers: boxes invisible when typeset, and boxes that the text denies.

A box is invisible inside a command such as ``\phantom`` or ``\cancel``, in white ink, in a comment of LaTeX or HTML,
or in a hidden element; it is denied by *not* before it or *is wrong* after it.
"""

import re
from typing import Final

from sim2reason.grading.alphabet import HIDING, INK

__all__ = ["fault_of_box"]

_STRIKING: Final = "x?cancel|bcancel|sout|st|xout"
_SCAN: Final = re.compile(
    rf"\\[\\{{}}]|(?P<switch>\\(?:transparent|opacity|iffalse)(?![A-Za-z]))"
    rf"|(?P<hide>\\(?:{HIDING}|{_STRIKING})(?![A-Za-z])\s*)"
    r"|(?P<show>\\fi(?![A-Za-z]))|(?P<ink>\\(?:text)?color(?![A-Za-z])\s*(?:\[[^\[\]]{0,20}\])?\s*\{(?P<name>[^{}]{0,40})\}\s*)"
    r"|(?P<brace>[{}])"
)
_INKS: Final = re.compile(rf"\s*(?:{INK})(?:!(?:[4-9][0-9]|100)(?:!black)?)?\s*")
_COMMENT: Final = re.compile(r"(?<![\\0-9])(?<![0-9][ ~])(?<!\\ )%[^\n]*\Z")
_STYLE: Final = (
    r"display\s*:\s*none|visibility\s*:\s*hidden|opacity\s*:\s*0|font-size\s*:\s*0|(?<![-a-z])color\s*[:=]"
    r"|(?<![-a-z:])hidden(?![-a-z])"
)
_ELEMENT: Final = re.compile(
    rf"<(?P<name>s|del|strike|script|style|template|noscript|[a-z][a-z0-9]*(?=[^<>]{{0,400}}(?:{_STYLE})))(?:\s[^<>]{{0,400}})?>",
    re.IGNORECASE,
)
SHORT: Final = 6  # characters after a box that are too few to deny it
_NEAR: Final = 4000  # characters before a box that are searched for the start of a hiding command
_DENYING: Final = re.compile(r"no|nev|nei|n['’]t|wit|exc|unl|rath|inst|wron|inco|fals")
"""A part of every word that denies, which is found at once."""
_DENIED_BEFORE: Final = re.compile(
    r"(?:\b(?:not|never|nor|neither|cannot|without|except|excluding|unlike|rather than|instead of|wrong|wrongly"
    r"|incorrect|incorrectly|false|falsely)|n['’]t)"
    r"(?:[\s$*]|\\[(\[]|=|\b(?:be|been|equal|equals|to|the|a|an|is|was|simply|just|really|actually|exactly|get|gives?"
    r"|answer|value|result|correct|right|final|by)\b){0,12}\Z",
    re.IGNORECASE,
)
_DENIED_BEHIND: Final = re.compile(
    r"\}[^.!?\n]{0,24}?(?:\b(?:is|was|are|looks|seems|would be|must be|can(?:not)? be|could be)\s+"
    r"(?:clearly\s+|obviously\s+|also\s+|actually\s+)?(?:wrong|incorrect|false|impossible|mistaken|invalid|absurd"
    r"|too\s+(?:large|small|big|high|low)|not\s+(?:the|correct|right|true|possible|valid|my|what|it)\b)"
    r"|\b(?:isn|wasn|can|couldn)['’]?(?:t|not)\s+(?:be\s+)?(?:the|correct|right|true|possible|valid|my|what|it)\b"
    r"|\((?:this is |that is |which is )?(?:wrong|incorrect|false|not\b))",
    re.IGNORECASE,
)


def fault_of_box(text: str, begin: int, end: int) -> str:
    """Return the reason why a box with its content from `begin` to `end` does not count; empty if it counts."""
    start = text.rfind("\\", 0, begin)
    before, behind = text[max(start - _NEAR, 0) : start], text[end : end + 80]
    near = before[-60:].lower()
    denied = _DENYING.search(near) is not None and _DENIED_BEFORE.search(near) is not None
    if denied or (len(behind) > SHORT and _DENIED_BEHIND.match(behind)):
        return "words beside the box deny it"
    return "print hides the box" if _is_hidden(before, behind) else ""


def _is_hidden(before: str, behind: str) -> bool:
    if "%" in before and _COMMENT.search(before, before.rfind("\n") + 1):
        return True
    if "\\" in before and _is_within(before):
        return True
    if "<" in before and _is_in_element(before):
        return True
    return before.rstrip(" $")[-2:] == "~~" and behind[1:].lstrip(" $").startswith("~~")


def _is_within(before: str) -> bool:
    """Return whether an open LaTeX group, or the last command, hides or strikes out the text that follows."""
    levels = [False]  # for each open group, whether it is hidden
    pending = -1  # where the argument of a command that hides it begins
    for found in _SCAN.finditer(before):
        if found["hide"]:
            pending = found.end()
        elif found["switch"] or found["show"]:
            levels[-1] = bool(found["switch"])
        elif found["ink"] and found["ink"].startswith(r"\text"):
            pending = pending if _INKS.fullmatch(found["name"]) else found.end()
        elif found["ink"]:
            levels[-1] = _INKS.fullmatch(found["name"]) is None
        elif found["brace"] == "{":
            levels.append(levels[-1] or pending == found.start())
        elif found["brace"] and len(levels) > 1:
            levels.pop()
    return levels[-1] or pending == len(before)


def _is_in_element(before: str) -> bool:
    comment = before.rfind("<!--")
    if comment >= 0 and "-->" not in before[comment:]:
        return True
    lowered = before.lower()
    return any(lowered.rfind(f"</{found['name'].lower()}") < found.start() for found in _ELEMENT.finditer(before))

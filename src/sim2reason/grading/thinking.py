r"""Removal of the thinking in a response, by the marks that public models put around it.

Tags such as ``<think>``, ``<thinking>`` and ``<seed:think>``; ``[THINK]`` (Mistral); ``◁think▷`` (Kimi); the tokens of
Cohere, Sky-T1, MedGemma, Apertus, Gemma and openPangu; the phrases of Granite 3.2 and Apriel; the channels of gpt-oss,
with their tokens or without.
"""

import re
from typing import Final

from sim2reason.grading.score import Outcome, Refused

__all__ = ["OPENING", "without_thinking"]

OPENING: Final = "<think>"
MOST: Final = 20_000  # of the signs "<" that are looked at, so that no text takes long
FEW: Final = 8  # marks that a text may speak of
_WORDS: Final = "think|thinking|thoughts?|reason|reasoning|reflection|scratchpad|analysis"
_TAG: Final = rf"(?:[a-z]{{1,12}}[:_])?(?:{_WORDS})\s{{0,8}}>"
_CHANNEL: Final = r"<\|channel\|>\s{0,8}"
_CLOSE: Final = (
    rf"</{_TAG}|<\|end_of_thought\|>|<\|think_end\|>|<\|END_THINKING\|>|<unused95>|<\|inner_suffix\|>|<channel\|>"
    rf"|{_CHANNEL}final[^<\n]{{0,40}}(?:<\|constrain\|>[^<\n]{{0,40}})?<\|message\|>"
)
_TOKEN: Final = (
    r"<\|begin_of_thought\|>|<\|think_start\|>|<\|START_THINKING\|>|<unused94>|<\|inner_prefix\|>|<\|channel>thought"
    rf"|{_CHANNEL}(?:analysis|commentary)"
)
_ANGLED: Final = re.compile(rf"(?P<close>{_CLOSE})|(?P<token>{_TOKEN})|<{_TAG}", re.IGNORECASE)
_PLAIN: Final = (
    ("[/THINK]", "[THINK]"),
    ("◁/think▷", "◁think▷"),
    ("[unused17]", "[unused16]"),
    ("[BEGIN FINAL RESPONSE]", ""),
    ("Here is my response:", ""),
    ("Here's my response:", ""),
    ("assistantfinal", ""),
)
_BEGINNING: Final = re.compile(
    r"\s{0,8}(?:(?:assistant)?(?:analysis|commentary)(?=[^\s:,.;\-–—'’])"
    r"|Here are my reasoning steps:|Here(?: is|'s) my thought process:)"
)
"""Matches the beginning of a response that starts with thinking: of gpt-oss without its tokens, Apriel, Granite 3.2."""


def without_thinking(text: str) -> str:
    """Return the text after the last closing mark of thinking.

    Raises `Refused`: no answer where thinking is open at the end. A mark that is only quoted, within a line and with no
    box after it, opens no thinking.
    """
    begins = _BEGINNING.match(text) is not None
    if not begins and "<" not in text and not any(mark in text for pair in _PLAIN for mark in pair if mark):
        return text
    end, tags, tokens = _angled(text)
    for close, opening in _PLAIN:
        end = max(end, at + len(close) if (at := text.rfind(close, end)) >= 0 else 0)
        if opening and (at := text.rfind(opening, end)) >= 0:
            tags.append(at)
    late = [at for at in tags if at >= end]
    if any(at >= end for at in tokens) or (begins and not end) or (late and not _spoken_of(text, end, late)):
        raise Refused(Outcome.NO_ANSWER, "the thinking never ends")
    return text[end:]


def _angled(text: str) -> tuple[int, list[int], list[int]]:
    """Return the end of the last closing mark with "<", or 0, and the places of opening tags and tokens after it."""
    tags, tokens = list[int](), list[int]()
    at = len(text)
    for _ in range(MOST):
        at = text.rfind("<", 0, at)
        if at < 0:
            return 0, tags, tokens
        mark = _ANGLED.match(text, at)
        if mark is None:
            continue
        if mark["close"]:
            return mark.end(), tags, tokens
        (tokens if mark["token"] else tags).append(at)
    raise Refused(Outcome.TOO_LONG, f"the response has more than {MOST} signs <")


def _spoken_of(text: str, end: int, marks: list[int]) -> bool:
    """Return whether all opening marks are only quoted: each within a line of text, with no box after the first."""
    first = min(marks)
    within = all(text[max(text.rfind("\n", end, at) + 1, end) : at].strip() for at in marks[:FEW])
    return within and len(marks) <= FEW and r"\boxed" not in text[first:]

"""Letters of options in answers to multiple-choice questions."""

import re
from typing import Final

from sim2reason.benchmarks.scoring.parts.answers import after_thinking

__all__ = ["chosen", "said_without_box"]

LAST: Final = 1000  # characters in which an answer without a box must stand
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
    """The options that an answer names, such as ``A``, ``(A), (C)``, ``ABD`` or ``B) 6.4 J``; None if it is no such.

    *None* and *none of these* name no option.
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


def said_without_box(response: str) -> frozenset[str] | None:
    """The options of the last *answer is …* near the end of a response; None if there is none."""
    *_, last = [None, *_SAID.finditer(after_thinking(response)[-LAST:])]
    return None if last is None else frozenset(re.findall("[A-D]", last[1]))

r"""Parts of an answer that do not change its value: unit vectors, and clauses that define symbols."""

import re
from typing import Final

__all__ = ["vector_as_direction", "vectors_as_components", "without_meanings"]

_FONT: Final = r"\\(?:text|textbf|textit|mathrm|mathbf|mathit|boldsymbol|bm|vec|hat|widehat|overrightarrow)"
_LETTER: Final = r"(?:\\[ij]math(?![A-Za-z])|[ijkxyz])"
_IN_FONT: Final = rf"{_FONT}\s*\{{\s*({_LETTER})\s*\}}"
_HAT: Final = rf"\\(?:wide)?hat(?:\s*\{{\s*(?:{_IN_FONT}|({_LETTER}))\s*\}}|\s+({_LETTER}))"
_VECTOR: Final = re.compile(rf"\s*(?:\\[,;:! ]|~)*(?:{_HAT}|\\(?:mathbf|boldsymbol|bm)\s*\{{\s*{_HAT}\s*\}})")
_NAMED: Final = r"(?:[A-Za-z]|\\[A-Za-z]{2,10})"
_ARROWED: Final = re.compile(
    rf"\\(?:vec|overrightarrow)\s*(?:\{{\s*(?P<braced>{_NAMED}(?:_(?:[A-Za-z0-9]|\{{[A-Za-z0-9]{{1,12}}\}}))?)\s*\}}"
    rf"|(?P<bare>{_NAMED}))"
)
_OF_VECTORS: Final = re.compile(r"\||\\(?:[lr]?vert|[lr]?Vert|parallel|times|cdot)(?![A-Za-z])|[×·⋅]|\^")
"""What makes another quantity of vectors than a sum of their components."""
_AXES: Final = {"i": "x", "j": "y", "k": "z", r"\imath": "x", r"\jmath": "y"}
_OPERATORS: Final = re.compile(r"[-−–+=<>≈,;±]|\\(?:pm|mp|approx|quad|times|cdot|hat|vec)(?![A-Za-z])|[0-9]")
_PLAIN_POWER: Final = re.compile(r"(?:\^|\*\*)\s*\{?\s*[-−]?[0-9]\s*\}?|\\[,;:! ]|\\cdot(?![A-Za-z])")
_SYMBOL: Final = r"\\?[A-Za-zα-ωΑ-Ω]{1,8}(?:_(?:[A-Za-z0-9]|\{[A-Za-z0-9\\{} ]{1,20}\}))?"
_MEANING: Final = (
    rf"{_SYMBOL}\s+(?:is|are|denotes|represents)\s+(?:the|its|their|an?)\s+(?P<words>[A-Za-z][A-Za-z' -]{{1,60}})"
)
_MEANINGS: Final = re.compile(r"[\s,;.]*where\s+(?P<said>[^=<>≈±≠]{3,300})")
_OPENING: Final = re.compile(
    r"(?:[\s,;.~]|\\[,;:! ]|\\q?quad(?![A-Za-z]))*(?:\\(?:text|textrm|mathrm|mbox)\s*\{[\s,;~]*)?\Z"
)
_FONTS: Final = re.compile(r"\\(?:text|textrm|textit|mathrm|mbox)\s*\{|\$|\\[,;:! ]|\\q?quad(?![A-Za-z])|[~{}]")
_SPLIT: Final = re.compile(r"\s*(?:,\s*and|,|;|\band)\s+(?=\S{1,30}\s+(?:is|are|denotes|represents)\b)")
_MEANT: Final = re.compile(_MEANING)
_UNFIT: Final = """
    not wrong right true false incorrect correct negative opposite inverse reciprocal half twice double answer value
    square other actual real
"""
_NO_MEANING: Final = frozenset(_UNFIT.split())


def vector_as_direction(content: str) -> str:
    r"""Rewrite the unit vector in ``2.4\,\hat{i}\text{ m/s}`` as a direction at the end; leave other vectors unchanged.

    Other vectors, and vectors followed by more than a unit, remain and make the number unreadable.
    """
    found = list(_VECTOR.finditer(content))
    if len(found) != 1:
        return content
    before, behind = content[: found[0].start()], content[found[0].end() :]
    if not before.strip() or _OPERATORS.search(_PLAIN_POWER.sub(" ", behind)):
        return content
    letter = next(letter for letter in found[0].groups() if letter).strip()
    return rf"{before}{behind}\text{{ (along the +{_AXES.get(letter, letter)} axis)}}"


def vectors_as_components(content: str) -> str:
    r"""Replace vectors along one line by their components: ``m(\vec{g}+\vec{a})`` becomes m(g + a).

    Vectors with bars, in products with a sign, or in powers remain; such an answer is refused unless it is a name.
    """
    if r"\vec" not in content and r"\overrightarrow" not in content:
        return content
    if _OF_VECTORS.search(content):
        return content
    return _ARROWED.sub(lambda found: f"{found['braced'] or found['bare']} ", content)


def without_meanings(content: str) -> str:
    """Remove a clause that only defines symbols of an answer, such as *where v is the speed of A*.

    A clause with a number, a relation or a word that could change the value remains, and the answer is refused.
    """
    if "where" not in content:
        return content
    at = content.rfind("where")
    opening = _OPENING.search(content, max(at - 40, 0), at)
    begin = opening.start() if opening else at
    said = _MEANINGS.fullmatch(_FONTS.sub(_shown, content[begin:]).strip())
    if said is None:
        return content
    for part in _SPLIT.split(said["said"].strip(" .")):
        meant = _MEANT.fullmatch(" ".join(part.split()))
        if meant is None or not _NO_MEANING.isdisjoint(meant["words"].lower().split()):
            return content
    return content[:begin]


def _shown(mark: re.Match[str]) -> str:
    """Return the replacement of a LaTeX command: nothing for a brace, else a space."""
    return "" if mark[0] in "{}" else " "

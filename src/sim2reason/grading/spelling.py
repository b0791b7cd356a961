"""Normalization of an answer's spelling: invisible layout, equivalent commands, vectors and explained symbols.

For the tokenizer, ``30º`` and ``30^{o}`` become ``30°``, and repeating decimals are expanded. Unit vectors and clauses
that define symbols do not change the value. Most answers are returned unchanged. All patterns run in linear time.
"""

import re
from typing import Final

from sim2reason.grading.alphabet import HIDING, LAYOUT, alternatives_pattern
from sim2reason.grading.score import Outcome, Refused
from sim2reason.grading.units import expand_siunitx

__all__ = [
    "normalize_spelling",
    "strip_meanings",
    "strip_unmatched_braces",
    "vector_as_direction",
    "vectors_as_components",
]

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
    vectors = list(_VECTOR.finditer(content))
    if len(vectors) != 1:
        return content
    before, behind = content[: vectors[0].start()], content[vectors[0].end() :]
    if not before.strip() or _OPERATORS.search(_PLAIN_POWER.sub(" ", behind)):
        return content
    letter = next(letter for letter in vectors[0].groups() if letter).strip()
    return rf"{before}{behind}\text{{ (along the +{_AXES.get(letter, letter)} axis)}}"


def vectors_as_components(content: str) -> str:
    r"""Replace vectors along one line by their components: ``m(\vec{g}+\vec{a})`` becomes m(g + a).

    Vectors with bars, in products with a sign, or in powers remain; such an answer is refused unless it is a name.
    """
    if r"\vec" not in content and r"\overrightarrow" not in content:
        return content
    if _OF_VECTORS.search(content):
        return content
    return _ARROWED.sub(lambda match: f"{match['braced'] or match['bare']} ", content)


def strip_meanings(content: str) -> str:
    """Remove a clause that only defines symbols of an answer, such as *where v is the speed of A*.

    A clause with a number, a relation or a word that could change the value remains, and the answer is refused.
    """
    if "where" not in content:
        return content
    at = content.rfind("where")
    opening = _OPENING.search(content, max(at - 40, 0), at)
    begin = opening.start() if opening else at
    match = _MEANINGS.fullmatch(_FONTS.sub(_shown, content[begin:]).strip())
    if match is None:
        return content
    for part in _SPLIT.split(match["said"].strip(" .")):
        meaning = _MEANT.fullmatch(" ".join(part.split()))
        if meaning is None or not _NO_MEANING.isdisjoint(meaning["words"].lower().split()):
            return content
    return content[:begin]


def _shown(mark: re.Match[str]) -> str:
    """Return the replacement of a LaTeX command: nothing for a brace, else a space."""
    return "" if mark[0] in "{}" else " "


_HIDING: Final = re.compile(rf"\\(?:{HIDING})(?![A-Za-z])")
_USUAL: Final = (
    r"[,;:! ]|(?:[dt]?frac|times|cdot|text|mathrm|sqrt|approx|left|right|circ|quad|sin|cos|tan|ln"
    r"|theta|mu|pi|alpha|beta|phi|omega|rho|lambda|Delta)(?![A-Za-z])"
)
_IN_TEXT: Final = r"\s*(?:\\(?:text|mathrm)\s*\{\s*)?"
_TRIGGER: Final = re.compile(
    rf"[*`$º˚…<&✓✔％]|\^\s*\{{?\s*(?:o|\\[tm])|tg|\.\.|i\.e|\{{\s*[-−+=,.}}]"
    rf"|\({_IN_TEXT}(?:or|eq|that)|where|\\(?!{_USUAL})"
)
_ALIGNED: Final = r"(?:aligned|align\*?|gathered|gather\*?|equation\*?|split|displaymath|math)"
_DOTS: Final = r"(?:\\[lc]?dots[cbmio]?(?![A-Za-z])|\.{3}|…)"
_RELATION: Final = (
    rf"(?==|≈|\\(?:{alternatives_pattern('relation', '=')}|{alternatives_pattern('relation', '≈')})(?![A-Za-z]))"
)
_DECIMAL_COMMA: Final = (  # of one number that it can't part into thousands
    r"(?<![0-9.])(?<![^\\],)(?<!\{,\})([0-9]+)\{,\}([0-9]{1,2}|[0-9]{4,}|(?<=(?<![0-9])0\{,\})[0-9]{3})(?![0-9.]|\{?,)"
)
_REWRITTEN: Final = tuple(
    (re.compile(pattern), replacement)
    for pattern, replacement in (
        (r"(?<![A-Za-z])i\.\s?e\.,?", " "),
        (rf"\(({_IN_TEXT})(?:or|equivalently|equal to|that is,?)(?![A-Za-z])", r"(\1= "),
        (r"(?<=[0-9])\{\.\}(?=[0-9])", "."),
        (r"％", r"\\%"),
        (r"\\text\s*\{\s*-\s*\}", "-"),
        (r"\\text\s*\{\s*--\s*\}", "–"),
        (r"\\[hm]space\*?\s*\{\s*[0-9.]+\s*(?:mm|cm|pt|em|ex|mu|in)\s*\}", r"\\ "),
        (rf"\\(?:{'|'.join(LAYOUT)})(?![A-Za-z])", r"\\ "),
        (r"\\[()\[\]]|[$`]", " "),
        (r"\\tag\*?\s*\{[0-9.*]{1,5}\}", " "),
        (rf"\\(?:begin|end)\s*\{{\s*{_ALIGNED}\s*\}}|\\begin\s*\{{array\}}\s*\{{[lcr]\}}|\\end\s*\{{array\}}", " "),
        (rf"(?:\\\\\s*)?&\s*{_RELATION}|\\\\\s*{_RELATION}", " "),
        (r"\\\\\s*\Z", ""),
        (_DECIMAL_COMMA, r"\1.\2"),
        (r"(?:\\checkmark|[✓✔]\ufe0f?)\s*\Z", ""),
        (r"<sup>\s*([-−+]?[0-9]{1,3})\s*</sup>", r"^{\1}"),
        (r"\\textsuperscript\s*\{([^{}]{0,20})\}", r"^{\1}"),
        (r"[º˚]|\\textdegree(?![A-Za-z])", "°"),
        (r"(?<=[0-9})])\s*\^\s*\{?\s*(?:\\(?:text|mathrm)\s*\{\s*)?o\s*\}{0,2}(?![A-Za-z])", "°"),
        (rf"([0-9]\.[0-9]+)\s*{_DOTS}(?!\s*[0-9.])", r"\1"),
        (rf"\\(?:{alternatives_pattern('open', '{')})\s*\{{\s*\}}", " "),
        (r"(?<![A-Za-z])\{\s*\}", ""),
        (r"(?<![A-Za-z^_])\{\s*([-−+=]|\\cdot|\\times)\s*\}", r"\1 "),
    )
)
_FUNCTIONS: Final = {"arctg": "arctan", "arcctg": "arccot", "tg": "tan", "ctg": "cot", "cotg": "cot", "cosec": "csc"}
_CALLED: Final = "|".join(_FUNCTIONS)
_FUNCTION: Final = re.compile(
    rf"\\(?:(?:operatorname\*?|mathrm|text)\s*\{{\s*({_CALLED})\s*\}}|({_CALLED})(?![A-Za-z]))|(?<![A-Za-z\\])(arctg)"
)
_REPEATING: Final = re.compile(
    r"(?P<digits>[0-9]*\.[0-9]*)\s*\\(?:overline|bar|dot)(?:\s*\{(?P<many>[0-9]{1,6})\}|\s*(?P<one>[0-9]))"
)
_BOLD: Final = re.compile(r"\*\*(?=\s*(?:\Z|[,;.:)=≈]|\\|[A-Za-z]))")
REPEATED_DIGITS: Final = 18  # of a repeating decimal, enough for a float


def normalize_spelling(content: str) -> str:
    """Return an answer in the notation that the tokenizer reads; raise Refused for commands that hide text."""
    if _TRIGGER.search(content) is None:
        return content
    if hiding := _HIDING.search(content):
        raise Refused(Outcome.UNREADABLE, f"{hiding[0]} hides a part of the answer")
    content = expand_siunitx(content) if "\\" in content else content
    content = _unmarked(strip_meanings(content))
    content = vector_as_direction(content) if "\\" in content else content
    for pattern, replacement in _REWRITTEN:
        content = pattern.sub(replacement, content)
    content = _FUNCTION.sub(lambda match: rf"\{_FUNCTIONS[match[1] or match[2] or match[3]]} ", content)
    return _REPEATING.sub(_repeated, content) if "." in content else content


def strip_unmatched_braces(text: str) -> str:
    """Return a piece of an answer without unmatched braces."""
    if "}" not in text:
        return text
    depth, kept = 0, list[str]()
    for character in text:
        depth += (character == "{") - (character == "}")
        kept.append(character if depth >= 0 else " ")
        depth = max(depth, 0)
    return "".join(kept)


def _unmarked(content: str) -> str:
    """Return the text without Markdown stars around the answer or its beginning; elsewhere ``**`` is a power."""
    bare = content.strip()
    if bare.startswith("**"):
        content = _BOLD.sub(" ", bare[2:], count=1)
    elif bare.startswith("*") and bare.endswith("*") and len(bare) > 1:
        content = bare[1:-1]
    return content


def _repeated(match: re.Match[str]) -> str:
    cycle = match["many"] or match["one"]
    return match["digits"] + (cycle * REPEATED_DIGITS)[:REPEATED_DIGITS]

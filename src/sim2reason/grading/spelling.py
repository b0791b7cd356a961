r"""Normalization of an answer's spelling: removal of invisible layout, and one form for equivalent commands.

For the tokenizer, ``\hspace{1mm}`` becomes a space, ``30º`` and ``30^{\text{o}}`` become ``30°``, and
``0.\overline{6}`` is expanded. Most answers are returned unchanged. All patterns run in linear time.
"""

import re
from typing import Final

from sim2reason.grading import clauses, siunitx
from sim2reason.grading.alphabet import HIDING, LAYOUT, either
from sim2reason.grading.score import Outcome, Refused

__all__ = ["balanced", "spelled"]

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
_RELATION: Final = rf"(?==|≈|\\(?:{either('relation', '=')}|{either('relation', '≈')})(?![A-Za-z]))"
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
        (rf"\\(?:{either('open', '{')})\s*\{{\s*\}}", " "),
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
DIGITS: Final = 18  # of a repeating decimal, enough for a float


def spelled(content: str) -> str:
    """Return an answer in the notation that the tokenizer reads; raise Refused for commands that hide text."""
    if _TRIGGER.search(content) is None:
        return content
    if hiding := _HIDING.search(content):
        raise Refused(Outcome.UNREADABLE, f"{hiding[0]} hides a part of the answer")
    content = siunitx.expanded(content) if "\\" in content else content
    content = _unmarked(clauses.without_meanings(content))
    content = clauses.vector_as_direction(content) if "\\" in content else content
    for pattern, replacement in _REWRITTEN:
        content = pattern.sub(replacement, content)
    content = _FUNCTION.sub(lambda found: rf"\{_FUNCTIONS[found[1] or found[2] or found[3]]} ", content)
    return _REPEATING.sub(_repeated, content) if "." in content else content


def balanced(text: str) -> str:
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
    return match["digits"] + (cycle * DIGITS)[:DIGITS]

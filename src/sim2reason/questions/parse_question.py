"""Parsing of a question's sentence into a query, with usual spellings of numbers."""

import re
from collections.abc import Collection, Mapping
from decimal import Decimal
from functools import cache

from sim2reason.questions import KINDS, Query, SimulatedScene, Words
from sim2reason.questions.phrasing import sentence
from sim2reason.questions.query import targets
from sim2reason.questions.words import DIGITS, format_number
from sim2reason.scenes.dsl.units import UnitSystem

_LENGTHS = {
    "m metre metres meter meters": "1",
    "cm centimetre centimetres centimeter centimeters": "0.01",
    "mm millimetre millimetres millimeter millimeters": "0.001",
    "km kilometre kilometres kilometer kilometers": "1000",
}
_TIMES = {
    "s sec secs second seconds": "1",
    "ms millisecond milliseconds": "0.001",
    "min mins minute minutes": "60",
    "h hr hrs hour hours": "3600",
}
_ANGLES = {"° deg degs degree degrees": "1"}
_ASTRONOMICAL = {"au": {"au AU": "1"}, "yr": {"yr yrs year years": "1"}}
SPELLINGS: Mapping[str, Mapping[str, str]] = {"m": _LENGTHS, "s": _TIMES, "deg": _ANGLES, **_ASTRONOMICAL}
"""By the unit in which a text counts: what else people write, and how many of these units one of it is."""

_COUNTED = "one two three four five six seven eight nine ten eleven twelve"
_PARTS = {"half": 2, "third": 3, "quarter": 4, "fifth": 5, "tenth": 10}
_PLAIN = {word: str(n) for n, word in enumerate(_COUNTED.split(" "), start=1)}
_SHARES = {
    f"{word} {part}{'s' if count > 1 else ''} of {article}": str(Decimal(count) / size)
    for count, word in enumerate(("a", *_COUNTED.split(" ")[1:]), start=1)
    for part, size in _PARTS.items()
    for article in ("a", "an")
    if count < size
}
_HALVES = {"half a": "0.5", "half an": "0.5"}
_SMALL = _SHARES | _HALVES | _PLAIN
_WORDS = _SMALL | {word.capitalize(): number for word, number in _SMALL.items()}
_FRACTIONS = {"½": "0.5", "¼": "0.25", "¾": "0.75"}
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
_GROUPED = r"\d{1,3}(?:[,\u2009\u202f]\d{3})+" + rf"(?:\.{DIGITS})?"
_POWER = r"(?:\s?[×x]\s?10\^?(?P<power>[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]{1,3}|-?\d{1,2})|[eE](?P<exponent>[+-]?\d{1,2}))?"
_NUMBER = rf"(?P<number>{_GROUPED}|{DIGITS}(?:\.{DIGITS})?|\.{DIGITS}|[½¼¾]|(?:{'|'.join(_WORDS)})\b){_POWER}"
_BETWEEN = "(?:\\s|\N{NO-BREAK SPACE}|-)?"  # a number and its unit
LARGEST = Decimal("1e15")  # larger numbers are left as they are
APOSTROPHES, DASHES = "\N{RIGHT SINGLE QUOTATION MARK}", "\N{NON-BREAKING HYPHEN}\N{HYPHEN}"
SPELLED_OUT = {"What's": "What is", "what's": "what is", "how's": "how is", "How's": "How is"}


def plainly(text: str, units: UnitSystem) -> str:
    """Return a question with its times, lengths and angles rewritten in the library's units and digits.

    Numbers in other units stay unchanged, and so does a sentence that is already written in this way.
    """
    text = " ".join(text.replace(APOSTROPHES, "'").split())
    for said, spelled in SPELLED_OUT.items():
        text = text.replace(said, spelled)
    text = re.sub(r"\bt\s*=\s*(?=[\d.])", "t = ", text)
    for unit in ("m", "s", "deg"):
        shown = units.spell(unit)
        if shown in SPELLINGS:
            text = _pattern(shown).sub(lambda found, shown=shown: _told(found, shown), text)
    return text


@cache
def _pattern(unit: str) -> re.Pattern[str]:
    names = sorted((name for group in SPELLINGS[unit] for name in group.split()), key=len, reverse=True)
    units = f"(?P<unit>{'|'.join(map(re.escape, names))})"
    return re.compile(rf"(?<![\w.,$\\^]){_NUMBER}{_BETWEEN}{units}(?![\w/·^²³⁴*]|\s?/)")


@cache
def _sizes(unit: str) -> Mapping[str, Decimal]:
    return {name: Decimal(size) for group, size in SPELLINGS[unit].items() for name in group.split()}


def _told(found: re.Match[str], unit: str) -> str:
    said = found["number"]
    digits = _WORDS.get(said) or _FRACTIONS.get(said) or re.sub(r"[,\u2009\u202f]", "", said)
    power = (found["power"] or "").translate(_RAISED) or found["exponent"] or "0"
    value = Decimal(digits).scaleb(int(power)) * _sizes(unit)[found["unit"]]
    return format_number(float(value), unit) if 0 < value < LARGEST else found[0]


def parse_question(
    text: str, study: SimulatedScene, words: Words, kinds: Collection[str] | None = None
) -> Query | None:
    """Return the query that a sentence expresses, found by trying all phrases of all kinds; None if none matches.

    Each kind reads numbers and names from the sentence. The rest must match the kind's `shapes` word for word, but
    numbers may be spelled in any usual way. Where `kinds` are named, only those are tried.
    """
    text, offered = sentence(plainly(text, words.units)), targets(words)
    heard = {target: noun for target, noun in offered.items() if noun.heard(text)}
    for kind in (found for name, found in KINDS.items() if kinds is None or name in kinds):
        for query in kind.parsed(text, study, words, heard):
            noun = offered[query.target] if query.target is not None else None
            if any(
                sentence(shape) == text
                for shape in (*kind.shapes(query, words, noun), *kind.former_sentences(query, words))
            ):
                return query
    return None

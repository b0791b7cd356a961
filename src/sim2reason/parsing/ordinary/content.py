"""What a sentence tells, whatever its wording: its words that matter, and its numbers with their units."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from decimal import Decimal
from functools import cache, lru_cache

from sim2reason.dsl.units import UnitError, coherent
from sim2reason.parsing.ordinary.vocabulary import FILLERS, ORDERED, PHRASES, SAME, SURFACES, TEXTURES

MINUS, TIMES = "\N{MINUS SIGN}", "\N{MULTIPLICATION SIGN}"
_NUMBER = re.compile(
    rf"(?<![\w.])([-{MINUS}]?\d{{1,30}}(?:\.\d{{1,30}})?"
    rf"(?:e[+-]?\d{{1,3}}|\s?[{TIMES}x*]\s?10\^?[-{MINUS}]?\d{{1,3}})?)"
    r"(?:[ \-]?(°|%|[A-Za-zµμΩ][A-Za-zµμΩ0-9²³⁻¹·*/^]{0,20}))?"
)
_SYMBOL = re.compile(r"\$([^$\n]{1,40})\$")
_WORD = re.compile(r"#\d+#|\$\d+\$|[A-Za-z][A-Za-z-]*")
_MEANS = {other: word for word, others in SAME.items() for other in others.split()}


@dataclass(frozen=True, slots=True)
class Told:
    """A number as it is written, with its unit (empty for a pure number) and that unit without prefixes."""

    digits: str
    unit: str
    bare: str

    def in_unit(self, unit: str) -> str:
        """Return the digits that tell this number in another unit of its kind, without rounding."""
        mine, other = coherent(self.unit)[1], coherent(unit)[1]
        if mine == other:
            return self.digits
        plain = re.sub(rf"\s?[{TIMES}x*]\s?10\^?", "e", self.digits).replace(MINUS, "-")
        return f"{(Decimal(plain) * mine / other).normalize():f}".replace("-", MINUS)


@dataclass(frozen=True, slots=True)
class Content:
    """The words of a sentence that matter, in order, `#0#` standing for its first number, and the numbers."""

    words: tuple[str, ...]
    numbers: tuple[Told, ...]

    @property
    def facts(self) -> frozenset[str]:
        """Return the words of the sentence, without numbers and without letters that name bodies."""
        return frozenset(word for word in self.words if len(word) > 1 and word[0] != "#")

    @property
    def order(self) -> tuple[str, ...]:
        """Return the words of the sentence whose order matters, in order, each once where it is repeated at once."""
        several = sum(word in SURFACES for word in self.words) > 1
        matters: frozenset[str] = ORDERED.union(TEXTURES, SURFACES) if several else ORDERED
        found = [word for word in self.words if word in matters]
        return tuple(word for index, word in enumerate(found) if index == 0 or found[index - 1] != word)

    @property
    def letters(self) -> tuple[str, ...]:
        """Return the letters that name bodies, in the order of the sentence."""
        return tuple(word for word in self.words if len(word) == 1)

    def beside(self, index: int) -> frozenset[str]:
        """Return the words next to a number on either side."""
        at = self.words.index(f"#{index}#")
        near = (*self.words[max(at - 1, 0) : at], *self.words[at + 1 : at + 2])
        return frozenset(word for word in near if word[0] != "#")


@lru_cache(maxsize=1024)
def content(sentence: str) -> Content:
    """Return what a sentence tells; numbers count from 0 in the order in which they stand."""
    numbers: list[Told] = []

    def numbered(found: re.Match[str]) -> str:
        unit, bare, rest = _unit(found[2] or "")
        numbers.append(Told(found[1], unit, bare))
        return f" #{len(numbers) - 1}# {rest}"

    return Content(tuple(_words(_NUMBER.sub(numbered, sentence))), tuple(numbers))


def content_of_form(form: str) -> Content:
    """Return what a sentence tells whose numbers are symbols in dollars; each stands as a number without a unit."""
    symbols: list[Told] = []

    def numbered(found: re.Match[str]) -> str:
        symbols.append(Told(found[1], "", ""))
        return f" #{len(symbols) - 1}# "

    return Content(tuple(_words(_SYMBOL.sub(numbered, form))), tuple(symbols))


def _unit(said: str) -> tuple[str, str, str]:
    """Return a unit, the same without prefixes, and what of `said` is no unit."""
    word = said.rstrip(".")
    try:
        return (word, coherent(word)[0], "") if word else ("", "", "")
    except (UnitError, ArithmeticError):
        return "", "", said


def _words(text: str) -> Iterator[str]:
    text = _letters(text)
    for pattern, plain in _phrases():
        text = pattern.sub(f" {plain} ", text)
        text = " ".join(text.split())
    words: list[str] = _WORD.findall(text)
    for word in words:
        if word.isupper() or word[0] == "#":
            yield word
        elif word not in FILLERS:
            found = _MEANS.get(word, word)
            singular = found[:-1] if found.endswith("s") and len(found) > 3 and not found.endswith("ss") else found
            yield _MEANS.get(singular, singular)


def _letters(text: str) -> str:
    """Return the text in lower case but for the letters of bodies; a capital A at the start is an article."""
    text = re.sub(r"^\W*A\s+(?=[a-z#])", "a ", text)
    return re.sub(r"\b(?![A-Z]\b)\w+", lambda word: word[0].lower(), text)


@cache
def _phrases() -> tuple[tuple[re.Pattern[str], str], ...]:
    return tuple((re.compile(pattern), plain) for pattern, plain in PHRASES.items())

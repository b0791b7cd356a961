r"""The syntax of units: from ``\text{m}/\text{s}^{2}``, ``kg·m²`` or ``metres per second`` to words and powers."""

from __future__ import annotations

import re
from itertools import pairwise
from typing import Final

__all__ = ["UnitError", "factors"]

MAX_LENGTH: Final = 200
MAX_DEPTH: Final = 16
MAX_POWER: Final = 9


class UnitError(ValueError):
    """An error for a text that is not a known unit."""


_SPOKEN: Final = {
    "per": ("slash", "/"),
    "squared": ("power", "2"),
    "cubed": ("power", "3"),
    "per cent": ("word", "%"),
}
# Products that are commonly run together; a power after one belongs to its second unit.
_RUN_TOGETHER: Final = re.compile(r"(kg|[kM]?[NJWV]|A)([mshd])")
_LOWERED: Final = str.maketrans("⁻⁺⁰¹²³⁴⁵⁶⁷⁸⁹−–", "-+0123456789--")

_TOKEN: Final = re.compile(
    r"(?P<power>(?:\^|\*\*)\s*(?:[-+−–]?[0-9]+|\{\s*[-+−–]?[0-9]+\s*\})|[⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)"
    r"|(?P<degree>\^\s*(?:\\circ(?![A-Za-z])|\{\s*\\circ\s*\}|°)|°|\\degree(?![A-Za-z]))"
    r"|(?P<space>[\s~]|\\[ ,;:!]|\\(?:q?quad|left|right|rm|displaystyle)(?![A-Za-z]))"
    r"|(?P<times>[·⋅*×]|\\(?:cdot|times)(?![A-Za-z]))"
    r"|(?P<wrap>\\(?:text|textrm|textup|textnormal|mathrm|operatorname|mathit|mathbf|mbox)\s*\{)"
    r"|(?P<fraction>\\[dt]?frac(?![A-Za-z]))|(?P<slash>/)|(?P<open>[({])|(?P<close>[)}])|(?P<one>1(?![0-9.]))"
    r"|(?P<word>per cent(?![A-Za-z])|(?:[µμ]|\\mu\s*(?:\\(?:text|mathrm)\s*\{)?)?[A-Za-zΩ]+|\\Omega(?![A-Za-z])|\\?%)"
)


class _UnitReader:
    """A recursive-descent parser of one unit; a factor is a list of (word, power)."""

    def __init__(self, text: str) -> None:
        self.tokens = list(_tokens(text))
        self.at = 0

    def peek(self) -> str:
        return self.tokens[self.at][0] if self.at < len(self.tokens) else "end"

    def take(self) -> str:
        self.at += 1
        return self.tokens[self.at - 1][1]

    def quotient(self, depth: int = 0) -> list[tuple[str, int]]:
        """Parse a product of units divided by any number of single factors, since a/b c would be ambiguous."""
        if depth > MAX_DEPTH:
            raise UnitError("a unit is nested too deeply")
        factors = self.product(depth) if self.peek() != "slash" else []
        while self.peek() == "slash":
            self.take()
            self.spaces()
            factors += [(word, -power) for word, power in self.factor(depth)]
            self.spaces()
            if self.peek() not in {"slash", "close", "end"}:
                raise UnitError("what stands after a slash needs parentheses")
        return factors

    def spaces(self) -> None:
        while self.peek() == "space":
            self.take()

    def product(self, depth: int) -> list[tuple[str, int]]:
        factors: list[tuple[str, int]] = []
        while True:
            while self.peek() in {"space", "times"}:
                self.take()
            if self.peek() in {"slash", "close", "end"}:
                return factors
            factors += self.factor(depth)

    def factor(self, depth: int) -> list[tuple[str, int]]:
        kind = self.peek()
        if kind == "one":
            self.take()
            return []
        if kind == "fraction":
            self.take()
            above, below = self.group(depth), self.group(depth)
            return above + [(word, -power) for word, power in below]
        base = self.group(depth) if kind == "open" else [(self.word(), 1)]
        self.spaces()
        exponent = int(self.take()) if self.peek() == "power" else 1
        if abs(exponent) > MAX_POWER:
            raise UnitError("a power beyond the table")
        return [(word, power * exponent) for word, power in base]

    def group(self, depth: int) -> list[tuple[str, int]]:
        self.spaces()
        if self.peek() != "open":
            return [(self.word(), 1)]
        self.take()
        inside = self.quotient(depth + 1)
        if self.peek() != "close":
            raise UnitError("an unclosed group in a unit")
        self.take()
        return inside

    def word(self) -> str:
        if self.peek() != "word":
            raise UnitError("a unit was expected")
        return self.take()


def _tokens(text: str) -> list[tuple[str, str]]:
    """Return kinds and texts of tokens; invisible braces become spaces, `per` a slash."""
    tokens: list[tuple[str, str]] = []
    unseen: list[bool] = []  # for each open brace or parenthesis
    arguments = at = 0  # how many groups the fractions so far still take
    while at < len(text):
        match = _TOKEN.match(text, at)
        if match is None:
            raise UnitError(f"{text[at]!r} stands in no unit")
        kind, word, at = str(match.lastgroup), match[0], match.end()
        arguments += 2 * (kind == "fraction")
        shown = word == "(" or (word == "{" and arguments > 0)
        if kind in {"open", "wrap"}:
            unseen.append(not shown)
            arguments -= shown and word == "{"
            kind = "open" if shown else "space"
        elif kind == "close" and unseen:
            kind = "space" if unseen.pop() else "close"
        tokens.append(_lexeme(kind, word))
        if together := _RUN_TOGETHER.fullmatch(word):
            tokens[-1:] = [("word", together[1]), ("word", together[2])]
        if kind == "word" and "{" in word:  # \mu\mathrm{m}: the brace is part of the word, its closing is not
            unseen.append(True)
    return tokens


def _lexeme(kind: str, word: str) -> tuple[str, str]:
    if kind == "power":
        return "power", word.translate(_LOWERED).strip("^*{} \t\n")[:4]
    if kind == "degree":
        return "word", "deg"
    if kind != "word":
        return kind, word
    if word.lower() in _SPOKEN:
        return _SPOKEN[word.lower()]
    word = re.sub(r"^(?:[µμ]|\\mu\s*(?:\\\w+\s*\{)?)", "u", word)
    return "word", re.sub(r"Ω|\\Omega", "ohm", word).lstrip("\\")


def factors(text: str) -> list[tuple[str, int]]:
    """Return the words of a unit with their powers, in the order of the text; an empty text has none.

    Words are as in the table but not yet looked up. Raises `UnitError` for what is not built like a unit.
    """
    if len(text) > MAX_LENGTH:
        raise UnitError("too long for a unit")
    reader = _UnitReader(text)
    words = reader.quotient()
    if reader.peek() != "end" or (text.strip() and not words):
        raise UnitError(f"{text.strip()!r} is no unit")
    if any(first[0] == "deg" and second[0] in {"C", "F", "K"} for first, second in pairwise(words)):
        raise UnitError("a temperature scale is not in the table of units")
    return words

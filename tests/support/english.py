"""A prompt taken apart, for whoever checks its English."""

import re
from dataclasses import dataclass
from functools import cached_property

from sim2reason.questions.shapes import SHAPES, Draft
from sim2reason.questions.shapes.layout import is_table, units

FORMAT = re.compile(r"(?:Give your|State the|Write the)[^.]*\\boxed\{\}\.$")
VERBS = ("what", "how", "find", "determine", "calculate")
VERB = re.compile(rf"\b(?:{'|'.join(VERBS)})\b", re.IGNORECASE)
UNITS = r"kg·m/s|m/s²|m/s|kg|m|s|N|J|°"
NUMBER = re.compile(r"(?<![\w.])\d+(?:\.\d+)?")
LETTER = re.compile(r"(?<![A-Za-z$_])([A-Z])(?![A-Za-z$])")
STRING = re.compile(
    r"light string (?:is )?tied to|^From .* light string|light string .*\bjoins\b"
    r"|light string runs from|by a light string from"
)


@dataclass(frozen=True)
class Prose:
    """A prompt of some shape: its story with its table, its question and its format line."""

    text: str
    shape: str = "scene_first"

    @cached_property
    def usual(self) -> Draft:
        """Its story and its question as they would stand in the usual shape."""
        return next(iter(SHAPES[self.shape].drafts(self.body)))

    @cached_property
    def body(self) -> str:
        """All but the format line."""
        return FORMAT.sub("", self.text).strip()

    @cached_property
    def plain(self) -> str:
        """The story and the question without the rows of a table."""
        return " ".join(line.strip() for line in self.body.splitlines() if line and not line.startswith("|"))

    @cached_property
    def sentences(self) -> list[str]:
        """Sentences, the question last; a full stop inside a number ends nothing."""
        return [found.strip() for found in re.split(r"(?<=[.?])\s+(?=[A-Z0-9])", self.plain) if found.strip()]

    @property
    def question(self) -> str:
        """The sentence that asks."""
        return self.usual.question

    @cached_property
    def story(self) -> list[str]:
        """All others, in the usual order."""
        return [unit for unit in units(self.usual.story) if not is_table(unit)]

    @property
    def words(self) -> int:
        """As a reader counts them: no bars of a table, no format line."""
        return sum(bool(re.search(r"\w", word)) for word in self.body.split())

    @property
    def verb(self) -> str:
        """The word that asks."""
        found = VERB.search(self.question)
        return found.group().lower() if found else ""


def shape(sentence: str) -> str:
    """A sentence with its numbers and letters masked."""
    return LETTER.sub("X", re.sub(rf"{NUMBER.pattern} ?(?:{UNITS})?", "#", sentence))


def digits(number: str) -> int:
    """Significant digits as written; zeros that end a whole number don't count."""
    whole = number.replace(".", "").lstrip("0")
    return len(whole if "." in number else whole.rstrip("0")) or 1


def introduced(letter: str, story: str) -> bool:
    """Whether the first time that a letter stands in a text, a noun or a list of like bodies introduces it."""
    noun = r"\b(?!(?:from|to|of|and|at|on|over|with|round|joins|reaches|carries)\b)[a-z]+"
    first = re.search(rf"(?<![A-Za-z$]){letter}(?![A-Za-z$])", story)
    before = story[: first.start()] if first else ""
    return bool(
        re.search(rf"{noun},? (?:[A-Z](?: \([^)]*\))?(?:, | and ))*$", before, re.IGNORECASE)
    ) or before.endswith("| ")

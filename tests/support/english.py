"""Analysis of prompts for tests of their English."""

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
    """Prompt of some shape, split into its story with its table, its question and its format line."""

    text: str
    shape: str = "scene_first"

    @cached_property
    def usual(self) -> Draft:
        """Story and question in the order of the usual shape."""
        return next(iter(SHAPES[self.shape].drafts(self.body)))

    @cached_property
    def body(self) -> str:
        """Text without the format line."""
        return FORMAT.sub("", self.text).strip()

    @cached_property
    def plain(self) -> str:
        """Story and question without the rows of a table."""
        return " ".join(line.strip() for line in self.body.splitlines() if line and not line.startswith("|"))

    @cached_property
    def sentences(self) -> list[str]:
        """Sentences, the question last; a decimal point ends no sentence."""
        return [found.strip() for found in re.split(r"(?<=[.?])\s+(?=[A-Z0-9])", self.plain) if found.strip()]

    @property
    def question(self) -> str:
        """Sentence that asks the question."""
        return self.usual.question

    @cached_property
    def story(self) -> list[str]:
        """Sentences other than the question, in the usual order."""
        return [unit for unit in units(self.usual.story) if not is_table(unit)]

    @property
    def words(self) -> int:
        """Number of words, without the bars of a table and the format line."""
        return sum(bool(re.search(r"\w", word)) for word in self.body.split())

    @property
    def verb(self) -> str:
        """Verb of the question."""
        found = VERB.search(self.question)
        return found.group().lower() if found else ""


def shape(sentence: str) -> str:
    """Return a sentence with its numbers and letters masked."""
    return LETTER.sub("X", re.sub(rf"{NUMBER.pattern} ?(?:{UNITS})?", "#", sentence))


def digits(number: str) -> int:
    """Return the number of significant digits; trailing zeros of a whole number don't count."""
    whole = number.replace(".", "").lstrip("0")
    return len(whole if "." in number else whole.rstrip("0")) or 1


def introduced(letter: str, story: str) -> bool:
    """Return whether a noun or a list of like bodies introduces a letter where it first occurs in a text."""
    noun = r"\b(?!(?:from|to|of|and|at|on|over|with|round|joins|reaches|carries)\b)[a-z]+"
    first = re.search(rf"(?<![A-Za-z$]){letter}(?![A-Za-z$])", story)
    before = story[: first.start()] if first else ""
    return bool(
        re.search(rf"{noun},? (?:[A-Z](?: \([^)]*\))?(?:, | and ))*$", before, re.IGNORECASE)
    ) or before.endswith("| ")

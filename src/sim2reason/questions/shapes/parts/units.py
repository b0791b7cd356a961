"""Division of a prompt into sentences and tables, and rearrangement of sentences."""

import re
from collections.abc import Iterator, Sequence

import numpy as np

from sim2reason.text.prose.closings import is_assumption
from sim2reason.text.prose.description import Description
from sim2reason.text.prose.phrases import paragraphs

_END = re.compile(r"(?:(?<=[.?])|(?<=[.?]\)))\s+(?=[A-Z(])")
QUESTION = 2  # greatest number of sentences of a question
ASKS = re.compile(r"(?:What|How|By how much|Find|Determine|Calculate)\b")


def units(text: str) -> list[str]:
    """Return the parts of a text in order, each part a sentence or a table."""
    found: list[str] = []
    for block in re.split(r"\n\n+", text.strip()):
        found.extend([f"\n\n{block}\n\n"] if is_table(block) else _END.split(block.strip()))
    return [unit for unit in found if unit]


def is_table(unit: str) -> bool:
    """Return whether a unit is a table rather than a sentence."""
    return unit.lstrip().startswith("|")


def text_of(said: Sequence[str]) -> str:
    """Return sentences and tables joined into one text."""
    return paragraphs(said)


def splits(said: Sequence[str]) -> Iterator[tuple[list[str], str]]:
    """Yield splits of a prompt into the story and the question at its end, of one sentence or more."""
    for count in range(1, min(QUESTION, len(said) - 1) + 1):
        if not any(map(is_table, said[-count:])):
            yield list(said[:-count]), text_of(said[-count:])


def begins_plainly(question: str) -> bool:
    """Return whether a question begins with an interrogative or imperative word, so that a clause can precede it."""
    return ASKS.match(question) is not None


def lowered(sentence: str) -> str:
    """Return a sentence without its initial capital, for use after a clause; letters that name bodies stay."""
    return sentence if re.match(r"[A-Z]\b(?! [a-z])", sentence) else sentence[0].lower() + sentence[1:]


def raised(sentence: str) -> str:
    """Return a sentence with an initial capital."""
    return sentence[:1].upper() + sentence[1:]


def one_of(options: Sequence[str], rng: np.random.Generator) -> str:
    """Return one of several wordings, with exactly one random draw."""
    return options[int(rng.random() * len(options))]


def without_assumptions(said: Sequence[str]) -> tuple[list[str], list[str]]:
    """Return a story without its closing general assumptions, and those assumptions."""
    count = len(said)
    while count and is_assumption(said[count - 1]):
        count -= 1
    return list(said[:count]), list(said[count:])


def assumptions(description: Description) -> list[str]:
    """Return the closing general assumptions of a text."""
    said = list(description.sentences)
    count = len(said)
    while count and description.role(said[count - 1]) == "assumption":
        count -= 1
    return said[count:]

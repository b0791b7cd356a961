"""Prompts of multiple choice: scene, question, lettered options and the instruction to give a letter."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from math import floor, log10

import numpy as np

from sim2reason.errors import TextError
from sim2reason.questions.parse_prompt import ParsedPrompt, parse_prompt
from sim2reason.questions.prompt import FORMATS, PLAIN_FORMATS, unit_in_words
from sim2reason.scenes.dsl.measures import join_unit

LETTERS = "ABCDE"
DIGITS = 3  # significant digits that prompts ask for
PLAIN = range(-3, 5)  # powers of ten of numbers written without scientific notation
ENDING = "Which answer is right? Give its letter inside \\boxed{}."
MINUS = "\N{MINUS SIGN}"
_OPTION = re.compile(rf"([{LETTERS}])\. (.+)")


@dataclass(frozen=True)
class ChoicePrompt:
    """A scene and its question as one text, with the options in order."""

    question: str
    options: tuple[str, ...]

    @classmethod
    def of(cls, question: str, values: Sequence[float], unit: str) -> "ChoicePrompt":
        """Return a prompt with numbers as options, all formatted in one style."""
        return cls(question, amounts(values, unit))

    @classmethod
    def read(cls, text: str) -> "ChoicePrompt":
        """Return the parts of a multiple-choice prompt; TextError for any other text."""
        body, _, last = text.rpartition("\n\n")
        question, _, listed = body.rpartition("\n\n")
        options = [_OPTION.fullmatch(line) for line in listed.splitlines()]
        found = cls(question, tuple(option[2] for option in options if option is not None))
        if last != ENDING or not found.options or found.text != text:
            raise TextError("prompt", "it has no options A, B, … with a last line about them", "give one of ours")
        return found

    @property
    def text(self) -> str:
        """Return the whole prompt."""
        listed = "\n".join(f"{letter}. {text}" for letter, text in zip(LETTERS, self.options, strict=False))
        return f"{self.question}\n\n{listed}\n\n{ENDING}"


def parse_choice(text: str, unit: str, rng: np.random.Generator | None = None) -> ParsedPrompt:
    """Return the scene, question and answer that a multiple-choice prompt expresses; `unit` is that of its options."""
    question = ChoicePrompt.read(text).question
    form = FORMATS[0].format(unit=unit_in_words(unit)) if unit else PLAIN_FORMATS[0]
    between = "\n\n" if question.endswith("|") else " "
    return parse_prompt(f"{question}{between}{form}", rng)


def amounts(values: Sequence[float], unit: str) -> tuple[str, ...]:
    """Return the texts of numbers with their unit, all in one style."""
    return tuple(join_unit(text.replace("-", MINUS), unit) for text in said(values))


def said(values: Sequence[float], digits: int = DIGITS) -> list[str]:
    """Return the texts of numbers, all as integers or all with `digits` significant digits and any powers of ten."""
    if all(value == round(value) and abs(value) < 10**digits for value in values):
        return [str(round(value)) for value in values]
    powers = [_power(value, digits) for value in values]
    if all(power in PLAIN for power in powers):
        pairs = zip(values, powers, strict=True)
        return [f"{float(f'{value:.{digits - 1}e}'):.{max(0, digits - 1 - power)}f}" for value, power in pairs]
    parted = (f"{value:.{digits - 1}e}".split("e") for value in values)
    return [f"{mantissa} × 10^{int(power)}" for mantissa, power in parted]


def _power(value: float, digits: int) -> int:
    """Return the exponent of ten of a number in scientific notation, after rounding to `digits` digits; 0 for zero."""
    rounded = abs(float(f"{value:.{digits - 1}e}"))
    return floor(log10(rounded)) if rounded else 0

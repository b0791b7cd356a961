"""Formats of prompts: several parts with references to earlier moments, and multiple choice.

Several parts are read back part by part: the scene with one of the questions is a prompt like any other.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import floor, log10

import numpy as np

from sim2reason.errors import TextError
from sim2reason.grading.parts import PART_LABELS
from sim2reason.questions import KINDS, Question
from sim2reason.questions.moments import Happening, Moment
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.phrasing import sentence
from sim2reason.questions.prompt import (
    FORMATS,
    PLAIN_FORMATS,
    WHOLE_NUMBER_FORMATS,
    ParsedPrompt,
    Prompt,
    composed,
    parse_prompt,
    unit_in_words,
)
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.measures import join_unit
from sim2reason.text.prose.description import Description
from sim2reason.text.prose.phrases import join

REFERENCE_PHRASE = "that moment"


def with_reference(text: str, moment: Moment | None, words: Words) -> str:
    """Return a question with *that moment* for the preceding question's moment; unchanged if that is not shorter."""
    for full, short in _phrases(moment, words):
        if full in text:
            return text.replace(full, short, 1)
        if text.startswith(sentence(full)):
            return sentence(short) + text.removeprefix(sentence(full))
    return text


def resolved_references(text: str, moment: Moment | None, words: Words) -> Iterator[str]:
    """Yield all possible meanings of a question with *that moment*, given the moment of the preceding one."""
    for full, short in _phrases(moment, words):
        if text.startswith(sentence(short)):
            yield sentence(full) + text.removeprefix(sentence(short))
        if short in text:
            yield text.replace(short, full, 1)


def _phrases(moment: Moment | None, words: Words) -> list[tuple[str, str]]:
    """Return the full and the short phrases for a moment, longest first; none for other moments.

    Those just before or after an event must say so.
    """
    if not isinstance(moment, Happening | AtTime) or moment.sided is not None:
        return []
    clause = moment.clause(words) if isinstance(moment, Happening) else None
    pairs = [(phrase, f"at {REFERENCE_PHRASE}") for phrase in moment.phrases(words)]
    if isinstance(moment, AtTime):
        pairs += [(stretch, f"until {REFERENCE_PHRASE}") for stretch in moment.stretches(words)]
    if clause is not None:
        pairs += [
            (f"until {clause.statement}", f"until {REFERENCE_PHRASE}"),
            (f"the moment when {clause.statement}", REFERENCE_PHRASE),
        ]
    subject = moment.subject(words)
    if subject:
        pairs += [(phrase.replace(subject, moment.pronoun, 1), short) for phrase, short in pairs if subject in phrase]
    return sorted(pairs, key=lambda pair: -len(pair[0]))


FORMS = (
    "Give all answers together in one box, as in {box}: {units}{digits}.",
    "Put the answers into one box, in the form {box}: {units}{digits}.",
    "Write the final answers in a single box as {box}, that is, {units}{digits}.",
)
ROUNDING = ", to three significant figures"
AS_WHOLE, AS_PURE = "as a whole number", "as a pure number"
ANSWER = "Answer:"
_PART = re.compile(rf"\(([{PART_LABELS}])\) (.+)")
_UNIT = re.compile(rf"\([{PART_LABELS}]\) (?:in (?P<unit>\S+?)|{AS_WHOLE}|{AS_PURE})(?=,| and \([{PART_LABELS}]\)|\.$)")
_SAME = re.compile(rf"\b(?:both|all) (?:in (?P<unit>\S+?)|{AS_WHOLE}|{AS_PURE})(?=,|\.$)")


@dataclass(frozen=True)
class PartPrompt:
    """The contents of a prompt with several questions: the scene, the questions, and the units of the answers in words.

    A unit is `AS_WHOLE` for a count and `AS_PURE` for a dimensionless number.
    """

    scene: str
    questions: tuple[str, ...]
    units: tuple[str, ...]
    form: int = 0
    """Which of `FORMS` tells how to answer."""

    @classmethod
    def read(cls, text: str) -> "PartPrompt":
        """Return the parts of a prompt; TextError for a text that is no such prompt."""
        body, _, last = text.rpartition("\n\n")
        scene, _, listed = body.rpartition("\n\n")
        lines = [_PART.fullmatch(line) for line in listed.splitlines()]
        labels = "".join(line[1] for line in lines if line is not None)
        same = _SAME.search(last)
        said = [same] * len(labels) if same is not None else list(_UNIT.finditer(last))
        units = tuple(candidate["unit"] or _as_number(candidate[0]) for candidate in said)
        for form in range(len(FORMS)):
            candidate = cls(scene, tuple(line[2] for line in lines if line is not None), units, form)
            if len(units) > 1 and labels == PART_LABELS[: len(units)] and candidate.text == text:
                return candidate
        raise TextError(
            "prompt", "it has no parts (a), (b), … with a last line about their answers", "give one of ours"
        )

    @property
    def text(self) -> str:
        """Return the whole prompt."""
        listed = (f"({label}) {question}" for label, question in zip(PART_LABELS, self.questions, strict=False))
        return "\n\n".join([self.scene, "\n".join(listed), self.last_line])

    @property
    def last_line(self) -> str:
        """Return the last line, on how to give the answers."""
        unit_phrases = [f"({label}) {_told(unit)}" for label, unit in zip(PART_LABELS, self.units, strict=False)]
        box = "; ".join(f"({label}) …" for label in PART_LABELS[: len(self.units)])
        digits = ROUNDING if any(unit != AS_WHOLE for unit in self.units) else ""
        each = (
            join(unit_phrases)
            if len({*self.units}) > 1
            else f"{'both' if len(unit_phrases) == 2 else 'all'} {_told(self.units[0])}"
        )
        return FORMS[self.form].format(box=rf"\boxed{{{box}}}", units=each, digits=digits)

    def single(self, part: int, question: str) -> Iterator[str]:
        """Yield possible prompts of one part alone; one of them has the library's own form."""
        form = _single_form(self.units[part])
        for between in (" ", "\n\n"):  # a table ends with an empty line
            yield f"{self.scene}{between}{question} {form}"

    def after(self, part: int, answers: Sequence[str]) -> str:
        """Return the prompt of one part that gives the answers to all earlier parts."""
        before = [
            f"({label}) {question} {ANSWER} {answer}."
            for label, question, answer in zip(PART_LABELS, self.questions[:part], answers, strict=False)
        ]
        listed = "\n".join([*before, f"({PART_LABELS[part]}) {self.questions[part]}"])
        return "\n\n".join(
            [self.scene, listed, _single_form(self.units[part], f"your answer to ({PART_LABELS[part]})")]
        )


def build_part_prompt(
    description: Description, questions: Sequence[Question], words: Words, rng: np.random.Generator
) -> tuple[Prompt, tuple[str, ...]]:
    """Return one prompt with several questions, in a shape that ends with the question, and the questions' texts in it.

    Where two in a row are about one moment, the second one calls it that moment.
    """
    last = questions[-1].text
    texts = [questions[0].text]
    for before, question in pairwise(questions):
        moment = question.query.moment
        again = moment is not None and moment == before.query.moment
        texts.append(with_reference(question.text, moment, words) if again else question.text)
    body = composed(description, last, rng, question_last=True)
    scene = body.text.removesuffix(last).rstrip()
    units = tuple(map(_unit_of, questions))
    prompt = PartPrompt(scene, tuple(texts), units, int(rng.random() * len(FORMS)))
    return Prompt(prompt.text, body.shape), prompt.questions


def parse_parts(text: str, rng: np.random.Generator | None = None) -> tuple[ParsedPrompt, ...]:
    """Return the meaning of each part of a prompt; TextError if a part has no meaning."""
    prompt = PartPrompt.read(text)
    parsed: list[ParsedPrompt] = []
    for part in range(len(prompt.questions)):
        parsed.append(_parsed(prompt, part, parsed[-1:], rng))
    return tuple(parsed)


def _parsed(
    prompt: PartPrompt, part: int, before: Sequence[ParsedPrompt], rng: np.random.Generator | None
) -> ParsedPrompt:
    question = prompt.questions[part]
    resolved = [
        full for earlier in before for full in resolved_references(question, earlier.query.moment, earlier.words)
    ]
    refused: list[TextError] = []
    for text in (text for each in (resolved or [question]) for text in prompt.single(part, each)):
        try:
            return parse_prompt(text, rng)
        except TextError as error:
            refused.append(error)
    raise refused[0]


def _unit_of(question: Question) -> str:
    if KINDS[question.query.kind].measured(question.query).whole:
        return AS_WHOLE
    return unit_in_words(question.unit) if question.unit else AS_PURE


def _told(unit: str) -> str:
    return unit if unit in (AS_WHOLE, AS_PURE) else f"in {unit}"


def _as_number(said: str) -> str:
    return AS_WHOLE if AS_WHOLE in said else AS_PURE


def _single_form(unit: str, answer: str = "your answer") -> str:
    """Return the last line of a prompt with one question."""
    form = {AS_WHOLE: WHOLE_NUMBER_FORMATS, AS_PURE: PLAIN_FORMATS}.get(unit, FORMATS)[0]
    return (
        form.replace("your answer", answer).format(unit=unit)
        if form in FORMATS
        else form.replace("your answer", answer)
    )


LETTERS = "ABCDE"
SIGNIFICANT_DIGITS = 3  # significant digits that prompts ask for
PLAIN_EXPONENTS = range(-3, 5)  # powers of ten of numbers written without scientific notation
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
        return cls(question, format_options(values, unit))

    @classmethod
    def read(cls, text: str) -> "ChoicePrompt":
        """Return the parts of a multiple-choice prompt; TextError for any other text."""
        body, _, last = text.rpartition("\n\n")
        question, _, listed = body.rpartition("\n\n")
        options = [_OPTION.fullmatch(line) for line in listed.splitlines()]
        prompt = cls(question, tuple(option[2] for option in options if option is not None))
        if last != ENDING or not prompt.options or prompt.text != text:
            raise TextError("prompt", "it has no options A, B, … with a last line about them", "give one of ours")
        return prompt

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


def format_options(values: Sequence[float], unit: str) -> tuple[str, ...]:
    """Return the texts of numbers with their unit, all in one style."""
    return tuple(join_unit(text.replace("-", MINUS), unit) for text in format_numbers(values))


def format_numbers(values: Sequence[float], digits: int = SIGNIFICANT_DIGITS) -> list[str]:
    """Return the texts of numbers, all as integers or all with `digits` significant digits and any powers of ten."""
    if all(value == round(value) and abs(value) < 10**digits for value in values):
        return [str(round(value)) for value in values]
    powers = [_power(value, digits) for value in values]
    if all(power in PLAIN_EXPONENTS for power in powers):
        pairs = zip(values, powers, strict=True)
        return [f"{float(f'{value:.{digits - 1}e}'):.{max(0, digits - 1 - power)}f}" for value, power in pairs]
    parted = (f"{value:.{digits - 1}e}".split("e") for value in values)
    return [f"{mantissa} × 10^{int(power)}" for mantissa, power in parted]


def _power(value: float, digits: int) -> int:
    """Return the exponent of ten of a number in scientific notation, after rounding to `digits` digits; 0 for zero."""
    rounded = abs(float(f"{value:.{digits - 1}e}"))
    return floor(log10(rounded)) if rounded else 0

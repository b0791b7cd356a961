"""Prompts: the text of a scene, one question, and a line on the form of the answer, in one of several shapes."""

import re
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from sim2reason.questions import KINDS, Formula, Question, Words
from sim2reason.questions.shapes import SHAPES
from sim2reason.scenes.dsl.measures import show_unit
from sim2reason.text.prose.description import Description
from sim2reason.text.prose.phrases import join, symbols

FORMATS = (
    "Give your answer in {unit}, to three significant figures, inside \\boxed{{}}.",
    "State the answer in {unit} to three significant figures, inside \\boxed{{}}.",
    "Write the answer in {unit}, to three significant figures, in \\boxed{{}}.",
)
WHOLE = (
    "Give your answer as a whole number, inside \\boxed{}.",
    "State the answer as a whole number inside \\boxed{}.",
    "Write the final answer, a whole number, in \\boxed{}.",
)
"""For what is counted."""


PLAIN_FORMATS = (
    "Give your answer to three significant figures, inside \\boxed{}.",
    "State the answer to three significant figures, inside \\boxed{}.",
    "Write the final answer, to three significant figures, in \\boxed{}.",
)
"""Of a pure number."""

SYMBOLIC = (
    "Give your answer in terms of {symbols}, inside \\boxed{{}}.",
    "Express the answer in terms of {symbols}, inside \\boxed{{}}.",
    "Write the final answer as a formula in terms of {symbols}, in \\boxed{{}}.",
    "The answer is a formula in {symbols}; put it in \\boxed{{}}.",
)
"""Where the numbers are symbols."""
ANGLES, IN_RADIANS = ("deg", "rad"), "in radians"
_TURNED = re.compile(
    r"\\(?:sin|cos|tan)(?:\^\{?\d\}?)?(?:\\left\(.*?\\right\)| ?\\?[A-Za-z]+(?:_\{.*?\}|_\\?[A-Za-z0-9]+)?)"
)
"""A trigonometric function with its argument."""


@dataclass(frozen=True)
class Prompt:
    """The text of a problem and the name of its shape."""

    text: str
    shape: str


def words_of(description: Description) -> Words:
    """Return the names, symbols and numbers of a description in the form that questions use."""
    scene = description.scene
    said = [(p.path, p) for p in scene.parameters if p.path in description.symbols]
    mentions = {address: description.mention(address) for address in scene.bodies}
    alone = {path: symbols([parameter], scene.bodies, description.names) for path, parameter in said}
    unknowns = {path: found[path] for path, found in alone.items()}
    together = {path: description.symbols[path] for path in description.told if path in description.symbols}
    return Words.of(scene, mentions, unknowns, together)


def prompt(description: Description, question: Question, rng: np.random.Generator) -> str:
    """Return the text of the scene, the question, and how to give the answer."""
    return shaped(description, question, rng).text


def shaped(description: Description, question: Question, rng: np.random.Generator) -> Prompt:
    """Return the prompt in a random shape that suits the text and the question."""
    form = _last_line(question, rng)
    body = composed(description, question.text, rng)
    after = "\n\n" if body.text.endswith("|") else " "
    return Prompt(f"{body.text}{after}{form}", body.shape)


def composed(
    description: Description, question: str, rng: np.random.Generator, *, question_last: bool = False
) -> Prompt:
    """Return scene and question in a random suitable shape, or in one that ends with the unchanged question."""
    names, shares = list(SHAPES), np.array([member.share for member in SHAPES.values()])
    order: list[int] = rng.choice(len(names), len(names), replace=False, p=shares / shares.sum()).tolist()
    for number in order:
        text = SHAPES[names[number]].compose(description, question, rng)
        if text is not None and (text.endswith(question) or not question_last):
            return Prompt(text, names[number])
    raise LookupError("no shape of prompts takes every text; one must")


def _last_line(question: Question, rng: np.random.Generator) -> str:
    """Return the last line, on how to give the answer."""
    if question.formula is not None:
        form = SYMBOLIC[int(rng.random() * len(SYMBOLIC))]
        own = f", {IN_RADIANS}" if question.unit in ANGLES else ""
        return form.format(symbols=f"{join(list(_named(question.formula)))}{own}")
    whole = KINDS[question.query.kind].measured(question.query).whole
    forms = WHOLE if whole else FORMATS if question.unit else PLAIN_FORMATS
    form = forms[int(rng.random() * len(forms))]
    return form.format(unit=unit_in_words(question.unit)) if forms is FORMATS else form


def _named(formula: Formula) -> Iterator[str]:
    """Yield the symbols of a formula, with *in radians* for angles outside trigonometric functions."""
    plain = _TURNED.sub("", formula.latex)
    for symbol, unit in zip(formula.symbols, formula.units, strict=True):
        yield f"${symbol}$ ({IN_RADIANS})" if unit in ANGLES and symbol in plain else f"${symbol}$"


def unit_in_words(unit: str) -> str:
    """Return a unit as it is written in a sentence: degrees as a word, all others as symbols."""
    return "degrees" if unit == "deg" else show_unit(unit)

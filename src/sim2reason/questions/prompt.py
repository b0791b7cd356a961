"""Prompts: the text of a scene, one question, one line on how to answer."""

import numpy as np

from sim2reason.dsl.measures import show_unit
from sim2reason.prose.writer import Description
from sim2reason.questions import KINDS, Question, Words

FORMATS = (
    "Give your answer in {unit}, to three significant figures, inside \\boxed{{}}.",
    "State the answer in {unit} to three significant figures, inside \\boxed{{}}.",
    "Write the final answer, in {unit} and to three significant figures, in \\boxed{{}}.",
)
WHOLE = (
    "Give your answer as a whole number, inside \\boxed{}.",
    "State the answer as a whole number inside \\boxed{}.",
    "Write the final answer, a whole number, in \\boxed{}.",
)
"""For what is counted."""


def words_of(description: Description) -> Words:
    """What questions need to know of a text."""
    scene = description.scene
    return Words.of(scene, {address: description.mention(address) for address in scene.bodies})


def prompt(description: Description, question: Question, rng: np.random.Generator) -> str:
    """The text of the scene, the question, and how to give the answer."""
    whole = KINDS[question.query.kind].measured(question.query).whole
    forms = WHOLE if whole else FORMATS
    form = forms[int(rng.random() * len(forms))]
    form = form if whole else form.format(unit=unit_in_words(question.unit))
    return f"{description.text} {question.text} {form}"


def unit_in_words(unit: str) -> str:
    """A unit as a sentence has it: degrees are a word, all else a symbol."""
    return "degrees" if unit == "deg" else show_unit(unit)

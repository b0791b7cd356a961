"""Shapes that differ in the order of the parts of a problem."""

import re
from collections.abc import Iterator

import numpy as np

from sim2reason.questions.shapes import Draft, PromptShape, shape
from sim2reason.questions.shapes.parts.units import (
    assumptions,
    is_table,
    one_of,
    splits,
    text_of,
    units,
    without_assumptions,
)
from sim2reason.text.prose.description import Description


@shape
class AssumptionsInBracket(PromptShape):
    """Assumptions in brackets: “How far apart are the pucks at t = 0.71 s? (All collisions are elastic.)”."""

    name = "assumptions_in_bracket"
    share = 0.85

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Return the prompt for a text that ends with general assumptions; None for others."""
        del rng
        held = assumptions(description)
        facts = description.sentences[: len(description.sentences) - len(held)]
        return text_of([*facts, question, f"({text_of(held)})"]) if held and facts else None

    def drafts(self, text: str) -> Iterator[Draft]:
        """Yield drafts of the usual order, with the bracketed assumptions moved from the end to before the question."""
        before, opens, inside = text.removesuffix(".)").rpartition(" (")
        if not (opens and text.endswith(".)")):
            return
        for story, question in splits(units(before)):
            yield Draft(text_of([*story, f"{inside}."]), question)


@shape
class AssumptionsLast(PromptShape):
    """Assumptions at the end: “How fast is block A moving? Friction at pulleys is negligible. Take g = 9.8 m/s².”."""

    name = "assumptions_last"

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Return the prompt for a text that ends with general assumptions; None for others."""
        del rng
        facts, closings = without_assumptions(description.sentences)
        return text_of([*facts, question, *closings]) if closings and facts else None

    def drafts(self, text: str) -> Iterator[Draft]:
        """Yield drafts of the usual order, with the closing assumptions moved from the end to before the question."""
        asked, closings = without_assumptions(units(text))
        for story, question in splits(asked) if closings else ():
            yield Draft(text_of([*story, *closings]), question)


FRONTS = (
    "Take g = {g} here.",
    "In this problem g = {g}.",
    "The acceleration of free fall is taken as g = {g}.",
    "Let the acceleration of free fall be g = {g}.",
    "Take the acceleration of free fall as g = {g}.",
)
USUAL = "Take g = {g}."
_TOLD = re.compile(r"\bg = (\S.{0,20})\.$")
_FRONT = re.compile("|".join(re.escape(front).replace(r"\{g\}", r"(\S.{0,20}?)") for front in FRONTS))


@shape
class GravityFirst(PromptShape):
    """The value of g first: “Take g = 9.8 m/s² here. Block A lies on …”."""

    name = "gravity_first"

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Return the prompt for a text that ends with the value of g; None for others."""
        front, *facts = one_of(FRONTS, rng), *description.sentences[:-1]
        told = _TOLD.search(description.sentences[-1])
        if told is None or description.role(description.sentences[-1]) != "assumption":
            return None
        return text_of([front.replace("{g}", told[1]), *facts, question])

    def drafts(self, text: str) -> Iterator[Draft]:
        """Yield drafts of the usual order, with the value of g moved from the front to the end of the scene's text."""
        first, *rest = units(text)
        told = _FRONT.fullmatch(first)
        number = next(filter(None, told.groups()), "") if told else ""
        for story, question in splits(rest) if number else ():
            yield Draft(text_of([*story, USUAL.replace("{g}", number)]), question)


LABELS = (
    ("Situation: ", "Question: "),
    ("Set-up: ", "Task: "),
    ("Given: ", "Asked: "),
    ("Description: ", "Question: "),
)


@shape
class Labelled(PromptShape):
    """Labelled parts: “Situation: Block A lies on …” and, in a paragraph of its own, “Question: how fast …?”."""

    name = "labelled"
    share = 0.3

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Return the prompt, which suits every text."""
        scene, asked = LABELS[int(rng.random() * len(LABELS))]
        return f"{scene}{description.text}\n\n{asked}{question}"

    def drafts(self, text: str) -> Iterator[Draft]:
        """Yield the draft whose scene and question are the texts after their labels."""
        for scene, asked in LABELS:
            story, heading, question = text.rpartition(f"\n\n{asked}")
            if heading and story.startswith(scene):
                yield Draft(story.removeprefix(scene), question)


BETWEEN = "\n\n"


@shape
class QuestionApart(PromptShape):
    """The usual order, with the question in a paragraph of its own."""

    name = "question_apart"
    share = 0.8

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Return the text with the question as its own paragraph; None after a table, which ends with an empty line."""
        del rng
        return None if is_table(description.sentences[-1]) else f"{description.text}{BETWEEN}{question}"

    def drafts(self, text: str) -> Iterator[Draft]:
        """Yield the draft whose question is the last paragraph of the text."""
        story, between, question = text.rpartition(BETWEEN)
        if between:
            yield Draft(story, question)


@shape
class SceneFirst(PromptShape):
    """The usual order: the scene with its general assumptions, then the question."""

    name = "scene_first"
    marked = False

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Return the prompt, which suits every text."""
        del rng
        return text_of([*description.sentences, question])

    def drafts(self, text: str) -> Iterator[Draft]:
        """Yield one draft with the last sentence as its question, and one with the last two sentences."""
        for story, question in splits(units(text)):
            yield Draft(text_of(story), question)

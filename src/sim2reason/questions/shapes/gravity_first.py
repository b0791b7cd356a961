"""The acceleration of free fall first, then the scene."""

import re
from collections.abc import Iterator

import numpy as np

from sim2reason.prose.description import Description
from sim2reason.questions.shapes import Draft, PromptShape, shape
from sim2reason.questions.shapes.parts.units import one_of, splits, text_of, units

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
    """Like this: “Take g = 9.8 m/s² here. Block A lies on …”."""

    name = "gravity_first"

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Of texts that end with the number of g."""
        front, *facts = one_of(FRONTS, rng), *description.sentences[:-1]
        told = _TOLD.search(description.sentences[-1])
        if told is None or description.role(description.sentences[-1]) != "assumption":
            return None
        return text_of([front.replace("{g}", told[1]), *facts, question])

    def drafts(self, text: str) -> Iterator[Draft]:
        """It goes back to the end of the story."""
        first, *rest = units(text)
        told = _FRONT.fullmatch(first)
        number = next(filter(None, told.groups()), "") if told else ""
        for story, question in splits(rest) if number else ():
            yield Draft(text_of([*story, USUAL.replace("{g}", number)]), question)

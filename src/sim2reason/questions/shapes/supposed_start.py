"""How the motion begins, as a supposition right before the question."""

from collections.abc import Iterator

import numpy as np

from sim2reason.prose.closings import RESTS
from sim2reason.prose.description import Description
from sim2reason.questions.shapes import Draft, PromptShape, shape
from sim2reason.questions.shapes.parts.units import (
    lowered,
    raised,
    splits,
    text_of,
    units,
    without_assumptions,
)

FRONT = "Suppose that "


@shape
class SupposedStart(PromptShape):
    """Like this: “Suppose that cart B is struck and starts off to the left at 0.47 m/s. How far …?”."""

    name = "supposed_start"
    share = 1.2

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Of texts whose last sentence before the closings on what holds throughout tells a start."""
        del rng
        facts, closings = without_assumptions(description.sentences)
        if not facts or description.role(facts[-1]) != "start" or facts[-1] in RESTS:
            return None
        return text_of([*facts[:-1], *closings, FRONT + lowered(facts[-1]), question])

    def drafts(self, text: str) -> Iterator[Draft]:
        """What is supposed goes back to before the closings."""
        for story, question in splits(units(text)):
            if story and story[-1].startswith(FRONT):
                facts, closings = without_assumptions(story[:-1])
                yield Draft(text_of([*facts, raised(story[-1].removeprefix(FRONT)), *closings]), question)

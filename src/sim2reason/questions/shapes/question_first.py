"""The question first, then the scene."""

from collections.abc import Iterator

import numpy as np

from sim2reason.prose.description import Description
from sim2reason.questions.shapes import Draft, PromptShape, shape
from sim2reason.questions.shapes.parts.units import (
    QUESTION,
    begins_plainly,
    lowered,
    one_of,
    raised,
    text_of,
    units,
)

FRONTS = (
    "In the set-up below, ",
    "For the motion below, ",
    "In the situation below, ",
    "In the following situation, ",
    "In the case below, ",
)


@shape
class QuestionFirst(PromptShape):
    """Like this: “In the set-up below, what is the tension 0.50 s after release? Block A lies …”."""

    name = "question_first"
    share = 0.45

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Of questions that begin with the word that asks, and assume nothing of what is not yet told."""
        front, lone = one_of(FRONTS, rng), len(units(question)) == 1
        return f"{front}{lowered(question)} {description.text}" if lone and begins_plainly(question) else None

    def drafts(self, text: str) -> Iterator[Draft]:
        """What a front announces, up to the end of its sentence or the next, is the question."""
        front = next((front for front in FRONTS if text.startswith(front)), None)
        said = units(text)
        for count in range(1, min(QUESTION, len(said) - 1) + 1) if front else ():
            yield Draft(text_of(said[count:]), raised(text_of(said[:count])[len(front or "") :]))

"""The scene, and the question in a paragraph of its own."""

from collections.abc import Iterator

import numpy as np

from sim2reason.prose.description import Description
from sim2reason.questions.shapes import Draft, PromptShape, shape
from sim2reason.questions.shapes.parts.units import is_table

BETWEEN = "\n\n"


@shape
class QuestionApart(PromptShape):
    """The usual order, but for the empty line that parts the question from the scene."""

    name = "question_apart"
    share = 0.8

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Return the text with the question as its own paragraph; None after a table, which ends with an empty line."""
        del rng
        return None if is_table(description.sentences[-1]) else f"{description.text}{BETWEEN}{question}"

    def drafts(self, text: str) -> Iterator[Draft]:
        """Yield the text with its last paragraph as the question."""
        story, between, question = text.rpartition(BETWEEN)
        if between:
            yield Draft(story, question)

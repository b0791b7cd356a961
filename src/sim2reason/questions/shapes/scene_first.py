"""The usual shape: the scene, then the question."""

from collections.abc import Iterator

import numpy as np

from sim2reason.prose.description import Description
from sim2reason.questions.shapes import Draft, PromptShape, shape
from sim2reason.questions.shapes.parts.units import splits, text_of, units


@shape
class SceneFirst(PromptShape):
    """The text of the scene with all that holds throughout, and the question last."""

    name = "scene_first"
    marked = False

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Of every text."""
        del rng
        return text_of([*description.sentences, question])

    def drafts(self, text: str) -> Iterator[Draft]:
        """The last sentence or two are the question."""
        for story, question in splits(units(text)):
            yield Draft(text_of(story), question)

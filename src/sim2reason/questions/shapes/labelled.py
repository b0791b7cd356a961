"""Scene and question as two paragraphs under headings, as on a worksheet."""

from collections.abc import Iterator

import numpy as np

from sim2reason.prose.description import Description
from sim2reason.questions.shapes import Draft, PromptShape, shape

LABELS = (
    ("Situation: ", "Question: "),
    ("Set-up: ", "Task: "),
    ("Given: ", "Asked: "),
    ("Description: ", "Question: "),
)


@shape
class Labelled(PromptShape):
    """Like this: “Situation: Block A lies on …* and, in a paragraph of its own, *Question: how fast …?”."""

    name = "labelled"
    share = 0.3

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Of every text."""
        scene, asked = LABELS[int(rng.random() * len(LABELS))]
        return f"{scene}{description.text}\n\n{asked}{question}"

    def drafts(self, text: str) -> Iterator[Draft]:
        """What stands under either heading."""
        for scene, asked in LABELS:
            story, heading, question = text.rpartition(f"\n\n{asked}")
            if heading and story.startswith(scene):
                yield Draft(story.removeprefix(scene), question)

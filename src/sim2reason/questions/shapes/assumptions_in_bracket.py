"""What holds throughout in a bracket after the question."""

from collections.abc import Iterator

import numpy as np

from sim2reason.prose.description import Description
from sim2reason.questions.shapes import Draft, PromptShape, shape
from sim2reason.questions.shapes.parts.units import assumptions, splits, text_of, units


@shape
class AssumptionsInBracket(PromptShape):
    """Like this: “How far apart are the pucks at t = 0.71 s? (All collisions are elastic.)”."""

    name = "assumptions_in_bracket"
    share = 0.85

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Of texts that end with what holds throughout."""
        del rng
        held = assumptions(description)
        facts = description.sentences[: len(description.sentences) - len(held)]
        return text_of([*facts, question, f"({text_of(held)})"]) if held and facts else None

    def drafts(self, text: str) -> Iterator[Draft]:
        """The bracket goes back to before the question."""
        before, opens, inside = text.removesuffix(".)").rpartition(" (")
        if not (opens and text.endswith(".)")):
            return
        for story, question in splits(units(before)):
            yield Draft(text_of([*story, f"{inside}."]), question)

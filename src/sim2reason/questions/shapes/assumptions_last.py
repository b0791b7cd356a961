"""What holds throughout after the question, g last."""

from collections.abc import Iterator

import numpy as np

from sim2reason.prose.description import Description
from sim2reason.questions.shapes import Draft, PromptShape, shape
from sim2reason.questions.shapes.parts.units import splits, text_of, units, without_assumptions


@shape
class AssumptionsLast(PromptShape):
    """Like this: “How fast is block A moving? Friction at pulleys is negligible. Take g = 9.8 m/s².”."""

    name = "assumptions_last"

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Of texts that close with what holds for every scene of their kind."""
        del rng
        facts, closings = without_assumptions(description.sentences)
        return text_of([*facts, question, *closings]) if closings and facts else None

    def drafts(self, text: str) -> Iterator[Draft]:
        """The closings go back to before the question."""
        asked, closings = without_assumptions(units(text))
        for story, question in splits(asked) if closings else ():
            yield Draft(text_of([*story, *closings]), question)

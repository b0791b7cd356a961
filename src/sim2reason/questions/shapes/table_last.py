"""A table after the question."""

from collections.abc import Iterator

import numpy as np

from sim2reason.prose.description import Description
from sim2reason.questions.shapes import Draft, PromptShape, shape
from sim2reason.questions.shapes.parts.units import is_table, splits, text_of, units


@shape
class TableLast(PromptShape):
    """The story and the question as they are, and between them and the last line the table of which they speak."""

    name = "table_last"
    share = 1.2

    def compose(self, description: Description, question: str, rng: np.random.Generator) -> str | None:
        """Of texts with one table."""
        del rng
        tables = [unit for unit in description.sentences if is_table(unit)]
        told = [unit for unit in description.sentences if not is_table(unit)]
        return text_of([*told, question, *tables]) if len(tables) == 1 else None

    def drafts(self, text: str) -> Iterator[Draft]:
        """The table goes back to any place in the story: reading shows which is right."""
        *told, last = units(text)
        if is_table(last):
            for story, question in splits(told):
                for place in range(1, len(story) + 1):
                    yield Draft(text_of([*story[:place], last, *story[place:]]), question)

"""The multipart mode: several questions about one scene, each of which leads to a later one."""

import numpy as np

from sim2reason.generation.modes.numeric import Numeric
from sim2reason.questions import KINDS, ParsedQuestion, Query, Question, Study, Words, mode


@mode
class Multipart(Numeric):
    """Several numbers, where one leads to the next?

    Each part is a numeric question; `datasets.part_search` looks for those that build on each other.
    """

    name = "multipart"
    several = True

    @property
    def kinds(self) -> frozenset[str]:
        """Those that leave no number of the text open, which other parts may need."""
        return frozenset(name for name in super().kinds if not KINDS[name].hides)

    def asking(self, query: Query, study: Study, words: Words, rng: np.random.Generator) -> Question | None:
        """None, too, where the question would leave a number open."""
        return super().asking(query, study, words, rng) if not query.hides else None

    def parsed(self, text: str, study: Study, words: Words) -> ParsedQuestion | None:
        """None: each part is read by itself, as a numeric question."""
        del text, study, words
        return None

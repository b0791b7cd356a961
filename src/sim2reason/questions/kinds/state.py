"""What is the quantity at a stated time?"""

import numpy as np

from sim2reason.questions.choices import pick
from sim2reason.questions.kinds import ValueKind, drawn, kind
from sim2reason.questions.query import Query
from sim2reason.questions.study import Study
from sim2reason.questions.targets import Targets
from sim2reason.questions.words import Words


@kind
class StateKind(ValueKind):
    """What is the quantity at a stated time?"""

    name = "state"
    share = 0.18  # at most 30 % of all that passes the filters

    def draw(self, study: Study, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Any quantity, and a time away from events."""
        target = pick(targets, rng)
        found = drawn(self.moments(), study, words, rng)
        if target is None or not found:
            return None
        return Query(self.name, target, found[int(rng.integers(len(found)))])

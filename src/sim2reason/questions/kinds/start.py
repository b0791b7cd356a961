"""What is the quantity just after the start?"""

import numpy as np

from sim2reason.quantities import QUANTITIES
from sim2reason.questions.choices import pick
from sim2reason.questions.kinds import ValueKind, drawn, kind
from sim2reason.questions.query import Query
from sim2reason.questions.study import Study
from sim2reason.questions.targets import Targets
from sim2reason.questions.words import Words


@kind
class StartKind(ValueKind):
    """What is an acceleration or a force at t = 0⁺, which the text does not give?"""

    name = "start"
    share = 0.25

    def draw(self, study: Study, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """A quantity that can differ from zero before anything has moved."""
        mechanism = study.mechanism
        if not (mechanism.lines or mechanism.contacts):
            return None  # what only falls has the acceleration that the text gives it
        target = pick([target for target in targets if QUANTITIES[target.quantity].immediate], rng)
        found = drawn(self.moments(), study, words, rng)
        if target is None or not found:
            return None
        return Query(self.name, target, found[int(rng.integers(len(found)))])

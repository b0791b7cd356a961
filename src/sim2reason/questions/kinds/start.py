"""What is the quantity just after the start?"""

import numpy as np

from sim2reason.quantities import QUANTITIES
from sim2reason.questions.choices import only_falls, pick
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
    timeless = True

    def draw(self, study: Study, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """A quantity that can differ from zero before anything has moved."""
        if only_falls(study.mechanism):
            return None
        target = pick([target for target in targets if QUANTITIES[target.quantity].immediate], rng)
        moment = drawn(self.moments(), study, words, rng)
        return Query(self.name, target, moment) if target is not None and moment is not None else None

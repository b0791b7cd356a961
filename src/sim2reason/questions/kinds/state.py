"""What is the quantity at a stated time?"""

import numpy as np

from sim2reason.questions.change import changed
from sim2reason.questions.choices import has_formula_of_time, pick
from sim2reason.questions.kinds import ValueKind, drawn, kind
from sim2reason.questions.moments import Moment
from sim2reason.questions.query import Query
from sim2reason.questions.study import Study
from sim2reason.questions.targets import Targets
from sim2reason.questions.words import Words


@kind
class StateKind(ValueKind):
    """What is the quantity at a stated time?"""

    name = "state"
    share = 0.06  # at most 30 % of all that passes the filters

    def draw(self, study: Study, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Draw a quantity at a time that is not close to an event, whose value differs then from the initial one.

        None where no short formula gives the motion as a function of time.
        """
        if not has_formula_of_time(study.mechanism):
            return None
        moment = drawn(self.moments(), study, words, rng)
        return self.at(moment, study, words, targets, rng) if moment is not None else None

    def at(
        self, moment: Moment, study: Study, words: Words, targets: Targets, rng: np.random.Generator
    ) -> Query | None:
        """Any quantity that is not then what it was at the start."""
        del words
        target = pick(targets, rng, changed(study, moment)) if moment.kind == self.name else None
        return Query(self.name, target, moment) if target is not None else None

"""What is the quantity when something happens for the first time?"""

import numpy as np

from sim2reason.questions.change import changed
from sim2reason.questions.choices import pick
from sim2reason.questions.kinds import ValueKind, drawn, kind
from sim2reason.questions.moments import Moment
from sim2reason.questions.query import Query
from sim2reason.questions.study import Study
from sim2reason.questions.targets import Targets
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel


@kind
class EventKind(ValueKind):
    """What is the quantity when something happens: a collision, a body that stops, or that has moved so far?"""

    name = "event"
    share = 0.3

    def draw(self, study: Study, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """A moment of this motion and a quantity that it bears on, but none that the question tells."""
        moment = drawn(self.moments(), study, words, rng)
        return self.at(moment, study, words, targets, rng) if moment is not None else None

    def at(
        self, moment: Moment, study: Study, words: Words, targets: Targets, rng: np.random.Generator
    ) -> Query | None:
        """A quantity that the moment bears on, but none that its words tell."""
        del words
        if moment.kind != self.name:
            return None
        offered = [target for target in targets if Channel(target.subject, target.quantity) not in moment.tells]
        if moment.own:
            offered = [target for target in offered if target.subject in moment.subjects] or offered
        target = pick(offered, rng, changed(study, moment))
        return Query(self.name, target, moment) if target is not None else None

"""Whether a round body rolls without slipping."""

from dataclasses import dataclass
from math import isfinite

import numpy as np

from sim2reason.dsl.mechanism import ZERO, Mechanism
from sim2reason.dsl.scene import Scene
from sim2reason.quantities.subjects.contacts import Contacts
from sim2reason.questions.moments.parts.slip_change import rolls, slip
from sim2reason.questions.outcomes import OUTCOMES, PossibleOutcome, rest_speed_noise
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace

ROUNDING = 1e-9  # m/s


@OUTCOMES.register("slips_rolling")
@dataclass(frozen=True, slots=True)
class SlipsRolling(PossibleOutcome):
    """A round body that could roll slips on its face; where its centre of mass is its centre, at once or never."""

    of = Contacts()

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """What may roll on a face that is rough, but not so rough that nothing ever slips."""
        mechanism = words.mechanism
        return {
            name: said
            for name, said in words.called(cls.of).items()
            if rolls(words, name)
            and mechanism.contacts[name].friction > 0.0
            and isfinite(mechanism.contacts[name].friction)
            and mechanism.body[name].center == ZERO
            and abs(_slip_at_start(mechanism, name)) <= ROUNDING
        }

    def duration(self, scene: Scene) -> float:
        """The horizon."""
        return scene.horizon

    def happens(self, trace: Trace) -> bool:
        """Whether it ever slips."""
        return self.excess(trace) > 0.0

    def excess(self, trace: Trace) -> float:
        """The fastest that it slips, but for what is none."""
        return float(np.abs(slip(trace.state, self.name)).max()) - rest_speed_noise(trace)

    def does(self, words: Words) -> tuple[str, ...]:
        """As in: the cylinder slips."""
        subject = self.subject(words)
        return (f"{subject} slips", f"{subject} slips as it rolls")

    def does_not(self, words: Words) -> tuple[str, ...]:
        """As in: the cylinder rolls without slipping."""
        subject = self.subject(words)
        return (f"{subject} rolls without slipping", f"{subject} does not slip")


def _slip_at_start(mechanism: Mechanism, name: str) -> float:
    """The velocity with which a body slips on its face at t = 0, m/s."""
    speeds = {coordinate.name: coordinate.speed for coordinate in mechanism.coordinates}
    return sum(factor * speeds[coordinate] for coordinate, factor in mechanism.contacts[name].slip)

"""The first time that a body is at the lowest point of its path."""

from dataclasses import dataclass

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.quantities.kinematics import Displacement, Velocity
from sim2reason.quantities.subjects.paths import chain
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.turning_point import TurningPoint
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.questions.study import Study

STANDS = 1e-3  # of its greatest speed: a hinge that turns more slowly stands still


@MOMENTS.register("lowest_point")
@dataclass(frozen=True, slots=True)
class LowestPoint(TurningPoint):
    """The first time that a body is at the lowest point of its path."""

    label = "lowest point"
    verb = Verb("passes through the lowest point of its path", "pass through the lowest point of its path")
    local_verb = Verb("stops falling", "stop falling")

    def comes(self, study: Study) -> bool:
        """Whether it passes through it: an arm that rocks to one side of its axle turns back where it is lowest."""
        if not super(LowestPoint, self).comes(study):  # slots make another class of this one, which super() misses
            return False
        time, hinges = study.time(self), _hinges(study.mechanism, self.name)
        assert time is not None
        turning, fastest = (
            np.abs(state.v[:, hinges]).max(axis=0) for state in (study.trace.at(time), study.trace.scan)
        )
        return not hinges or bool(np.any(turning > STANDS * fastest))

    def extent(self, state: State) -> Array:
        """Its depth from where it began."""
        return -Displacement.evaluate(state, self.name)[:, 2]

    def excess(self, state: State) -> Array:
        """How fast it rises."""
        return Velocity.evaluate(state, self.name)[:, 2]


def _hinges(mechanism: Mechanism, name: str) -> list[int]:
    """The coordinates with which the first body turns that turns at all, of itself and those that carry it."""
    each = ([c for c in body.coordinates if c.kind == "hinge"] for body in chain(mechanism, name))
    return [mechanism.number[c.name] for c in next(filter(None, each), ())]

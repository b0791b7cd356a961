"""The first time that a body is at the lowest point of its path."""

from dataclasses import dataclass

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.quantities.kinematics import Displacement, Velocity
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

    def comes(self, study: Study) -> bool:
        """Whether it passes through it: an arm that rocks to one side of its axle turns back where it is lowest."""
        time, hinges = study.time(self), _hinges(study.mechanism, self.name)
        if time is None or not hinges:
            return super(LowestPoint, self).comes(study)
        turning = np.abs(np.append(study.trace.scan.v, study.trace.sample(np.array([time])).v, axis=0)[:, hinges])
        return super(LowestPoint, self).comes(study) and bool(np.any(turning[-1] > STANDS * turning.max(axis=0)))

    def extent(self, state: State) -> Array:
        """Its depth from where it began."""
        return -Displacement.evaluate(state, self.name)[:, 2]

    def excess(self, state: State) -> Array:
        """How fast it rises."""
        return Velocity.evaluate(state, self.name)[:, 2]


def _hinges(mechanism: Mechanism, name: str | None) -> list[int]:
    """The coordinates about which the nearest body turns that it is fixed to and that turns, or it does itself."""
    while name is not None:
        body = mechanism.body[name]
        found = [mechanism.number[c.name] for c in body.coordinates if c.kind == "hinge"]
        if found:
            return found
        name = body.parent
    return []

"""Whether what burns fuel lifts off at once, or is too heavy at first."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from sim2reason.dsl.mechanism import Prop
from sim2reason.quantities.kinematics import Acceleration, Velocity
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.questions.regimes import REGIMES, Regime
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words

STILL = 1e-9  # m/s², m/s


@REGIMES.register("waits")
@dataclass(frozen=True, slots=True)
class DelayedLiftoff(Regime):
    """A rocket on the ground burns some of its fuel, and not all, before its thrust can lift it, or none."""

    of = Bodies()
    stage = 0
    unseen = True

    waits: bool

    @classmethod
    def possible(cls, study: Study, words: Words) -> Sequence[Self]:
        """What burns fuel and stands on something."""
        if not any(isinstance(line.law, Prop) for line in study.mechanism.lines):
            return []
        named = words.called(cls.of)
        found = [burn.body for burn in study.mechanism.burns if burn.body in named]
        return [cls(body, waits) for body in found for waits in (True, False)]

    def holds(self, study: Study, until: float) -> bool:
        """Whether it is accelerated as the engine starts; or it is not, but moves when that stops."""
        del until
        trace = study.trace
        burnt = min(*(burn.until for burn in trace.mechanism.burns if burn.body == self.name), trace.stable_until)
        pushed = Acceleration.evaluate(trace.at(0.0), self.name)
        moves = Velocity.evaluate(trace.at(burnt), self.name)
        lifted = float(np.linalg.norm(pushed)) > STILL
        return (not lifted and float(np.linalg.norm(moves)) > STILL) if self.waits else lifted

    def always_told(self, study: Study) -> bool:
        """Symbols do not say whether the thrust is more than the weight."""
        del study
        return True

    def margin(self, study: Study, until: float) -> float | None:
        """By how much the thrust at the start exceeds the weight, or falls short of it, as a share of the weight."""
        del until
        mechanism = study.mechanism
        weight = float(mechanism.body[self.name].mass * np.linalg.norm(mechanism.gravity))
        thrust = sum(burn.rate * burn.exhaust for burn in mechanism.burns if burn.body == self.name)
        return (thrust / weight - 1.0) * (-1.0 if self.waits else 1.0) if weight else None

    def clause(self, words: Words) -> str:
        """As in: the rocket lifts off as soon as its engine starts."""
        called = words.called(self.of)[self.name]
        if not self.waits:
            return f"{called} lifts off as soon as its engine starts"
        return f"{called} lifts off only after its engine has burned part of its fuel"

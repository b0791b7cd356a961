"""Assumptions about the fuel and the lift-off of rockets."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf
from typing import Self

import numpy as np

from sim2reason.questions.regimes import REGIMES, Regime
from sim2reason.questions.regimes.directions import MovesOneWay
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Prop
from sim2reason.simulation.quantities.kinematics import Acceleration, Velocity
from sim2reason.simulation.quantities.subjects.bodies import Bodies

THEN = 1e-9  # relative: a moment closer to burn-out coincides with it


@REGIMES.register("burnt out")
@dataclass(frozen=True, slots=True)
class BurntOut(Regime):
    """The assumption that all fuel is used up before the moment asked about, or that it is not.

    A rocket that may come down again has not yet done so, as the simulated motion ends there.
    """

    of = Bodies()
    stage = 2

    out: bool
    falls: bool = False

    @classmethod
    def possible(cls, study: SimulatedScene, words: Words) -> Sequence[Self]:
        """Return two regimes for each body that burns fuel: all of the fuel is used up before the moment, or not."""
        named = [burn.body for burn in study.mechanism.burns if burn.body in words.called(cls.of)]
        body = study.mechanism.body
        falls = {name: "s" in words.own and any(c.lower > -inf for c in body[name].coordinates) for name in named}
        return [held for name in named for held in (cls(name, out=True, falls=falls[name]), cls(name, out=False))]

    def holds(self, study: SimulatedScene, until: float) -> bool:
        """Return whether a time, s, is on the assumed side of burn-out, before or after; True at burn-out itself."""
        end = self._end(study)
        return until > end * (1.0 + THEN) if self.out else 0.0 < until < end * (1.0 - THEN)

    def margin(self, study: SimulatedScene, until: float) -> float | None:
        """Return the interval between the time and burn-out, relative to the burn time; None without a burn."""
        later = until / self._end(study) - 1.0
        return later if self.out else -later

    def _end(self, study: SimulatedScene) -> float:
        return max(burn.until for burn in study.mechanism.burns if burn.body == self.name)

    def must_be_stated(self, study: SimulatedScene) -> bool:
        """Return True, as formulas do not show the burn time."""
        del study
        return True

    def clause(self, words: Words) -> str:
        """Return a clause such as *it has burned all its fuel by that moment but has not yet fallen back*."""
        return f"{self.short_clause(words)}{' but has not yet fallen back' * (self.out and self.falls)}"

    def short_clause(self, words: Words) -> str:
        """Return the part about fuel only, such as *the rocket has burned all its fuel by that moment*."""
        called = words.called(self.of)[self.name]
        return (
            f"{called} has burned all its fuel by that moment"
            if self.out
            else f"{called} still has fuel at that moment"
        )

    def clause_beside(self, words: Words, others: Sequence[Regime]) -> str:
        """Return the clause without *but has not yet fallen back* if another clause says that the rocket only rises."""
        rises = any(isinstance(other, MovesOneWay) and other.name == self.name for other in others)
        return self.short_clause(words) if rises else self.clause(words)


STILL = 1e-9  # m/s², m/s


@REGIMES.register("waits")
@dataclass(frozen=True, slots=True)
class DelayedLiftoff(Regime):
    """The assumption that a rocket on the ground burns some of its fuel before it lifts off, or none."""

    of = Bodies()
    stage = 0
    unseen = True

    waits: bool

    @classmethod
    def possible(cls, study: SimulatedScene, words: Words) -> Sequence[Self]:
        """Return two regimes for each rocket that stands on the ground: lift-off after some burning, or at once."""
        if not any(isinstance(line.law, Prop) for line in study.mechanism.lines):
            return []
        named = words.called(cls.of)
        found = [burn.body for burn in study.mechanism.burns if burn.body in named]
        return [cls(body, waits) for body in found for waits in (True, False)]

    def holds(self, study: SimulatedScene, until: float) -> bool:
        """Return whether the rocket is accelerated at ignition or, for a delay, only later but before burn-out."""
        del until
        trace = study.trace
        burnt = min(*(burn.until for burn in trace.mechanism.burns if burn.body == self.name), trace.stable_until)
        pushed = Acceleration.evaluate(trace.at(0.0), self.name)
        moves = Velocity.evaluate(trace.at(burnt), self.name)
        lifted = float(np.linalg.norm(pushed)) > STILL
        return (not lifted and float(np.linalg.norm(moves)) > STILL) if self.waits else lifted

    def must_be_stated(self, study: SimulatedScene) -> bool:
        """Return True, as formulas do not show whether the thrust exceeds the weight."""
        del study
        return True

    def margin(self, study: SimulatedScene, until: float) -> float | None:
        """Return the difference of initial thrust and weight, relative to the weight; None without gravity."""
        del until
        mechanism = study.mechanism
        weight = float(mechanism.body[self.name].mass * np.linalg.norm(mechanism.gravity))
        thrust = sum(burn.rate * burn.exhaust for burn in mechanism.burns if burn.body == self.name)
        return (thrust / weight - 1.0) * (-1.0 if self.waits else 1.0) if weight else None

    def clause(self, words: Words) -> str:
        """Return the clause, such as *the rocket lifts off as soon as its engine starts*."""
        called = words.called(self.of)[self.name]
        if not self.waits:
            return f"{called} lifts off as soon as its engine starts"
        return f"{called} lifts off only after its engine has burned part of its fuel"

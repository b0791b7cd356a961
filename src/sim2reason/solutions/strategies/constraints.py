"""Constraints: inextensible strings and a resting centre of mass; momentum conserved along a direction."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.turning_points import Stopped
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.algebra.fractions import reduced_quotient
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.goals import GOALS, MotionPart
from sim2reason.solutions.laws.dynamics import Dynamics, LawQuantity
from sim2reason.solutions.laws.newton import Newton
from sim2reason.solutions.laws.stage_part import StagePart
from sim2reason.solutions.laws.straight_way import StraightMotion
from sim2reason.solutions.laws.written_dynamics import WrittenDynamics
from sim2reason.solutions.oscillations.single_way import TwoBodyModel
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.strategies import Strategy, strategy, varying_acceleration
from sim2reason.solutions.strategies.energy import EnergyModel, WorkAndEnergy
from sim2reason.solutions.writing.notation import METRES, SPEED
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError, record_inequality


@strategy
class Constraint(Strategy):
    """The strategy for the displacement of one body at a stated displacement of another, both from rest."""

    name = "constraint"
    cost = 0.5
    kinds = frozenset({"start", "state", "event", "time_to_event", "sum"})

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason that accelerations vary or the motion does not begin at rest; empty if neither is so."""
        if any(coordinate.speed for coordinate in mechanism.coordinates):
            return "it does not begin at rest"
        return varying_acceleration(mechanism)

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        target, moment = setting.target, setting.query.moment
        if not isinstance(moment, Moved) or target is None:
            return "no distance is stated"
        if target.quantity not in GOALS or GOALS[target.quantity].uses != "s":
            return "no distance is asked for"
        return "something changes on the way" if len(setting.motion.segments) > 1 else ""

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the ratios of displacements and the answer, and return the answer's symbol."""
        return _Proportions(setting, book).write()


class _Proportions(StraightMotion):
    """Displacements that constraints without forces relate to each other."""

    def size(self, k: int) -> Expression:
        """Return the distance that a coordinate covers, m: the size of its displacement, as nothing turns back."""
        displacement = self.rate("s", k).expression()
        return displacement if self.book.value(displacement) >= 0.0 else -displacement

    @cached_property
    def loaded(self) -> WrittenDynamics:
        """Return Newton's laws of the first segment, which give a force whose work or impulse is asked for."""
        return WrittenDynamics(self.setting, self.book, self.setting.motion.segments[0])

    def write(self) -> str:
        """Write the constraints and the answer, and return the answer's symbol."""
        assert self.target is not None
        assert self.goal is not None
        self.dynamics.reach([f"q{k}" for k in self.asked_coordinates()])
        force = self.goal.force(self.target, self.setting) if self.goal.throughout else ""
        if force:
            sliding = force[0] == "f" and self.loaded.newton.slip_directions[int(force[1:])]
            self.loaded.reach([f"N{force[1:]}" if sliding else force])
            if self.loaded.shared:
                raise UnsolvedError("the force hangs on accelerations")
        return self.goal.write(self.target, self).name

    @cached_property
    def dynamics(self) -> WrittenDynamics:
        """Return Newton's laws with displacements for accelerations, of which only constraints are used."""
        moment = self.query.moment
        assert isinstance(moment, Moved)
        k, *_ = self.moving([moment.name])
        name = self.book.fresh("d")
        self.book.state_given(name.name, moment.value, METRES)
        there = self.setting.motion.state(np.array([self.setting.time])).q[0]
        measure = LawQuantity("s", METRES, "displacement", tuple(there), (k, name))
        return WrittenDynamics(self.setting, self.book, self.setting.motion.segments[0], measure)

    @property
    def motion_parts(self) -> Sequence[MotionPart]:
        """Return the whole motion as a single part."""
        return [StagePart(self, _Course(self), self.loaded)]

    @property
    def newton(self) -> Newton:
        """Return Newton's laws of the only segment."""
        return self.dynamics.newton

    def rate(self, kind: str, k: int) -> Polynomial:
        """Return the displacement of a coordinate; UnsolvedError if it depends on forces."""
        del kind
        polynomial = self.dynamics.names.get(f"q{k}")
        if polynomial is None:
            raise UnsolvedError("a displacement hangs on forces")
        return polynomial

    def force(self, kind: str, name: str) -> Symbol:
        """Raise UnsolvedError, since forces need Newton's laws."""
        raise UnsolvedError(f"no {kind} of {name} without Newton's laws")


@dataclass(frozen=True, slots=True)
class _Course:
    """The whole motion as a single part."""

    model: _Proportions

    @property
    def dynamics(self) -> Dynamics:
        """Return Newton's laws, of which only the constraints on displacements are used."""
        return self.model.dynamics

    @property
    def time(self) -> Symbol:
        """Raise UnsolvedError, since times need forces."""
        raise UnsolvedError("no time without Newton's laws")

    def gain(self, k: int) -> Polynomial:
        """Return the displacement of a coordinate."""
        return self.model.rate("s", k)

    def gained(self, k: int) -> Polynomial:
        """Return the displacement of a coordinate relative to its carrier, as constraints count it."""
        return self.model.rate("s", k)

    def path(self, k: int) -> Expression:
        """Return the distance that a coordinate covers."""
        return self.model.size(k)


@strategy
class MomentumKept(WorkAndEnergy):
    """The strategy for two free coordinates with a conserved momentum."""

    name = "momentum"
    cost = 0.95
    kinds = frozenset({"event", "extremum"})
    free = 2

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason that a mechanism is unsuitable: a single moving body, or as for energy; else empty."""
        alone = len({coordinate.body for coordinate in mechanism.coordinates}) < self.free
        return "a single body moves" if alone else super().why_unsuitable(mechanism)

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the reduced mass, the work, the momentum and the answer, and return the answer's symbol."""
        return _Pair(setting, book).write().name


class _Pair(TwoBodyModel, EnergyModel):
    """A motion model of two bodies with relative speeds from energy."""

    def _turning(self) -> Symbol:
        """Write the turning point, and that a body that stops later still moves there; return its symbol."""
        turning_point, moment, book = super()._turning(), self.query.moment, self.book
        if not self.greatest or not isinstance(moment, Stopped) or not self.conserved_momentum:
            return turning_point
        both = reduced_quotient(self.conserved_momentum, self._relative.masses[0])
        own = self.moving([moment.name])
        first = self.first_speeds.get(own[0], NIL).expression() if len(own) == 1 else ZERO
        alike = self._relative.ratio(own[0], self._relative.other) == 1.0
        if not alike or book.is_hidden(both) or not 0.0 < book.value(both) < book.value(first):
            return turning_point
        step, name, who = book.begin_step("verify"), book.fresh("V"), self.setting.display_name(moment.name)
        record_inequality(book, step, both, ZERO)
        record_inequality(book, step, first, both)
        verified = step.verified(name, both, SPEED)
        step.add_text(
            f"The common velocity is then {verified}. Until then {who} is faster, so it has not come to rest before."
        )
        step.close()
        return turning_point

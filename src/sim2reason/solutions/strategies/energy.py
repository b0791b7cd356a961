"""Energy: the change in kinetic energy of a system with one free coordinate equals the work of all forces.

See any textbook, such as Kleppner and Kolenkow, An Introduction to Mechanics, chapter 5.
"""

from typing import ClassVar

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.questions.moments.contacts import StoppedSlipping
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.strings import MostCompressed, MostStretched, NaturalLength
from sim2reason.questions.moments.times import AtStart, AtTime
from sim2reason.questions.moments.turning_points import Stopped
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.fractions import reduced_quotient
from sim2reason.solutions.algebra.functions import Power, Root, sum_of_squares
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.goals import GOALS
from sim2reason.solutions.oscillations.friction import StaticFrictionChecks, first_friction, write_fastest_position
from sim2reason.solutions.oscillations.linear_motion import LinearMotion, min_free_coordinates, nonlinear_reason
from sim2reason.solutions.oscillations.net_force import (
    collect_stiffness,
    extensions_sentence,
    greatest_target,
    law_words,
    net_force,
    time_of_greatest,
    work,
    write_extreme_end,
)
from sim2reason.solutions.oscillations.single_way import OneCoordinateModel, signed_polynomial
from sim2reason.solutions.setting import ProblemContext, capitalized
from sim2reason.solutions.strategies import Strategy, missing_goal, strategy
from sim2reason.solutions.writing.notation import ACCELERATION, JOULES, METRES, SECONDS, SPEED
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

MOMENTS = (AtStart, AtTime, Moved, Stopped, StoppedSlipping, MostStretched, MostCompressed, NaturalLength)
HALF = Number(0.5)
REST_SPEED_RTOL = 1e-6  # relative to the greatest speed


@strategy
class WorkAndEnergy(Strategy):
    """The strategy for one free coordinate, with constant forces and springs."""

    name = "energy"
    cost = 1.05
    kinds = frozenset({"start", "state", "event", "time_to_event", "extremum"})
    free: ClassVar[int] = 1  # number of free coordinates

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that the strategy cannot apply to a mechanism; empty if it may apply."""
        if mechanism.meetings:
            return "something may collide"
        if min_free_coordinates(mechanism) > self.free:
            return "several things move by themselves"
        if len(mechanism.coordinates) < self.free:
            return "only one thing moves by itself"
        return nonlinear_reason(mechanism)

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        if greatest_target(setting) is None and (unknown := missing_goal(setting, MOMENTS)):
            return unknown
        target = greatest_target(setting)
        return f"no way to the quantity {target.quantity}" if target and target.quantity not in GOALS else ""

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the work, the kinetic energy and the answer, and return the answer's symbol."""
        return EnergyModel(setting, book).write().name


class EnergyModel(OneCoordinateModel):
    """A motion model with speeds from energy and accelerations from power."""

    @cached_property
    def _i(self) -> int:
        """Return the index of the only free coordinate."""
        if len(self.motion.free) != 1:
            raise UnsolvedError("several things move by themselves")
        if self.motion.damped:
            raise UnsolvedError("it is damped")
        return self.motion.free[0]

    @property
    def name(self) -> Symbol:
        """Return the symbol of the free coordinate."""
        return self._name

    @cached_property
    def _name(self) -> Symbol:
        name, motion = self.book.fresh("x"), self.motion
        self.introduce({self._i: name})
        if isinstance(motion, LinearMotion) and self._slides and not self.initial_rate(self._i):
            direction = self.towards(self._i, forward=motion.load(self._i).value(motion.givens) > 0.0)
            clause = f"{self.mover} starts to move {direction}"
            written = StaticFrictionChecks(self).write_moves(motion, 0, clause)
            step = self.book.begin_step("names")
            step.add_text("" if written else f"{capitalized(clause)}.", f"{first_friction(self, motion)}.")
            step.close()
        return name

    @property
    def _slides(self) -> bool:
        """Return whether kinetic friction acts."""
        return isinstance(self.motion, LinearMotion) and bool(self.motion.friction(self._i))

    def write(self) -> Symbol:
        """Write the time or the quantity that is asked for, and return its symbol."""
        _ = self.name
        if self.target is None or self.goal is None:
            return self._time
        return self._energy(self.target.subject) if self._is_all else self.goal.write(self.target, self)

    @property
    def _is_all(self) -> bool:
        """Return whether the question asks for the kinetic energy of the only moving body, which work alone gives."""
        assert self.target is not None
        timed = isinstance(self.query.moment, AtTime | AtStart) and not self.greatest
        moved = {self.mechanism.coordinates[k].body for k, parts in self.motion.ratios.items() if parts}
        alone = isinstance(self.motion, LinearMotion) and moved == {self.target.subject}
        return self.target.quantity == "kinetic energy" and alone and not timed and not self._turns

    def _energy(self, body: str) -> Symbol:
        """Write the kinetic energy, J, by the work-energy theorem and return its symbol."""
        formula, mark = self._kinetic(self._first) + work(self.motion, self._place), self.setting.subscript_of(body)
        text = f"By the work-energy theorem, the kinetic energy of {self.setting.display_name(body)} is"
        return self.book.add_step("energy", text, self.book.fresh("K", mark), formula, JOULES)

    # ---- the sums

    @cached_property
    def _mass(self) -> Expression:
        """Return the effective mass, kg, of all bodies that move with the free coordinate x."""
        return self.motion.mass(self._i, self._i).factored()

    @cached_property
    def _first(self) -> Expression:
        return self.initial_rate(self._i).expression()

    def _kinetic(self, v: Expression) -> Expression:
        return HALF * self._mass * sum_of_squares([v])

    # ---- the moment

    @cached_property
    def _engine(self) -> tuple[float, float]:
        """Return the free coordinate and its rate, by the engine, at the question's moment or greatest value."""
        time = time_of_greatest(self.setting) if self.greatest else self.setting.time
        state = self.setting.study.trace.sample(np.array([time]))
        return self.engine_value(state.q[0]), self.engine_value(state.v[0])

    @cached_property
    def _turns(self) -> bool:
        """Return whether the system is at rest at the moment."""
        if not self.greatest:
            self.stops_alone()
            return isinstance(self.query.moment, Stopped | MostStretched | MostCompressed | StoppedSlipping)
        speeds = [abs(self.engine_value(row)) for row in self.setting.study.trace.scan.v]
        return abs(self._engine[1]) <= 1e-3 * max(speeds)

    @cached_property
    def _place(self) -> Expression:
        """Write the free coordinate x at the moment of the question, m, and return it."""
        moment = self.query.moment
        if self._turns:
            if self.greatest and self.motion.springs:
                write_extreme_end(self.setting, self.book, self.name, self.mover)
            return self._turning()
        if self.greatest:
            return write_fastest_position(self, self._engine[0])
        if isinstance(moment, AtStart):
            return ZERO
        if isinstance(moment, Moved):
            return self.moved_to(moment)
        if isinstance(moment, NaturalLength):
            text = f"{capitalized(self.setting.spring_phrases[moment.name])} has its natural length at"
            return self.book.add_step("place", text, self.name, self.relaxed_place(moment.name), METRES)
        time = self._lasting
        formula = self._first * time
        formula = formula + HALF * self._rise * Power(time, 2)
        return self.book.add_step("distance", "In this time it moves by", self.name, formula, METRES)

    def _turning(self) -> Symbol:
        """Write x at the turning point, where the work uses up the initial kinetic energy, and return its symbol."""
        step, name = self.book.begin_step("energy"), self.name
        first = self._kinetic(self._first)
        law = step.law(first + work(self.motion, name), ZERO)
        load, stiffness = self.motion.load(self._i), self.motion.stiffness(self._i, self._i)
        if not stiffness:
            formula = -first / load.factored()
        elif first == ZERO:
            gathered = collect_stiffness(load, stiffness)
            plain = gathered == load.expression()
            formula = reduced_quotient(load.scale(2.0), stiffness) if plain else 2.0 * gathered / stiffness.expression()
        else:
            under = self._mass * stiffness.expression() * Power(self._first, 2)
            size = load.factored() if self.book.value(load.factored()) > 0.0 else load.scale(-1.0).factored()
            root = Root(Power(size, 2) + under if load else under)
            beyond = self._engine[0] > load.value(self.motion.givens) / stiffness.value(self.motion.givens)
            above = load.expression() + root if beyond else load.expression() - root
            formula = above / stiffness.expression()
        step.add_text(f"By the work-energy theorem, {self.at_rest} where {law},")
        step.add_text(f"so {step.result(name, formula, METRES)}.")
        step.add_text("The other root, zero, is the start." if first == ZERO and stiffness else "")
        if stiffness and first != ZERO and self.book.value(name) * self.book.value(self._first) > 0.0:
            wording = ("positive", "increases") if self.book.value(name) > 0.0 else ("negative", "decreases")
            step.add_text(f"This is the {wording[0]} root, as ${name.name}$ {wording[1]} at first.")
        step.close()
        return name

    # ---- speed, acceleration, time

    @cached_property
    def _speed(self) -> Expression:
        """Write the rate of the free coordinate x at the moment of the question, m/s, and return it."""
        if self._turns:
            return ZERO
        if isinstance(self.query.moment, AtStart):
            return self._first
        if isinstance(self.query.moment, AtTime) and not self.greatest:
            time = self._lasting
            formula = self._first + self._rise * time
            return self.book.add_step(
                "speed", f"At ${time.name}$ its velocity is", self.book.fresh("v"), formula, SPEED
            )
        moment = self.query.moment
        relaxed = moment.name if isinstance(moment, NaturalLength) and not self.greatest else ""
        gained = work(self.motion, self._place, self._number(relaxed) if relaxed else -1)
        if gained == ZERO:
            raise UnsolvedError("nothing does work")
        step, name = self.book.begin_step("energy"), self.book.fresh("v")
        law = step.law(self._kinetic(name), self._kinetic(self._first) + gained)
        root = Root(sum_of_squares([self._first]) + 2.0 * gained / self._mass)
        when = f" when {self.setting.spring_phrases[relaxed]} has its natural length" if relaxed else ""
        forward = self._engine[1] >= 0.0
        velocity = f"${name.name}$" if forward else f"$-{name.name}$"
        moving = f"the velocity {velocity} along ${self.name.name}$"
        moving = f"the speed ${name.name}$" if self.book.in_symbols else moving  # it may move either way
        step.add_text(f"By the work-energy theorem, with {moving}{when}: {law},")
        step.add_text(f"so {step.result(name, root, SPEED)}.")
        step.close()
        return name if forward else -name

    @cached_property
    def _rise(self) -> Symbol:
        """Write the acceleration of the free coordinate x from the net force along it, and return its symbol."""
        position: Expression = ZERO
        if self.motion.springs and not isinstance(self.query.moment, AtStart):
            if isinstance(self.query.moment, AtTime) and not self.greatest:
                raise UnsolvedError("energy says nothing of times where springs pull")
            position = self._place
        pulls, mass = net_force(self.motion, position), self._mass
        if pulls == ZERO:
            raise UnsolvedError("nothing is accelerated")
        step, name = self.book.begin_step("power"), self.book.fresh("a")
        step.add_text(extensions_sentence(self.motion, position, self.setting))
        step.add_text(*law_words(self.setting.mechanism, self.motion, mass, self.name, name))
        step.add_text(f"{step.law(mass * name, pulls)},")
        step.add_text(f"so {step.result(name, pulls / mass, ACCELERATION)}.")
        step.close()
        return name

    @cached_property
    def _lasting(self) -> Symbol:
        """Return the symbol of the time that the question states."""
        if self.motion.springs:
            raise UnsolvedError("energy says nothing of times where springs pull")
        moment = self.query.moment
        assert isinstance(moment, AtTime)
        name = self.book.fresh("t")
        self.book.state_given(name.name, moment.after, SECONDS)
        return name

    def moment_time(self) -> Symbol:
        """Return the time of the moment, given or computed."""
        return self._lasting if isinstance(self.query.moment, AtTime) else self._time

    @cached_property
    def _time(self) -> Symbol:
        """Write the time, s, from the mean of the initial and final velocities, and return its symbol."""
        if self.motion.springs:
            raise UnsolvedError("energy says nothing of times where springs pull")
        velocity_sum = self._speed + self._first
        if self._speed == ZERO:
            velocity_sum = self._first
        text = "At constant acceleration the mean velocity is the average of the initial and the final one:"
        return self.book.add_step("time", text, self.book.fresh("t"), 2.0 * self._place / velocity_sum, SECONDS)

    # ---- what goals ask

    def along(self, kind: str) -> Polynomial:
        """Return the displacement ``s``, velocity ``v`` or acceleration ``a`` of the free coordinate."""
        value = {"s": lambda: self._place, "v": lambda: self._speed, "a": lambda: self._rise}[kind]()
        return signed_polynomial(value)

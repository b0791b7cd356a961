"""Oscillation: one free coordinate on springs oscillates harmonically about its equilibrium.

See any textbook, such as Kleppner and Kolenkow, An Introduction to Mechanics, chapter 3.
"""

from collections.abc import Sequence

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.functionals.aggregates import Extreme
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.strings import NaturalLength
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.phrasing import PeriodQuery
from sim2reason.scenes.dsl.mechanism import Elastic, Mechanism
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.algebra.functions import Call, Power
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.goals import GOALS, MotionPart
from sim2reason.solutions.oscillations.harmonic import HarmonicOscillation, measured_period
from sim2reason.solutions.oscillations.linear_motion import min_free_coordinates, nonlinear_reason
from sim2reason.solutions.oscillations.net_force import greatest_target
from sim2reason.solutions.oscillations.single_way import OneCoordinateModel, TwoBodyModel, signed_polynomial
from sim2reason.solutions.oscillations.to_and_fro import (
    REST_SPEED_RTOL,
    BackAndForthTravel,
    verify_taut,
    write_first_move,
)
from sim2reason.solutions.setting import ProblemContext, capitalized
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.writing.notation import ACCELERATION, METRES, SECONDS, SPEED
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

SUMS = (
    *("distance travelled", "impulse of the net force", "impulse of a tension", "work of a tension"),
    "energy dissipated by friction",
)
TWO_COORDINATES = 2  # free coordinates of which one mode is left if a momentum is conserved


@strategy
class Oscillation(Strategy):
    """The strategy for one mode of oscillation, along a line or with strings over pulleys."""

    name = "oscillation"
    cost = 1.1
    kinds = frozenset({"state", "event", "time_to_event", "extremum", "period", "sum"})

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that the strategy cannot apply to a mechanism; empty if it may apply."""
        return no_oscillation_reason(mechanism) or (
            "there are several modes" if min_free_coordinates(mechanism) > TWO_COORDINATES else ""
        )

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        query = setting.query
        if isinstance(query, StretchQuery) and query.kind == "sum" and query.functional not in SUMS:
            return f"no way to the {query.functional}"
        target = greatest_target(setting) or setting.target
        return f"no way to the quantity {target.quantity}" if target and target.quantity not in GOALS else ""

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the equilibrium, the angular frequency, the moment and the answer, and return the answer's symbol."""
        model = Oscillating(setting, book)
        return (_Pair(setting, book) if len(model.linear.free) == 2 else model).write().name


def no_oscillation_reason(mechanism: Mechanism) -> str:
    """Return the reason that no linear oscillation occurs, such as *there is no spring*; empty if one is possible."""
    if not any(isinstance(line.law, Elastic) for line in mechanism.lines):
        return "there is no spring"
    return "something may collide" if mechanism.meetings else nonlinear_reason(mechanism)


class Oscillating(OneCoordinateModel):
    """A motion model of one oscillating coordinate, counted from the position `begin` at the time `started`, s."""

    begin: Expression = ZERO
    started = 0.0
    turned = 0

    @property
    def name(self) -> Symbol:
        """Return the symbol of the free coordinate, counted from the position `begin`."""
        return self.harmonic.name

    @cached_property
    def harmonic(self) -> HarmonicOscillation:
        """Return the oscillation; raise UnsolvedError unless there is exactly one undamped mode."""
        motion = self.motion
        if len(motion.free) != 1:
            raise UnsolvedError("there are several modes")
        if motion.damped or any(motion.laws.slip_directions.values()):
            raise UnsolvedError("it is damped")
        i = motion.free[0]
        name = self.book.fresh("x")
        self.introduce({i: name})
        return HarmonicOscillation(self.book, motion, name, self.initial_rate(i))

    def write(self) -> Symbol:
        """Write the answer to the query and return the answer's symbol."""
        query, oscillation = self.query, self.harmonic
        _ = oscillation.numbers
        self.stops_alone()
        if isinstance(query, PeriodQuery):
            return measured_period(self.book, query, self.harmonic.angular_frequency)
        verify_taut(self.setting, self.book, oscillation)
        if self.target is None or self.goal is None:
            return self._time
        return self.goal.write(self.target, self)

    # ---- the moment

    @cached_property
    def _when(self) -> float:
        """Return the time, s, of the question's moment or of the greatest value that is asked for, by the engine."""
        query, until = self.query, self.setting.time
        functional = FUNCTIONALS[query.functional] if isinstance(query, StretchQuery) else None
        if not isinstance(query, StretchQuery) or not isinstance(functional, Extreme):
            return until
        times = self.started + np.array(self.harmonic.instants(until - self.started))
        if not len(times):
            raise UnsolvedError("the greatest value is no extremum of the oscillation")
        heights = functional.height(self.setting.study.trace.sample(times), query.name)
        return float(times[int(np.argmax(heights))])

    @cached_property
    def _angle(self) -> Expression:
        """Return the phase ωt at the moment."""
        moment, oscillation = self.query.moment, self.harmonic
        if isinstance(moment, AtTime):
            return oscillation.angular_frequency * self.shift_time_to_begin(self._given_time)
        if oscillation.is_turning_point(self.time_since_start_position):
            return oscillation.angle_of_turning(self.time_since_start_position)
        return oscillation.angle_of(self._place, self.time_since_start_position)

    @property
    def time_since_start_position(self) -> float:
        """Return the time, s, from the instant at the position `begin` to the moment of the question."""
        return self._when - self.started

    def shift_time_to_begin(self, time: Symbol) -> Symbol:
        """Convert a time since the start to the time since the instant at the position `begin`; by default the same."""
        return time

    def shift_time_to_start(self, time: Symbol) -> Symbol:
        """Convert a time since the instant at the position `begin` to the time since the start; by default the same."""
        return time

    @cached_property
    def _given_time(self) -> Symbol:
        moment, name = self.query.moment, self.book.fresh("t")
        assert isinstance(moment, AtTime)
        self.book.state_given(name.name, moment.after, SECONDS)
        return name

    def moment_time(self) -> Symbol:
        """Return the time of the moment."""
        return self._given_time if self._timed else self._time

    @cached_property
    def _time(self) -> Symbol:
        """Return the time of the moment since the start, s."""
        return self.shift_time_to_start(self.time_since())

    def time_since(self) -> Symbol:
        """Write the time, s, from the instant at the position `begin` to the moment, and return its symbol."""
        oscillation, angle, position = self.harmonic, self._angle, self._place
        rate, turns = oscillation.angular_frequency, oscillation.is_turning_point(self.time_since_start_position)
        _ = self._first_move if turns else None
        step, time = self.book.begin_step("time"), self.time_name()
        motion = (rate * time, angle) if turns else (position, oscillation.displacement(time))
        step.add_text(
            f"{self._reached(turns=turns)} {step.law(*motion)}, so {step.result(time, angle / rate, SECONDS)}."
        )
        step.close()
        return time

    @cached_property
    def _first_move(self) -> None:
        """Write the initial direction of a motion from rest, which decides the turning points."""
        write_first_move(self, self.motion)

    def time_name(self) -> Symbol:
        """Return a new symbol for the time since the instant at the position `begin`."""
        return self.book.fresh("t")

    def _reached(self, *, turns: bool) -> str:
        """Return the beginning of a sentence about the event at the moment."""
        moment = self.query.moment
        if turns:
            return f"{self.standing} when"
        if isinstance(moment, Moved):
            return f"{capitalized(moment.told(self.setting.words, f'${self._given_distance}$'))} when"
        if isinstance(moment, NaturalLength) and self._place != self.harmonic.equilibrium:
            return f"{capitalized(self.setting.spring_phrases[moment.name])} has its natural length when"
        return f"{capitalized(self.harmonic.balance)} is reached when"

    @cached_property
    def _timed(self) -> bool:
        return isinstance(self.query.moment, AtTime) and not self.greatest

    @cached_property
    def _place(self) -> Expression:
        """Write the displacement from the position `begin` at the moment, m, and return it."""
        oscillation, moment = self.harmonic, self.query.moment
        if self._timed:
            formula = oscillation.displacement_at_phase(self._angle)
            return self.book.add_step("place", "The displacement is then", oscillation.name, formula, METRES)
        if not self.greatest:
            if isinstance(moment, NaturalLength):
                return self._relaxed(moment.name)
            if isinstance(moment, Moved):
                total_displacement = self.moved_to(moment)
                return total_displacement - self.begin
        if oscillation.is_turning_point(self.time_since_start_position):
            _ = self._first_move
            return self.book.add_step(
                "place",
                f"{self.standing} at",
                oscillation.name,
                oscillation.turning(self.time_since_start_position),
                METRES,
            )
        if (
            abs(oscillation.state_at(self.time_since_start_position)[0] - oscillation.numbers[1])
            > 1e-6 * oscillation.amplitude_value
        ):
            raise UnsolvedError("the moment is no mark of an oscillation")
        return oscillation.equilibrium

    def _relaxed(self, spring: str) -> Expression:
        """Write the displacement from `begin` at which a spring has its natural length, m, and return it."""
        formula = self.relaxed_place(spring) - self.begin
        if formula == ZERO:
            return ZERO
        name = self.setting.spring_phrases[spring]
        what = f"{name[:1].upper()}{name[1:]} has its natural length at"
        return self.book.add_step("place", what, self.harmonic.name, formula, METRES)

    @cached_property
    def _speed(self) -> Expression:
        """Write the velocity of the free coordinate at the moment, m/s, and return it."""
        oscillation = self.harmonic
        if not self._timed and oscillation.is_turning_point(self.time_since_start_position):
            return ZERO
        step, name, forward = (
            self.book.begin_step("speed"),
            self.book.fresh("v"),
            oscillation.state_at(self.time_since_start_position)[1] > 0.0,
        )
        if self._timed:
            formula: Expression = ZERO
            if oscillation.equilibrium != ZERO:
                formula = oscillation.equilibrium * oscillation.angular_frequency * Call("sin", self._angle)
            if oscillation.sine_coefficient != ZERO:
                formula = formula + oscillation.first.expression() * Call("cos", self._angle)
            shift = oscillation.displacement_at_phase(self._angle).latex()  # as a function of time
            step.add_text(
                f"The displacement is ${shift}$; its derivative is {step.result(name, formula, SPEED, law=True)}."
            )
        else:
            changes = f"${oscillation.name.name}$ {'increases' if forward else 'decreases'} at the rate"
            changes = f"At the moment in question {changes}"
            text = capitalized(self.fastest(oscillation.balance)) if self._place == oscillation.equilibrium else changes
            step.add_text(f"{text} {step.result(name, oscillation.speed_at(self._place), SPEED, law=True)}.")
        step.close()
        return name if self._timed or forward else -name

    # ---- what goals ask

    @cached_property
    def whole_place(self) -> Expression:
        """Write the displacement from the start at the moment, m, and return it."""
        if self.begin == ZERO:
            return self._place
        text = "The displacement from the start is then"
        name = self.book.fresh("x", str(self.turned + 1))
        return self.book.add_step("place", text, name, self.begin + self._place, METRES)

    @property
    def motion_parts(self) -> Sequence[MotionPart]:
        """Return the whole motion with its turning points."""
        oscillation, until = self.harmonic, self.setting.time
        turns = [
            time
            for time in oscillation.instants(until)
            if oscillation.is_turning_point(time) and time < until * (1.0 - REST_SPEED_RTOL)
        ]
        places: list[Expression] = [ZERO]
        for time in turns:
            name = self.book.fresh(oscillation.name.name.partition("_")[0])
            places.append(self.book.add_step("turning", f"{self.standing} at", name, oscillation.turning(time), METRES))
        return [BackAndForthTravel(self, [*places, self._place])]

    @cached_property
    def _acceleration(self) -> Symbol:
        oscillation, position, rest = self.harmonic, self._place, self.harmonic.equilibrium
        deviation = rest - position
        formula = Power(oscillation.angular_frequency, 2) * deviation
        text = f"The acceleration in the direction of increasing ${oscillation.name.name}$ is"
        return self.book.add_step("acceleration", text, self.book.fresh("a"), formula, ACCELERATION)

    def along(self, kind: str) -> Polynomial:
        """Return the displacement ``s``, velocity ``v`` or acceleration ``a`` of the free coordinate."""
        if kind == "a":
            return NIL if self._place == self.harmonic.equilibrium else Polynomial.from_expression(self._acceleration)
        return signed_polynomial(self.whole_place if kind == "s" else self._speed)


class _Pair(TwoBodyModel, Oscillating):
    """A motion model of two bodies joined by a spring, whose relative motion oscillates."""

    @property
    def motion_parts(self) -> Sequence[MotionPart]:
        """Raise UnsolvedError, since the paths of the bodies are not paths of the relative motion."""
        raise UnsolvedError("its path is no path of the relative motion")

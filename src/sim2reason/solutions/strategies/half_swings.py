"""Half-oscillations: friction shifts the equilibrium each time that a body on a spring turns back.

See Lapidus, Motion of a harmonic oscillator with sliding friction, American Journal of Physics 38 (1970) 1360.
"""

from collections.abc import Sequence
from math import pi

from sim2reason.base.records import cached_property
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.strings import NaturalLength
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.moments.turning_points import Halted
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.engines.exact.motion import Segment
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, total
from sim2reason.solutions.goals import MotionPart
from sim2reason.solutions.oscillations.friction import StaticFrictionChecks, swing_words
from sim2reason.solutions.oscillations.harmonic import HarmonicOscillation
from sim2reason.solutions.oscillations.linear_motion import LinearMotion, min_free_coordinates
from sim2reason.solutions.oscillations.to_and_fro import (
    FrictionTravel,
    write_first_rest,
    write_rest_beyond,
    write_rest_later,
)
from sim2reason.solutions.setting import ProblemContext, capitalized
from sim2reason.solutions.strategies import STRATEGIES, Strategy, strategy
from sim2reason.solutions.strategies.oscillation import Oscillating, no_oscillation_reason
from sim2reason.solutions.writing.notation import METRES, SECONDS
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError


@strategy
class HalfSwings(Strategy):
    """The strategy for one free coordinate on springs with kinetic friction."""

    name = "half swings"
    cost = 1.3
    kinds = frozenset({"state", "event", "time_to_event", "extremum", "sum"})

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that the strategy cannot apply to a mechanism; empty if it may apply."""
        if not any(face.friction > 0.0 for face in mechanism.faces):
            return "there is no friction"
        return no_oscillation_reason(mechanism) or (
            "there are several modes" if min_free_coordinates(mechanism) > 1 else ""
        )

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that an oscillation strategy does not apply to a question; else empty."""
        return STRATEGIES["oscillation"].why_not_applicable(setting)

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write each half-oscillation, the moment and the answer, and return the answer's symbol."""
        return _Swinging(setting, book).write().name


class _Swinging(Oscillating):
    """The last half-oscillation; earlier ones give its initial position and time."""

    _half: Symbol | None = None  # the duration of a half-oscillation, once it is written

    @cached_property
    def _segments(self) -> list[Segment]:
        return [s for s in self.setting.motion.segments if s.start < self.setting.time * (1.0 - 1e-9) or s.start == 0.0]

    @cached_property
    def segment(self) -> Segment:
        """Return the last segment of the motion."""
        return self._segments[-1]

    @cached_property
    def _checks(self) -> StaticFrictionChecks:
        return StaticFrictionChecks(self)

    def write(self) -> Symbol:
        """Verify the assumptions about friction, write the answer and return its symbol."""
        moment, oscillation = self.query.moment, self.harmonic
        self._verify_others(oscillation)
        if isinstance(moment, Halted):
            there = self.whole_place
            self._checks.write_stays(self._motion(self.segment, there), len(self._segments))
        marked = isinstance(moment, Moved | NaturalLength) and not self.greatest
        if marked and not oscillation.is_turning_point(self.time_since_start_position):
            self._turns_beyond(oscillation)
        return super().write()

    # ---- swing by swing

    def _motion(self, segment: Segment, begin: Expression) -> LinearMotion:
        """Return the equations of one half-oscillation, with positions counted from `begin`."""
        at = self.book.value(begin) if begin != ZERO else 0.0
        return LinearMotion(self.setting, segment, self.linear.free).counted_from(begin, at)

    def _swing(self, segment: Segment, name: Symbol, before: HarmonicOscillation | None) -> HarmonicOscillation:
        """Return one half-oscillation, with positions counted from the turning point at which it begins."""
        motion = self._motion(segment, self.begin)
        if len(motion.free) != 1:
            raise UnsolvedError("there are several modes")
        if motion.damped or not any(motion.laws.slip_directions.values()):
            raise UnsolvedError("it does not slide all the while")
        return HarmonicOscillation(
            self.book, motion, name, NIL if before else self.initial_rate(motion.free[0]), before
        )

    @cached_property
    def harmonic(self) -> HarmonicOscillation:
        """Write all half-oscillations and return the last one."""
        if len(self.linear.free) != 1:
            raise UnsolvedError("nothing moves at last, or several modes do")
        first = self.book.fresh("x")
        self.introduce({self.linear.free[0]: first})
        before: HarmonicOscillation | None = None
        for number, segment in enumerate(self._segments):
            name = self.book.fresh("s", str(number + 1)) if number else first
            oscillation = self._swing(segment, name, before)
            self._begins(oscillation, number)
            if segment is self._segments[-1]:
                return oscillation
            span = self._segments[number + 1].start - segment.start
            if not oscillation.is_turning_point(span):
                raise UnsolvedError("something changes on the way that is no turn")
            self._turn(oscillation, span)
            before = oscillation
        raise UnsolvedError("it never moves")

    def _begins(self, held: HarmonicOscillation, number: int) -> None:
        """Write why the body moves in a half-oscillation, and that friction is constant until it next comes to rest."""
        motion = held.motion
        assert isinstance(motion, LinearMotion)
        resting = [motion.mechanism.faces[face].subject for face, _ in self._checks.resting_faces(motion)]
        if resting and not number and not self.book.in_symbols:
            self._write_names(
                f"Assume that {self.setting.bodies_phrase(resting)} {'stays' if len(resting) == 1 else 'stay'} at rest."
            )
        if number:
            self._checks.write_moves(motion, number, f"{self.mover} moves back")
        elif not held.first:
            (i,) = motion.free
            forward = motion.load(i).value(motion.givens) > 0.0
            clause = f"{self.mover_phrase(i)} starts to move {self.towards(i, forward=forward)}"
            self._assume(clause if not self._checks.write_moves(motion, number, clause) else "")
        else:
            self._assume("")
        self._write_names(*swing_words(self, held, number))

    def _assume(self, said: str) -> None:
        """Write what is assumed and verified later: the clause `said`, and motion back at each turning point."""
        if self.book.in_symbols:
            return
        if len(self._segments) > 1 and self._checks.is_force_hidden(self._motion(self._segments[-1], ZERO)):
            back = "moves back at each turning point before the moment in question"
            said = f"{said} and {back}" if said else f"{self.mover} {back}"
        self._write_names(f"Assume that {said}." if said else "")

    def _write_names(self, *sentences: str) -> None:
        step = self.book.begin_step("names")
        step.add_text(*sentences)
        step.close()

    def _turn(self, held: HarmonicOscillation, span: float) -> None:
        """Write the position of the next turning point, preceded by its time if times are needed."""
        first, book = self.begin == ZERO, self.book
        self._times.append((held, span))
        timed = self.query.target is None or isinstance(self.query.moment, AtTime)
        if timed:
            _ = self._earlier_duration
        who = capitalized(self.mover)
        text = "The turning point is at" if timed else f"{who} first comes to rest at"
        text, name = (text, book.fresh("x", "1")) if first else (f"{who} next comes to rest at", held.name)
        there = book.add_step("turning", text, name, held.turning(span), METRES)
        if not first:
            text, name = "The displacement from the start is then", book.fresh("x", str(len(self._places)))
            there = book.add_step("turning", text, name, self.begin + there, METRES)
        self.begin = there
        self._places.append(there)
        self.started, self.turned = self.started + span, self.turned + 1

    @cached_property
    def _places(self) -> list[Expression]:
        return [ZERO]

    # ---- times

    @cached_property
    def _times(self) -> list[tuple[HarmonicOscillation, float]]:
        return []

    @cached_property
    def _lasting(self) -> list[Symbol]:
        """Return the symbols of the durations of half-oscillations that are written."""
        return []

    @property
    def _earlier_duration(self) -> Expression:
        """Return the total duration of the earlier half-oscillations, and write those durations that are missing."""
        for oscillation, span in self._times[len(self._lasting) :]:
            self._lasting.append(self._lasts(oscillation, span))
        return total(map(Polynomial.from_expression, self._lasting)).expression()

    def _time_name(self) -> Symbol:
        return self.book.fresh("t", str(len({duration.name for duration in self._lasting}) + 1))

    def _lasts(self, held: HarmonicOscillation, span: float) -> Symbol:
        """Write the duration of a half-oscillation, s, only once for those that begin at rest; return its symbol."""
        from_rest = held.sine_coefficient == ZERO
        if from_rest and self._half is not None:
            return self._half
        if not from_rest:
            return write_first_rest(self, held, span, self._time_name())
        text = "From one moment of rest to the next it takes half an oscillation:"
        if not self._lasting:
            text = f"{capitalized(self.mover)} first comes to rest after half an oscillation,"
        formula = held.angle_of_turning(span) / held.angular_frequency
        self._half = self.book.add_step("time", text, self._time_name(), formula, SECONDS)
        return self._half

    def shift_time_to_begin(self, time: Symbol) -> Symbol:
        """Return the time within the last half-oscillation: a time less the earlier durations."""
        left = time
        if self._times:
            before = self._earlier_duration
            text = capitalized(f"{self._equal_times()}the remaining time is")
            left = self.book.add_step("time", text, self._time_name(), time - before, SECONDS)
        self._turns_later(left)
        return left

    def time_since(self) -> Symbol:
        """Write the time of the moment within the last half-oscillation, s, and return its symbol."""
        oscillation = self.harmonic
        if oscillation.is_turning_point(self.time_since_start_position):
            return self._lasts(oscillation, self.time_since_start_position)
        return super().time_since()

    def time_name(self) -> Symbol:
        """Return a symbol for the time within the last half-oscillation, `t` if it is the first."""
        return self._time_name() if self._times else self.book.fresh("t")

    def shift_time_to_start(self, time: Symbol) -> Symbol:
        """Return the time since the start, s, from the time within the last half-oscillation."""
        if not self._times:
            return time
        total_time = total(map(Polynomial.from_expression, (*self._lasting, time))).expression()
        text = capitalized(f"{self._equal_times(time)}the total time is")
        return self.book.add_step("time", text, self.book.fresh("t"), total_time, SECONDS)

    def _equal_times(self, *more: Symbol) -> str:
        """Return a clause such as *both half oscillations take the same time, so*; empty for one half-oscillation."""
        goes_on, number = more != (self._half,), sum(duration == self._half for duration in (*self._lasting, *more))
        every = "both" if number == 2 else f"all {number}"
        every = f"the first {'two' if number == 2 else number}" if goes_on else every
        return f"{every} half oscillations take the same time, so " if number > 1 else ""

    @property
    def standing(self) -> str:
        """Return words such as *The block next comes to rest*, which begin a sentence on a half-oscillation's end."""
        return f"{capitalized(self.mover)} {'next' if self._times else 'first'} comes to rest"

    # ---- what is verified

    def _ends_after(self, held: HarmonicOscillation) -> float:
        """Return the duration of a half-oscillation, s."""
        return min(time for time in held.instants(2.0 * pi / held.numbers[0]) if held.is_turning_point(time))

    def _turns_later(self, left: Symbol) -> None:
        """Write that the last half-oscillation takes longer than the remaining time."""
        formula = self.harmonic.angle_of_turning(self._ends_after(self.harmonic)) / self.harmonic.angular_frequency
        write_rest_later(self.book, formula, left, self._half, again=bool(self._times))

    def _turns_beyond(self, held: HarmonicOscillation) -> None:
        """Write that the body comes to rest only beyond its position at the moment, if need be at the end."""
        formula, position, later = held.turning(self._ends_after(held)), self._place, len(self._places) > 1
        if not self.book.in_symbols and any(map(self.book.is_hidden, (formula, position))):
            self.book.afterwards.append(lambda: write_rest_beyond(self, held, formula, position, later=later))
        else:
            write_rest_beyond(self, held, formula, position, later=later)

    def _verify_others(self, held: HarmonicOscillation) -> None:
        """Write that bodies at rest stay at rest while the oscillating body moves between its turning points."""
        motion = held.motion
        assert isinstance(motion, LinearMotion)
        if not self._checks.resting_faces(motion):
            return
        span, places = self._ends_after(held), [*self._places]
        if len(places) == 1:
            text, name = "It first comes to rest at", self.book.fresh("x", "1")
            places.append(self.book.add_step("turning", text, name, held.turning(span), METRES))
        self._checks.others_rest(motion, places, self.book.value(self.begin) + held.state_at(span)[0])

    @property
    def motion_parts(self) -> Sequence[MotionPart]:
        """Return all half-oscillations as one motion with friction."""
        last = self.whole_place
        return [FrictionTravel(self, [*self._places, last])]

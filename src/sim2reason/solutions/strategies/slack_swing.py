"""Slack swing: a bob whose string goes slack: energy on the circle, then a projectile, then the circle again."""

from collections.abc import Mapping
from typing import ClassVar

from sim2reason.base.records import cached_property
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.strings import WentTaut
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.moments.turning_points import HighestPoint, Stopped
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.trace import Event
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import Call, Power, Root
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.swings.angle import UP
from sim2reason.solutions.swings.asked import EXTREMES, quantity_of, where_extreme
from sim2reason.solutions.swings.pendulum import pivot
from sim2reason.solutions.swings.slack_chain import (
    FREE_FLIGHT_PHRASE,
    ON_CIRCLE,
    MotionState,
    SlackSwingPhases,
    change,
    vector_magnitude,
    write_free_flight,
    write_velocities,
)
from sim2reason.solutions.writing.notation import QUANTITY_SYMBOLS, SECONDS, SPEED, magnitude_words
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

MOMENTS = (AtTime, HighestPoint, Stopped, WentTaut)
EVENT_TIME_RTOL = 1e-9  # relative tolerance of equal times
TWO, HALF = Number(2.0), Number(0.5)
LOSS = "energy lost in a jerk"


@strategy
class SlackSwing(Strategy):
    """The strategy for a small body on a string that goes slack, at a later moment."""

    name = "circle and projectile"
    cost = 1.05
    kinds = Strategy.kinds | {"extremum", "sum"}

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that no small body swings on a string; empty if a body does."""
        suspension = pivot(mechanism)
        return "" if suspension is not None and suspension[1] is not None else "no small body swings on a string"

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        quantity, query = quantity_of(setting), setting.query
        if quantity and quantity not in _Slack.METHOD_BY_QUANTITY:
            return f"no way to the {quantity}"
        if not isinstance(query.moment, MOMENTS):
            return f"no way to the moment {type(query.moment).__name__}"
        happened = setting.earlier_event_kinds | ({"taut"} if isinstance(query.moment, WentTaut) else set[str]())
        return "" if happened & {"slack", "taut"} else "the string stays taut"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write each phase of the motion, on the circle or in free flight, and the answer; return its symbol."""
        return _Slack(setting, book).write().name


class _Slack:
    """The quantities of a bob in the last phase of its motion, which contains the moment of the question."""

    def __init__(self, setting: ProblemContext, book: SolutionBuilder) -> None:
        """Take a question, without writing anything."""
        self.setting, self.book = setting, book
        self.chain = SlackSwingPhases(setting, book)
        self.swing, self.mass = self.chain.swing, self.chain.swing.mass
        self.quantity = quantity_of(setting)
        self.timed = isinstance(setting.query.moment, AtTime) or not self.quantity
        self.speed: Expression = self.swing.launch  # along the circle, at the beginning of the last phase on it
        self.since: Expression = ZERO  # beginning of the last phase
        self.phase_start_time = 0.0  # s, its value

    # ---- the phases

    @property
    def _passed(self) -> list[Event]:
        """Return the events at which the string goes slack or taut before the phase that contains the moment."""
        moment, end = self.setting.query.moment, self.setting.time
        if isinstance(moment, WentTaut) and moment.after and self.quantity not in ("", LOSS):
            return self.chain.changes
        return [event for event in self.chain.changes if event.time < end * (1.0 - EVENT_TIME_RTOL)]

    @cached_property
    def is_slack(self) -> bool:
        """Return whether the string is slack in the last phase."""
        return self._passed[-1].kind == "slack" if self._passed else self.chain.slack_at_once

    @cached_property
    def last(self) -> MotionState:
        """Write all phases before that of the moment; return its initial position and velocity."""
        state, flies = self.chain.start, self.chain.slack_at_once
        self.chain.write_axes()
        self._phase("the start of the motion", flies=flies)
        for event in self._passed:
            if (event.kind == "taut") != flies:
                raise UnsolvedError("the string goes slack just where it becomes taut")
            state = self._tightened(state) if flies else self._slackened(state, event.time)
            flies = not flies
            self.phase_start_time = event.time
            self._phase(f"the string becomes {'slack' if flies else 'taut'}", flies=flies)
        return state

    def _phase(self, begins: str, *, flies: bool) -> None:
        """Begin a phase on the circle or in free flight."""
        acts = FREE_FLIGHT_PHRASE if flies else ON_CIRCLE
        self.book.begin_phase(
            begins, f"{self.chain.who} {acts} until the string becomes {'taut' if flies else 'slack'}"
        )

    def _slackened(self, held: MotionState, time: float) -> MotionState:
        state = self.chain.goes_slack(held, time)
        if self.timed:
            angle = self.chain.angle(state, self.book.fresh(r"\phi", r"\text{s}"))
            self._later(self.chain.times(held, self.speed).reaches(angle, time - self.phase_start_time))
        return state

    def _tightened(self, held: MotionState) -> MotionState:
        span, before = self.chain.is_taut_again(held)
        state, self.speed = self.chain.write_jerk(before)
        if self.timed:
            self._later(span)
        return state

    def _later(self, span: Symbol) -> None:
        """Write the start time of the next phase: that of the current one plus its duration `span`."""
        if self.since == ZERO:
            self.since = span
            return
        self.since = self.book.add_step("time", "The time is then", self.book.fresh("t"), self.since + span, SECONDS)

    # ---- the moment

    @cached_property
    def moment_state(self) -> MotionState:
        """Write the position and velocity at the moment and return them."""
        moment, state = self.setting.query.moment, self.last
        if isinstance(moment, WentTaut):
            return self.chain.is_taut_again(state)[1] if self.is_slack else state
        if isinstance(moment, AtTime):
            return self._at_time(moment, state)
        return self.chain.highest(state) if self.is_slack else self.chain.turns(state)

    def _at_time(self, moment: AtTime, held: MotionState) -> MotionState:
        name = self.book.fresh("t")
        self.book.state_given(name.name, moment.after, SECONDS)
        left = name
        if self.since != ZERO:
            text = "The time since then is"
            left = self.book.add_step("time", text, self.book.fresh("t"), name - self.since, SECONDS)
        if self.is_slack:
            return self.chain.after(held, left, f"At that time {self.chain.who} is at")
        return self.chain.write_circular_motion(held, self.chain.times(held, self.speed), left)

    def _when(self) -> Symbol:
        """Write the time of the moment and return its symbol."""
        state = self.last
        if isinstance(self.setting.query.moment, WentTaut):
            span, _ = self.chain.is_taut_again(state)
        elif self.is_slack:
            text = "The vertical velocity is zero after"
            span = self.book.add_step("time", text, self.book.fresh("t"), state.vy / self.chain.gravity, SECONDS)
        else:
            span = self.chain.times(state, self.speed).write_vertical_time(self.setting.time - self.phase_start_time)
        self._later(span)
        assert isinstance(self.since, Symbol)
        return self.since

    # ---- what is asked

    def write(self) -> Symbol:
        """Write the answer to the query and return the answer's symbol."""
        if not self.quantity:
            return self._when()
        sense = self.setting.query.target.sense if self.setting.query.target is not None else None
        if sense is not None and sense.vector != UP and any(sense.vector):
            raise UnsolvedError("a component along a direction that is not vertical")
        self.vertical = sense is not None and sense.vector == UP
        method, why = self.METHOD_BY_QUANTITY[self.quantity]
        formula: Expression = getattr(self, method)()
        if sense is None and self.book.value(formula) < 0.0:
            formula, why = -formula, magnitude_words(why, self.quantity)
        if isinstance(formula, Symbol):
            return formula
        return self.book.add_step(
            "answer", why, self.book.fresh(QUANTITY_SYMBOLS[self.quantity]), formula, self.setting.unit
        )

    @cached_property
    def fastest(self) -> Expression:
        """Write the speed at the lowest point, before the string goes slack, and return its square."""
        query = self.setting.query
        if not isinstance(query, StretchQuery) or EXTREMES[query.functional][1] != "fastest":
            raise UnsolvedError("it is not greatest at the lowest point")
        chain, start = self.chain, self.chain.start
        self._phase("the start of the motion", flies=False)
        step, v = self.book.begin_step("energy"), self.book.fresh("v", r"\text{b}")
        square = chain.squared(start) + TWO * chain.gravity * (chain.length + start.y)
        law = step.law(Power(v, 2), square)
        superlative, _, noun = query.functional.partition(" ")
        step.add_text(where_extreme(self.quantity, noun, superlative, "at the lowest point"), self._later_slower)
        step.add_text(f"There {law}, so {step.result(v, Root(square), SPEED)}.")
        step.close()
        return Power(v, 2)

    @property
    def _later_slower(self) -> str:
        """Return a sentence why the speed is never greater after the string has gone slack; empty if it stays taut."""
        kinds = {event.kind for event in self.chain.changes}
        jerk = ", and it loses energy when the string becomes taut again" if "taut" in kinds else ""
        return f"With the string slack, {self.chain.who} is above this point and so slower{jerk}." if kinds else ""

    @property
    def extreme(self) -> bool:
        """Return whether a greatest value is asked for."""
        return isinstance(self.setting.query, StretchQuery) and self.setting.query.functional in EXTREMES

    @cached_property
    def square(self) -> Expression:
        """Return the square of the speed at the moment."""
        if self.is_slack and not self.extreme and self.moment_state.vy == ZERO:
            write_free_flight(self.book, self.moment_state)
        return self.fastest if self.extreme else self.chain.squared(self.moment_state)

    @property
    def height(self) -> Expression:
        """Return the height above the fixed point."""
        return -self.chain.length if self.extreme else self.moment_state.y

    def _velocity(self) -> Expression:
        if self.vertical:
            return self.moment_state.vy
        square = self.square
        return square.base if isinstance(square, Power) else Root(square)

    def _kinetic(self) -> Expression:
        return HALF * self.mass * self.square

    def _momentum(self) -> Expression:
        return self.mass * self._velocity()

    def _height(self) -> Expression:
        return self.moment_state.y - self.chain.start.y

    def _potential(self) -> Expression:
        return self.mass * self.chain.gravity * self._height()

    def _displacement(self) -> Expression:
        if self.vertical:
            return self._height()
        return vector_magnitude(self.moment_state.x - self.chain.start.x, self._height())

    def _impulse(self) -> Expression:
        there, start = self.moment_state, self.chain.start
        write_velocities(self.book, there, start, flies=self.is_slack)
        return self.mass * change(self.book, there, start)

    def _on_circle(self) -> None:
        """Raise UnsolvedError if the string is slack."""
        if self.is_slack and not self.extreme:
            raise UnsolvedError("the string is slack")

    def _tension(self) -> Expression:
        self._on_circle()
        return self.mass * (self.square - self.chain.gravity * self.height) / self.chain.length

    def _acceleration(self) -> Expression:
        ell, g = self.chain.length, self.chain.gravity
        if self.extreme:
            return self.square / ell
        self._on_circle()
        if self.vertical:
            raise UnsolvedError("a component of the acceleration on the circle")
        return vector_magnitude(self.square / ell, g * self.moment_state.x / ell)

    def _force(self) -> Expression:
        return self.mass * self._acceleration()

    def _deflection(self) -> Expression:
        self._on_circle()
        return Call("arccos", -(self.moment_state.y / self.chain.length))

    def _loss(self) -> Expression:
        return HALF * self.mass * Power(self.chain.radial(self.moment_state), 2)

    METHOD_BY_QUANTITY: ClassVar[Mapping[str, tuple[str, str]]] = {
        "velocity": ("_velocity", "The velocity is"),
        "kinetic energy": ("_kinetic", "The kinetic energy is"),
        "momentum": ("_momentum", "The momentum is"),
        "height": ("_height", "The height above the starting point is"),
        "potential energy": ("_potential", "The change in potential energy is"),
        "displacement": ("_displacement", "The displacement is"),
        "impulse of the net force": ("_impulse", "The impulse is the change in momentum, of magnitude"),
        "tension": ("_tension", "By Newton's second law along the string, the tension is"),
        "acceleration": ("_acceleration", "The acceleration is"),
        "net force": ("_force", "The net force is"),
        "deflection": ("_deflection", "The angle with the downward vertical is"),
        LOSS: ("_loss", "The kinetic energy lost is"),
    }

"""Tumbling: a prism tips over its edges; energy about each edge, angular momentum as the next one lands."""

from collections.abc import Callable, Mapping
from math import radians
from typing import ClassVar

from sim2reason.base.records import cached_property
from sim2reason.questions.moments.angles import TurnedThrough
from sim2reason.questions.moments.times import AtStart, AtTime
from sim2reason.questions.moments.turning_points import HighestPoint
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.trace import Event, events_before
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import PI, Call, Power, Root, sum_of_squares
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.swings.asked import COMPONENT_LEADS, of_components, quantity_of
from sim2reason.solutions.swings.rigid_shapes import (
    angle_words,
    landing_words,
    shape_words,
    sinking_words,
    velocities_words,
    verify_tops,
    write_sentence,
)
from sim2reason.solutions.swings.times import SwingTime
from sim2reason.solutions.writing.lexicon import UnreadError
from sim2reason.solutions.writing.notation import (
    ANGULAR_ACCELERATION,
    ANGULAR_SPEED,
    DEGREES,
    INERTIA,
    QUANTITY_SYMBOLS,
    SECONDS,
    magnitude_words,
)
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

MOMENTS = (AtStart, AtTime, HighestPoint, TurnedThrough)
HALF, TWO, FOUR, SIX = Number(0.5), Number(2.0), Number(4.0), Number(6.0)


@strategy
class Tumbling(Strategy):
    """The strategy for a regular prism that turns about one edge after another without slip or rebound."""

    name = "tumbling over edges"
    cost = 1.1
    kinds = Strategy.kinds | {"sum"}

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that the strategy cannot apply to a mechanism; empty if it may apply."""
        kinds = sorted(c.kind for c in mechanism.coordinates)
        alone = len(mechanism.bodies) == 1 and kinds == ["hinge", "slide", "slide"]
        return "" if alone and mechanism.feet else "no lone prism tumbles"

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        query, quantity = setting.query, quantity_of(setting)
        if quantity and quantity not in _Tumbling.METHOD_BY_QUANTITY:
            return f"no way to the {quantity}"
        if not isinstance(query.moment, MOMENTS) or not quantity:
            return f"no way to the moment {type(query.moment).__name__}"
        return ""

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the rotation about each edge and the answer, and return the answer's symbol."""
        return _Tumbling(setting, book).write().name


class _Tumbling:
    """The quantities of a tumbling prism; angles are those from the upward vertical to the line edge–axis."""

    def __init__(self, setting: ProblemContext, book: SolutionBuilder) -> None:
        """Read the parameters; raise UnreadError if one is not a simple function of the numbers in the text."""
        self.setting, self.book = setting, book
        body, read = setting.mechanism.bodies[0].name, setting.lexicon.formula_for
        radius, sides = setting.given(f"{body}.radius"), getattr(setting.scene.bodies.get(body), "sides", 0)
        if radius is None or not sides:
            raise UnreadError("its shape is not known")
        self.who, self.radius = setting.display_name(body), Symbol(radius.symbol)
        self.sides = float(sides)
        self.half: Expression = PI / Number(self.sides)
        self.turn: Expression = PI / Number(0.5 * self.sides)
        self.mass = read(lambda m: m.bodies[0].mass).expression()
        self.gravity = read(lambda m: -m.gravity[2]).expression()
        self.launch = read(lambda m: abs(next(c.speed for c in m.coordinates if c.kind == "hinge"))).expression()
        rise = read(lambda m: max((c.axis for c in m.coordinates if c.kind == "slide"), key=lambda a: abs(a[0]))[2])
        sine = rise.expression()
        self.slope: Expression = sine.argument if isinstance(sine, Call) else ZERO
        if self.slope == ZERO and sine != ZERO:
            raise UnreadError("its slope is not known")
        self.highest = isinstance(setting.query.moment, HighestPoint)
        self.edges = 0  # number of landings before the current phase
        self.rate: Expression = self.launch  # angular velocity at the beginning of that phase
        self.since: Expression = ZERO  # beginning of that phase
        self.phase_start_time = 0.0  # s, its value

    # ---- moments of inertia, energy

    @cached_property
    def axis_inertia(self) -> Symbol:
        """Write the moment of inertia about the axis and return its symbol."""
        formula = self.mass * Power(self.radius, 2) * (TWO + Call("cos", self.turn)) / SIX
        text = shape_words(self.who, round(self.sides), self.turn)
        return self.book.add_step("table", text, self.book.fresh("I", "0"), formula, INERTIA)

    @cached_property
    def about(self) -> Symbol:
        """Write the moment of inertia of the prism about an edge and return its symbol."""
        text = "By the parallel-axis theorem, the moment of inertia about an edge is"
        formula = self.axis_inertia + self.mass * Power(self.radius, 2)
        return self.book.add_step("inertia", text, self.book.fresh("I"), formula, INERTIA)

    @property
    def weight(self) -> Expression:
        """Return the greatest torque of gravity about an edge, at a horizontal lever arm."""
        return self.mass * self.gravity * self.radius

    @property
    def begins(self) -> Expression:
        """Return the angle of the line edge–axis with the upward vertical just after a landing, negative uphill."""
        return self.slope - self.half if self.slope != ZERO else -self.half

    # ---- the phases

    @cached_property
    def landings(self) -> list[Event]:
        """Return the landings before the moment."""
        return [e for e in events_before(self.setting.motion.events, self.setting.time) if e.kind == "land"]

    @cached_property
    def pendulum_frequency(self) -> Symbol:
        """Write √(m g R/I), the frequency of the equivalent pendulum about an edge, rad/s, and return its symbol."""
        text = "About an edge it moves like a pendulum whose small oscillations have the angular frequency"
        name, formula = self.book.fresh(r"\omega", "n"), Root(self.weight / self.about)
        return self.book.add_step("natural", text, name, formula, ANGULAR_SPEED)

    def _times(self) -> SwingTime:
        return SwingTime(self.book, self.pendulum_frequency, PI + self.begins, self.rate, 1.0)

    def _through(self) -> None:
        """Write all phases before that of the moment."""
        timed = isinstance(self.setting.query.moment, AtTime)
        self.book.begin_phase("the start of the motion", f"the next edge of {self.who} lands")
        rates = list[Expression]()
        for event in self.landings:
            if timed:
                self._lands_after(event.time)
            rates.append(self.rate)
            self._lands()
            self.edges, self.phase_start_time = self.edges + 1, event.time
            self.book.begin_phase("an edge lands", f"the next edge of {self.who} lands")
        verify_tops(self.book, [*rates, self.rate], self.about, self.weight, self.begins)

    def _lands_after(self, time: float) -> None:
        end = PI + (self.slope + self.half if self.slope != ZERO else self.half)
        span = self._times().reaches(end, time - self.phase_start_time)
        if self.since == ZERO:
            self.since = span
        else:
            self.since = self.book.add_step(
                "time", "The time is then", self.book.fresh("t"), self.since + span, SECONDS
            )

    def _lands(self) -> None:
        """Write the angular velocities just before and just after the next edge hits the surface."""
        book, fast, after = self.book, self.book.fresh(r"\omega"), self.book.fresh(r"\omega")
        step = book.begin_step("energy")
        drop = FOUR * self.weight * Call("sin", self.half) * Call("sin", self.slope) if self.slope != ZERO else ZERO
        law = step.law(
            HALF * self.about * Power(fast, 2), HALF * self.about * sum_of_squares([self.rate]) + HALF * drop
        )
        formula = Root(sum_of_squares([self.rate]) + drop / self.about)
        step.add_text(f"{sinking_words(self.radius, self.half, self.slope)}. By conservation of energy, {law},")
        step.add_text(f"so {step.result(fast, formula, ANGULAR_SPEED)}.")
        step.close()
        step = book.begin_step("landing")
        left = self.axis_inertia + self.mass * Power(self.radius, 2) * Call("cos", self.turn)
        law = step.law(self.about * after, left * fast)
        step.add_text(landing_words(self.radius * fast, self.turn, law))
        step.add_text(f"so {step.result(after, left * fast / self.about, ANGULAR_SPEED)}.")
        step.close()
        self.rate = after

    @cached_property
    def turned_angle(self) -> Expression:
        """Write the angle turned about the last edge at the moment and return it."""
        moment = self.setting.query.moment
        self._through()
        if isinstance(moment, AtStart):
            return ZERO
        if self.highest:
            return -self.begins
        if isinstance(moment, AtTime):
            return self._swung - PI - self.begins
        assert isinstance(moment, TurnedThrough)
        name = self.book.fresh(r"\phi")
        self.book.set_value(name.name, radians(moment.value), DEGREES)
        self.book.stated[name.name] = rf"{moment.value:g}{DEGREES}"
        if not self.edges:
            return name
        text = "Since the last landing it has turned through"
        completed_angle = Number(2.0 * self.edges / self.sides) * PI
        return self.book.add_step("angle", text, self.book.fresh(r"\phi"), name - completed_angle, DEGREES)

    @property
    def angle(self) -> Expression:
        """Return the angle at the moment, positive downhill."""
        turned = self.turned_angle
        if self.highest:
            return ZERO
        return self._swung - PI if isinstance(self.setting.query.moment, AtTime) else self.begins + turned

    @cached_property
    def _swung(self) -> Expression:
        """Write the angle of the equivalent pendulum from the downward vertical at a stated time, and return it."""
        moment = self.setting.query.moment
        assert isinstance(moment, AtTime)
        name = self.book.fresh("t")
        self.book.state_given(name.name, moment.after, SECONDS)
        left = name
        if self.since != ZERO:
            text = "The time since then is"
            left = self.book.add_step("time", text, self.book.fresh("t"), name - self.since, SECONDS)
        return self._times().angle(left)

    @cached_property
    def spin(self) -> Expression:
        """Write the angular velocity at the moment and return it."""
        angle = self.angle
        if isinstance(self.setting.query.moment, AtStart):
            return self.launch
        step, name = self.book.begin_step("energy"), self.book.fresh(r"\omega")
        here = Call("cos", angle) if angle != ZERO else ONE
        gained = self.weight * (Call("cos", self.begins) - here)
        law = step.law(HALF * self.about * Power(name, 2), HALF * self.about * sum_of_squares([self.rate]) + gained)
        formula = Root(sum_of_squares([self.rate]) + TWO * gained / self.about)
        where = "At the highest point the axis is straight above the edge. By" if self.highest else "By"
        step.add_text(f"{where} conservation of energy, {law}, so {step.result(name, formula, ANGULAR_SPEED)}.")
        step.close()
        return name

    @cached_property
    def growth(self) -> Expression:
        """Write the angular acceleration at the moment and return it."""
        if self.angle == ZERO:
            return ZERO
        write_sentence(self.book, angle_words(self.half, self.angle))
        text = "The torque of gravity about the edge divided by the moment of inertia is"
        formula = self.weight * Call("sin", self.angle) / self.about
        return self.book.add_step("torque", text, self.book.fresh(r"\alpha"), formula, ANGULAR_ACCELERATION)

    def write(self) -> Symbol:
        """Write the answer to the query and return the answer's symbol."""
        query, quantity = self.setting.query, quantity_of(self.setting)
        if query.target is not None and query.target.sense is not None and any(query.target.sense.vector):
            raise UnsolvedError("a component along a direction")
        attribute: Expression | Callable[[], Expression] = getattr(self, self.METHOD_BY_QUANTITY[quantity][0])
        formula, text = attribute() if callable(attribute) else attribute, self.METHOD_BY_QUANTITY[quantity][1]
        if self.book.value(formula) < 0.0:
            formula, text = -formula, magnitude_words(text, quantity)
        if isinstance(formula, Symbol):
            return formula
        if quantity in COMPONENT_LEADS:
            text = of_components(
                quantity, self.radius * sum_of_squares([self.spin]), self.radius * self.growth, begins=True
            )
        return self.book.add_step(
            "answer", text, self.book.fresh(QUANTITY_SYMBOLS[quantity]), formula, self.setting.unit
        )

    def _velocity(self) -> Expression:
        return self.radius * self.spin

    def _momentum(self) -> Expression:
        return self.mass * self._velocity()

    def _acceleration(self) -> Expression:
        inward = Power(self.spin, 2)
        return self.radius * (inward if self.growth == ZERO else Root(Power(self.spin, 4) + Power(self.growth, 2)))

    def _force(self) -> Expression:
        return self.mass * self._acceleration()

    def _kinetic(self) -> Expression:
        return HALF * self.about * Power(self.spin, 2)

    def _moving_energy(self) -> Expression:
        return HALF * self.mass * Power(self._velocity(), 2)

    def _turning_energy(self) -> Expression:
        return HALF * self.axis_inertia * Power(self.spin, 2)

    def _angular_momentum(self) -> Expression:
        return self.axis_inertia * self.spin

    def _torque(self) -> Expression:
        return self.axis_inertia * self.growth

    def _impulse(self) -> Expression:
        bent = self.launch * self.spin * Call("cos", self.turned_angle)
        text = velocities_words(self.turned_angle, highest=self.highest, landed=self.edges > 0)
        write_sentence(self.book, text)
        return self.mass * self.radius * Root(sum_of_squares([self.launch]) + sum_of_squares([self.spin]) - TWO * bent)

    METHOD_BY_QUANTITY: ClassVar[Mapping[str, tuple[str, str]]] = {
        "velocity": ("_velocity", "The speed of the centre is the angular speed times the radius,"),
        "momentum": ("_momentum", "The momentum is"),
        "angular velocity": ("spin", "The angular velocity is"),
        "angular acceleration": ("growth", "The angular acceleration is"),
        "acceleration": ("_acceleration", COMPONENT_LEADS["acceleration"]),
        "net force": ("_force", COMPONENT_LEADS["net force"]),
        "kinetic energy": ("_kinetic", "The kinetic energy is"),
        "translational kinetic energy": ("_moving_energy", "The kinetic energy of the motion of the centre of mass is"),
        "rotational kinetic energy": ("_turning_energy", "The kinetic energy of the rotation about the axis is"),
        "angular momentum": ("_angular_momentum", "The angular momentum about the axis is"),
        "torque": ("_torque", "The torque about the axis is"),
        "impulse of the net force": ("_impulse", "The impulse is the change in momentum, of magnitude"),
    }

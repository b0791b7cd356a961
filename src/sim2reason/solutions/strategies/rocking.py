"""Rocking: a round body with an eccentric centre of mass rolls without slipping; torque about its contact."""

from collections.abc import Callable
from math import hypot, inf

from sim2reason.base.records import cached_property
from sim2reason.questions.moments.times import AtStart
from sim2reason.questions.phrasing import PeriodQuery
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.solids import Shape
from sim2reason.scenes.dsl.vectors import apply_tensor, dot
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import Call, Power, Root, sum_of_squares
from sim2reason.solutions.oscillations.harmonic import measured_period
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.swings.rigid_shapes import candidates, mean_squares
from sim2reason.solutions.writing.lexicon import UnreadError
from sim2reason.solutions.writing.notation import (
    ACCELERATION,
    ANGULAR_ACCELERATION,
    ANGULAR_SPEED,
    DEGREES,
    INERTIA,
    METRES,
    NEWTONS,
    TORQUE,
)
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

INERTIA_RTOL = 1e-9
TWO = Number(2.0)
QUANTITIES = ("acceleration", "angular acceleration", "net force", "friction force", "normal force", "torque")


@strategy
class Rocking(Strategy):
    """The strategy for the initial forces on a rocking body, and for its small oscillations."""

    name = "rocking without slipping"
    cost = 1.1
    kinds = frozenset({"start", "period"})

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that a mechanism is not a single rocking body; empty if it is one."""
        m = mechanism
        other = m.lines or m.forces or m.attractions or m.burns or m.meetings or m.feet
        kinds = sorted(c.kind for c in m.coordinates)
        if len(m.bodies) != 1 or kinds != ["hinge", "slide"] or len(m.faces) != 1 or other:
            return "no lone body rolls"
        if m.faces[0].friction != inf or not any(m.bodies[0].center):
            return "it may slip, or its centre of mass lies on its axis"
        return ""

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        query = setting.query
        if isinstance(query, PeriodQuery):
            return "" if query.small else "only integration gives the period of large swings"
        if not isinstance(query.moment, AtStart) or query.target is None:
            return "it is not about the start"
        return "" if query.target.quantity in QUANTITIES else f"no way to the quantity {query.target.quantity}"

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the centre of mass, the moment of inertia about the contact and the answer; return its symbol."""
        return _Rocking(setting, book).write().name


class _Rocking:
    """The quantities of a rocking body; x points right, z up, and it rolls clockwise to the right."""

    def __init__(self, setting: ProblemContext, book: SolutionBuilder) -> None:
        """Read the parameters; raise UnreadError if one is not a simple function of the numbers in the text."""
        self.setting, self.book = setting, book
        self.body = setting.mechanism.bodies[0].name
        self.mass = self._read(lambda m: m.bodies[0].mass)
        self.gravity = self._read(lambda m: -m.gravity[2])
        self.radius = self._size("radius")
        self.aside = [self._read(lambda m, n=n: m.bodies[0].center[n] / hypot(*m.bodies[0].center)) for n in (0, 2)]
        self.uphill = [self._read(lambda m, n=n: _slide(m)[n]) for n in (0, 2)]
        speed = self._read(lambda m: sum(c.speed for c in m.coordinates if c.kind == "slide"))
        self.launch = speed / self.radius

    def _read(self, number: Callable[[Mechanism], float]) -> Expression:
        return self.setting.lexicon.formula_for(number).expression()

    def _size(self, field: str) -> Expression:
        given = self.setting.given(f"{self.body}.{field}")
        if given is None:
            raise UnreadError(f"the {field} is not said")
        return Symbol(given.symbol)

    # ---- the body

    @cached_property
    def _spread(self) -> tuple[Expression, Expression]:
        """Return the distance of the centre of mass from the axis, and the body's moment of inertia over its mass."""
        body, shape = self.setting.mechanism.bodies[0], self.setting.scene.bodies.get(self.body)
        spread = mean_squares(shape, self._size) if isinstance(shape, Shape) else None
        if spread is None:
            raise UnreadError(f"{self.setting.display_name(self.body)} is in no table")
        axis = next(c.axis for c in self.setting.mechanism.coordinates if c.kind == "hinge")
        actual = float(dot(axis, apply_tensor(body.inertia, axis)))
        for formula in candidates(spread):
            if abs(self.book.value(formula) * body.mass - actual) <= INERTIA_RTOL * actual:
                positive = self.book.value(spread.center) > 0.0
                return spread.center if positive else -spread.center, formula
        raise UnreadError(f"the moment of inertia of {self.setting.display_name(self.body)} is in no table")

    @cached_property
    def offset(self) -> Symbol:
        """Write the distance of the centre of mass from the axis, m, and return its symbol."""
        text = "Because of the hole, the centre of mass lies on the other side of the axis, at the distance"
        return self.book.add_step("table", text, self.book.fresh("c"), self._spread[0], METRES)

    @cached_property
    def own_inertia(self) -> Symbol:
        """Write the moment of inertia about the centre of mass and return its symbol."""
        _ = self.offset
        text = "The moment of inertia about the centre of mass, that of the full body less that of the hole, is"
        return self.book.add_step("table", text, self.book.fresh("I", "0"), self.mass * self._spread[1], INERTIA)

    @cached_property
    def about(self) -> Symbol:
        """Write the moment of inertia about the line of contact at the start and return its symbol."""
        (ex, ez), (ux, uz) = self.aside, self.uphill
        across = ez * ux - ex * uz
        square = Power(self.radius, 2) + Power(self.offset, 2) + TWO * self.radius * self.offset * across
        text = "By the parallel-axis theorem and the law of cosines, the moment of inertia about the line of contact is"
        return self.book.add_step("inertia", text, self.book.fresh("I"), self.own_inertia + self.mass * square, INERTIA)

    @cached_property
    def growth(self) -> Symbol:
        """Write the angular acceleration, positive clockwise, and return its symbol."""
        (ex, ez), (ux, uz) = self.aside, self.uphill
        lever = self.offset * ex - self.radius * uz
        torque = self.mass * self.gravity * lever
        if self.launch != ZERO:
            along = ex * ux + ez * uz
            torque = torque + self.mass * self.radius * self.offset * along * Power(self.launch, 2)
        text = "Taking torques about the line of contact, the clockwise angular acceleration is"
        if self.launch != ZERO:
            text = "Taking torques about the line of contact, with the centripetal acceleration of the centre of mass, "
            text += "the clockwise angular acceleration is"
        return self.book.add_step("torque", text, self.book.fresh(r"\alpha"), torque / self.about, ANGULAR_ACCELERATION)

    @cached_property
    def acceleration(self) -> list[Expression]:
        """Write the acceleration of the centre of mass and return its components to the right and upward."""
        (ex, ez), (ux, uz) = self.aside, self.uphill
        grown = self.growth
        components: list[Expression] = []
        square = sum_of_squares([self.launch])
        for label, along, turned, inward in (("x", ux, ez, ex), ("z", uz, -ex, ez)):
            formula = self.radius * grown * along + self.offset * grown * turned - self.offset * square * inward
            direction = "to the right" if label == "x" else "upward"
            text = (
                f"The acceleration of the centre of mass {direction} is that of the axis plus that due to the rotation,"
            )
            components.append(
                self.book.add_step("acceleration", text, self.book.fresh("a", label), formula, ACCELERATION)
            )
        return components

    # ---- what is asked

    def write(self) -> Symbol:
        """Write the answer to the query and return the answer's symbol."""
        query = self.setting.query
        if isinstance(query, PeriodQuery):
            return self._period(query)
        assert query.target is not None
        quantity, sense = query.target.quantity, query.target.sense
        if quantity in ("acceleration", "net force"):
            return self._accelerated(quantity, sense.vector if sense is not None else None)
        if sense is not None and any(sense.vector):
            raise UnsolvedError("a component of that is not known")
        if quantity in ("angular acceleration", "torque"):
            size = self.book.magnitude(self.growth)
            if quantity == "torque":
                text = "The magnitude of the torque about the centre of mass is"
                return self.book.add_step("answer", text, self.book.fresh("M"), self.own_inertia * size, TORQUE)
            return size if isinstance(size, Symbol) else self._sized(size, r"\alpha", ANGULAR_ACCELERATION)
        return self._contact(quantity)

    def _sized(self, formula: Expression, base: str, unit: str) -> Symbol:
        return self.book.add_step("answer", "Its magnitude is", self.book.fresh(base), formula, unit)

    def _accelerated(self, quantity: str, way: tuple[float, float, float] | None) -> Symbol:
        if way is None:
            x, z = self.acceleration
            formula: Expression = Root(Power(x, 2) + Power(z, 2))
        else:
            axes = [n for n in (0, 2) if abs(abs(way[n]) - 1.0) < INERTIA_RTOL]
            if not axes:
                raise UnsolvedError("a component along the slope")
            part = self.acceleration[axes[0] // 2]
            formula = part if way[axes[0]] > 0.0 else -part
        if quantity == "net force":
            return self.book.add_step(
                "answer", "By Newton's second law,", self.book.fresh("F"), self.mass * formula, NEWTONS
            )
        if isinstance(formula, Symbol):
            return formula
        text = "The component asked for is" if way is not None else "Its magnitude is"
        return self.book.add_step("answer", text, self.book.fresh("a"), formula, ACCELERATION)

    def _contact(self, quantity: str) -> Symbol:
        """Write the friction or normal force from Newton's second law and return its symbol."""
        (x, z), (ux, uz) = self.acceleration, self.uphill
        along = quantity == "friction force"
        part = x * ux + (z + self.gravity) * uz if along else (z + self.gravity) * ux - x * uz
        formula = self.mass * part
        formula = self.book.magnitude(formula)
        text = f"Newton's second law {'along' if along else 'perpendicular to'} the plane gives the {quantity}"
        return self.book.add_step("newton", text, self.book.fresh("f" if along else "N"), formula, NEWTONS)

    def _period(self, query: PeriodQuery) -> Symbol:
        """Write the period of small oscillations, with ω² = m g c cos ψ/I, and return its symbol."""
        cosine, uz = self.uphill
        level = uz == ZERO
        tilt: Expression = ZERO
        if not level:
            name, step = self.book.fresh(r"\psi"), self.book.begin_step("equilibrium")
            law = step.law(self.offset * Call("sin", name), self.radius * uz)
            formula = Call("arcsin", self.radius * uz / self.offset)
            step.add_text(
                "In equilibrium the centre of mass is vertically above the contact; the line to it from the axis makes"
            )
            step.add_text(
                f"an angle with the downward vertical such that {law}, so {step.result(name, formula, DEGREES)}."
            )
            step.close()
            tilt = name
        deep = self.offset if level else self.offset * Call("cos", tilt)
        high = self.radius - deep if level else self.radius * cosine - deep
        text = "In equilibrium the moment of inertia about the line of contact is"
        about = self.book.add_step(
            "inertia", text, self.book.fresh("I"), self.own_inertia + self.mass * Power(high, 2), INERTIA
        )
        text = "For a small rotation the restoring torque is proportional to the angle, so the "
        text += "angular frequency is"
        formula = Root(self.mass * self.gravity * deep / about)
        rate = self.book.add_step("oscillation", text, self.book.fresh(r"\omega"), formula, ANGULAR_SPEED)
        return measured_period(self.book, query, rate)


def _slide(m: Mechanism) -> tuple[float, float, float]:
    """Return the direction in which the body rolls, uphill or to the right, as a unit vector."""
    return next(c.axis for c in m.coordinates if c.kind == "slide")

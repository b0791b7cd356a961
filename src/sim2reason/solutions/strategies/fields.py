"""Fields: closed-form motion of a charged body in electric and magnetic fields."""

from collections.abc import Callable

from sim2reason.base.records import cached_property
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.distances import Away
from sim2reason.questions.moments.fields import VelocityTurned
from sim2reason.questions.moments.times import AtStart, AtTime
from sim2reason.questions.moments.turning_points import Stopped
from sim2reason.questions.phrasing import PeriodQuery
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import Power, Root
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, total
from sim2reason.solutions.fields.forces import AXES, Fields
from sim2reason.solutions.fields.magnetic_motion import RotatingMotion
from sim2reason.solutions.fields.moment import FieldMoment
from sim2reason.solutions.fields.motion import FieldMotion
from sim2reason.solutions.fields.turns import REACHES, TURN_MOMENTS, FieldTurn
from sim2reason.solutions.goals import GOALS, Components, magnitude, modulus
from sim2reason.solutions.goals.kinematics import ACCELERATIONS, DISPLACEMENTS, VELOCITIES, squared
from sim2reason.solutions.laws.newton import Newton
from sim2reason.solutions.laws.straight_way import StraightMotion
from sim2reason.solutions.oscillations.harmonic import measured_period
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.strategies import Strategy, strategy
from sim2reason.solutions.writing.notation import JOULES
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

HALF = Number(0.5)


class FieldEnergy:
    """Works and energies of a charged body up to a moment, written as they are needed."""

    def __init__(self, known: StraightMotion, moment: FieldMoment) -> None:
        """Take the displacement and velocity at the moment of the question as `known`, and that `moment`."""
        self.known, self.moment, self.fields, self.book = known, moment, moment.fields, known.book

    def potential(self) -> Expression:
        """Return the work of the electric force along its axis; UnsolvedError for a field without a potential."""
        drive, mass = self.fields.electric_acceleration, self.fields.mass
        if drive is None:
            return ZERO
        if drive.growth is not None or drive.frequency is not None:
            raise UnsolvedError("the field changes with time")
        moved = self.known.vector("s", self.fields.body)[drive.axis].expression()
        work = mass * drive.strength * moved
        if drive.slope is not None:
            if drive.along != drive.axis:
                raise UnsolvedError("the field has no potential")
            work = work + HALF * mass * drive.slope * Power(moved, 2)
        return work

    def _gained(self) -> Expression:
        """Return the change in kinetic energy from the start to the moment of the question."""
        speeds = (self.known.first_speeds.get(number, NIL) for number in self.fields.coordinates)
        first = total(speed * speed for speed in speeds).expression()
        square = self._square()
        return HALF * self.fields.mass * (square - first)

    def _square(self) -> Expression:
        """Return the square of the body's speed at the moment of the question."""
        if self.moment.speed is not None:
            return Power(self.moment.speed, 2)
        last = magnitude(self.known.vector("v", self.fields.body), self.known, VELOCITIES, self.fields.body)
        return last.inside if isinstance(last, Root) else squared(last)

    def work(self) -> Symbol:
        """Write the work of the electric field and return its symbol."""
        if self.fields.linear_drag_rate is None:
            formula = self._gained()
            text = "The magnetic force does no work, so the work of the electric force is the gain in kinetic energy,"
            text = text if self.fields.turning is not None else "By the work-energy theorem,"
        else:
            text, formula = "The work of the electric force is", self.potential()
        return self.book.add_step("work", text, self.book.fresh("W"), formula, JOULES)

    def write_dissipated_energy(self) -> Symbol:
        """Write the energy lost to the medium: the electric work minus the gain in kinetic energy."""
        work: Expression = self.potential()
        if work != ZERO:
            text = "The work of the electric force is"
            work = self.book.add_step("work", text, self.book.fresh("W"), work, JOULES)
        text = "The energy lost to the medium is this work less the gain in kinetic energy,"
        return self.book.add_step("energy", text, self.book.fresh("Q"), work - self._gained(), JOULES)


NOUNS = {noun.base: noun for noun in (DISPLACEMENTS, VELOCITIES, ACCELERATIONS)}
MOMENTS = (AtStart, AtTime, Away, Stopped, *TURN_MOMENTS)
QUANTITIES = (
    *("displacement", "velocity", "acceleration", "net force", "momentum", "kinetic energy"),
    "electric potential energy",
)
FUNCTIONALS = (
    *("greatest speed", "least speed", "greatest displacement", "greatest kinetic energy"),
    *("work of an electric field", "energy lost to drag", "impulse of the net force"),
    *REACHES,
)


@strategy
class FieldsStrategy(Strategy):
    """The strategy for one charged body in unbounded fields: uniform, linear, or a cosine in time."""

    name = "motion in fields"
    cost = 1.0
    kinds = frozenset({"start", "state", "event", "time_to_event", "extremum", "period", "sum"})

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that the strategy cannot apply to a mechanism; empty if it may apply."""
        m = mechanism
        moving = [body for body in m.bodies if body.coordinates]
        other = m.lines or m.faces or m.attractions or m.burns or m.meetings or m.feet
        if not m.forces or len(moving) != 1 or len(m.coordinates) != 2 or other:
            return "no lone body moves in fields"
        if any(abs(c.axis[2]) > 1e-9 or c.kind != "slide" for c in m.coordinates):
            return "it does not move in a level plane"
        return "the fields have an end" if any(force.region is not None for force in m.forces) else ""

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        return _unasked(setting)

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the forces, the motion and the answer, and return the answer's symbol."""
        return _InFields(setting, book).write().name


def _unasked(setting: ProblemContext) -> str:
    """Return the reason that a query is unsupported, such as *small oscillations are asked about*; else empty."""
    query = setting.query
    if isinstance(query, PeriodQuery):
        return "small oscillations are asked about" if query.small else ""
    if isinstance(query, StretchQuery):
        if query.kind == "sum" and not isinstance(query.moment, MOMENTS):
            return f"no way to the moment {type(query.moment).__name__}"
        return "" if query.functional in FUNCTIONALS else f"no way to the {query.functional}"
    if not isinstance(query.moment, MOMENTS):
        return f"no way to the moment {type(query.moment).__name__}"
    quantity = query.target.quantity if query.target is not None else ""
    return "" if quantity in ("", *QUANTITIES) else f"no way to the quantity {quantity}"


class _InFields(StraightMotion):
    """The quantities of a body in fields."""

    def __init__(self, setting: ProblemContext, book: SolutionBuilder) -> None:
        """Take a question; raise UnsolvedError if the motion has no closed form."""
        super().__init__(setting, book)
        self.body = next(body.name for body in self.mechanism.bodies if body.coordinates)
        self.fields = Fields(setting, book, self.body, start=isinstance(setting.query.moment, AtStart))
        self._names: dict[tuple[str, int], Expression] = {}

    def write(self) -> Symbol:
        """Write the answer to the query and return the answer's symbol."""
        if isinstance(self.query, PeriodQuery):
            return self._period(self.query)
        if isinstance(self.query, StretchQuery):
            return self._summed(self.query) if self.query.kind == "sum" else self.moment.extreme(self.query)
        if self.target is None:
            return self.time
        if self.target.quantity == "electric potential energy":
            return self._potential()
        return GOALS[self.target.quantity].write(self.target, self)

    @cached_property
    def moment(self) -> FieldMoment:
        """Return the moment of the question, with the extremes of speed and distance."""
        return FieldMoment(self.setting, self.book, self.fields)

    @property
    def time(self) -> Symbol:
        """Return the time of the moment, s."""
        return self.moment.time

    @property
    def motion(self) -> FieldMotion:
        """Return the position and velocity of the body as functions of time."""
        return self.moment.motion

    # ---- what is asked

    def _period(self, query: PeriodQuery) -> Symbol:
        """Write the period of the circular motion, s, and return its symbol."""
        turns = self.fields.turning
        if turns is None or self.fields.electric_acceleration is not None or self.fields.linear_drag_rate is not None:
            raise UnsolvedError("it does not go round a circle")
        size = self.book.magnitude(turns)
        return measured_period(self.book, query, size, "The period of the circular motion is")

    def _summed(self, query: StretchQuery) -> Symbol:
        """Write a work or a change of momentum and return its symbol."""
        assert self.target is not None
        energy = FieldEnergy(self, self.moment)
        if query.functional == "work of an electric field":
            return energy.work()
        if query.functional == "energy lost to drag":
            return energy.write_dissipated_energy()
        return GOALS[query.functional].write(self.target, self)

    def _potential(self) -> Symbol:
        """Write the change in electric potential energy, minus the work of the electric force, in J."""
        work = FieldEnergy(self, self.moment).potential()
        text = "The change in potential energy is minus the work of the electric force; its magnitude is"
        size = modulus(work, self.book, of_either_sign=True)
        return self.book.add_step("energy", text, self.book.fresh("U"), size, JOULES)

    # ---- for goals

    def _pull(
        self, axis: int, time: Expression, rate: Callable[[int], Expression], moved: Callable[[int], Expression]
    ) -> Expression:
        return self.fields.acceleration(axis, time, rate, moved)

    def rate(self, kind: str, k: int) -> Polynomial:
        """Return a component of a displacement, velocity or acceleration."""
        axis = self.fields.coordinates.index(k)
        known = self._names.get((kind, axis))
        if known is None:
            known = self._names[kind, axis] = self._written(kind, axis)
        if kind == "v" and known == self.fields.launch[axis]:  # as at the start, so that their difference vanishes
            return self.first_speeds.get(k, NIL)
        return Polynomial.from_expression(known) if known != ZERO else NIL

    def _written(self, kind: str, axis: int) -> Expression:
        if isinstance(self.query.moment, AtStart):
            if kind != "a":
                raise UnsolvedError("only the acceleration at the start is to be found")
            formula = self._pull(axis, ZERO, lambda n: self.fields.launch[n], lambda _: ZERO)
        elif kind == "a":
            formula = self._pull(axis, self.time, self._component("v"), self._component("s"))
        else:
            law = self.motion.displacement if kind == "s" else self.motion.rate
            if isinstance(self.query.moment, Stopped) and isinstance(self.motion, RotatingMotion) and kind == "s":
                law = self.motion.drift_displacement  # what turns has come round again
            formula = law(axis, self.time)
            short = self._turn.component(kind, axis, self.time) if self._turn is not None else None
            formula = formula if short is None else short
        if (
            isinstance(self.query.moment, Away)
            and kind == "s"
            and self.motion.displacement(1 - axis, self.time) == ZERO
        ):
            distance = Symbol(next(name for name in self.book.stated if name != self.time.name))
            return distance if self.book.value(formula) > 0.0 else -distance
        if formula == ZERO or isinstance(formula, Symbol) or (kind == "v" and formula == self.fields.launch[axis]):
            return formula
        name = self.fields.velocity[axis] if kind == "v" else self.book.fresh(kind, AXES[axis])
        text, law = self._component_lead(kind, axis)
        return self.book.add_step("component", text, name, formula, NOUNS[kind].unit, rests=law)

    def _component_lead(self, kind: str, axis: int) -> tuple[str, str]:
        """Return the beginning of a sentence about a component, and the label of the law that it uses."""
        who, along = self.setting.display_name(self.body), AXES[axis]
        if isinstance(self.query.moment, AtStart):
            return f"By Newton's second law, the acceleration of {who} along {along} at the start is", ""
        if kind == "a":
            return f"By the equation of motion, the acceleration of {who} along {along} is", self.fields.law
        if isinstance(self.query.moment, Stopped) and isinstance(self.motion, RotatingMotion) and kind == "s":
            text = f"Over a whole turn, the rotating part adds nothing to the displacement of {who}"
            return f"{text}, which along {along} is", self.fields.law
        if self._turn is not None and (short := self._turn.lead_text(kind, axis)):
            return short, self.fields.law
        return self.motion.lead_text(kind, axis, self.time), self.fields.law

    @property
    def _turn(self) -> FieldTurn | None:
        """Return the turn of the velocity that defines the moment of the question; None for other moments."""
        return self.moment.turn if isinstance(self.query.moment, TURN_MOMENTS) else None

    def vector(self, kind: str, body: str) -> Components:
        """Return a vector by component, or its magnitude alone if that is asked for and has a short formula."""
        magnitude_only = self.target is not None and self.target.sense is None and self.query.kind != "sum"
        if magnitude_only and not isinstance(self.query.moment, AtStart):
            sizes = {"v": lambda: self.moment.speed, "a": lambda: self.moment.acceleration_magnitude, "s": self._chord}
            size = sizes.get(kind, lambda: None)()
            if size is not None:
                return Polynomial.from_expression(size), NIL, NIL
        return super().vector(kind, body)

    def _chord(self) -> Expression | None:
        """Return the distance from the start after a turn of the velocity in a magnetic field alone, else None."""
        alone = (
            self.fields.electric_acceleration is None
            and self.fields.linear_drag_rate is None
            and not self.fields.has_quadratic_drag
        )
        if not alone or not isinstance(self.query.moment, VelocityTurned):
            return None
        assert self.time is not None
        return self.moment.turn.chord(self.moment.circle)

    def _component(self, kind: str) -> Callable[[int], Expression]:
        return lambda axis: self.rate(kind, self.fields.coordinates[axis]).expression()

    def mass(self, body: str) -> Polynomial:
        """Return the mass of the body."""
        del body
        return Polynomial.from_expression(self.fields.mass)

    @property
    def newton(self) -> Newton:
        """Raise UnsolvedError, since the forces are those of fields."""
        raise UnsolvedError("the forces are those of fields")

    def force(self, kind: str, name: str) -> Symbol:
        """Raise UnsolvedError, since no contact or string exerts a force."""
        raise UnsolvedError(f"no {kind} of {name}")

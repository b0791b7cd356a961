"""Forces per unit mass on a charged body in a plane, in the symbols of the text."""

from collections.abc import Callable
from dataclasses import dataclass

from sim2reason.base.records import cached_property
from sim2reason.scenes.bodies.charges import ChargedBead
from sim2reason.scenes.dsl.fields import Magnetic, Profile, Push, Resistance
from sim2reason.scenes.dsl.mechanism import Force, Mechanism
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Symbol
from sim2reason.solutions.algebra.functions import Call, Power, Root
from sim2reason.solutions.algebra.plain_latex import plain_latex
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.setting import ProblemContext, capitalized, join_words
from sim2reason.solutions.writing.notation import ACCELERATION, ANGULAR_SPEED, PER_SECOND, PER_SECOND_SQUARED, latex
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError

AXES = ("x", "y")
LAW = "Newton's second law"
MAGNETIC_SIGNS = (1.0, -1.0)  # signs of the magnetic acceleration: a_x = Ω v_y, a_y = −Ω v_x


@dataclass(frozen=True, slots=True)
class ElectricAcceleration:
    """The electric acceleration along an axis: strength + growth t, or strength cos(νt + φ), or strength + slope s."""

    axis: int
    strength: Symbol
    growth: Symbol | None = None
    frequency: Expression | None = None
    slope: Symbol | None = None
    along: int = 0  # axis along which the field varies
    phase: Expression = ZERO

    def at(self, time: Expression, moved: Callable[[int], Expression]) -> Expression:
        """Return the acceleration at a time, and at a position if it depends on it."""
        if self.frequency is not None and (time != ZERO or self.phase != ZERO):
            return self.strength * Call("cos", self.angle(time))
        if self.slope is not None:
            return self.strength + self.slope * moved(self.along)
        return self.strength + self.growth * time if self.growth is not None else self.strength

    def angle(self, time: Expression) -> Expression:
        """Return the argument νt + φ of the cosine of an oscillating field."""
        assert self.frequency is not None
        return self.frequency * time + self.phase


class Fields:
    """The forces on one charged body in fields; UnsolvedError for forces of other kinds."""

    def __init__(self, setting: ProblemContext, book: SolutionBuilder, body: str, *, start: bool) -> None:
        """Read the forces on a body; with `start`, only those at the start count, with the body at the origin."""
        self.start = start
        self.setting, self.book, self.body = setting, book, body
        m = setting.mechanism
        self.forces = [number for number, force in enumerate(m.forces) if force.body == body]
        self.coordinates = [m.number[c.name] for c in m.body[body].coordinates]
        self.launch = [self._read(lambda m, k=k: m.coordinates[k].speed).expression() for k in self.coordinates]
        self.mass = self._read(lambda m: m.body[body].mass).expression()
        self.velocity = [self._component(axis) for axis in AXES]
        self._checked()

    def _component(self, axis: str) -> Symbol:
        """Return the symbol of a velocity component: v_x or v_y, or a new one if that already has a value."""
        usual = Symbol(f"v_{axis}")
        if usual.name not in self.book.values or usual.name in self.book.stated:
            return usual
        self.book.reserve(usual.name)
        return self.book.fresh("v", axis)

    def _checked(self) -> None:
        """Raise UnsolvedError unless the equations of motion are linear with constant coefficients."""
        for law in (self.setting.mechanism.forces[number].law for number in self.forces):
            if isinstance(law, Magnetic) and (law.profile.uniform or self.start):
                continue
            if isinstance(law, Resistance) and (not law.quadratic or self.start or self._of(Push) is None):
                continue
            if not isinstance(law, Push):
                raise UnsolvedError("what acts leaves no closed form")

    def _read(self, number: Callable[[Mechanism], float]) -> Polynomial:
        """Return a number of the mechanism in the symbols of the text."""
        return self.setting.lexicon.formula_for(number)

    def _of(self, kind: type) -> int | None:
        """Return the index of the body's force of a given kind; None if no such force acts."""
        return next((n for n in self.forces if isinstance(self.setting.mechanism.forces[n].law, kind)), None)

    # ---- what acts

    @cached_property
    def running_time(self) -> Symbol:
        """Return the symbol τ of the running time since the start."""
        return self.book.fresh(r"\tau")

    @cached_property
    def instant(self) -> Symbol:
        """Return the symbol t of the moment of the question."""
        return self.book.fresh("t")

    @cached_property
    def _charge(self) -> str:
        """Return a sentence about the sign of a charge of stated magnitude; empty if it is positive."""
        body, given = self.setting.scene.bodies[self.body], self.setting.given(f"{self.body}.charge")
        if given is None or not isinstance(body, ChargedBead) or body.sign == "positive":
            return ""
        return f"The charge of {self.setting.display_name(self.body)} is $-{given.symbol}$. "

    @cached_property
    def turning(self) -> Symbol | None:
        """Return Ω = qB/m, the angular velocity of the velocity vector, positive if clockwise; None without a field."""
        number = self._of(Magnetic)
        if number is None:
            return None
        charge = self._read(lambda m: _magnetic(m.forces[number]))
        text = "The magnetic force rotates the velocity with the angular velocity"
        text = f"{'' if self.has_field else self._charge}{text} (positive if clockwise as seen from positive z)"
        return self.book.add_step(
            "field", text, self.book.fresh(r"\Omega"), charge.expression() / self.mass, ANGULAR_SPEED
        )

    @cached_property
    def linear_drag_rate(self) -> Symbol | None:
        """Return b/m, the linear drag per unit mass and velocity; None without linear drag."""
        number = self._of(Resistance)
        if number is None or self.has_quadratic_drag:
            return None
        drag = self._read(lambda m: getattr(m.forces[number].law, "linear", 0.0)).expression()
        text = "The drag per unit mass and velocity is"
        return self.book.add_step("field", text, self.book.fresh(r"\gamma"), drag / self.mass, PER_SECOND)

    @property
    def has_quadratic_drag(self) -> bool:
        """Return whether the medium exerts quadratic drag."""
        number = self._of(Resistance)
        return number is not None and bool(getattr(self.setting.mechanism.forces[number].law, "quadratic", 0.0))

    @cached_property
    def drag(self) -> Expression:
        """Return c v/m, the initial quadratic drag per unit mass and velocity; zero without quadratic drag."""
        number = self._of(Resistance)
        square = (
            self._read(lambda m: getattr(m.forces[number or 0].law, "quadratic", 0.0)) if number is not None else None
        )
        if not square:
            return ZERO
        vx, vy = self.launch
        text = "The initial drag per unit mass and velocity is"
        formula = square.expression() * Root(Power(vx, 2) + Power(vy, 2)) / self.mass
        return self.book.add_step("field", text, self.book.fresh(r"\gamma"), formula, PER_SECOND)

    @cached_property
    def electric_acceleration(self) -> ElectricAcceleration | None:
        """Write the electric acceleration and return it; None without an electric field."""
        number = self._of(Push)
        if number is None:
            return None
        law = self.setting.mechanism.forces[number].law
        assert isinstance(law, Push)
        axis = next(n for n in (0, 1) if abs(law.direction[n]) > 0.5)
        strength = self._part(number, "value", axis) / self.mass
        who, where = self.setting.display_name(self.body), self._where(law.profile)
        text = f"the electric force gives {who} an acceleration whose {AXES[axis]} component is"
        text = f"{self._charge}{where}{text if where else capitalized(text)}"
        name = self.book.add_step("field", text, self.book.fresh("a", r"\text{E}"), strength, ACCELERATION)
        profile = law.profile
        if profile.phase and (self.turning is not None or self.linear_drag_rate is not None or self.has_quadratic_drag):
            raise UnsolvedError("the field begins with a phase of its own")
        if profile.frequency:
            frequency = self._read(lambda m: _profile(m.forces[number]).frequency).expression()
            phase = self._read(lambda m: _profile(m.forces[number]).phase).expression() if profile.phase else ZERO
            return ElectricAcceleration(axis, name, frequency=frequency, phase=phase)
        if profile.rate:
            growth = self._part(number, "rate", axis) / self.mass
            more = "The rate of change of this acceleration is"
            return ElectricAcceleration(
                axis, name, growth=self.book.add_step("field", more, self.book.fresh("j"), growth, latex("m/s^3"))
            )
        if profile.slope:
            along = next(n for n in (0, 1) if abs(profile.axis[n]) > 0.5)
            slope, more = (
                self._part(number, "slope", axis) / self.mass,
                f"Away from the origin this component changes with {AXES[along]} at the rate",
            )
            slope = self.book.add_step("field", more, self.book.fresh("k"), slope, PER_SECOND_SQUARED)
            return ElectricAcceleration(axis, name, slope=slope, along=along)
        return ElectricAcceleration(axis, name)

    @property
    def has_field(self) -> bool:
        """Return whether an electric field acts."""
        return self._of(Push) is not None

    def _where(self, profile: Profile) -> str:
        """Return words for the time or position of the stated field strength; empty for a uniform field."""
        if profile.uniform:
            return ""
        given = self.setting.given(f"{self.body.rpartition('.')[0]}.electric.strength")
        where, there = ("at the origin", "there") if profile.steady else ("at the start", "at that moment")
        if given is not None and profile.frequency:
            when = "when the field has this value," if profile.phase else "at the start"
            return f"${given.symbol}$ is the amplitude of the electric field; {when} "
        strength = f"${given.symbol}$ is the magnitude of the electric field " if given is not None else ""
        return f"{strength}{where}; {there} " if strength else f"{where}, "

    def _part(self, number: int, field: str, axis: int) -> Expression:
        """Return a parameter of the electric force, such as its rate of change, as a component along an axis."""

        def signed(m: Mechanism) -> float:
            law = m.forces[number].law
            assert isinstance(law, Push)
            return float(getattr(law.profile, field)) * law.direction[axis]

        return self._read(signed).expression()

    @cached_property
    def places(self) -> list[Symbol]:
        """Return the symbols of the coordinates as functions of time."""
        return [self.book.fresh(axis) for axis in AXES]

    @cached_property
    def law(self) -> str:
        """Write the equations of motion and return the label of that step."""
        step = self.book.begin_step("equations of motion")
        if self.has_quadratic_drag:
            factor = (ONE + self.drag * self.running_time).latex()
            turns = "" if self.turning is None else ", and the magnetic force only rotates the velocity"
            step.add_text("The drag is proportional to the square of the speed, so the reciprocal of the speed grows")
            time = self.running_time.latex()
            step.add_text(f"uniformly with time: at the time ${time}$ the speed is that at the start, divided by")
            step.add_text(f"${factor}${turns}.")
            step.label(LAW)
            step.close()
            return LAW
        (vx, vy), places = self.velocity, self.places
        sides = [
            self.acceleration(n, self.running_time, lambda k: self.velocity[k], lambda k: places[k]) for n in (0, 1)
        ]
        rate = r"\dot{v}"
        equations = [
            rf"${name.name.replace('v', rate, 1)} = {plain_latex(side)}$"
            for name, side in zip(self.velocity, sides, strict=True)
        ]
        both = f"${vx.latex()}$ and ${vy.latex()}$"
        timed = any(self.running_time.name in side.symbols() for side in sides)
        when = f" at the time ${self.running_time.latex()}$" if timed else ""
        step.add_text(f"Let {both} be the components of the velocity{when}.")
        step.add_text(f"The equations of motion are {join_words(equations)}, by Newton's second law.")
        step.label(LAW)
        step.close()
        return LAW

    def acceleration(
        self, axis: int, time: Expression, rate: Callable[[int], Expression], moved: Callable[[int], Expression]
    ) -> Expression:
        """Return the acceleration along an axis: the sum of all forces over the mass."""
        total: Expression = ZERO
        if self.electric_acceleration is not None and self.electric_acceleration.axis == axis:
            total = total + self.electric_acceleration.at(time, moved)
        if self.turning is not None:
            total = total + self.turning * rate(1 - axis) * MAGNETIC_SIGNS[axis]
        if self.linear_drag_rate is not None:
            total = total - self.linear_drag_rate * rate(axis)
        if self.drag != ZERO:
            total = total - self.drag / (ONE + self.drag * time) * rate(axis)
        return total

    def speed(self, first: Expression, time: Expression) -> Expression:
        """Return the speed at a time, m/s, if only drag has changed it since the start."""
        if self.linear_drag_rate is not None:
            return first * Call("exp", -(self.linear_drag_rate * time))
        return first / (ONE + self.drag * time)


def _profile(force: Force) -> Profile:
    """Return how an electric force depends on time and position."""
    assert isinstance(force.law, Push)
    return force.law.profile


def _magnetic(force: Force) -> float:
    """Return the product of charge and magnetic field, positive along z."""
    assert isinstance(force.law, Magnetic)
    return force.law.profile.value * force.law.direction[2]

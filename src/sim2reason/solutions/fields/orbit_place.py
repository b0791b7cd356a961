"""Where a body on an ellipse is, and how fast, at one moment."""

from abc import ABC, abstractmethod
from collections.abc import Callable

from sim2reason.lazy import cached_property
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Symbol
from sim2reason.solutions.algebra.functions import PI, Call, Power, Root
from sim2reason.solutions.fields.kepler import TWO, KeplerOrbit
from sim2reason.solutions.writing.unit_latex import ACCELERATION, METRES, PER_SECOND, RADIANS, SECONDS, SPEED

FIELDS = ("x", "y")


class OrbitPlace(ABC):
    """A body at one place of its ellipse."""

    def __init__(self, orbit: KeplerOrbit) -> None:
        """Nothing is written yet."""
        self.orbit = orbit
        self._names: dict[tuple[str, int], Symbol] = {}

    @cached_property
    def grown(self) -> Expression:
        """By how much the eccentric anomaly has grown."""
        return self._anomaly()

    @cached_property
    def radius(self) -> Symbol:
        """How far it is from the centre."""
        return self._distance()

    @abstractmethod
    def _anomaly(self) -> Expression:
        """Write by how much the eccentric anomaly has grown."""

    @abstractmethod
    def _distance(self) -> Symbol:
        """Write how far it is from the centre."""

    @abstractmethod
    def _moved(self, axis: int) -> Expression:
        """By how much it has moved along an axis."""

    @abstractmethod
    def _rate(self, axis: int) -> Expression:
        """Its velocity along an axis."""

    def component(self, kind: str, axis: int) -> Symbol:
        """The displacement ``s``, velocity ``v`` or acceleration ``a`` along an axis, 0 or 1."""
        known = self._names.get((kind, axis))
        if known is None:
            known = self._names[kind, axis] = self._written(kind, axis)
        return known

    def _written(self, kind: str, axis: int) -> Symbol:
        orbit, label = self.orbit, FIELDS[axis]
        if kind == "s":
            formula, unit, said = self._moved(axis), METRES, f"Its displacement along {label} is"
        elif kind == "v":
            formula, unit, said = self._rate(axis), SPEED, f"Its velocity along {label} is"
        else:
            place = orbit.place[axis] + self.component("s", axis)
            formula, unit = -(orbit.parameter * place / Power(self.radius, 3)), ACCELERATION
            said = f"The acceleration points to the centre; along {label} it is"
        return orbit.book.told("component", said, orbit.named(kind, label), formula, unit)

    @cached_property
    def speed(self) -> Symbol:
        """From the energy: the vis-viva equation."""
        orbit = self.orbit
        formula = Root(orbit.parameter * (TWO / self.radius - ONE / orbit.axis))
        return orbit.book.told("energy", "By conservation of energy, its speed is", orbit.named("v"), formula, SPEED)

    @cached_property
    def pull(self) -> Symbol:
        """The size of the acceleration."""
        orbit, formula = self.orbit, self.orbit.parameter / Power(self.radius, 2)
        return orbit.book.told("attraction", "Its acceleration is", orbit.named("a"), formula, ACCELERATION)


class AtAnomaly(OrbitPlace):
    """Where the eccentric anomaly has grown by something."""

    def __init__(
        self, orbit: KeplerOrbit, grown: Callable[[], Expression], radius: Callable[[], Symbol] | None = None
    ) -> None:
        """`radius` writes the distance, where that is known without the anomaly."""
        super().__init__(orbit)
        self._grown, self._radius = grown, radius

    def _anomaly(self) -> Expression:
        """As it was given."""
        return self._grown()

    def _distance(self) -> Symbol:
        """R = a (1 − p cos η + q sin η)."""
        if self._radius is not None:
            return self._radius()
        orbit, angle = self.orbit, self.grown
        near = ONE - orbit.along * Call("cos", angle) + orbit.across * Call("sin", angle)
        said = "The distance from the centre is then"
        return orbit.book.told("distance", said, orbit.named("r"), orbit.axis * near, METRES)

    @cached_property
    def _weights(self) -> dict[str, Symbol]:
        """Names of the four weights with which the first place and velocity stand in those of the moment."""
        return {number: self.orbit.named("c", number) for number in "1234"}

    def _combined(self, numbers: str, axis: int) -> Expression:
        """A sum of the first place and velocity; a part that is zero has no weight."""
        orbit, found = self.orbit, ZERO
        for number, part in zip(numbers, (orbit.place[axis], orbit.rate[axis]), strict=True):
            if part != ZERO:
                found = found + self._weight(number) * part
        return found

    def _weight(self, number: str) -> Symbol:
        orbit, name = self.orbit, self._weights[number]
        if name.name in orbit.book.values:
            return name
        rest = ONE - Call("cos", self.grown)
        if number in "12":
            formula = orbit.weights(self.grown)[int(number) - 1]
        elif number == "3":
            swift = Root(orbit.parameter * orbit.axis) * Call("sin", self.grown)
            formula = -(swift / (orbit.radius * self.radius))
        else:
            formula = ONE - orbit.axis / self.radius * rest
        whole, part = "displacement" if number in "12" else "velocity", "place" if number in "13" else "velocity"
        unit = {"2": SECONDS, "3": PER_SECOND}.get(number, "")
        return orbit.book.told(
            "weights", f"In the {whole}, the coefficient of the initial {part} is", name, formula, unit
        )

    def _moved(self, axis: int) -> Expression:
        return self._combined("12", axis)

    def _rate(self, axis: int) -> Expression:
        return self._combined("34", axis)


class Turned(OrbitPlace):
    """Where the line to a body has turned through a right angle, or through two: the equation of its conic."""

    def __init__(self, orbit: KeplerOrbit, quarters: int) -> None:
        """`quarters` of a turn: 1 or 2."""
        super().__init__(orbit)
        self._quarters = quarters
        self._sense = 1.0 if orbit.book.value(orbit.momentum) > 0.0 else -1.0

    @cached_property
    def _rectum(self) -> Symbol:
        orbit, formula = self.orbit, Power(self.orbit.momentum, 2) / self.orbit.parameter
        said = "The semi-latus rectum of the ellipse is"
        return orbit.book.told("conic", said, orbit.named(r"\ell"), formula, METRES)

    @cached_property
    def _outward(self) -> Symbol:
        """How fast it recedes at the start."""
        orbit = self.orbit
        said = "The initial radial velocity is"
        return orbit.book.told("recedes", said, orbit.named("u", "0"), orbit.dot / orbit.radius, SPEED)

    def _distance(self) -> Symbol:
        """ℓ/r = 1 + e cos ν: ahead by 180° the cosine has the other sign, by 90° it is minus the sine."""
        orbit = self.orbit
        if self._quarters == 2:
            formula = self._rectum / (TWO - self._rectum / orbit.radius)
            said = r"By the conic, $\ell/r$ is $1 + e \cos\nu$, half a turn on with the opposite cosine, so"
        else:
            formula = self._rectum / (ONE - self._across)
            said = r"By the conic, $\ell/r$ is $1 + e \cos\nu$; a quarter turn later it is $1 - e \sin\nu$, so"
        return orbit.book.told("conic", said, orbit.named("r"), formula, METRES)

    @property
    def _across(self) -> Expression:
        """The product e sin ν at the start."""
        swift = self.orbit.momentum if self._sense > 0.0 else -self.orbit.momentum
        return swift * self._outward / self.orbit.parameter

    @cached_property
    def _outward_now(self) -> Expression:
        """How fast it recedes there."""
        if self._quarters == 2:
            return -self._outward
        orbit = self.orbit
        swift = orbit.momentum if self._sense > 0.0 else -orbit.momentum
        formula = orbit.parameter / swift * (self._rectum / orbit.radius - ONE)
        return orbit.book.told("recedes", "The radial velocity there is", orbit.named("u"), formula, SPEED)

    @property
    def _direction(self) -> tuple[Expression, Expression]:
        """From the centre to the body, times the distance at the start."""
        x, y = self.orbit.place
        if self._quarters == 2:
            return -x, -y
        return (-y, x) if self._sense > 0.0 else (y, -x)

    def _moved(self, axis: int) -> Expression:
        return self.radius / self.orbit.radius * self._direction[axis] - self.orbit.place[axis]

    def _rate(self, axis: int) -> Expression:
        along, across = self._direction[axis], (-self._direction[1], self._direction[0])[axis]
        first = self._outward_now / self.orbit.radius * along
        return first + self.orbit.momentum / (self.radius * self.orbit.radius) * across

    def _anomaly(self) -> Expression:
        """From where the place r₀ − a (1 − cos η) + … has turned: cot(η/2) = (b − q a)/r₀, or −q a/r₀."""
        orbit = self.orbit
        if self._quarters == 2:
            return self._opposite_end()
        swift = orbit.momentum if self._sense > 0.0 else -orbit.momentum
        small = swift / Root(orbit.parameter * orbit.axis)
        rest = small - orbit.across if orbit.dot != ZERO else small
        formula = TWO * Call("arctan", orbit.radius / (orbit.axis * rest))
        if orbit.book.value(formula) <= 0.0:
            formula = formula + TWO * PI
        said = r"The line has turned through $90^\circ$ when $E$ has increased by"
        return orbit.book.told("anomaly", said, orbit.named(r"\eta"), formula, RADIANS)

    def _opposite_end(self) -> Expression:
        """Return the increase of the eccentric anomaly over a focal chord, from cos(η/2) = e cos(E₀ + η/2)."""
        orbit, name = self.orbit, self.orbit.named(r"\eta")
        turned = r"The line has turned through $180^\circ$ when $E$ has increased by"
        if orbit.dot == ZERO:
            return orbit.book.told("anomaly", turned, name, PI, RADIANS)
        formula = PI + TWO * Call("arctan", orbit.axis * orbit.across / orbit.radius)
        p, q, half = orbit.along, orbit.across, name / TWO
        step = orbit.book.open("anomaly")
        law = step.law(Call("cos", half), p * Call("cos", half) - q * Call("sin", half))
        step.say(r"The ends of a chord through the focus, at $E_0$ and $E_0 + \eta$, are those for which")
        step.say(r"$e \cos\left(E_0 + \tfrac{1}{2} \eta\right)$ is equal to $\cos\left(\tfrac{1}{2} \eta\right)$:")
        step.say(f"{law}. Since $1 - {p.latex()}$ is ${(orbit.radius / orbit.axis).latex()}$,")
        step.say(f"{turned[0].lower()}{turned[1:]} {step.result(name, formula, RADIANS)}.")
        step.close()
        return name

"""Position and velocity of a body in an elliptic orbit at one moment."""

from abc import ABC, abstractmethod
from collections.abc import Callable

from sim2reason.base.records import cached_property
from sim2reason.solutions.algebra.expressions import ONE, ZERO, Expression, Symbol
from sim2reason.solutions.algebra.functions import Call, Power, Root
from sim2reason.solutions.fields.kepler import TWO, KeplerOrbit
from sim2reason.solutions.writing.unit_latex import ACCELERATION, METRES, PER_SECOND, SECONDS, SPEED

FIELDS = ("x", "y")


class OrbitPlace(ABC):
    """The position of a body on its ellipse, with velocity and acceleration."""

    def __init__(self, orbit: KeplerOrbit) -> None:
        """Take the orbit."""
        self.orbit = orbit
        self._names: dict[tuple[str, int], Symbol] = {}

    @cached_property
    def grown(self) -> Expression:
        """Return the increase of the eccentric anomaly since the start, in radians."""
        return self._anomaly()

    @cached_property
    def radius(self) -> Symbol:
        """Return the distance of the body from the central body."""
        return self._distance()

    @abstractmethod
    def _anomaly(self) -> Expression:
        """Write the increase of the eccentric anomaly since the start."""

    @abstractmethod
    def _distance(self) -> Symbol:
        """Write the distance of the body from the central body."""

    @abstractmethod
    def _moved(self, axis: int) -> Expression:
        """Return the displacement along an axis."""

    @abstractmethod
    def _rate(self, axis: int) -> Expression:
        """Return the velocity along an axis."""

    def component(self, kind: str, axis: int) -> Symbol:
        """Return the displacement ``s``, velocity ``v`` or acceleration ``a`` along an axis, 0 or 1."""
        known = self._names.get((kind, axis))
        if known is None:
            known = self._names[kind, axis] = self._written(kind, axis)
        return known

    def _written(self, kind: str, axis: int) -> Symbol:
        """Write a component of displacement, velocity or acceleration."""
        orbit, label = self.orbit, FIELDS[axis]
        if kind == "s":
            formula, unit, said = self._moved(axis), METRES, f"The displacement of {self._who} along {label} is"
        elif kind == "v":
            formula, unit, said = self._rate(axis), SPEED, f"The velocity of {self._who} along {label} is"
        else:
            place = orbit.place[axis] + self.component("s", axis)
            formula, unit = -(orbit.parameter * place / Power(self.radius, 3)), ACCELERATION
            said = f"The acceleration of {self._who} points to {self._star}; along {label} it is"
        rests = self._reason(kind)
        return orbit.book.add_step("component", said, orbit.named(kind, label), formula, unit, rests=rests)

    def _reason(self, kind: str) -> str:
        """Return the label of the step that gives displacements or velocities; by default ""."""
        del kind
        return ""

    @property
    def _who(self) -> str:
        """Return the name of the body."""
        return self.orbit.setting.display_name(self.orbit.body)

    @property
    def _star(self) -> str:
        """Return the name of the central body."""
        return self.orbit.setting.display_name(self.orbit.center)

    @cached_property
    def speed(self) -> Symbol:
        """Return the speed by the vis-viva equation."""
        orbit = self.orbit
        formula = Root(orbit.parameter * (TWO / self.radius - ONE / orbit.axis))
        said = f"By conservation of energy, the speed of {self._who} is"
        return orbit.book.add_step("energy", said, orbit.named("v"), formula, SPEED)

    @cached_property
    def pull(self) -> Symbol:
        """Return the magnitude of the acceleration."""
        orbit, formula = self.orbit, self.orbit.parameter / Power(self.radius, 2)
        said = f"The acceleration of {self._who} is"
        return orbit.book.add_step("attraction", said, orbit.named("a"), formula, ACCELERATION)


class AtAnomaly(OrbitPlace):
    """The position after a known increase of the eccentric anomaly."""

    def __init__(
        self, orbit: KeplerOrbit, grown: Callable[[], Expression], radius: Callable[[], Symbol] | None = None
    ) -> None:
        """Take the increase of the anomaly, and `radius` if the distance is known without the anomaly."""
        super().__init__(orbit)
        self._grown, self._radius = grown, radius

    def _anomaly(self) -> Expression:
        """Return the known increase of the eccentric anomaly."""
        return self._grown()

    def _distance(self) -> Symbol:
        """Write the distance r = a (1 − e cos(E₀ + η)) after the increase η of the eccentric anomaly."""
        if self._radius is not None:
            return self._radius()
        orbit, angle = self.orbit, self.grown
        near = ONE - orbit.e_cos_anomaly * Call("cos", angle) + orbit.e_sin_anomaly * Call("sin", angle)
        e = rf"${orbit.eccentricity_symbol.latex()} \cos {orbit.anomaly.latex()}$"
        grown = orbit.e_cos_anomaly * Call("cos", angle) - orbit.e_sin_anomaly * Call("sin", angle)
        said = f"There {e} is ${grown.latex()}$, so the distance from {self._star} is"
        return orbit.book.add_step("distance", said, orbit.named("r"), orbit.axis * near, METRES)

    @cached_property
    def _weights(self) -> dict[str, Symbol]:
        """Return names for Lagrange's four coefficients of initial position and velocity."""
        return {number: self.orbit.named("c", number) for number in "1234"}

    def _combined(self, numbers: str, axis: int) -> Expression:
        """Return a component of a vector: Lagrange's coefficients times initial position and velocity."""
        orbit, found = self.orbit, ZERO
        for number, part in zip(numbers, (orbit.place[axis], orbit.rate[axis]), strict=True):
            if part != ZERO:
                found = found + self._weight(number) * part
        return found

    def _weight(self, number: str) -> Symbol:
        """Write one of Lagrange's coefficients."""
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
        whole, part = "displacement" if number in "12" else "velocity", "position" if number in "13" else "velocity"
        said = f"By Lagrange's formulas, the coefficient of the initial {part} in the {whole} is"
        unit = {"2": SECONDS, "3": PER_SECOND}.get(number, "")
        return orbit.book.add_step("weights", said, name, formula, unit)

    def _moved(self, axis: int) -> Expression:
        return self._combined("12", axis)

    def _rate(self, axis: int) -> Expression:
        return self._combined("34", axis)

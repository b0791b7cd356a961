"""Fields that are not linear: of a magnetic dipole, which falls off as 1/r³, and of functions of time."""

from dataclasses import dataclass, replace
from math import hypot, radians
from typing import Annotated, Literal, Self

from annotated_types import Ge, Le
from pydantic import model_validator

from sim2reason.scenes.authoring import LEAST, Law, Measure, Profile, Push, Range, Usually, Vector, add, either
from sim2reason.scenes.dsl.vectors import Maths, Number, Triple, cross, dot, scale_triple, subtract_triples
from sim2reason.scenes.entities.fields import (
    CHANGING,
    Direction,
    ElectricAtFirst,
    ElectricField,
    ElectricStrength,
    MagneticField,
    Trend,
    direction_vector,
    force_field,
)

DipoleStrength = Annotated[float, LEAST, Le(1e6), Measure("dipole strength", "T m^3", "b"), Range(1.0, 5.0)]
BOUNDS = (Ge(-1e3), Le(1e3))


@dataclass(frozen=True, slots=True)
class DipoleForce:
    """The force law q v × B with B = b/r³ along one direction."""

    center: Vector
    direction: Vector
    strength: float  # charge times b, C T m³

    def force(self, place: Triple, velocity: Triple, time: Number, maths: Maths) -> Triple:
        """Return the force, which is perpendicular to velocity and field and does no work."""
        del time
        separation = subtract_triples(place, self.center)
        square = dot(separation, separation)
        return scale_triple(self.strength / (square * maths.sqrt(square)), cross(velocity, self.direction))

    def potential(self, place: Triple, maths: Maths) -> Number | None:
        """Return 0, since the force does no work."""
        del place, maths
        return 0.0

    @property
    def constant(self) -> bool:
        """Return False, since the force depends on the velocity."""
        return False

    def moved(self, by: Vector) -> "DipoleForce":
        """Return the law with its origin displaced by `by`, m."""
        return replace(self, center=add(self.center, by))


@force_field
class DipoleMagnetic(MagneticField):
    """Square to the plane; the dipole itself is not where the bead starts."""

    strength: DipoleStrength
    way: Literal["positive z", "negative z"]
    x: Annotated[float, *BOUNDS, Measure("position", "m", "x_d", decimals=2), Range(1.0, 2.0)]
    y: Annotated[float, *BOUNDS, Measure("position", "m", "y_d", decimals=2), Range(-1.0, 1.0)]

    says = (
        either(
            "a magnetic field in the {way} direction falls off as the inverse cube of the distance from the point ({x}, {y}); its strength times the cube of the distance is {strength}.",
            "around the point ({x}, {y}) there is a magnetic field in the {way} direction; its strength times the cube of the distance from there is everywhere {strength}.",
            "a magnetic field points in the {way} direction; its strength is {strength} divided by the cube of the distance from the point ({x}, {y}).",
        ),
    )

    @model_validator(mode="after")
    def _elsewhere(self) -> Self:
        if hypot(self.x, self.y) == 0.0:
            raise ValueError("x, y: the field has no strength at its centre, where the bead starts; move it away")
        return self

    def law(self, charge: float) -> Law:
        """Return the force law F = q v × B, with B = b/r³."""
        return DipoleForce((self.x, self.y, 0.0), direction_vector(self.way), charge * self.strength)

    def rate(self, charge: float, mass: float) -> float:
        """Return the cyclotron frequency at the origin."""
        return abs(charge) * self.strength / hypot(self.x, self.y) ** 3 / mass


Growth = Annotated[float, LEAST, Le(1e6), Measure("growth", "N/(C s)", "k", called="rate"), Range(0.1, 0.8)]


@force_field
class GrowingElectric(ElectricField):
    """The same everywhere, and a linear function of time.

    The `trend` is that of its component in the direction that it has at first.
    """

    strength: ElectricAtFirst
    way: Direction
    trend: Trend
    growth: Growth

    words = CHANGING
    says = (
        either(
            "a uniform electric field is always parallel to {line}; at t = 0 it has magnitude {strength} and points in {direction}, and its {component} {changes} at a rate of {growth}.",
            "there is a uniform electric field parallel to {line}, whose {component} {changes} at a constant rate of {growth}; at t = 0 the field has magnitude {strength} and points in {direction}.",
            "a uniform electric field, always parallel to {line}, has magnitude {strength} and points in {direction} at t = 0; its {component} {changes} at a constant rate of {growth}.",
        ),
    )

    def law(self, charge: float) -> Law:
        """Return the force law F = q (E₀ + rt)."""
        growth = self.growth if self.trend == "increases" else -self.growth
        return Push(direction_vector(self.way), Profile(charge * self.strength, rate=charge * growth))

    def rate(self, charge: float, mass: float) -> float:
        """Return twice the relative growth rate of the initial strength, 1/s."""
        del charge, mass
        return 2.0 * self.growth / self.strength


Frequency = Annotated[float, LEAST, Le(1e12), Measure("angular frequency", "rad/s", r"\omega"), Range(0.5, 4.0)]
Phase = Annotated[float, Ge(-180), Le(180), Measure("phase", "deg", r"\varphi", decimals=0), Range(10.0, 170.0)]


@force_field
class OscillatingElectric(ElectricField):
    """The same everywhere, and a cosine of time."""

    strength: ElectricStrength
    way: Direction
    frequency: Frequency
    phase: Annotated[Phase | None, Usually(present=False)] = None

    says = (
        either(
            "a uniform electric field in the {way} direction varies as the cosine of time, with amplitude {strength} and angular frequency {frequency}.",
            "in the {way} direction there is a uniform electric field that varies as a cosine of time; its amplitude is {strength}, its angular frequency {frequency}.",
            "a uniform electric field oscillates with an angular frequency of {frequency}; it is greatest at t = 0, when it is {strength} in the {way} direction.",
        ).if_given(
            "phase",
            "a uniform electric field in the {way} direction varies as the cosine of time, with amplitude {strength}, angular frequency {frequency} and phase {phase} at t = 0.",
            "in the {way} direction there is a uniform electric field that varies as a cosine of time; its amplitude is {strength}, its angular frequency {frequency}, its phase at t = 0 {phase}.",
            "a uniform electric field in the {way} direction oscillates with an amplitude of {strength} and an angular frequency of {frequency}; the phase of its cosine is {phase} at t = 0.",
        ),
    )

    def law(self, charge: float) -> Law:
        """Return the law of the force on a charge, F = q E₀ cos(ωt + φ)."""
        phase = radians(self.phase or 0.0)
        return Push(direction_vector(self.way), Profile(charge * self.strength, frequency=self.frequency, phase=phase))

    def rate(self, charge: float, mass: float) -> float:
        """Return the angular frequency of the field, rad/s."""
        del charge, mass
        return self.frequency

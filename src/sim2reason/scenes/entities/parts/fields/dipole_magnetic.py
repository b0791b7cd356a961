"""The magnetic field of a dipole, in the plane perpendicular to its moment: it falls off as 1/r³."""

from dataclasses import dataclass, replace
from math import hypot
from typing import Annotated, Literal, Self

from annotated_types import Ge, Le
from pydantic import model_validator

from sim2reason.scenes.authoring import LEAST, Law, Measure, Range, Vector, add, either
from sim2reason.scenes.dsl.vectors import Maths, Number, Triple, cross, dot, minus, times
from sim2reason.scenes.entities.parts.fields import MagneticField, along, force_field

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
        apart = minus(place, self.center)
        square = dot(apart, apart)
        return times(self.strength / (square * maths.sqrt(square)), cross(velocity, self.direction))

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
        return DipoleForce((self.x, self.y, 0.0), along(self.way), charge * self.strength)

    def rate(self, charge: float, mass: float) -> float:
        """Return the cyclotron frequency at the origin."""
        return abs(charge) * self.strength / hypot(self.x, self.y) ** 3 / mass

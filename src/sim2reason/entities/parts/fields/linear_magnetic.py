"""A magnetic field that changes from place to place."""

from typing import Annotated, Literal

from annotated_types import Le

from sim2reason.authoring import LEAST, Law, Magnetic, Measure, Profile, Range, either
from sim2reason.entities.parts.fields import (
    AXES,
    CHANGING,
    MagneticAtFirst,
    MagneticField,
    Trend,
    along,
    force_field,
)

Slope = Annotated[float, LEAST, Le(1e6), Measure("gradient", "T/m", r"\beta"), Range(0.05, 0.5)]


@force_field
class LinearMagnetic(MagneticField):
    """Square to the plane, and as strong as a linear function of x or of y says.

    The `trend` is that of its component in the direction that it has at the origin.
    """

    strength: MagneticAtFirst
    way: Literal["positive z", "negative z"]
    trend: Trend
    axis: Literal["x", "y"]
    slope: Slope

    words = CHANGING
    says = (
        either(
            "a magnetic field is everywhere parallel to {line}; at {axis} = 0 it has magnitude {strength} and points in {direction}, and its {component} {changes} with {axis} at a rate of {slope}.",
            "there is a magnetic field parallel to {line}, whose {component} {changes} with {axis} at a rate of {slope}; at {axis} = 0 the field has magnitude {strength} and points in {direction}.",
            "the lines of a magnetic field are parallel to {line}; at {axis} = 0 the field points in {direction} and has magnitude {strength}, and its {component} {changes} with {axis} at a rate of {slope}.",
        ),
    )

    def law(self, charge: float) -> Law:
        """F = q v × B, with B = B₀ + βs."""
        slope = self.slope if self.trend == "increases" else -self.slope
        return Magnetic(along(self.way), Profile(charge * self.strength, charge * slope, AXES[self.axis]))

    def rate(self, charge: float, mass: float) -> float:
        """The cyclotron frequency at the origin."""
        return abs(charge) * self.strength / mass

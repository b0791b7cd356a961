"""A magnetic field that changes from place to place."""

from typing import Annotated, Literal

from annotated_types import Le

from sim2reason.authoring import LEAST, Law, Magnetic, Measure, Profile, Range, either
from sim2reason.entities.parts.fields import (
    AXES,
    MagneticField,
    MagneticStrength,
    Trend,
    along,
    force_field,
)

Slope = Annotated[float, LEAST, Le(1e6), Measure("gradient", "T/m", r"\beta"), Range(0.05, 0.5)]


@force_field
class LinearMagnetic(MagneticField):
    """Square to the plane, and as strong as a linear function of x or of y says."""

    strength: MagneticStrength
    way: Literal["positive z", "negative z"]
    trend: Trend
    axis: Literal["x", "y"]
    slope: Slope

    says = (
        either(
            "a magnetic field has magnitude {strength} at {axis} = 0 and points in the {way} direction; its component in that direction, the only one, {trend} with {axis} at a rate of {slope}.",
            "at {axis} = 0 a magnetic field of magnitude {strength} points in the {way} direction; its component in that direction, the only one, {trend} with {axis} at a rate of {slope}.",
            "there is a magnetic field, which at {axis} = 0 has magnitude {strength} and points in the {way} direction; its component in that direction, the only one, {trend} with {axis} at a rate of {slope}.",
        ),
    )

    def law(self, charge: float) -> Law:
        """F = q v × B, with B = B₀ + βs."""
        slope = self.slope if self.trend == "increases" else -self.slope
        return Magnetic(along(self.way), Profile(charge * self.strength, charge * slope, AXES[self.axis]))

    def rate(self, charge: float, mass: float) -> float:
        """The cyclotron frequency at the origin."""
        return abs(charge) * self.strength / mass

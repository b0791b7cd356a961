"""An electric field that changes from place to place."""

from math import sqrt
from typing import Annotated, Literal

from annotated_types import Le

from sim2reason.authoring import LEAST, Law, Measure, Profile, Push, Range, either
from sim2reason.entities.parts.fields import (
    AXES,
    Direction,
    ElectricField,
    ElectricStrength,
    Trend,
    along,
    force_field,
)

Slope = Annotated[float, LEAST, Le(1e6), Measure("gradient", "N/(C m)", "k"), Range(0.2, 1.2)]


@force_field
class LinearElectric(ElectricField):
    """One direction, and a strength that is a linear function of x or of y."""

    strength: ElectricStrength
    way: Direction
    trend: Trend
    axis: Literal["x", "y"]
    slope: Slope

    says = (
        either(
            "an electric field has a component in the {way} direction only; this component is {strength} at {axis} = 0 and {trend} with {axis} at the rate {slope}.",
            "there is an electric field whose only component is that in the {way} direction; it is {strength} at {axis} = 0 and {trend} with {axis} at the rate {slope}.",
            "an electric field has a single component, in the {way} direction; it is {strength} at {axis} = 0 and {trend} with {axis} at the rate {slope}.",
        ),
    )

    @property
    def signed(self) -> float:
        """By how much the strength grows along the axis, N/(C m)."""
        return self.slope if self.trend == "increases" else -self.slope

    def law(self, charge: float) -> Law:
        """F = q (E₀ + k s) along one direction."""
        return Push(along(self.way), Profile(charge * self.strength, charge * self.signed, AXES[self.axis]))

    def rate(self, charge: float, mass: float) -> float:
        """√(qk/m), with which the bead swings or runs away."""
        return 2.0 * sqrt(abs(charge) * self.slope / mass)

"""An electric field that grows or fades as time passes."""

from typing import Annotated

from annotated_types import Le

from sim2reason.authoring import LEAST, Law, Measure, Profile, Push, Range, either
from sim2reason.entities.parts.fields import (
    Direction,
    ElectricField,
    ElectricStrength,
    Trend,
    along,
    force_field,
)

Growth = Annotated[float, LEAST, Le(1e6), Measure("growth", "N/(C s)", "k", called="rate"), Range(0.1, 0.8)]


@force_field
class GrowingElectric(ElectricField):
    """The same everywhere, and a linear function of time."""

    strength: ElectricStrength
    way: Direction
    trend: Trend
    growth: Growth

    says = (
        either(
            "a uniform electric field has magnitude {strength} at t = 0 and points in the {way} direction; its component in that direction, the only one, {trend} at a rate of {growth}.",
            "at t = 0 a uniform electric field of magnitude {strength} points in the {way} direction; its component in that direction {trend} at a rate of {growth}, and it never has another.",
            "there is a uniform electric field, which at t = 0 has magnitude {strength} and points in the {way} direction; its component in that direction, the only one, {trend} at a rate of {growth}.",
        ),
    )

    def law(self, charge: float) -> Law:
        """F = q (E₀ + rt)."""
        growth = self.growth if self.trend == "increases" else -self.growth
        return Push(along(self.way), Profile(charge * self.strength, rate=charge * growth))

    def rate(self, charge: float, mass: float) -> float:
        """The strength at the start, compared with its growth."""
        del charge, mass
        return 2.0 * self.growth / self.strength

"""An electric field that grows or fades as time passes."""

from typing import Annotated

from annotated_types import Le

from sim2reason.authoring import LEAST, Law, Measure, Profile, Push, Range, either
from sim2reason.entities.parts.fields import (
    CHANGING,
    Direction,
    ElectricAtFirst,
    ElectricField,
    Trend,
    along,
    force_field,
)

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
        """F = q (E₀ + rt)."""
        growth = self.growth if self.trend == "increases" else -self.growth
        return Push(along(self.way), Profile(charge * self.strength, rate=charge * growth))

    def rate(self, charge: float, mass: float) -> float:
        """The strength at the start, compared with its growth."""
        del charge, mass
        return 2.0 * self.growth / self.strength

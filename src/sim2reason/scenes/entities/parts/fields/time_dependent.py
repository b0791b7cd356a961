"""Electric fields that depend on time."""

from math import radians
from typing import Annotated

from annotated_types import Ge, Le

from sim2reason.scenes.authoring import LEAST, Law, Measure, Profile, Push, Range, Usually, either
from sim2reason.scenes.entities.parts.fields import (
    CHANGING,
    Direction,
    ElectricAtFirst,
    ElectricField,
    ElectricStrength,
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
        """Return the force law F = q (E₀ + rt)."""
        growth = self.growth if self.trend == "increases" else -self.growth
        return Push(along(self.way), Profile(charge * self.strength, rate=charge * growth))

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
        return Push(along(self.way), Profile(charge * self.strength, frequency=self.frequency, phase=phase))

    def rate(self, charge: float, mass: float) -> float:
        """Return the angular frequency of the field, rad/s."""
        del charge, mass
        return self.frequency

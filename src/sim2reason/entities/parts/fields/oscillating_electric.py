"""An electric field that oscillates."""

from typing import Annotated

from annotated_types import Le

from sim2reason.authoring import LEAST, Law, Measure, Profile, Push, Range, either
from sim2reason.entities.parts.fields import (
    Direction,
    ElectricField,
    ElectricStrength,
    along,
    force_field,
)

Frequency = Annotated[float, LEAST, Le(1e12), Measure("angular frequency", "rad/s", r"\omega"), Range(0.5, 4.0)]


@force_field
class OscillatingElectric(ElectricField):
    """The same everywhere, and a cosine of time."""

    strength: ElectricStrength
    way: Direction
    frequency: Frequency

    says = (
        either(
            "a uniform electric field in the {way} direction varies as the cosine of time, with amplitude {strength} and angular frequency {frequency}.",
            "in the {way} direction there is a uniform electric field that varies as a cosine of time; its amplitude is {strength}, its angular frequency {frequency}.",
            "a uniform electric field oscillates with an angular frequency of {frequency}; it is greatest at t = 0, when it is {strength} in the {way} direction.",
        ),
    )

    def law(self, charge: float) -> Law:
        """F = q E₀ cos ωt."""
        return Push(along(self.way), Profile(charge * self.strength, frequency=self.frequency))

    def rate(self, charge: float, mass: float) -> float:
        """Its own."""
        del charge, mass
        return self.frequency

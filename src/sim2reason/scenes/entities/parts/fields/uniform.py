"""Uniform fields."""

from typing import Literal

from sim2reason.scenes.authoring import Law, Magnetic, Profile, Push, either
from sim2reason.scenes.entities.parts.fields import (
    Direction,
    ElectricField,
    ElectricStrength,
    MagneticField,
    MagneticStrength,
    along,
    force_field,
)


@force_field
class UniformElectric(ElectricField):
    """The same strength and direction everywhere."""

    strength: ElectricStrength
    way: Direction

    says = (
        either(
            "a uniform electric field of strength {strength} points in the {way} direction.",
            "a uniform electric field, whose strength is {strength}, is directed along the {way} direction.",
            "there is a uniform electric field of strength {strength} in the {way} direction.",
        ),
    )

    def law(self, charge: float) -> Law:
        """Return the force law F = qE."""
        return Push(along(self.way), Profile(charge * self.strength))


@force_field
class UniformMagnetic(MagneticField):
    """Square to the plane of the motion."""

    strength: MagneticStrength
    way: Literal["positive z", "negative z"]

    says = (
        either(
            "a uniform magnetic field of strength {strength} points in the {way} direction.",
            "a uniform magnetic field, whose strength is {strength}, is directed along the {way} direction.",
            "there is a uniform magnetic field of strength {strength} in the {way} direction.",
        ),
    )

    def law(self, charge: float) -> Law:
        """Return the force law F = q v × B."""
        return Magnetic(along(self.way), Profile(charge * self.strength))

    def rate(self, charge: float, mass: float) -> float:
        """Return the cyclotron frequency |q|B/m."""
        return abs(charge) * self.strength / mass

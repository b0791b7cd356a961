"""An electric field that is everywhere the same."""

from sim2reason.authoring import Law, Profile, Push, either
from sim2reason.entities.parts.fields import Direction, ElectricField, ElectricStrength, along, force_field


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
        """F = qE."""
        return Push(along(self.way), Profile(charge * self.strength))

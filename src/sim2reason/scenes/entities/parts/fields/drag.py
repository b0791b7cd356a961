"""Media that resist motion."""

from typing import Annotated

from annotated_types import Le

from sim2reason.scenes.authoring import LEAST, Law, Measure, Range, Resistance, either
from sim2reason.scenes.entities.parts.fields import Medium, force_field

Drag = Annotated[float, LEAST, Le(1e6), Measure("drag", "uN s/m", "b", called="constant"), Range(0.1, 1.0)]


@force_field
class LinearDrag(Medium):
    """A force −bv."""

    coefficient: Drag

    says = (
        either(
            "a medium resists the motion with a force proportional to the speed, with the constant of proportionality {coefficient}.",
            "a medium exerts a drag force proportional to the speed; the constant of proportionality is {coefficient}.",
            "the drag force of a medium is proportional to the speed, the constant of proportionality being {coefficient}.",
        ),
    )

    def law(self, charge: float) -> Law:
        """Return the force law F = −bv."""
        del charge
        return Resistance(linear=self.coefficient)

    def rate(self, charge: float, mass: float) -> float:
        """Return the decay rate of the speed, 1/s."""
        del charge
        return self.coefficient / mass


SquareDrag = Annotated[float, LEAST, Le(1e6), Measure("drag", "uN s^2/m^2", "c", called="constant"), Range(0.1, 0.5)]


@force_field
class QuadraticDrag(Medium):
    """A force −c|v|v."""

    coefficient: SquareDrag

    says = (
        either(
            "a medium resists the motion with a force proportional to the square of the speed, with the constant of proportionality {coefficient}.",
            "a medium exerts a drag force proportional to the square of the speed; the constant of proportionality is {coefficient}.",
            "the drag force of a medium is proportional to the square of the speed, the constant of proportionality being {coefficient}.",
        ),
    )

    def law(self, charge: float) -> Law:
        """Return the force law F = −c|v|v."""
        del charge
        return Resistance(quadratic=self.coefficient)

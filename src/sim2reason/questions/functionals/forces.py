"""Extreme values of forces and of the extension of springs."""

from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.quantities.forces import AxleForce, NormalForce, RodForce, RodPull, Tension
from sim2reason.simulation.quantities.springs import Extension, SpringForce


@functional
class GreatestAxleForce(Extreme):
    """The greatest magnitude of the force that a fixed axle exerts on the body that turns about it."""

    name = "greatest axle force"
    quantity = AxleForce
    impulsive = True
    phrase = "the greatest magnitude of the force that the axle exerts on {body}"
    weight = 3.0


@functional
class GreatestExtension(Extreme):
    """The greatest extension of a spring."""

    name = "greatest extension"
    quantity = Extension
    phrase = "the greatest extension of {spring}"
    weight = 3.0

    def height(self, state: State, name: str) -> Array:
        """Return the extension, m, (n,)."""
        return Extension.evaluate(state, name)


@functional
class GreatestCompression(Extreme):
    """The greatest compression of a spring."""

    name = "greatest compression"
    quantity = Extension
    phrase = "the greatest compression of {spring}"
    weight = 3.0

    def height(self, state: State, name: str) -> Array:
        """Return the compression, m, (n,)."""
        return -Extension.evaluate(state, name)


@functional
class GreatestNormalForce(Extreme):
    """The greatest normal force that a face exerts on a body."""

    name = "greatest normal force"
    quantity = NormalForce
    impulsive = True
    phrase = "the greatest normal force exerted on {body} by {surface}"
    weight = 2.0


@functional
class LeastNormalForce(Extreme):
    """The least normal force that a face exerts on a body."""

    name = "least normal force"
    quantity = NormalForce
    sign = -1.0
    phrase = "the least normal force exerted on {body} by {surface}"


@functional
class GreatestRodForce(Extreme):
    """The greatest magnitude of the force in a light rod, be it a pull or a push."""

    name = "greatest rod force"
    quantity = RodForce
    impulsive = True
    phrase = "the greatest magnitude of the force in {rod}"
    weight = 5.0


@functional
class GreatestRodPull(Extreme):
    """The greatest magnitude of the force in a light rod on a moving axle; never drawn by recipes."""

    name = "greatest rod pull"
    quantity = RodPull
    impulsive = True
    drawn_by_recipes = False
    phrase = "the greatest magnitude of the force in {rod}"


@functional
class GreatestSpringForce(Extreme):
    """The greatest magnitude of the force of a spring, N, whether it pulls or pushes; never drawn by recipes."""

    name = "greatest spring force"
    quantity = SpringForce
    phrase = "the greatest force exerted by {spring}"
    drawn_by_recipes = False


@functional
class GreatestTension(Extreme):
    """The greatest tension in a string."""

    name = "greatest tension"
    quantity = Tension
    impulsive = True
    phrase = "the greatest tension in {string}"
    weight = 5.0


@functional
class LeastTension(Extreme):
    """The least tension in a string that never goes slack."""

    name = "least tension"
    quantity = Tension
    sign = -1.0
    phrase = "the least tension in {string}"

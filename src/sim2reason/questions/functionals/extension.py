"""By how much a spring is stretched or compressed at most."""

from sim2reason.dsl.state import Array, State
from sim2reason.quantities.springs import Extension
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme


@functional
class GreatestExtension(Extreme):
    """The greatest extension of a spring."""

    name = "greatest extension"
    quantity = Extension
    phrase = "the greatest extension of {spring}"
    weight = 3.0

    def height(self, state: State, name: str) -> Array:
        """How far it is stretched, (n,)."""
        return Extension.evaluate(state, name)


@functional
class GreatestCompression(Extreme):
    """The greatest compression of a spring."""

    name = "greatest compression"
    quantity = Extension
    phrase = "the greatest compression of {spring}"
    weight = 3.0

    def height(self, state: State, name: str) -> Array:
        """How far it is compressed, (n,)."""
        return -Extension.evaluate(state, name)

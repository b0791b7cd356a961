"""A cart on a straight track."""

from sim2reason.dsl.body import Body, body
from sim2reason.dsl.looks import Small
from sim2reason.dsl.measures import Mass


@body
class Cart(Body):
    """A small cart that a track leads along a straight line."""

    mass: Mass

    nouns = ("cart", "trolley", "block")
    lone = ("a {noun} of mass {mass}", "a {noun} ({mass})", "a {noun} whose mass is {mass}")
    named = ("{noun} {letter} of mass {mass}", "{noun} {letter} ({mass})")
    listed = "{letter} ({mass})"
    alike = "({mass} each)"

    @property
    def look(self) -> Small:
        """A cart."""
        return Small("cart")

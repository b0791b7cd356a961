"""A carriage on a rail."""

from sim2reason.dsl.body import Body, body
from sim2reason.dsl.looks import Small
from sim2reason.dsl.measures import Mass


@body
class Carriage(Body):
    """Something small that a straight rail carries and guides."""

    mass: Mass

    nouns = ("carriage", "slider", "trolley")
    letters = "XYZ"
    lone = ("a {noun} of mass {mass}", "a {noun} ({mass})")
    named = ("{noun} {letter} of mass {mass}", "{noun} {letter} ({mass})")
    symbols = {"mass": "M"}

    @property
    def look(self) -> Small:
        """A box on wheels."""
        return Small("cart")

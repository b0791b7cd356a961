"""A block: a small body with mass."""

from sim2reason.dsl.body import Body, body
from sim2reason.dsl.looks import Small
from sim2reason.dsl.measures import Mass


@body
class Block(Body):
    """A small block, moving without turning."""

    mass: Mass

    nouns = ("block", "crate")
    lone = ("a {noun} of mass {mass}", "a {noun} ({mass})", "a {noun} whose mass is {mass}")
    named = ("{noun} {letter} of mass {mass}", "{noun} {letter} ({mass})")
    listed = "{letter} ({mass})"

    @property
    def look(self) -> Small:
        """A rectangle."""
        return Small("block")

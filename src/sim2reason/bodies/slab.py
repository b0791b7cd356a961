"""A slab: long enough to carry others, which slide on it."""

from sim2reason.dsl.body import Body, body
from sim2reason.dsl.looks import Small
from sim2reason.dsl.measures import Mass


@body
class Slab(Body):
    """A long flat block, moving without turning."""

    mass: Mass

    nouns = ("slab", "plank", "board")
    lone = ("a long {noun} of mass {mass}", "a long {noun} ({mass})")
    named = ("{noun} {letter} of mass {mass}", "{noun} {letter} ({mass})")
    listed = "{letter} ({mass})"

    @property
    def look(self) -> Small:
        """A flat rectangle, longer than what it carries."""
        return Small("slab")

"""A small ball."""

from sim2reason.dsl.body import Body, body
from sim2reason.dsl.measures import Mass


@body
class Ball(Body):
    """A ball so small that its size never matters."""

    mass: Mass

    nouns = ("ball", "bead")
    lone = ("a small {noun} of mass {mass}", "a small {noun} ({mass})")
    named = ("small {noun} {letter} of mass {mass}", "small {noun} {letter} ({mass})")
    listed = "{letter} ({mass})"

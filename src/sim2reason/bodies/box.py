"""A large box that blocks ride on."""

from sim2reason.bodies.plane import Smoothness
from sim2reason.dsl.body import Body, body
from sim2reason.dsl.looks import BigBox
from sim2reason.dsl.measures import Friction, Mass, StaticFriction


@body
class Box(Body):
    """A box with a level top, moving without turning."""

    mass: Mass
    friction: Friction = 0.0
    static_friction: StaticFriction | None = None

    nouns = ("box",)
    letters = "WVUY"
    lone = ("a box of mass {mass} with a {surface} top", "a large box ({mass}) with a {surface} top")
    named = ("box {letter} of mass {mass} with a {surface} top", "box {letter} ({mass}) with a {surface} top")
    words = {"surface": Smoothness}
    symbols = {"mass": "M"}

    @property
    def look(self) -> BigBox:
        """A rectangle below and between what it carries."""
        return BigBox()

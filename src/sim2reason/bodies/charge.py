"""A charged bead, and how it starts."""

from math import cos, radians, sin
from typing import Annotated, Literal

from annotated_types import Ge, Le, Lt

from sim2reason.dsl.body import Body, body
from sim2reason.dsl.looks import Small, Unseen
from sim2reason.dsl.measures import Measure, Range, Speed
from sim2reason.dsl.template import Word

BeadMass = Annotated[float, Ge(1e-26), Le(1e6), Measure("mass", "mg", "m"), Range(1.0, 5.0)]
Charge = Annotated[
    float, Ge(1e-14), Le(1e6), Measure("charge", "uC", "q", called="magnitude of the charge"), Range(1.0, 5.0)
]
Heading = Annotated[float, Ge(0), Lt(360), Measure("angle", "deg", r"\theta", decimals=0), Range(2.0, 358.0)]


@body
class ChargedBead(Body):
    """A small body with a charge."""

    mass: BeadMass
    charge: Charge
    sign: Literal["positive", "negative"]

    nouns = ("bead", "ball")
    words = {
        "charged": Word(
            "sign",
            {"positive": "a positive charge of {charge}", "negative": "a negative charge of magnitude {charge}"},
        ),
    }
    lone = (
        "a small {noun} of mass {mass} with {charged}",
        "a small {noun} ({mass}) that carries {charged}",
    )
    named = (
        "a small {noun} {letter} of mass {mass} with {charged}",
        "a small {noun} {letter} ({mass}), which carries {charged},",
    )

    @property
    def signed_charge(self) -> float:
        """The charge with its sign, uC."""
        return self.charge if self.sign == "positive" else -self.charge

    @property
    def look(self) -> Small:
        """A filled circle with the sign of the charge."""
        return Small("ball", "+" if self.sign == "positive" else "\N{MINUS SIGN}")


class BeadStart(Body):
    """How a bead begins to move at the origin; told as what it does there."""

    letters = ""

    @property
    def velocity(self) -> tuple[float, float]:
        """Along x and y, m/s."""
        raise NotImplementedError

    @property
    def look(self) -> Unseen:
        """Its velocity is drawn at the bead."""
        return Unseen()


@body
class Launched(BeadStart):
    """It has a velocity."""

    speed: Annotated[Speed, Range(1.5, 4.0)]
    angle: Heading

    nouns = ("start",)
    lone = (
        "leaves the origin of the x-y plane at speed {speed} {heading}",
        "is at the origin of the x-y plane, moving at speed {speed} {heading}",
    )
    words = {
        "heading": Word(
            "angle",
            {
                0.0: "in the positive x direction",
                90.0: "in the positive y direction",
                180.0: "in the negative x direction",
                270.0: "in the negative y direction",
            },
            "in a direction {angle} counter-clockwise from the positive x direction",
        ),
    }

    @property
    def velocity(self) -> tuple[float, float]:
        """Along x and y, m/s."""
        return self.speed * cos(radians(self.angle)), self.speed * sin(radians(self.angle))


@body
class Released(BeadStart):
    """It is let go."""

    nouns = ("start",)
    lone = (
        "is released from rest at the origin of the x-y plane",
        "starts from rest at the origin of the x-y plane",
    )

    @property
    def velocity(self) -> tuple[float, float]:
        """Zero."""
        return 0.0, 0.0

"""A movable pulley that a string goes round, with a hook on its axle for another."""

from typing import Literal

from sim2reason.authoring import End, Entity, Frame, Pass, Word, Z, entity, scale
from sim2reason.bodies.pulley import MovablePulley


@entity
class ThreePointMovablePulley(Entity):
    """The hook is on the side that the string does not pull to: below where both its parts go up, and the reverse."""

    schematic = True

    pulley: MovablePulley
    hook: Literal["below", "above"] = "below"

    words = {
        "way": Word(
            "hook",
            {
                "below": "runs straight down, under {pulley} and straight up again",
                "above": "runs straight up, over {pulley} and straight down again",
            },
        ),
        "away": Word("hook", {"below": "runs straight down", "above": "runs straight up"}),
        "towards": Word("hook", {"below": "runs straight up", "above": "runs straight down"}),
    }
    strand = Pass(sites=("pulley.left", "pulley.right"), passes="{way}", required=True)
    eye = End(
        sites=("axle",),
        tied="the hook {hook} {pulley}",
        leaves="{away}",
        arrives="{towards} to the hook {hook} {pulley}",
        required=True,
    )

    def build(self, room: Frame) -> None:
        """The pulley on a vertical slide, its rims facing away from its hook."""
        away = scale(-1.0 if self.hook == "below" else 1.0, Z)
        carrier = room.body("carrier").slide(Z)
        carrier.site("axle", faces=away)
        carrier.pulley("pulley", mass=self.pulley.mass, faces=scale(-1.0, away))

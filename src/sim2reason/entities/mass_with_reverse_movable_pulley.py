"""A movable pulley that hangs in the bight of a string, with a load on its axle."""

from sim2reason.authoring import End, Entity, Frame, FreeLength, Pass, Z, either, entity, scale
from sim2reason.bodies.block import Block
from sim2reason.bodies.pulley import MovablePulley


@entity
class MassWithReverseMovablePulley(Entity):
    """A string goes under the pulley, and both its sides pull it up; a load may hang from the axle."""

    schematic = True

    pulley: MovablePulley
    load: Block | None = None
    length: FreeLength = 1.0

    says = (
        either(
            "{load} hangs by a light string from the axle of {pulley}.",
            "{load} is tied by a light string to the axle of {pulley}.",
            "a light string from the axle of {pulley} carries {load}.",
        ),
    )
    under = Pass(
        sites=("pulley.left", "pulley.right"),
        passes="goes straight down, under {pulley} and straight up again",
        required=True,
    )
    bottom = End(
        sites=("axle",),
        tied="the axle of {pulley}",
        leaves="runs straight down",
        arrives="runs straight up to the axle of {pulley}",
        unless="load",
    )

    def build(self, room: Frame) -> None:
        """The pulley on a vertical slide, its rims facing up, its axle facing down to the load."""
        carrier = room.body("carrier").slide(Z)
        carrier.site("axle", faces=scale(-1.0, Z))
        carrier.pulley("pulley", mass=self.pulley.mass, faces=Z)
        if self.load is not None:
            load = room.body("load", self.load.mass, at=(0.0, 0.0, -self.length)).slide(Z)
            load.site("hook", faces=Z)
            room.string("cord", room.address("axle"), room.address("hook"))

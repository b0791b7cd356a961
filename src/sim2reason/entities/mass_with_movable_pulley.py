"""A movable pulley that hangs by its axle and carries a mass system on either side of its string."""

from sim2reason.authoring import WHEEL_RADIUS, End, Entity, Frame, Pass, X, Z, entity, scale
from sim2reason.bodies.pulley import MovablePulley
from sim2reason.connections.string import String
from sim2reason.dsl.connection import Inside
from sim2reason.entities.parts.mass_systems import Hanging, OnPlane, OnWedge

ASIDE = 1.0  # m; how far from the pulley a plane or wedge stands, for looks


@entity
class MassWithMovablePulley(Entity):
    """A movable pulley, held from above by its axle; its string carries a mass system on either side."""

    schematic = True

    left: Hanging | OnPlane | OnWedge
    right: Hanging | OnPlane | OnWedge
    pulley: MovablePulley

    over = Pass(sites=("pulley.left", "pulley.right"), passes="passes over {pulley}")
    rope = Inside(String, ("left.tail", "over", "right.tail"))
    top = End(
        sites=("axle",),
        tied="the axle of {pulley}",
        leaves="runs straight up",
        arrives="runs straight down to the axle of {pulley}",
        required=True,
    )

    def build(self, room: Frame) -> None:
        """The pulley on a vertical slide, its rims facing down, its axle facing up."""
        carrier = room.body("carrier").slide(Z)
        carrier.site("axle", faces=Z)
        carrier.pulley("pulley", mass=self.pulley.mass, faces=scale(-1.0, Z))
        for name, system, side in (("left", self.left, 1.0), ("right", self.right, -1.0)):
            hangs = isinstance(system, Hanging)
            at = scale(-side * (WHEEL_RADIUS if hangs else ASIDE), X)
            system.build(room.part(name, at=at if hangs else (at[0], 0.0, -1.0)), side)

"""A mass system whose string passes over a pulley that is fixed in the room."""

from sim2reason.authoring import WHEEL_RADIUS, Chain, Entity, Frame, Pass, entity
from sim2reason.bodies.pulley import FixedPulley
from sim2reason.entities.parts.mass_systems import Hanging, OnPlane, OnWedge


@entity
class MassWithFixedPulley(Entity):
    """A fixed pulley; a mass system on one side of its string, the other side open."""

    schematic = True

    system: Hanging | OnPlane | OnWedge
    pulley: FixedPulley

    over = Pass(sites=("pulley.left", "pulley.right"), passes="passes over {pulley}")
    tail = Chain(stops=("system.tail", "over"), required=True)

    def build(self, room: Frame) -> None:
        """The system's string reaches the left of the rim, the open side leaves its right."""
        room.pulley("pulley", at=(WHEEL_RADIUS, 0.0, 0.0), mass=self.pulley.mass)
        self.system.build(room.part("system"))

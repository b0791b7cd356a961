"""Blocks that hang from the end of a string."""

from sim2reason.authoring import Chain, Entity, Frame, entity
from sim2reason.entities.parts.mass_systems import Hanging


@entity
class HangingMass(Entity):
    """Closes an open string with a load."""

    schematic = True

    system: Hanging

    end = Chain(stops=("system.tail",), required=True)

    def build(self, room: Frame) -> None:
        """The load itself."""
        self.system.build(room.part("system"))

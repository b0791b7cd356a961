"""A hand that draws a string in with a constant force."""

from sim2reason.authoring import Entity, Force, Frame, StringEnd, entity


@entity
class ConstantForcePuller(Entity):
    """Closes an open string with a constant pull along it."""

    schematic = True

    force: Force

    end = StringEnd(
        sites=("hand",), arrives="is pulled at its far end by a hand with a constant force of {force}", required=True
    )

    def build(self, room: Frame) -> None:
        """A fixed point at which the string is drawn in."""
        room.hand("hand", self.force)

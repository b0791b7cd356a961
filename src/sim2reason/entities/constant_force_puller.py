"""A hand that draws a string in with a constant force."""

from sim2reason.authoring import Entity, Force, Frame, StringEnd, entity


@entity
class ConstantForcePuller(Entity):
    """Closes an open string with a steady pull along it."""

    schematic = True

    force: Force

    end = StringEnd(sites=("hand",), arrives="ends in a hand that pulls with a steady force of {force}", required=True)

    def build(self, room: Frame) -> None:
        """A fixed point at which the string is drawn in."""
        room.hand("hand", self.force)

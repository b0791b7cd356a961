"""A hook to which an open string is tied."""

from sim2reason.authoring import End, Entity, Frame, entity


@entity
class FixedSupport(Entity):
    """Closes an open string with a point fixed in the room."""

    schematic = True

    end = End(
        sites=("hook",),
        tied="a fixed hook",
        arrives="ends at a fixed hook",
        required=True,
    )

    def build(self, room: Frame) -> None:
        """A point of the room."""
        room.site("hook")

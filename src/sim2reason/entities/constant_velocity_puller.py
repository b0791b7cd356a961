"""A winch that takes a string in with a constant speed."""

from typing import Annotated

from sim2reason.authoring import Entity, Frame, Range, Speed, StringEnd, entity


@entity
class ConstantVelocityPuller(Entity):
    """Closes an open string with a winch, which runs at full speed from t = 0 on."""

    schematic = True

    speed: Annotated[Speed, Range(0.1, 0.8)]

    end = StringEnd(
        sites=("drum",),
        arrives="ends at a winch that from t = 0 on takes it in at a constant {speed}",
        required=True,
    )

    def build(self, room: Frame) -> None:
        """A fixed point at which the string grows shorter."""
        room.winch("drum", self.speed)

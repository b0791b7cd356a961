"""Blocks in a row on a fixed plane, open to strings on either side."""

from sim2reason.authoring import End, Entity, Frame, Speed, either, entity, scale
from sim2reason.bodies.plane import Plane
from sim2reason.entities.parts.mass_systems import FRICTION_ON_PLANE, Blocks, row


@entity
class TwoSideMassPlane(Entity):
    """One or more blocks on a plane that rises to the right; they may start with a common speed up the slope."""

    schematic = True

    plane: Plane
    blocks: Blocks
    speed: Speed | None = None

    says = (
        either(
            "{blocks} {blocks:lies/lie} on {plane}{blocks:/, with {blocks.first} {plane.lower} and a light string between them/, joined in this order, from {plane.order}, by light strings}.",
            "on {plane} {blocks:lies/lie} {blocks}{blocks:/, {blocks.first} {plane.lower}, joined by a light string/, in this order from {plane.order} and joined by light strings}.",
            "{plane} carries {blocks}{blocks:/, {blocks.first} {plane.lower}, with a light string between them/, in a row from {plane.order} and joined by light strings}.",
        ),
        FRICTION_ON_PLANE,
        either(
            "at t = 0 {blocks} {blocks:moves/move} {plane.uphill} at speed {speed}.",
            "the velocity of {blocks} at t = 0 is {speed}, directed {plane.uphill}.",
            "{blocks} {blocks:is/are} launched {plane.uphill} at t = 0 with a speed of {speed}.",
        ),
    )
    left = End(
        sites=("lowest",),
        tied="{blocks.first}",
        leaves="runs {plane.downhill}",
        arrives="reaches {blocks.first} {plane.below}",
    )
    right = End(
        sites=("hook",),
        tied="{blocks.last}",
        leaves="runs {plane.uphill}",
        arrives="reaches {blocks.last} {plane.above}",
    )

    def build(self, room: Frame) -> None:
        """Blocks that rest on the room's face, the first one lowest."""
        plane, (uphill, _) = self.plane, self.plane.directions()
        frames = row(room, self.blocks, plane, length=0.0, speed=self.speed or 0.0)
        frames[0].site("lowest", faces=scale(-1.0, uphill))

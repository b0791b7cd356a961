"""A movable prism with blocks on either face, joined by a string over its apex."""

from math import cos, radians, sin
from typing import Annotated

from annotated_types import Len

from sim2reason.authoring import Count, Entity, Frame, FreeLength, StringEnd, X, Z, either, entity, scale
from sim2reason.bodies.block import Block
from sim2reason.bodies.wedge import Prism
from sim2reason.entities.parts.friction import two_coefficients
from sim2reason.entities.parts.mass_systems import SPACING

FaceBlocks = Annotated[tuple[Block, ...], Len(1, 3), Count(1, 2)]


@entity
class MassPrismPlane(Entity):
    """A prism free to slide on the floor; one string, over its apex, joins the blocks on both faces."""

    schematic = True

    prism: Prism
    left_blocks: FaceBlocks
    right_blocks: FaceBlocks
    length: FreeLength = 3.0

    says = (
        either(
            "{prism} is free to slide on a smooth floor.",
            "{prism} stands on a smooth floor and is free to slide.",
            "on a smooth floor {prism} is free to slide.",
        ),
        either(
            "{left_blocks} {left_blocks:rests/rest, the lower one first,/rest, in this order from the lowest up,} on the left face, and {right_blocks}{right_blocks:/, the lower one first,/, in this order from the lowest up,} on the right.",
            "on the left face {left_blocks:lies/lie, the lower one first,/lie, from the lowest up,} {left_blocks}, and on the right face{right_blocks:/, the lower one first,/, from the lowest up,} {right_blocks}.",
            "the left face carries {left_blocks}{left_blocks:/, the lower one first/, from the lowest up}, and the right face {right_blocks}{right_blocks:/, the lower one first/, from the lowest up}.",
        ),
        either(
            "a light string over a light pulley at the apex joins {left_blocks.last} to {right_blocks.last}{left_blocks:/; another joins {left_blocks.last} to {left_blocks.first} below it/; light strings join the others on the left face, each to the next}{right_blocks:/; another joins {right_blocks.last} to {right_blocks.first} below it/; light strings join the others on the right face, each to the next}.",
            "across the apex, over a light pulley, a light string joins {left_blocks.last} to {right_blocks.last}{left_blocks:/; on the left face another joins {left_blocks.last} to {left_blocks.first} below it/; on the left face light strings join each block to the next}{right_blocks:/; on the right face another joins {right_blocks.last} to {right_blocks.first} below it/; on the right face light strings join each block to the next}.",
            "over a light pulley at the apex a light string runs from {left_blocks.last} to {right_blocks.last}{left_blocks:/; another runs down the left face from {left_blocks.last} to {left_blocks.first}/; neighbours on the left face are joined by light strings}{right_blocks:/; another runs down the right face from {right_blocks.last} to {right_blocks.first}/; neighbours on the right face are joined by light strings}.",
        ),
        either(
            "the coefficient of friction (static and kinetic) on both faces is {prism.friction}.",
            "on both faces the coefficient of friction, static and kinetic, is {prism.friction}.",
            "static and kinetic friction have the same coefficient on both faces, {prism.friction}.",
        ).if_given("prism.static_friction", *two_coefficients("on both faces", "prism")),
    )
    left = StringEnd(
        sites=("left_lowest", "left_foot"),
        tied="{left_blocks.first}",
        leaves="runs down the left face, round a light pulley at its foot and on horizontally to the left",
        arrives="runs horizontally to a light pulley at the foot of the left face and up that face to {left_blocks.first}",
    )
    right = StringEnd(
        sites=("right_lowest", "right_foot"),
        tied="{right_blocks.first}",
        leaves="runs down the right face, round a light pulley at its foot and on horizontally to the right",
        arrives="runs horizontally to a light pulley at the foot of the right face and up that face to {right_blocks.first}",
    )

    def build(self, room: Frame) -> None:
        """The prism on the floor with its apex at the origin, and the blocks on its faces."""
        prism = room.body("prism", self.prism.mass).rest(along=X, normal=Z)
        prism.site("apex")
        tops = [
            self._face(prism, "left", self.left_blocks, self.prism.left, 1.0),
            self._face(prism, "right", self.right_blocks, self.prism.right, -1.0),
        ]
        prism.string("rope", tops[0], room.address("apex"), tops[1])

    def _face(self, prism: Frame, name: str, blocks: tuple[Block, ...], angle: float, side: float) -> str:
        """Blocks on a face that rises to the `side`, the last one highest; the address of its hook."""
        uphill = (side * cos(radians(angle)), 0.0, sin(radians(angle)))
        normal = (-side * sin(radians(angle)), 0.0, cos(radians(angle)))
        count = len(blocks)
        for index, block in enumerate(blocks):
            away = -(self.length + (count - 1 - index) * SPACING)
            frame = prism.body(f"{name}_blocks.{index}", block.mass, at=scale(away, uphill))
            frame.rest(uphill, normal, self.prism.friction, static=self.prism.static_friction)
            frame.site(f"{name}_hook{index}")
            if index == 0:
                frame.site(f"{name}_lowest")
            else:
                hooks = prism.address(f"{name}_hook{index - 1}"), prism.address(f"{name}_hook{index}")
                prism.string(f"{name}_link{index - 1}", *hooks)
        foot = -(2.0 * self.length + (count - 1) * SPACING)
        prism.site(f"{name}_foot", at=scale(foot, uphill), faces=scale(-side, X))
        return prism.address(f"{name}_hook{count - 1}")

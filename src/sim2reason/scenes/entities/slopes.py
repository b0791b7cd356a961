"""Blocks on planes, boxes and prisms."""

from math import cos, radians, sin
from typing import Annotated

from annotated_types import Len

from sim2reason.scenes.authoring import (
    Count,
    End,
    Entity,
    Frame,
    FreeLength,
    Speed,
    StringEnd,
    X,
    Z,
    either,
    entity,
    scale,
)
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.simple_machines import Box, Plane, Prism
from sim2reason.scenes.entities.string_ends import FRICTION_ON_PLANE, SPACING, Blocks, link, row, two_coefficients

BLOCK_SPACING = 1.2  # m between neighbours on the top, kept by their strings and without effect
EYE_HEIGHT = 1.6  # height of a string's eye below the top, in free lengths; for drawings only


@entity
class MassBoxPlane(Entity):
    """The box is free to slide; what hangs at its sides slides in guides there, so that the box draws it along."""

    box: Box
    blocks: Blocks
    right: Block
    left: Block | None = None
    length: FreeLength = 2.0

    says = (
        either(
            "{box} is free to slide on a smooth floor.",
            "{box} stands on a smooth floor and is free to slide.",
            "on a smooth floor {box} is free to slide.",
        ),
        either(
            "{blocks} {blocks:rests/rest} on its top{blocks:/, with {blocks.first} on the left and a light string between them/, joined in this order, from left to right, by light strings}.",
            "its top carries {blocks}{blocks:/, with {blocks.first} on the left and a light string between them/, joined in this order, from left to right, by light strings}.",
            "on its top {blocks:lies/lie} {blocks}{blocks:/, {blocks.first} on the left, joined by a light string/, in this order from left to right and joined by light strings}.",
        ),
        either(
            "the coefficient of friction (static and kinetic) on the top is {box.friction}.",
            "on the top the coefficient of friction, static and kinetic, is {box.friction}.",
            "static and kinetic friction on the top have the same coefficient, {box.friction}.",
        ).if_given("box.static_friction", *two_coefficients("on the top", "box")),
        either(
            "a light string from {blocks.first} runs to the left, over a light pulley at the edge and down to {left}, which slides in a smooth vertical guide on that side of {box}.",
            "over a light pulley at the left edge a light string joins {blocks.first} to {left}, which can only slide in a smooth vertical guide on that side of {box}.",
            "{left} slides in a smooth vertical guide on the left side of {box}; from it a light string runs up and over a light pulley at the edge to {blocks.first}.",
        ),
        either(
            "a light string from {blocks.last} runs to the right, over a light pulley at the edge and down to {right}, which slides in a smooth vertical guide on that side of {box}.",
            "over a light pulley at the right edge a light string joins {blocks.last} to {right}, which can only slide in a smooth vertical guide on that side of {box}.",
            "{right} slides in a smooth vertical guide on the right side of {box}; from it a light string runs up and over a light pulley at the edge to {blocks.last}.",
        ),
    )
    left_end = End(
        sites=("left_eye",),
        tied="{box}",
        leaves="runs horizontally to the left",
        arrives="runs horizontally from the left to {box}",
    )
    right_end = End(
        sites=("right_eye",),
        tied="{box}",
        leaves="runs horizontally to the right",
        arrives="runs horizontally from the right to {box}",
    )

    def build(self, room: Frame) -> None:
        """Build the box with its top at the origin, a row of blocks there, and a block beside each edge."""
        box = room.body("box", self.box.mass).rest(along=X, normal=Z)
        last = len(self.blocks) - 1
        for index, block in enumerate(self.blocks):
            frame = box.body(f"blocks.{index}", block.mass, at=scale((index - 0.5 * last) * BLOCK_SPACING, X))
            frame.rest(X, Z, self.box.friction, name="right", static=self.box.static_friction).site(f"hook{index}")
        link(box, len(self.blocks))
        edge = self.length + 0.5 * last * BLOCK_SPACING
        for name, block, sign, hook in (("left", self.left, -1.0, "hook0"), ("right", self.right, 1.0, f"hook{last}")):
            box.site(f"{name}_eye", at=(sign * edge, 0.0, -EYE_HEIGHT * self.length), faces=scale(sign, X))
            if block is not None:
                box.site(f"{name}_corner", at=(sign * edge, 0.0, 0.0))
                box.body(name, block.mass, at=(sign * edge, 0.0, -self.length)).slide(Z).site(f"{name}_hook")
                stops = (hook, f"{name}_corner", f"{name}_hook")
                box.string(f"{name}_rope", *map(box.address, stops))


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
        """Build the prism on the floor with its apex at the origin, and the blocks on its faces."""
        prism = room.body("prism", self.prism.mass).rest(along=X, normal=Z)
        prism.site("apex")
        tops = [
            self._face(prism, "left", self.left_blocks, self.prism.left, 1.0),
            self._face(prism, "right", self.right_blocks, self.prism.right, -1.0),
        ]
        prism.string("rope", tops[0], room.address("apex"), tops[1])

    def _face(self, prism: Frame, name: str, blocks: tuple[Block, ...], angle: float, side: float) -> str:
        """Build blocks on a face that rises to the `side`; return the address of the hook of the highest block."""
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
        """Build blocks on the slope, the first one lowest."""
        plane, (uphill, _) = self.plane, self.plane.directions()
        frames = row(room, self.blocks, plane, length=0.0, speed=self.speed or 0.0)
        frames[0].site("lowest", faces=scale(-1.0, uphill))

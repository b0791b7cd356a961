"""A box on the floor with blocks on its top and at its sides, joined by strings over its edges."""

from sim2reason.authoring import End, Entity, Frame, FreeLength, X, Z, either, entity, scale
from sim2reason.bodies.block import Block
from sim2reason.bodies.box import Box
from sim2reason.entities.parts.friction import two_coefficients
from sim2reason.entities.parts.mass_systems import Blocks, link

APART = 1.2  # m between neighbours on the top; their strings keep it, so it never matters
EYE = 1.6  # times the free length of a string that hangs there, below the top; for looks


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
        """The box with its top at the origin, a row of blocks there, and a block beside either edge."""
        box = room.body("box", self.box.mass).rest(along=X, normal=Z)
        last = len(self.blocks) - 1
        for index, block in enumerate(self.blocks):
            frame = box.body(f"blocks.{index}", block.mass, at=scale((index - 0.5 * last) * APART, X))
            frame.rest(X, Z, self.box.friction, name="right", static=self.box.static_friction).site(f"hook{index}")
        link(box, len(self.blocks))
        edge = self.length + 0.5 * last * APART
        for name, block, way, hook in (("left", self.left, -1.0, "hook0"), ("right", self.right, 1.0, f"hook{last}")):
            box.site(f"{name}_eye", at=(way * edge, 0.0, -EYE * self.length), faces=scale(way, X))
            if block is not None:
                box.site(f"{name}_corner", at=(way * edge, 0.0, 0.0))
                box.body(name, block.mass, at=(way * edge, 0.0, -self.length)).slide(Z).site(f"{name}_hook")
                stops = (hook, f"{name}_corner", f"{name}_hook")
                box.string(f"{name}_rope", *map(box.address, stops))

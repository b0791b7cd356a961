"""Mass systems at one end of a string."""

from itertools import pairwise
from math import cos, radians, sin
from typing import Annotated

from annotated_types import Len

from sim2reason.scenes.authoring import Count, End, Frame, FreeLength, Part, StringEnd, X, Z, among, either, scale
from sim2reason.scenes.bodies.planes import Plane, Wedge
from sim2reason.scenes.bodies.sliders import Block
from sim2reason.scenes.entities.parts.friction import two_coefficients

MAX_BLOCKS = 5
SPACING = 0.5  # m between neighbouring blocks of a row, kept by their strings and without effect
Blocks = Annotated[tuple[Block, ...], Len(1, MAX_BLOCKS), Count(1, 2)]
FREE_WEDGE = either(
    "{wedge} is free to slide on a smooth floor.",
    "{wedge} stands on a smooth floor and is free to slide.",
    "on a smooth floor {wedge} is free to slide.",
)
FRICTION_ON_PLANE = either(
    "the coefficient of friction (static and kinetic) on this plane is {plane.friction}.",
    "on this plane the coefficient of friction, static and kinetic, is {plane.friction}.",
    "static and kinetic friction on this plane have the same coefficient, {plane.friction}.",
    "the coefficient of friction, static and kinetic, is {plane.friction} on this plane.",
    "the coefficient of friction on this plane, static and kinetic, is {plane.friction}.",
    "for this plane the coefficient of friction is {plane.friction}, whether static or kinetic.",
    "the coefficients of static and of kinetic friction on this plane are both {plane.friction}.",
).if_given("plane.static_friction", *two_coefficients("on this plane", "plane"))


class MassSystem(Part):
    """Base class of mass systems; `tail` is the free end of the string, `length` its free length to the next pulley."""

    length: FreeLength = 3.0

    def build(self, room: Frame, side: float = 1.0) -> None:
        """Build the system with its string ending at the origin of `room`; a `side` of −1 mirrors it."""
        raise NotImplementedError


class Hanging(MassSystem):
    """Blocks that hang one below the other."""

    blocks: Blocks

    says = (
        among(
            "blocks",
            "{blocks} are joined by {blocks:/a light string, with {blocks.last} below {blocks.first}/light strings, one below the other in this order}.",
            "{blocks} hang one below the other, {blocks:/{blocks.first} on top, joined by a light string/in this order from the top down, joined by light strings}.",
            "{blocks} hang {blocks:/one below the other, with {blocks.last} attached to {blocks.first} by a light string/in a column, each below the one before on a light string}.",
            "{blocks:/a light string joins/light strings join} {blocks}, {blocks:/{blocks.last} hanging below {blocks.first}/which hang one below the other in this order}.",
        ),
    )
    tail = End(
        sites=("hook",),
        tied="{blocks.first}",
        leaves="runs straight up",
        arrives="runs straight down to {blocks.first}",
        hangs=True,
    )

    def build(self, room: Frame, side: float = 1.0) -> None:
        """Build blocks with a vertical sliding coordinate each, the first block on top."""
        del side
        for index, block in enumerate(self.blocks):
            depth = self.length + index * SPACING
            frame = room.body(f"blocks.{index}", block.mass, at=(0.0, 0.0, -depth)).slide(Z)
            frame.site("hook" if index == 0 else f"hook{index}", faces=Z)
        link(room, len(self.blocks), first="hook")


class OnPlane(MassSystem):
    """Blocks in a row on a fixed plane, drawn up its slope."""

    plane: Plane
    blocks: Blocks

    says = (
        either(
            "{blocks} {blocks:lies/lie} on {plane}{blocks:/, with {blocks.first} {plane.lower} and a light string between them/, joined in this order, from {plane.order}, by light strings}.",
            "on {plane} {blocks:lies/lie} {blocks}{blocks:/, {blocks.first} {plane.lower}, joined by a light string/, in this order from {plane.order} and joined by light strings}.",
            "{blocks} {blocks:rests/rest} on {plane}{blocks:/, {blocks.first} {plane.lower}, with a light string between them/, in a row from {plane.order} and joined by light strings}.",
        ),
        FRICTION_ON_PLANE,
    )
    tail = End(
        sites=("hook",),
        tied="{blocks.last}",
        leaves="runs {plane.uphill}",
        arrives="reaches {blocks.last} {plane.above}",
    )

    def build(self, room: Frame, side: float = 1.0) -> None:
        """Build blocks on the slope, the last one highest."""
        row(room, self.blocks, self.plane, self.length, side)


class OnWedge(MassSystem):
    """Blocks in a row on the face of a wedge that slides on a smooth floor."""

    wedge: Wedge
    blocks: Blocks

    says = (
        FREE_WEDGE,
        either(
            "{blocks} {blocks:rests/rest} on its face{blocks:/, with {blocks.first} lower down and a light string between them/, joined in this order, from the lowest to the highest, by light strings}.",
            "its face carries {blocks}{blocks:/, with {blocks.first} lower down and a light string between them/, joined in this order, from the lowest to the highest, by light strings}.",
            "on its face {blocks:lies/lie} {blocks}{blocks:/, {blocks.first} lower down, joined by a light string/, in this order from the lowest to the highest and joined by light strings}.",
        ),
        either(
            "the coefficient of friction (static and kinetic) on this face is {wedge.friction}.",
            "on this face the coefficient of friction, static and kinetic, is {wedge.friction}.",
            "static and kinetic friction on this face have the same coefficient, {wedge.friction}.",
        ).if_given("wedge.static_friction", *two_coefficients("on this face", "wedge")),
    )
    tail = StringEnd(
        sites=("hook", "corner"),
        tied="{blocks.last}",
        leaves="runs up the face, over a light pulley at its top and on horizontally, away from the face",
        arrives="runs horizontally to a light pulley at the top of {wedge} and beyond it down the face to {blocks.last}",
    )

    def build(self, room: Frame, side: float = 1.0) -> None:
        """Build the wedge on the floor with blocks on its face; the string leaves horizontally from its top."""
        corner = scale(-self.length, scale(side, X))
        wedge = room.body("wedge", self.wedge.mass, at=corner).rest(along=X, normal=Z)
        wedge.site("corner", faces=scale(side, X))
        row(wedge, self.blocks, self.wedge, self.length, side)


def row(
    carrier: Frame,
    blocks: tuple[Block, ...],
    slope: Plane | Wedge,
    length: float,
    side: float = 1.0,
    speed: float = 0.0,
) -> list[Frame]:
    """Return frames of blocks on a slope rising to the `side`; the last is `length` below the origin of `carrier`."""
    angle = radians(slope.angle)
    uphill, normal = (side * cos(angle), 0.0, sin(angle)), (-side * sin(angle), 0.0, cos(angle))
    last = len(blocks) - 1
    frames: list[Frame] = []
    for index, block in enumerate(blocks):
        away = -(length + (last - index) * SPACING)
        frame = carrier.body(f"blocks.{index}", block.mass, at=scale(away, uphill))
        frames.append(frame.rest(uphill, normal, slope.friction, speed, static=slope.static_friction))
        frame.site("hook" if index == last else f"hook{index}", faces=uphill)
    link(carrier, len(blocks), last="hook")
    return frames


def link(room: Frame, count: int, first: str = "hook0", last: str = "") -> None:
    """Add light strings between neighbours in a row of blocks; the first or last hook has a name of its own."""
    hooks = [first, *(f"hook{index}" for index in range(1, count))]
    if last:
        hooks = [*(f"hook{index}" for index in range(count - 1)), last]
    for index, (one, other) in enumerate(pairwise(hooks)):
        room.string(f"link{index}", room.address(one), room.address(other))

"""Entities at the end of a string: mass systems with their friction, hooks, and hands that pull."""

from itertools import pairwise
from math import cos, radians, sin
from typing import Annotated, Literal

from annotated_types import Ge, Le, Len

from sim2reason.scenes.authoring import (
    LEAST,
    Angle,
    Chain,
    Count,
    End,
    Entity,
    Force,
    Frame,
    FreeLength,
    Measure,
    Part,
    Range,
    Speed,
    StringEnd,
    X,
    Z,
    among,
    either,
    entity,
    scale,
)
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.simple_machines import Plane, Wedge


def two_coefficients(where: str, of: str = "") -> tuple[str, ...]:
    """Return sentences that state both friction coefficients; `where` is their location (*on this plane*)."""
    static, kinetic = (f"{{{of}{'.' * bool(of)}{name}}}" for name in ("static_friction", "friction"))
    return (
        f"the coefficients of static and kinetic friction {where} are {static} and {kinetic}, respectively.",
        f"{where} the coefficient of static friction is {static} and that of kinetic friction {kinetic}.",
        f"the coefficient of static friction {where} is {static}, that of kinetic friction {kinetic}.",
    )


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


@entity
class ConstantForcePuller(Entity):
    """Closes an open string with a constant pull along it."""

    schematic = True

    force: Force

    end = StringEnd(
        sites=("hand",), arrives="is pulled at its far end by a hand with a constant force of {force}", required=True
    )

    def build(self, room: Frame) -> None:
        """Build a fixed point at which a hand pulls the string."""
        room.hand("hand", self.force)


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
        """Build a fixed point at which a winch shortens the string."""
        room.winch("drum", self.speed)


Distance = Annotated[float, LEAST, Le(1e3), Measure("distance", "m", "d", decimals=2), Range(0.5, 2.0)]
Away = Annotated[Angle, Ge(1), Range(15.0, 70.0)]


@entity
class DirectedMass(Entity):
    """Each string leads from the block to a small fixed pulley, over or under it, and on horizontally."""

    block: Block
    left_distance: Distance
    left_angle: Away
    left_side: Literal["above", "below"]
    right_distance: Distance
    right_angle: Away
    right_side: Literal["above", "below"]

    says = (
        either(
            "{block} can slide only along a smooth horizontal guide.",
            "on a smooth horizontal guide, which it can't leave, slides {block}.",
            "a smooth horizontal guide lets {block} slide to the left and right.",
        ),
        either(
            "initially a small fixed pulley on its left is {left_distance} away from it, {left_angle} {left_side} the guide, and another on its right is {right_distance} away, {right_angle} {right_side} the guide.",
            "at the start its distance from a small fixed pulley on the left is {left_distance}, at an angle of {left_angle} {left_side} the guide; from a second one on the right it is {right_distance}, at {right_angle} {right_side} the guide.",
            "two small pulleys are fixed near by: seen from it, one is initially on the left, {left_angle} {left_side} the guide and {left_distance} away, the other on the right, {right_angle} {right_side} the guide and {right_distance} away.",
        ),
    )
    side_1 = StringEnd(
        sites=("left_hook", "left_wheel"),
        tied="{block}",
        leaves="runs to the small pulley on the left, round it and on horizontally to the left",
        arrives="runs horizontally to the small pulley on the left and round it to {block}",
        required=True,
    )
    side_2 = StringEnd(
        sites=("right_hook", "right_wheel"),
        tied="{block}",
        leaves="runs to the small pulley on the right, round it and on horizontally to the right",
        arrives="runs horizontally to the small pulley on the right and round it to {block}",
        required=True,
    )

    def build(self, room: Frame) -> None:
        """Build the block with a horizontal sliding coordinate, and the two points round which its strings pass."""
        room.body("block", self.block.mass).slide(X).site("left_hook").site("right_hook")
        for sign, name in ((-1.0, "left"), (1.0, "right")):
            distance, angle, side = (getattr(self, f"{name}_{field}") for field in ("distance", "angle", "side"))
            across, rise = distance * cos(radians(angle)), distance * sin(radians(angle))
            room.site(f"{name}_wheel", (sign * across, 0.0, rise if side == "above" else -rise), faces=scale(sign, X))


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
        """Build a fixed point."""
        room.site("hook")


@entity
class HangingMass(Entity):
    """Closes an open string with a load."""

    schematic = True

    system: Hanging

    end = Chain(stops=("system.tail",), required=True)

    def build(self, room: Frame) -> None:
        """Build the mass system."""
        self.system.build(room.part("system"))

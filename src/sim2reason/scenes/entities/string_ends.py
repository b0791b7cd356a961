"""Entities at the end of a string."""

from math import cos, radians, sin
from typing import Annotated, Literal

from annotated_types import Ge, Le

from sim2reason.scenes.authoring import (
    LEAST,
    Angle,
    Chain,
    End,
    Entity,
    Force,
    Frame,
    Measure,
    Range,
    Speed,
    StringEnd,
    X,
    either,
    entity,
    scale,
)
from sim2reason.scenes.bodies.sliders import Block
from sim2reason.scenes.entities.parts.mass_systems import Hanging


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
        for way, name in ((-1.0, "left"), (1.0, "right")):
            distance, angle, side = (getattr(self, f"{name}_{field}") for field in ("distance", "angle", "side"))
            across, rise = distance * cos(radians(angle)), distance * sin(radians(angle))
            room.site(f"{name}_wheel", (way * across, 0.0, rise if side == "above" else -rise), faces=scale(way, X))


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

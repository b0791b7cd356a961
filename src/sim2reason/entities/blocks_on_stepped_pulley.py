"""Two blocks that hang from a stepped pulley, one from each of its radii."""

from typing import Literal

from sim2reason.authoring import Entity, Frame, FreeLength, Word, X, Y, Z, axial_inertia, either, entity, scale
from sim2reason.bodies.block import Block
from sim2reason.bodies.stepped_pulley import SteppedPulley

UPRIGHT_ON_Y = (X, scale(-1.0, Z), Y)  # the axes of what is round about the axle, which points away from the reader


@entity
class BlocksOnSteppedPulley(Entity):
    """Two blocks on strings wound round the two radii of a pulley, on opposite sides of its axle or on one side."""

    pulley: SteppedPulley
    outer_block: Block
    inner_block: Block
    sides: Literal["opposite", "same"] = "opposite"
    outer_length: FreeLength = 2.0
    inner_length: FreeLength = 1.4  # so that a figure shows the blocks apart

    words = {"side": Word("sides", {"opposite": "opposite sides", "same": "the same side"})}
    says = (
        either(
            "{pulley} turns without friction about a fixed horizontal axle.",
            "{pulley} is free to turn about a fixed horizontal axle.",
            "a fixed horizontal axle carries {pulley}, which turns on it without friction.",
        ),
        either(
            "a light string wound round its outer radius carries {outer_block}, and one wound round its inner "
            "radius carries {inner_block}.",
            "{outer_block} hangs from a light string wound round the outer radius, {inner_block} from one wound "
            "round the inner radius.",
            "from a light string wound round the outer radius hangs {outer_block}, and from one wound round the "
            "inner radius {inner_block}.",
        ),
        either(
            "the two strings leave the pulley on {side} of its axle.",
            "the strings hang down on {side} of the axle.",
            "on {side} of the axle the strings lead straight down.",
        ),
    )

    def build(self, room: Frame) -> None:
        """Build the pulley, its axle at the origin, and the blocks; the outer string hangs to the left of the axle."""
        pulley = self.pulley
        wheel = room.body("pulley", inertia=axial_inertia(pulley.inertia)).hinge(Y).turned(UPRIGHT_ON_Y)
        inner = pulley.inner if self.sides == "opposite" else -pulley.inner
        for name, across, block, length in (
            ("outer", -pulley.outer, self.outer_block, self.outer_length),
            ("inner", inner, self.inner_block, self.inner_length),
        ):
            room.site(f"pulley.{name}", at=(across, 0.0, 0.0), faces=scale(-1.0, Z))
            frame = room.body(f"{name}_block", block.mass, at=(across, 0.0, -length)).slide(Z)
            frame.site(f"{name}_hook", faces=Z)
            wheel.wound(f"{name}_string", room.address(f"pulley.{name}"), room.address(f"{name}_hook"), across)

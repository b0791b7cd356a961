"""Masses on strings over fixed, movable and stepped pulleys."""

from typing import Literal

from sim2reason.scenes.authoring import (
    WHEEL_RADIUS,
    Chain,
    End,
    Entity,
    Frame,
    FreeLength,
    Pass,
    Word,
    X,
    Y,
    Z,
    axial_inertia,
    either,
    entity,
    scale,
)
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.simple_machines import FixedPulley, MovablePulley, SteppedPulley
from sim2reason.scenes.connections.string import String
from sim2reason.scenes.dsl.connection import InternalConnection
from sim2reason.scenes.entities.string_ends import Hanging, OnPlane, OnWedge

UPRIGHT_ON_Y = (X, scale(-1.0, Z), Y)  # figures symmetric about the axle, which points away from the reader


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


@entity
class MassWithFixedPulley(Entity):
    """A fixed pulley; a mass system on one side of its string, the other side open."""

    schematic = True

    system: Hanging | OnPlane | OnWedge
    pulley: FixedPulley

    over = Pass(sites=("pulley.left", "pulley.right"), passes="passes over {pulley}")
    tail = Chain(stops=("system.tail", "over"), required=True)

    def build(self, room: Frame) -> None:
        """Build the pulley with the mass system's string at the left of the rim and an open port at the right."""
        room.pulley("pulley", at=(WHEEL_RADIUS, 0.0, 0.0), mass=self.pulley.mass)
        self.system.build(room.part("system"))


SURFACE_OFFSET = 1.0  # m; distance of a plane or wedge from the pulley, for drawings only


@entity
class MassWithMovablePulley(Entity):
    """A movable pulley, held from above by its axle; its string carries a mass system on either side."""

    schematic = True

    left: Hanging | OnPlane | OnWedge
    right: Hanging | OnPlane | OnWedge
    pulley: MovablePulley

    over = Pass(sites=("pulley.left", "pulley.right"), passes="passes over {pulley}")
    rope = InternalConnection(String, ("left.tail", "over", "right.tail"))
    top = End(
        sites=("axle",),
        tied="the axle of {pulley}",
        leaves="runs straight up",
        arrives="runs straight down to the axle of {pulley}",
        required=True,
    )

    def build(self, room: Frame) -> None:
        """Build the pulley with a vertical sliding coordinate, its rims facing down and its axle facing up."""
        carrier = room.body("carrier").slide(Z)
        carrier.site("axle", faces=Z)
        carrier.pulley("pulley", mass=self.pulley.mass, faces=scale(-1.0, Z))
        for name, system, side in (("left", self.left, 1.0), ("right", self.right, -1.0)):
            hangs = isinstance(system, Hanging)
            at = scale(-side * (WHEEL_RADIUS if hangs else SURFACE_OFFSET), X)
            system.build(room.part(name, at=at if hangs else (at[0], 0.0, -1.0)), side)


@entity
class MassWithReverseMovablePulley(Entity):
    """A string goes under the pulley, and both its sides pull it up; a load may hang from the axle."""

    schematic = True

    pulley: MovablePulley
    load: Block | None = None
    length: FreeLength = 1.0

    says = (
        either(
            "{load} hangs by a light string from the axle of {pulley}.",
            "{load} is tied by a light string to the axle of {pulley}.",
            "a light string from the axle of {pulley} carries {load}.",
        ),
    )
    under = Pass(
        sites=("pulley.left", "pulley.right"),
        passes="goes straight down, under {pulley} and straight up again",
        required=True,
    )
    bottom = End(
        sites=("axle",),
        tied="the axle of {pulley}",
        leaves="runs straight down",
        arrives="runs straight up to the axle of {pulley}",
        unless="load",
    )

    def build(self, room: Frame) -> None:
        """Build the pulley with a vertical sliding coordinate, its rims facing up and its axle facing down."""
        carrier = room.body("carrier").slide(Z)
        carrier.site("axle", faces=scale(-1.0, Z))
        carrier.pulley("pulley", mass=self.pulley.mass, faces=Z)
        if self.load is not None:
            load = room.body("load", self.load.mass, at=(0.0, 0.0, -self.length)).slide(Z)
            load.site("hook", faces=Z)
            room.string("cord", room.address("axle"), room.address("hook"))


@entity
class ThreePointMovablePulley(Entity):
    """The hook is on the side that the string does not pull to: below where both its parts go up, and the reverse."""

    schematic = True

    pulley: MovablePulley
    hook: Literal["below", "above"] = "below"

    words = {
        "way": Word(
            "hook",
            {
                "below": "runs straight down, under {pulley} and straight up again",
                "above": "runs straight up, over {pulley} and straight down again",
            },
        ),
        "away": Word("hook", {"below": "runs straight down", "above": "runs straight up"}),
        "towards": Word("hook", {"below": "runs straight up", "above": "runs straight down"}),
    }
    strand = Pass(sites=("pulley.left", "pulley.right"), passes="{way}", required=True)
    eye = End(
        sites=("axle",),
        tied="the hook {hook} {pulley}",
        leaves="{away}",
        arrives="{towards} to the hook {hook} {pulley}",
        required=True,
    )

    def build(self, room: Frame) -> None:
        """Build the pulley with a vertical sliding coordinate, its rims facing away from its hook."""
        away = scale(-1.0 if self.hook == "below" else 1.0, Z)
        carrier = room.body("carrier").slide(Z)
        carrier.site("axle", faces=away)
        carrier.pulley("pulley", mass=self.pulley.mass, faces=scale(-1.0, away))

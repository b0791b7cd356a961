"""Blocks on springs on planes and wedges."""

from collections.abc import Mapping
from math import cos, radians, sin
from typing import Any, Literal

import numpy as np

from sim2reason.scenes.authoring import End, Entity, Frame, Word, X, Z, either, entity, scale
from sim2reason.scenes.bodies.planes import Plane, Wedge
from sim2reason.scenes.bodies.sliders import Block
from sim2reason.scenes.bodies.spring import Spring
from sim2reason.scenes.entities.parts.friction import two_coefficients
from sim2reason.scenes.entities.parts.mass_systems import FREE_WEDGE, FRICTION_ON_PLANE
from sim2reason.scenes.entities.parts.springs import START_LENGTH_SENTENCE, StartLength, fitted_spring


@entity
class AnchoredSpring(Entity):
    """The spring holds the block to a wall, the ceiling or the floor; a string leads on in the spring's line."""

    spring: Spring
    block: Block
    support: Literal["wall", "ceiling", "floor"] = "wall"
    start: StartLength

    words = {
        "held": Word(
            "support",
            {
                "wall": "on a smooth level floor {block} is attached to a wall on its left by {spring}",
                "ceiling": "{block} hangs from the ceiling by {spring}",
                "floor": "{spring} holds {block} upright above the floor",
            },
        ),
        "ties": Word(
            "support",
            {
                "wall": "{spring} joins {block}, which lies on a smooth level floor, to a wall on its left",
                "ceiling": "{spring} leads from the ceiling straight down to {block}",
                "floor": "{spring} leads from the floor straight up to {block}",
            },
        ),
        "lies": Word(
            "support",
            {
                "wall": "{block} lies on a smooth level floor, tied by {spring} to a wall on its left",
                "ceiling": "from the ceiling {block} hangs on {spring}",
                "floor": "above the floor {block} rests on {spring}, which stands there upright and holds it",
            },
        ),
        "from": Word(
            "support",
            {"wall": "runs horizontally to the right", "ceiling": "runs straight down", "floor": "runs straight up"},
        ),
        "to": Word(
            "support",
            {"wall": "runs horizontally from the right", "ceiling": "runs straight up", "floor": "runs straight down"},
        ),
    }
    says = (
        either("{held}.", "{ties}.", "{lies}."),
        START_LENGTH_SENTENCE,
    )
    end = End(sites=("hook",), tied="{block}", leaves="{from}", arrives="{to} to {block}")

    @classmethod
    def fitted(cls, drawn: Mapping[str, Any], rng: np.random.Generator) -> Mapping[str, object]:
        """Return a spring that is stiff enough for the block, near its natural length."""
        return fitted_spring(drawn, rng)

    def build(self, room: Frame) -> None:
        """Build the support at the origin, and the block at the initial length of the spring from it."""
        way = {"wall": X, "ceiling": scale(-1.0, Z), "floor": Z}[self.support]
        room.site("anchor")
        block = room.body("block", self.block.mass, at=scale(self.start, way))
        block.site("clasp").site("hook", faces=way)
        if self.support == "wall":
            block.rest(X, Z)
        else:
            block.slide(Z)
        ends = (room.address("anchor"), room.address("clasp"))
        room.spring("spring", *ends, stiffness=self.spring.stiffness, length=self.spring.length)


@entity
class SpringMassIncline(Entity):
    """The spring lies along the slope; on a level plane it leads to a wall on the left."""

    plane: Plane
    block: Block
    spring: Spring
    start: StartLength

    words = {"stop": Word("plane.angle", {0.0: "a wall on its left"}, "a stop at the foot of the slope")}
    says = (
        either(
            "{block} lies on {plane}.",
            "on {plane} lies {block}.",
            "{plane} carries {block}.",
        ),
        either(
            "{spring} joins {block} to {stop}.",
            "{block} is joined to {stop} by {spring}.",
            "{spring} leads from {block} to {stop}.",
        ),
        FRICTION_ON_PLANE,
        START_LENGTH_SENTENCE,
    )
    right = End(sites=("hook",), tied="{block}", leaves="runs {plane.uphill}", arrives="reaches {block} {plane.above}")

    @classmethod
    def fitted(cls, drawn: Mapping[str, Any], rng: np.random.Generator) -> Mapping[str, object]:
        """Return a spring that is stiff enough for the block, near its natural length."""
        return fitted_spring(drawn, rng)

    def build(self, room: Frame) -> None:
        """Build the stop at the origin, and the block up the slope from it."""
        uphill, normal = self.plane.directions()
        room.site("stop")
        block = room.body("block", self.block.mass, at=scale(self.start, uphill))
        block.rest(uphill, normal, self.plane.friction, static=self.plane.static_friction)
        block.site("clasp").site("hook", faces=uphill)
        ends = (room.address("stop"), room.address("clasp"))
        room.spring("spring", *ends, stiffness=self.spring.stiffness, length=self.spring.length)


@entity
class SpringOnWedge(Entity):
    """A block on the face of a free wedge, and a spring along the face from the block down to the foot of the wedge."""

    wedge: Wedge
    block: Block
    spring: Spring
    start: StartLength

    says = (
        FREE_WEDGE,
        either(
            "{block} lies on its face.",
            "on its face lies {block}.",
            "its face carries {block}.",
        ),
        either(
            "{spring} along the face joins {block} to a stop at the foot of {wedge}.",
            "{block} is joined to a stop at the foot of {wedge} by {spring} along the face.",
            "{spring} runs along the face from {block} to a stop at the foot of {wedge}.",
        ),
        either(
            "the coefficient of friction (static and kinetic) on this face is {wedge.friction}.",
            "on this face the coefficient of friction, static and kinetic, is {wedge.friction}.",
            "static and kinetic friction on this face have the same coefficient, {wedge.friction}.",
        ).if_given("wedge.static_friction", *two_coefficients("on this face", "wedge")),
        START_LENGTH_SENTENCE,
    )

    @classmethod
    def fitted(cls, drawn: Mapping[str, Any], rng: np.random.Generator) -> Mapping[str, object]:
        """Return a spring stiff enough for the weight of the block, and a start length near its natural length."""
        return fitted_spring(drawn, rng)

    def build(self, room: Frame) -> None:
        """Build the wedge, with its foot at the origin, and the block on its face, which rises to the right."""
        angle = radians(self.wedge.angle)
        uphill, normal = (cos(angle), 0.0, sin(angle)), (-sin(angle), 0.0, cos(angle))
        wedge = room.body("wedge", self.wedge.mass).rest(along=X, normal=Z).site("stop")
        block = wedge.body("block", self.block.mass, at=scale(self.start, uphill))
        block.rest(uphill, normal, self.wedge.friction, static=self.wedge.static_friction).site("clasp")
        ends = (room.address("stop"), room.address("clasp"))
        room.spring("spring", *ends, stiffness=self.spring.stiffness, length=self.spring.length)

"""A block on a plane, tied by a spring to a stop below it, with a string that leads up the slope."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from sim2reason.authoring import End, Entity, Frame, Word, either, entity, scale
from sim2reason.bodies.block import Block
from sim2reason.bodies.plane import Plane
from sim2reason.bodies.spring import Spring
from sim2reason.entities.parts.mass_systems import FRICTION_ON_PLANE
from sim2reason.entities.parts.stretched import AT_FIRST, StartLength, fitted_spring


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
        AT_FIRST,
    )
    right = End(sites=("hook",), tied="{block}", leaves="runs {plane.uphill}", arrives="reaches {block} {plane.above}")

    @classmethod
    def fitted(cls, drawn: Mapping[str, Any], rng: np.random.Generator) -> Mapping[str, object]:
        """A spring firm enough for the block, about as long as it is by itself."""
        return fitted_spring(drawn, rng)

    def build(self, room: Frame) -> None:
        """The stop at the origin, and the block up the slope from it."""
        uphill, normal = self.plane.directions()
        room.site("stop")
        block = room.body("block", self.block.mass, at=scale(self.start, uphill))
        block.rest(uphill, normal, self.plane.friction, static=self.plane.static_friction)
        block.site("clasp").site("hook", faces=uphill)
        ends = (room.address("stop"), room.address("clasp"))
        room.spring("spring", *ends, stiffness=self.spring.stiffness, length=self.spring.length)

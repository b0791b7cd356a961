"""A block on a wedge that is free to slide, tied by a spring to a stop on the wedge."""

from collections.abc import Mapping
from math import cos, radians, sin
from typing import Any

import numpy as np

from sim2reason.authoring import Entity, Frame, X, Z, either, entity, scale
from sim2reason.bodies.block import Block
from sim2reason.bodies.spring import Spring
from sim2reason.bodies.wedge import Wedge
from sim2reason.entities.parts.friction import two_coefficients
from sim2reason.entities.parts.mass_systems import FREE_WEDGE
from sim2reason.entities.parts.stretched import AT_FIRST, StartLength, fitted_spring


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
        AT_FIRST,
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

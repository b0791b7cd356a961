"""A block on a spring that is fixed at its other end, and takes a string."""

from collections.abc import Mapping
from typing import Any, Literal

import numpy as np

from sim2reason.authoring import End, Entity, Frame, Word, X, Z, either, entity, scale
from sim2reason.bodies.block import Block
from sim2reason.bodies.spring import Spring
from sim2reason.entities.parts.stretched import AT_FIRST, StartLength, fitted_spring


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
        AT_FIRST,
    )
    end = End(sites=("hook",), tied="{block}", leaves="{from}", arrives="{to} to {block}")

    @classmethod
    def fitted(cls, drawn: Mapping[str, Any], rng: np.random.Generator) -> Mapping[str, object]:
        """A spring firm enough for the block, about as long as it is by itself."""
        return fitted_spring(drawn, rng)

    def build(self, room: Frame) -> None:
        """The support at the origin, and the block as far from it as the spring is long."""
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

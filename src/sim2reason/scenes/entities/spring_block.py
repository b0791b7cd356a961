"""A block on a smooth table, held by springs at angles."""

from collections.abc import Mapping
from itertools import combinations
from math import dist, hypot, pi, sqrt
from typing import Annotated, Any, Self

import numpy as np
from annotated_types import Ge, Le, Len
from pydantic import model_validator

from sim2reason.scenes.authoring import (
    Chance,
    Count,
    Damping,
    Entity,
    Frame,
    Measure,
    Part,
    Range,
    X,
    Y,
    each,
    either,
    entity,
    placing,
    starting,
)
from sim2reason.scenes.bodies.sliders import Block
from sim2reason.scenes.bodies.spring import NailedSpring
from sim2reason.scenes.dsl.model import replace_validated, round_as_stated
from sim2reason.scenes.entities.parts.springs import DASHPOTS

Across = Annotated[float, Ge(-1e3), Le(1e3), Measure("position", "m", "x", decimals=2), Range(-0.3, 0.3)]
Away = Annotated[float, Ge(-1e3), Le(1e3), Measure("position", "m", "y", decimals=2), Range(-0.3, 0.3)]
Rate = Annotated[float, Ge(-1e3), Le(1e3), Measure("velocity", "m/s", "v", decimals=2), Range(-2.0, 2.0)]
MIN_NAIL_DISTANCE = 0.05  # m from the block to a nail, and between nails
LONG = Range(0.8, 1.25)  # initial length of a drawn spring, in natural lengths
SHORTEST = 0.1  # m, of a drawn spring
SWING = 0.3  # fraction of the shortest natural length: amplitude of a launch
PERIODS = 2.0  # periods of an oscillation on all springs in parallel in the default duration


class Launch(Part):
    """A velocity at the start."""

    x: Rate
    y: Rate


@entity
class SpringBlock(Entity):
    """A small block on a table, and springs from it to nails."""

    block: Block
    springs: Annotated[tuple[NailedSpring, ...], Len(1, 6), Count(1, 4)]
    damping: Annotated[Damping | None, Chance(0.2)] = None
    x: Across
    y: Away
    launch: Annotated[Launch | None, Chance(0.5)] = None

    says = (
        either(
            "{block} lies on a smooth horizontal table, on which x points to the right and y away from you.",
            "on a smooth horizontal table, where x points to the right and y away from you, lies {block}.",
            "a smooth horizontal table carries {block}; there x points to the right and y away from you.",
        ),
        each(
            "springs",
            "{springs.*} joins {block} to a nail at ({springs.*.x}, {springs.*.y}).",
            "{springs.*} runs from {block} to a fixed point at ({springs.*.x}, {springs.*.y}).",
            "{springs.*} ties {block} to a fixed point at ({springs.*.x}, {springs.*.y}).",
            table=(
                "light {noun}s run from {block} to fixed points; each {noun}'s {columns} are listed below.",
                "{block} is tied to fixed points by light {noun}s, and the list below gives the {columns} of each.",
                "several light {noun}s, each fixed at its far end, are attached to {block}; their {columns} are listed below.",
                "light {noun}s hold {block}; each has the {columns} in its row below.",
            ),
        ),
        DASHPOTS,
        placing(
            "initially {block} is at the point ({x}, {y}).",
            "the starting point of {block} is ({x}, {y}).",
            "at the start {block} is at ({x}, {y}).",
        ),
        starting(
            "at t = 0 {block} is launched with the velocity ({launch.x}, {launch.y}).",
            "{block} starts off at t = 0 with the velocity ({launch.x}, {launch.y}).",
            "{block} is given the velocity ({launch.x}, {launch.y}) at t = 0.",
            topic="start",
        ),
    )

    @model_validator(mode="after")
    def _fits(self) -> Self:
        ends = [(spring.x, spring.y) for spring in self.springs]
        for index, end in enumerate(ends):
            if dist(end, (self.x, self.y)) < MIN_NAIL_DISTANCE:
                raise ValueError(f"springs.{index}: its fixed end is where the block starts; move one of them")
        for (i, one), (j, other) in combinations(enumerate(ends), 2):
            if dist(one, other) < MIN_NAIL_DISTANCE:
                raise ValueError(f"springs.{i} and springs.{j} have one fixed end; make one spring of them")
        return self

    @classmethod
    def fitted(cls, drawn: Mapping[str, Any], rng: np.random.Generator) -> Mapping[str, object]:
        """Return springs near their natural lengths, and a launch that stretches them only moderately."""
        block, x, y = drawn["block"], drawn["x"], drawn["y"]
        springs = list[NailedSpring]()
        for spring in drawn["springs"]:
            natural = dist((spring.x, spring.y), (x, y)) / rng.uniform(LONG.low, LONG.high)
            springs.append(
                replace_validated(spring, length=max(round_as_stated(NailedSpring, "length", natural), SHORTEST))
            )
        launch = drawn.get("launch")
        if not isinstance(launch, Launch):
            return {"springs": tuple(springs)}
        frequency = sqrt(sum(spring.stiffness for spring in springs) / block.mass)
        fastest = SWING * min(spring.length for spring in springs) * frequency
        share = min(1.0, fastest / max(hypot(launch.x, launch.y), SHORTEST))
        slower = {name: round_as_stated(Launch, name, share * getattr(launch, name)) for name in ("x", "y")}
        return {"springs": tuple(springs), "launch": replace_validated(launch, **slower)}

    def horizon(self, gravity: float) -> float:
        """Return some periods of the block as if all springs were along one line, s."""
        del gravity
        return PERIODS * 2.0 * pi * sqrt(self.block.mass / sum(spring.stiffness for spring in self.springs))

    def build(self, room: Frame) -> None:
        """Build the block with two sliding coordinates on the table, and a spring to each nail."""
        launch = self.launch or Launch(x=0.0, y=0.0)
        block = room.body("block", self.block.mass, at=(self.x, self.y, 0.0))
        block.slide(X, launch.x, name="x", stated=("x", self.x))
        block.slide(Y, launch.y, name="y", stated=("y", self.y)).site("hook")
        for index, spring in enumerate(self.springs):
            room.site(f"nail{index}", at=(spring.x, spring.y, 0.0))
            room.spring(
                f"springs.{index}",
                room.address(f"nail{index}"),
                room.address("hook"),
                stiffness=spring.stiffness,
                length=spring.length,
                damping=self.damping or 0.0,
            )

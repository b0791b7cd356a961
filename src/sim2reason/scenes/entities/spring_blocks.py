"""Blocks on springs: on a smooth table, on planes and on wedges."""

from collections.abc import Mapping
from itertools import combinations
from math import cos, dist, hypot, pi, radians, sin, sqrt
from typing import Annotated, Any, Literal, Self

import numpy as np
from annotated_types import Ge, Le, Len
from pydantic import model_validator

from sim2reason.scenes.authoring import (
    Chance,
    Count,
    Damping,
    End,
    Entity,
    Frame,
    Measure,
    Part,
    Range,
    Word,
    X,
    Y,
    Z,
    each,
    either,
    entity,
    placing,
    scale,
    starting,
)
from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.bodies.oscillators import NailedSpring, Spring
from sim2reason.scenes.bodies.simple_machines import Plane, Wedge
from sim2reason.scenes.dsl.model import replace_validated, round_as_stated
from sim2reason.scenes.entities.spring_chains import DASHPOTS, START_LENGTH_SENTENCE, StartLength, fitted_spring
from sim2reason.scenes.entities.string_ends import FREE_WEDGE, FRICTION_ON_PLANE, two_coefficients

Across = Annotated[float, Ge(-1e3), Le(1e3), Measure("position", "m", "x", decimals=2), Range(-0.3, 0.3)]
Away = Annotated[float, Ge(-1e3), Le(1e3), Measure("position", "m", "y", decimals=2), Range(-0.3, 0.3)]
Rate = Annotated[float, Ge(-1e3), Le(1e3), Measure("velocity", "m/s", "v", decimals=2), Range(-2.0, 2.0)]
MIN_NAIL_DISTANCE = 0.05  # m from the block to a nail, and between nails
START_LENGTH_RATIO = Range(0.8, 1.25)  # initial length of a drawn spring, in natural lengths
MIN_NATURAL_LENGTH = 0.1  # m, of a drawn spring
LAUNCH_AMPLITUDE = 0.3  # fraction of the shortest natural length: amplitude of a launch
HORIZON_PERIODS = 2.0  # periods of an oscillation on all springs in parallel in the default duration


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
            natural = dist((spring.x, spring.y), (x, y)) / rng.uniform(START_LENGTH_RATIO.low, START_LENGTH_RATIO.high)
            springs.append(
                replace_validated(
                    spring, length=max(round_as_stated(NailedSpring, "length", natural), MIN_NATURAL_LENGTH)
                )
            )
        launch = drawn.get("launch")
        if not isinstance(launch, Launch):
            return {"springs": tuple(springs)}
        frequency = sqrt(sum(spring.stiffness for spring in springs) / block.mass)
        fastest = LAUNCH_AMPLITUDE * min(spring.length for spring in springs) * frequency
        share = min(1.0, fastest / max(hypot(launch.x, launch.y), MIN_NATURAL_LENGTH))
        slower = {name: round_as_stated(Launch, name, share * getattr(launch, name)) for name in ("x", "y")}
        return {"springs": tuple(springs), "launch": replace_validated(launch, **slower)}

    def horizon(self, gravity: float) -> float:
        """Return some periods of the block as if all springs were along one line, s."""
        del gravity
        return HORIZON_PERIODS * 2.0 * pi * sqrt(self.block.mass / sum(spring.stiffness for spring in self.springs))

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
        direction = {"wall": X, "ceiling": scale(-1.0, Z), "floor": Z}[self.support]
        room.site("anchor")
        block = room.body("block", self.block.mass, at=scale(self.start, direction))
        block.site("clasp").site("hook", faces=direction)
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

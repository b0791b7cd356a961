"""Pucks that slide and collide on a smooth table, level or tilted."""

from collections.abc import Mapping
from itertools import combinations
from math import cos, hypot, radians, sin
from typing import Annotated, Any, Self

import numpy as np
from annotated_types import Ge, Le, Len
from pydantic import model_validator

from sim2reason.scenes.authoring import (
    LEAST,
    Count,
    Entity,
    Frame,
    Measure,
    Member,
    Part,
    Range,
    Restitution,
    Usually,
    Word,
    X,
    assuming,
    each,
    either,
    entity,
    scale,
)
from sim2reason.scenes.bodies.blocks import Puck, Table
from sim2reason.scenes.dsl.model import replace_validated, round_as_stated
from sim2reason.scenes.dsl.template import Wordings, rarely

Pucks = Annotated[tuple[Puck, ...], Len(2, 6), Count(2, 4)]
Radius = Annotated[float, LEAST, Le(10), Measure("radius", "m", "R", decimals=2), Range(0.1, 0.3)]
WallX = Annotated[float, Ge(-1e3), Le(1e3), Measure("position of a wall", "m", "x_W", decimals=2)]
WallY = Annotated[float, Ge(-1e3), Le(1e3), Measure("position of a wall", "m", "y_W", decimals=2)]
Index = Annotated[int, Ge(0), Le(5), Member("pucks")]


CONTACT_DISTANCE = 1e-9  # m; smaller distances are round-off
MIN_APPROACH_SPEED = 0.5  # m/s, least speed of a puck towards another
PASSES, SHORTEST, MAX_DURATION = (
    4.0,
    2.0,
    20.0,
)  # passes of the fastest puck over the table in the default duration, and s


WALLS = {("x", -1.0): "left", ("x", 1.0): "right", ("y", -1.0): "bottom", ("y", 1.0): "top"}
"""The fields of walls, by the axis perpendicular to them and the side of the table."""


class PairRestitution(Part):
    """A restitution of two pucks, by their indices, other than that of all the others."""

    first: Index
    second: Index
    restitution: Restitution


def _wall(name: str, axis: str) -> Wordings:
    """Return the sentence about a wall perpendicular to `axis`, at the position given by the field `name`."""
    return rarely(
        f"a smooth vertical wall bounds the table at {axis} = {{{name}}}; {{pucks:s}} bounce off it as off one another.",
        f"at {axis} = {{{name}}} the table ends at a smooth wall, off which {{pucks:s}} bounce as off one another.",
        f"the table ends at {axis} = {{{name}}}, at a smooth wall that {{pucks:s}} bounce off as off one another.",
    )


@entity
class TwoDCollisionPlane(Entity):
    """Equal discs on a table; hits are smooth, so only the velocity along the line of centres changes."""

    table: Table
    radius: Radius
    pucks: Pucks
    restitution: Annotated[Restitution, Range(0.3, 1.0)]
    pairs: Annotated[tuple[PairRestitution, ...], Len(0, 3), Count(0, 0)] = ()
    left: Annotated[WallX | None, Range(-3.0, -2.4), Usually(present=False)] = None
    right: Annotated[WallX | None, Range(2.4, 3.0), Usually(present=False)] = None
    bottom: Annotated[WallY | None, Range(-3.0, -2.4), Usually(present=False)] = None
    top: Annotated[WallY | None, Range(2.4, 3.0), Usually(present=False)] = None

    words = {
        "of_all": Word(
            "restitution",
            {
                1.0: "{pucks:/the {pucks:s} collide elastically/every {pairs?/other }collision is elastic}",
                0.0: "{pairs?the coefficient of restitution {pucks:/between the {pucks:s}/of every collision} is zero/for every other pair it is zero}",
            },
            "{pairs?the coefficient of restitution {pucks:/between the {pucks:s}/of every collision}/for every other pair it} is {restitution}",
        ),
        "of_any": Word(
            "restitution",
            {
                1.0: "{pucks:/the {pucks:s} rebound from each other elastically/all {pairs?/other }collisions are elastic}"
            },
            "the coefficient of restitution is {pucks:/{restitution}/{pairs?always/otherwise} {restitution}}",
        ),
        "of_two": Word(
            "restitution",
            {1.0: "they rebound elastically", 0.0: "the coefficient of restitution is zero"},
            "the coefficient of restitution is {restitution}",
        ),
    }
    says = (
        either(
            "{pucks:#} smooth {pucks:s} of radius {radius} slide on {table}; {table.axes}.",
            "on {table} there are {pucks:#} smooth {pucks:s}, each of radius {radius}; {table.axes}.",
            "{table} carries {pucks:#} smooth {pucks:s} of radius {radius}; {table.axes}.",
        ),
        each(
            "pucks",
            "{pucks.*} is at ({pucks.*.x}, {pucks.*.y}) at t = 0, {pucks.*.moving}.",
            "at t = 0 {pucks.*} is at ({pucks.*.x}, {pucks.*.y}), {pucks.*.moving}.",
            "the position of {pucks.*} at t = 0 is ({pucks.*.x}, {pucks.*.y}); it is then {pucks.*.motion}.",
            table=(
                "each {noun}'s {columns} at t = 0 are listed below.",
                "the {columns} of each {noun} at t = 0 are the following.",
                "at t = 0 each {noun} has the {columns} in its row below.",
                "the list below gives each {noun}'s {columns} at t = 0.",
                "each {noun}'s row below gives its {columns} at t = 0.",
                "listed below are the {columns} of each {noun} at t = 0.",
            ),
        ),
        *(_wall(name, axis) for (axis, _), name in WALLS.items()),
        each(
            "pairs",
            "between {pairs.*.first>pucks} and {pairs.*.second>pucks} the coefficient of restitution is {pairs.*.restitution}.",
            "when {pairs.*.first>pucks} and {pairs.*.second>pucks} meet, the coefficient of restitution is {pairs.*.restitution}.",
            "the coefficient of restitution of {pairs.*.first>pucks} with {pairs.*.second>pucks} is {pairs.*.restitution}.",
        ),
        assuming(
            "{of_all}.",
            "{of_any}.",
            "{pairs?{pucks:/when they meet/whenever two {pucks:s} meet}/when any other two meet}, {of_two}.",
        ),
    )

    @model_validator(mode="after")
    def _fits(self) -> Self:
        for index, pair in enumerate(self.pairs):
            if not pair.first < pair.second:
                raise ValueError(f"pairs.{index}: name two pucks by index, the lower one first")
            if pair.restitution == self.restitution:
                raise ValueError(f"pairs.{index}: it has the restitution of all the others; leave it out")
        if len({(pair.first, pair.second) for pair in self.pairs}) < len(self.pairs):
            raise ValueError("pairs: two entries name the same pair")
        for (i, a), (j, b) in combinations(enumerate(self.pucks), 2):
            if hypot(a.x - b.x, a.y - b.y) < 2.0 * self.radius - CONTACT_DISTANCE:
                raise ValueError(f"pucks.{i} and pucks.{j} overlap; move them apart by two radii or more")
        for axis, side, position in self._walls:
            if any(
                side * (position - (puck.x if axis == "x" else puck.y)) < self.radius - CONTACT_DISTANCE
                for puck in self.pucks
            ):
                name = WALLS[axis, side]
                raise ValueError(f"{name}: a puck is in the wall or beyond it; move it a radius or more into the table")
        return self

    @classmethod
    def fitted(cls, drawn: Mapping[str, Any], rng: np.random.Generator) -> Mapping[str, object]:
        """Return velocities with which the second puck moves straight towards the first, so that the two collide."""
        del rng
        first, second, *rest = drawn["pucks"] if len(drawn["pucks"]) > 1 else (*drawn["pucks"], None)
        if second is None:
            return {}
        displacement = first.x - second.x, first.y - second.y
        share = max(MIN_APPROACH_SPEED, hypot(second.vx, second.vy)) / max(hypot(*displacement), MIN_APPROACH_SPEED)
        velocity = (
            round_as_stated(Puck, "vx", own + share * part)
            for own, part in zip((first.vx, first.vy), displacement, strict=True)
        )
        aimed = replace_validated(second, **dict(zip(("vx", "vy"), velocity, strict=True)))
        return {"pucks": (first, aimed, *rest)}

    def horizon(self, gravity: float) -> float:
        """Return the time, s, in which the fastest puck passes some times over the distance between two pucks."""
        del gravity
        fastest = max(hypot(puck.vx, puck.vy) for puck in self.pucks)
        widest = max(hypot(a.x - b.x, a.y - b.y) for a, b in combinations(self.pucks, 2))
        return min(max(SHORTEST, PASSES * widest / fastest), MAX_DURATION) if fastest else MAX_DURATION

    @property
    def _walls(self) -> list[tuple[str, float, float]]:
        """Return the walls, each with its axis, its side of the table (−1 or 1) and its position, m."""
        walls = (
            ("x", -1.0, self.left),
            ("x", 1.0, self.right),
            ("y", -1.0, self.bottom),
            ("y", 1.0, self.top),
        )
        return [(axis, side, position) for axis, side, position in walls if position is not None]

    def build(self, room: Frame) -> None:
        """Build pucks with two sliding coordinates each on the table, y up the slope; every two pucks may collide."""
        tilt = radians(self.table.angle)
        upslope = (0.0, cos(tilt), sin(tilt))
        special = {(pair.first, pair.second): pair.restitution for pair in self.pairs}
        frames: list[Frame] = []
        for index, puck in enumerate(self.pucks):
            at = (puck.x, puck.y * upslope[1], puck.y * upslope[2])
            frame = room.body(f"pucks.{index}", puck.mass, at=at)
            frame.slide(X, puck.vx, name="x", stated=("x", puck.x))
            frames.append(frame.slide(upslope, puck.vy, name="y", stated=("y", puck.y)))
        for axis, side, position in self._walls:
            inward = scale(-side, X if axis == "x" else upslope)
            for frame in frames:
                room.bump(room, frame, inward, self.radius - side * position, self.restitution)
        for i, j in combinations(range(len(frames)), 2):
            restitution = special.get((i, j), self.restitution)
            room.collide(frames[i], frames[j], 2.0 * self.radius, restitution)

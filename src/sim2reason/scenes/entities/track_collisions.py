"""Blocks and balls that collide on a straight track, with walls, spring buffers and springs between them."""

from collections.abc import Container, Mapping, Sequence
from itertools import pairwise
from math import ceil, inf
from typing import Annotated, Any, Self, TypeVar

import numpy as np
from annotated_types import Ge, Le, Len
from pydantic import model_validator

from sim2reason.scenes.authoring import (
    Chance,
    Count,
    Entity,
    Frame,
    Measure,
    Member,
    Part,
    Range,
    Restitution,
    Word,
    assuming,
    each,
    either,
    entity,
    scale,
)
from sim2reason.scenes.bodies.blocks import Glider, SlidingBall
from sim2reason.scenes.bodies.oscillators import Bumper, Coil
from sim2reason.scenes.bodies.simple_machines import Track
from sim2reason.scenes.dsl.model import field_types, replace_validated

Index = Annotated[int, Ge(0), Le(5), Member("gliders")]
Wall = Annotated[float, Ge(-1e3), Le(1e3), Measure("position of a wall", "m", "X", decimals=2)]
ROOM, SPRUNG = 0.3, 0.9  # m, least distance of drawn neighbours, and of those joined by a spring


class Pair(Part):
    """Two neighbours, by their indices, the left one first."""

    first: Index
    second: Index

    @model_validator(mode="after")
    def _neighbours(self) -> Self:
        if self.second != self.first + 1:
            raise ValueError("first, second: name two neighbours by index, the left one first")
        return self


class Joined(Pair):
    """A spring that joins two neighbours, relaxed at the start."""

    spring: Coil


class Buffered(Pair):
    """A light spring that is fixed to the first and that the second runs into; to which of them does not matter."""

    buffer: Bumper


def same_kind(gliders: Sequence[Glider]) -> tuple[Glider, ...]:
    """Return the gliders, all converted to the class of the first."""
    kind = type(gliders[0])
    return tuple(kind(mass=glider.mass, x=glider.x, v=glider.v) for glider in gliders)


Sprung = TypeVar("Sprung", Joined, Buffered)
HARDEST = {Buffered: 2000.0, Joined: 500.0}  # N/m, of drawn springs; joined bodies keep oscillating

MAX_COMPRESSION = 0.45  # fraction of its length: largest compression of a spring between two bodies


def fit_neighbours(
    gliders: Sequence[Glider], joined: Sequence[Joined], buffers: Sequence[Buffered]
) -> dict[str, object]:
    """Return the drawn gliders from left to right with sufficient distances, and stiff springs."""
    ordered = _apart(sorted(gliders, key=lambda glider: glider.x), {pair.first for pair in joined})
    return {"gliders": ordered, "joined": _firm(joined, ordered), "buffers": _firm(buffers, ordered)}


def _apart(gliders: Sequence[Glider], joined: Container[int]) -> tuple[Glider, ...]:
    """Return gliders with sufficient distances, shifted to the right and back into the range of positions."""
    drawn = field_types(Glider)["x"].drawn
    last = drawn.high if drawn is not None else inf
    places = [glider.x for glider in gliders]
    rooms = [SPRUNG if index in joined else ROOM for index in range(len(places) - 1)]
    for index, room in enumerate(rooms):
        places[index + 1] = max(places[index + 1], places[index] + room)
    for index in reversed(range(len(places))):
        places[index] = min(places[index], last - sum(rooms[index:]))
    return tuple(replace_validated(glider, x=round(x, 2)) for glider, x in zip(gliders, places, strict=True))


def _firm(pairs: Sequence[Sprung], gliders: Sequence[Glider]) -> tuple[Sprung, ...]:
    """Return the pairs whose springs are stiff enough, or can be made so, to avoid full compression.

    With a reduced mass µ and a relative speed of at most twice the largest, ½µ(2v)² = ½kd² where d is 0.45 of the room.
    """
    fastest, firm_pairs = 2.0 * max(abs(glider.v) for glider in gliders), list[Sprung]()
    for pair in pairs:
        one, other = gliders[pair.first], gliders[pair.second]
        room = pair.buffer.length if isinstance(pair, Buffered) else other.x - one.x
        spring = pair.buffer if isinstance(pair, Buffered) else pair.spring
        min_stiffness = one.mass * other.mass / (one.mass + other.mass) * (fastest / (MAX_COMPRESSION * room)) ** 2
        if min_stiffness <= HARDEST[type(pair)]:
            stiff = replace_validated(spring, stiffness=max(spring.stiffness, 10.0 * ceil(0.1 * min_stiffness)))
            firm_pairs.append(replace_validated(pair, **{"buffer" if isinstance(pair, Buffered) else "spring": stiff}))
    return tuple(firm_pairs)


class OwnRestitution(Pair):
    """A restitution of two neighbours other than that of all the others."""

    restitution: Restitution


WALLS = (
    either(
        "{track.left}, at x = {left}, stands a fixed wall.",
        "a fixed wall stands {track.left}, at x = {left}.",
        "the track ends {track.left} at a fixed wall, at x = {left}.",
        "{track.left} the track ends at x = {left}, at a fixed wall.",
        "at x = {left} the track ends {track.left}, at a fixed wall.",
    ),
    either(
        "{track.right}, at x = {right}, stands a fixed wall.",
        "a fixed wall stands {track.right}, at x = {right}.",
        "the track ends {track.right} at a fixed wall, at x = {right}.",
        "{track.right} the track ends at x = {right}, at a fixed wall.",
        "at x = {right} the track ends {track.right}, at a fixed wall.",
    ),
)
"""The lines of an entity whose `track` may have walls, at `left` and `right`."""

JOINED = each(
    "joined",
    "{joined.*.spring}, initially relaxed, joins {joined.*.first>gliders} to {joined.*.second>gliders}.",
    "{joined.*.first>gliders} is joined to {joined.*.second>gliders} by {joined.*.spring}, which is initially relaxed.",
    "between {joined.*.first>gliders} and {joined.*.second>gliders} runs {joined.*.spring} that is fixed to both and initially relaxed.",
)
"""The lines of an entity whose `gliders` have `joined`: springs that are fixed to both."""

BUFFERS = each(
    "buffers",
    "{buffers.*.buffer}, initially relaxed, is fixed to {buffers.*.first>gliders} on the side of {buffers.*.second>gliders}.",
    "{buffers.*.first>gliders} has, on the side of {buffers.*.second>gliders}, {buffers.*.buffer}, which is initially relaxed.",
    "on its side towards {buffers.*.second>gliders} {buffers.*.first>gliders} carries {buffers.*.buffer}, initially relaxed.",
)
"""The lines of an entity whose `gliders` have `buffers`: springs that are fixed to one of them."""

PAIRS = each(
    "pairs",
    "between {pairs.*.first>gliders} and {pairs.*.second>gliders} the coefficient of restitution is {pairs.*.restitution}.",
    "when {pairs.*.first>gliders} and {pairs.*.second>gliders} meet, the coefficient of restitution is {pairs.*.restitution}.",
    "the coefficient of restitution of {pairs.*.first>gliders} with {pairs.*.second>gliders} is {pairs.*.restitution}.",
)
"""The lines of an entity whose `gliders` have `pairs`: a restitution of its own."""


SAME_KIND_PROBABILITY = 0.95  # probability that all drawn gliders are of one kind
MIN_DISTANCE = 0.01  # m, between neighbours at the start
MAX_DURATION = 10.0  # s
HORIZON_PASSES = 5.0  # passes of the fastest glider over all others in the default duration


@entity
class ComplexCollisionPlane(Entity):
    """One-dimensional collisions; with a restitution of zero those that meet stay together."""

    track: Track
    gliders: Annotated[tuple[Glider | SlidingBall, ...], Len(2, 6), Count(2, 4)]
    left: Annotated[Wall | None, Range(-2.8, -2.1), Chance(0.6)] = None
    right: Annotated[Wall | None, Range(2.1, 2.8), Chance(0.6)] = None
    joined: Annotated[tuple[Joined, ...], Len(0, 2), Count(0, 1)] = ()
    buffers: Annotated[tuple[Buffered, ...], Len(0, 2), Count(0, 1)] = ()
    restitution: Annotated[Restitution, Range(0.3, 1.0)]
    pairs: Annotated[tuple[OwnRestitution, ...], Len(0, 3), Count(0, 0)] = ()

    words = {
        "hits": Word(
            "restitution",
            {
                1.0: "every {pairs?/other }collision is elastic",
                0.0: "whatever meets{pairs?/ in any other collision} stays together",
            },
            "the coefficient of restitution of every {pairs?/other }collision is {restitution}",
        ),
        "they": Word(
            "restitution",
            {1.0: "conserve kinetic energy", 0.0: "are perfectly inelastic"},
            "have the coefficient of restitution {restitution}",
        ),
        "there": Word(
            "restitution",
            {1.0: "no kinetic energy is lost", 0.0: "whatever meets sticks together"},
            "the coefficient of restitution is {restitution}",
        ),
    }
    says = (
        either(
            "{gliders:#} small {gliders:s}, named in order of increasing x, move along {track}; x is measured along it, {track.ahead}.",
            "on {track} there are {gliders:#} small {gliders:s}, named in order of increasing x; along it x is measured {track.ahead}.",
            "{track}, along which x is measured {track.ahead}, carries {gliders:#} small {gliders:s}, named in order of increasing x.",
        ),
        each(
            "gliders",
            "{gliders.*} is {gliders.*.moving} at x = {gliders.*.x} at t = 0.",
            "at t = 0 {gliders.*} is {gliders.*.moving} at x = {gliders.*.x}.",
            "the position of {gliders.*} at t = 0 is x = {gliders.*.x}; it is then {gliders.*.moving}.",
            table=(
                "the table gives each {noun}'s {columns} at t = 0.",
                "the table shows the {columns} of each {noun} at t = 0.",
                "at t = 0 each {noun} has the {columns} that the table gives.",
                "for t = 0 the table lists the {columns} of each {noun}.",
            ),
        ),
        *WALLS,
        JOINED,
        BUFFERS,
        PAIRS,
        assuming(
            "{hits}.",
            "all {pairs?/other }collisions {they}.",
            "in every {pairs?/other }collision {there}.",
        ),
    )

    @model_validator(mode="after")
    def _fits(self) -> Self:
        if any(other - one < MIN_DISTANCE and other != one for one, other in pairwise(self._places)):
            raise ValueError(
                "gliders: give them, and the walls, in order from left to right, 1 cm or more apart, or touching"
            )
        taken = [pair.first for pair in (*self.joined, *self.buffers, *self.pairs)]
        if len(set(taken)) < len(taken):
            raise ValueError("joined, buffers, pairs: two entries name the same pair")
        if len(self.joined) + len(self.buffers) == len(self._places) - 1:
            raise ValueError("joined, buffers: a spring keeps every pair apart; nothing can collide")
        for index, buffered in enumerate(self.buffers):
            if buffered.buffer.length >= self.gliders[buffered.second].x - self.gliders[buffered.first].x:
                raise ValueError(f"buffers.{index}: it is longer than the gap at the start; shorten it")
        for index, pair in enumerate(self.pairs):
            if pair.restitution in (0.0, self.restitution):
                raise ValueError(f"pairs.{index}: give it a restitution above 0 and other than that of all the others")
        if len(taken) == len(self.gliders) - 1 and self.pairs and self.left is None and self.right is None:
            raise ValueError("pairs: each pair has a restitution of its own, so that the other one never counts")
        return self

    @classmethod
    def fitted(cls, drawn: Mapping[str, Any], rng: np.random.Generator) -> Mapping[str, object]:
        """Return drawn gliders in order from left to right, and stiff springs; on a slope, no wall at the top."""
        right = None if drawn["track"].angle else drawn.get("right")
        gliders = same_kind(drawn["gliders"]) if rng.random() < SAME_KIND_PROBABILITY else drawn["gliders"]
        return {**fit_neighbours(gliders, drawn.get("joined", ()), drawn.get("buffers", ())), "right": right}

    def horizon(self, gravity: float) -> float:
        """Return the time of some passes of the fastest glider over the whole distance, s."""
        del gravity
        fastest = max(abs(glider.v) for glider in self.gliders)
        return (
            min(MAX_DURATION, HORIZON_PASSES * (self._places[-1] - self._places[0]) / fastest)
            if fastest
            else MAX_DURATION
        )

    @property
    def _places(self) -> list[float]:
        """Return the positions of walls and gliders, from left to right, m."""
        return [
            position
            for position in (self.left, *(glider.x for glider in self.gliders), self.right)
            if position is not None
        ]

    def build(self, room: Frame) -> None:
        """Build gliders on the track; neighbours collide unless a spring is between them."""
        along, frames = self.track.along, list[Frame]()
        for index, glider in enumerate(self.gliders):
            frame = room.body(f"gliders.{index}", glider.mass, at=scale(glider.x, along))
            frames.append(self.track.carry(frame, glider.v, ("x", glider.x)).site(f"hook{index}"))
        self._springs(room)
        special, sprung = {pair.first: pair.restitution for pair in self.pairs}, (*self.joined, *self.buffers)
        for index, (one, other) in enumerate(pairwise(frames)):
            if all(index != pair.first for pair in sprung):
                e = special.get(index, self.restitution)
                room.bump(one, other, along, 0.0, e, sticks=e == 0.0)
        for wall, frame, sign in ((self.left, frames[0], 1.0), (self.right, frames[-1], -1.0)):
            if wall is not None:
                e = self.restitution
                room.bump(room, frame, scale(sign, along), sign * wall, e, sticks=e == 0.0)

    def _springs(self, room: Frame) -> None:
        hooks = [room.address(f"hook{number}") for number in range(len(self.gliders))]
        for index, pair in enumerate(self.joined):
            stiffness = pair.spring.stiffness
            room.spring(f"joined.{index}.spring", *hooks[pair.first : pair.second + 1], stiffness=stiffness)
        for index, buffered in enumerate(self.buffers):
            ends, spring = (hooks[buffered.first], hooks[buffered.second]), buffered.buffer
            room.buffer(f"buffers.{index}.buffer", *ends, stiffness=spring.stiffness, length=spring.length)

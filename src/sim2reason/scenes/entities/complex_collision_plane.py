"""Blocks and balls that collide on a straight track, with walls, spring buffers and pairs joined by springs."""

from collections.abc import Mapping
from itertools import pairwise
from typing import Annotated, Any, Self

import numpy as np
from annotated_types import Len
from pydantic import model_validator

from sim2reason.scenes.authoring import (
    Chance,
    Count,
    Entity,
    Frame,
    Range,
    Restitution,
    Word,
    assuming,
    each,
    either,
    entity,
    scale,
)
from sim2reason.scenes.bodies.planes import Track
from sim2reason.scenes.bodies.sliders import Glider, SlidingBall
from sim2reason.scenes.entities.parts.neighbours import (
    BUFFERS,
    JOINED,
    PAIRS,
    WALLS,
    Buffered,
    Joined,
    OwnRestitution,
    Wall,
    fit_neighbours,
    same_kind,
)

SAME_KIND_PROBABILITY = 0.95  # probability that all drawn gliders are of one kind
MIN_DISTANCE = 0.01  # m, between neighbours at the start
MAX_DURATION = 10.0  # s
PASSES = 5.0  # passes of the fastest glider over all others in the default duration


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
        for index, held in enumerate(self.buffers):
            if held.buffer.length >= self.gliders[held.second].x - self.gliders[held.first].x:
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
        return min(MAX_DURATION, PASSES * (self._places[-1] - self._places[0]) / fastest) if fastest else MAX_DURATION

    @property
    def _places(self) -> list[float]:
        """Return the positions of walls and gliders, from left to right, m."""
        return [place for place in (self.left, *(glider.x for glider in self.gliders), self.right) if place is not None]

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
        for wall, frame, way in ((self.left, frames[0], 1.0), (self.right, frames[-1], -1.0)):
            if wall is not None:
                e = self.restitution
                room.bump(room, frame, scale(way, along), way * wall, e, sticks=e == 0.0)

    def _springs(self, room: Frame) -> None:
        hooks = [room.address(f"hook{number}") for number in range(len(self.gliders))]
        for index, pair in enumerate(self.joined):
            stiffness = pair.spring.stiffness
            room.spring(f"joined.{index}.spring", *hooks[pair.first : pair.second + 1], stiffness=stiffness)
        for index, held in enumerate(self.buffers):
            ends, spring = (hooks[held.first], hooks[held.second]), held.buffer
            room.buffer(f"buffers.{index}.buffer", *ends, stiffness=spring.stiffness, length=spring.length)

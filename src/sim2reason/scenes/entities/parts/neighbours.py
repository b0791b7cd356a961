"""Neighbours on a straight track: connections, buffers and restitutions between them, with their sentences."""

from collections.abc import Container, Sequence
from math import ceil, inf
from typing import Annotated, Self, TypeVar

from annotated_types import Ge, Le
from pydantic import model_validator

from sim2reason.scenes.authoring import Measure, Member, Part, Restitution, each, either
from sim2reason.scenes.bodies.sliders import Glider
from sim2reason.scenes.bodies.spring import Bumper, Coil
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
    fastest, found = 2.0 * max(abs(glider.v) for glider in gliders), list[Sprung]()
    for pair in pairs:
        one, other = gliders[pair.first], gliders[pair.second]
        room = pair.buffer.length if isinstance(pair, Buffered) else other.x - one.x
        spring = pair.buffer if isinstance(pair, Buffered) else pair.spring
        least = one.mass * other.mass / (one.mass + other.mass) * (fastest / (MAX_COMPRESSION * room)) ** 2
        if least <= HARDEST[type(pair)]:
            stiff = replace_validated(spring, stiffness=max(spring.stiffness, 10.0 * ceil(0.1 * least)))
            found.append(replace_validated(pair, **{"buffer" if isinstance(pair, Buffered) else "spring": stiff}))
    return tuple(found)


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

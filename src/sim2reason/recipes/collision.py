"""Pucks that meet on a table, and what meets on a straight track."""

from dataclasses import dataclass
from itertools import pairwise
from math import cos, hypot, pi, sin, sqrt

import numpy as np

from sim2reason.bodies.puck import Puck, Table
from sim2reason.dsl.entity import Named
from sim2reason.dsl.measures import Count, Range
from sim2reason.dsl.model import Choices, as_said, field_types
from sim2reason.dsl.scene import Scene
from sim2reason.entities.complex_collision_plane import ComplexCollisionPlane
from sim2reason.entities.two_d_collision_plane import PairRestitution, TwoDCollisionPlane
from sim2reason.recipes import Difficulty, recipe
from sim2reason.recipes.parts.ideas import Idea, one_of

PLACES = Range(-1.5, 1.5)  # m
CLEAR = 4.0  # radii between any two pucks at the start


@dataclass(frozen=True)
class CollisionTier:
    """How hard: how many pucks, how fast, how bouncy, how steep."""

    pucks: Count
    mass: Range
    speed: Range
    restitution: tuple[str, ...]  # elastic, partial, dead
    track: Choices  # how the collisions on a straight track are drawn
    tilt: float = 0.0  # the chance of a tilted table
    pairs: float = 0.0  # the chance that one pair has a restitution of its own
    straight: float = 0.4  # of its scenes are on a straight track


ELASTIC = 0.4  # of the scenes on a straight track have elastic collisions
PARTIAL = Range(0.2, 0.8)  # coefficients of restitution that nobody takes for one or for zero
PLAIN: Choices = {"tilt?": 0.0, "joined": Count(0, 0), "buffers": Count(0, 0), "pairs": Count(0, 0)}
TIERS = {
    "easy": CollisionTier(
        Count(2, 2),
        Range(0.5, 3.0),
        Range(0.5, 1.5),
        ("elastic", "partial"),
        {**PLAIN, "gliders": Count(2, 2), "left?": 0.3, "right?": 0.0},
        straight=0.25,  # where velocities do not hang on places, little can be asked
    ),
    "medium": CollisionTier(
        Count(2, 3),
        Range(0.5, 8.0),
        Range(0.5, 3.0),
        ("elastic", "partial", "partial"),
        {**PLAIN, "tilt?": 0.6, "tilt": Range(5.0, 30.0), "gliders": Count(2, 3), "left?": 0.4, "right?": 0.4},
        0.0,
        0.3,
    ),
    "hard": CollisionTier(
        Count(3, 3),  # with four of them a program is written, not a solution
        Range(0.5, 15.0),
        Range(1.0, 5.0),
        ("elastic", "partial", "partial", "partial", "dead"),
        {
            "tilt": Range(5.0, 30.0),
            "gliders": Count(3, 3),
            "left?": 0.3,
            "right?": 0.2,
            "joined": Count(0, 1),
            "buffers": Count(0, 1),
            "pairs": Count(0, 1),
        },
        0.6,
        0.1,
        straight=0.6,
    ),
}

WEIGHTS = {
    "count": 0.3,  # three collisions, or before some
    "comparison": 0.2,
    "extremum": 0.1,
    "limit": 0.0,  # which few laws answer
    "optimum": 0.0,
}


@recipe("collision", weights=WEIGHTS)
def draw_collision(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """Pucks, each aimed so that it meets the slowest one before it, or balls, carts and walls on a straight track."""
    tier = TIERS[difficulty]
    if rng.random() < tier.straight:
        restitution = 1.0 if rng.random() < ELASTIC else PARTIAL
        choices = {**tier.track, "ComplexCollisionPlane.restitution": restitution, "restitution": PARTIAL}
        return one_of((Idea(ComplexCollisionPlane.__name__, choices, suits=_meets),), rng, "track")
    radius = _drawn(TwoDCollisionPlane, "radius", rng)
    count = int(rng.integers(tier.pucks.low, tier.pucks.high + 1))
    places = _places(count, CLEAR * radius, rng)
    pucks: list[Puck] = []
    for place in places:
        slowest = min(pucks, key=lambda puck: hypot(puck.vx, puck.vy), default=None)
        velocity = _aim(slowest, place, radius, tier, rng) if slowest else _any(Range(0.1, tier.speed.low), rng)
        mass = _drawn(Puck, "mass", rng, tier.mass)
        vx, vy = (as_said(Puck, "vx", part) for part in velocity)
        pucks.append(Puck(mass=mass, x=place[0], y=place[1], vx=vx, vy=vy))
    tilt = _drawn(Table, "tilt", rng, Range(2.0, 30.0)) if rng.random() < tier.tilt else 0.0
    restitution = _restitution(tier, rng)
    entity = TwoDCollisionPlane(
        table=Table(tilt=tilt),
        radius=radius,
        pucks=tuple(pucks),
        restitution=restitution,
        pairs=_pairs(count, restitution, tier, rng),
    )
    return Scene(entities=(Named(name="table", entity=entity),))


def _meets(track: ComplexCollisionPlane) -> bool:
    """Whether not all run away from each other."""
    speeds = [glider.v for glider in track.gliders]
    ends = [0.0] if track.left is not None else []
    speeds = [*ends, *speeds, *([0.0] if track.right is not None else [])]
    return any(one > other for one, other in pairwise(speeds))


def _drawn(kind: type, name: str, rng: np.random.Generator, drawn: Range | None = None) -> float:
    """A number of a class, from its own range or a narrower one."""
    held = field_types(kind)[name]
    found = drawn or held.drawn
    assert held.measure is not None
    assert found is not None
    return held.measure.draw(rng, found.low, found.high)


def _places(count: int, clear: float, rng: np.random.Generator) -> list[tuple[float, float]]:
    """Points at least `clear` apart, in metres."""
    found: list[tuple[float, float]] = []
    while len(found) < count:
        point = (_drawn(Puck, "x", rng, PLACES), _drawn(Puck, "y", rng, PLACES))
        if all(hypot(point[0] - x, point[1] - y) >= clear for x, y in found):
            found.append(point)
    return found


def _any(speed: Range, rng: np.random.Generator) -> tuple[float, float]:
    """A velocity of any direction."""
    size, angle = rng.uniform(speed.low, speed.high), rng.uniform(0.0, 2.0 * pi)
    return (size * cos(angle), size * sin(angle))


def _aim(
    target: Puck, place: tuple[float, float], radius: float, tier: CollisionTier, rng: np.random.Generator
) -> tuple[float, float]:
    """A velocity with which a puck would meet another, were they alone: more or less off centre.

    It is the target's velocity and one towards it, as large as leaves the sum within the tier's speeds.
    """
    dx, dy = target.x - place[0], target.y - place[1]
    distance = hypot(dx, dy)
    offset = rng.uniform(-1.4, 1.4) * radius
    ux, uy = (dx - offset * dy / distance) / distance, (dy + offset * dx / distance) / distance
    along = target.vx * ux + target.vy * uy
    room = tier.speed.high**2 - target.vx**2 - target.vy**2
    fastest = max(sqrt(max(along**2 + room, 0.0)) - along, 0.0)
    speed = rng.uniform(min(tier.speed.low, 0.5 * fastest), fastest)
    return (target.vx + speed * ux, target.vy + speed * uy)


def _restitution(tier: CollisionTier, rng: np.random.Generator) -> float:
    kind = tier.restitution[int(rng.integers(len(tier.restitution)))]
    if kind == "partial":
        return _drawn(PairRestitution, "restitution", rng, PARTIAL)
    return 1.0 if kind == "elastic" else 0.0


def _pairs(count: int, usual: float, tier: CollisionTier, rng: np.random.Generator) -> tuple[PairRestitution, ...]:
    """At most one pair whose restitution is not the usual one."""
    if count < 3 or rng.random() >= tier.pairs:
        return ()
    first = int(rng.integers(count - 1))
    own = usual
    while own == usual:
        own = _drawn(PairRestitution, "restitution", rng, PARTIAL)
    return (PairRestitution(first=first, second=first + 1, restitution=own),)

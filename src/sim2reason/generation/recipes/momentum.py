"""Conservation of momentum: collisions and rockets."""

from dataclasses import dataclass
from itertools import pairwise
from math import hypot, sqrt

import numpy as np

from sim2reason.generation.recipes import recipe
from sim2reason.generation.recipes.ranges import Idea, draw_idea
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.authoring import GRAVITY
from sim2reason.scenes.bodies.blocks import Puck, Table
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.measures import Count, Range
from sim2reason.scenes.dsl.model import Choices, field_types, round_as_stated
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.space import RocketEntity
from sim2reason.scenes.entities.track_collisions import ComplexCollisionPlane
from sim2reason.scenes.entities.two_d_collision_plane import PairRestitution, TwoDCollisionPlane

APART = Range(0.5, 1.5)  # m, between two pucks at the start
OFFSET = Range(0.3, 1.6)  # radii: distance between the centre of one puck and the path of the other's, at most
MAX_PATH_DISTANCE = 0.4  # radii: distance of the next puck's centre from the path of a struck puck, at most
ALIKE = Range(0.6, 1.6)  # factor between the speeds of pucks on perpendicular paths
PLANE_ORIGIN = (0.0, 0.0)

PlaneVector = tuple[float, float]


@dataclass(frozen=True)
class CollisionTier:
    """The difficulty settings of collisions: arrangement, masses, speeds and restitution."""

    meetings: tuple[str, ...]  # of pucks, see `MEETINGS`
    mass: Range
    speed: Range
    restitution: tuple[str, ...]  # elastic, partial, dead
    track: Choices  # how the collisions on a straight track are drawn
    tilt: float = 0.0  # the chance of a tilted table for two pucks that both move
    straight: float = 0.4  # of its scenes are on a straight track


ELASTIC_FRACTION = 0.4  # fraction of scenes on a straight track with elastic collisions
PARTIAL = Range(0.2, 0.8)  # coefficients of restitution clearly between zero and one
PLAIN: Choices = {"angle?": 0.0, "joined": Count(0, 0), "buffers": Count(0, 0), "pairs": Count(0, 0)}
COLLISION_TIERS = {
    "easy": CollisionTier(
        ("at rest", "head-on"),
        Range(0.5, 3.0),
        Range(0.5, 1.5),
        ("elastic", "partial"),
        {**PLAIN, "gliders": Count(2, 2), "left?": 0.3, "right?": 0.0},
        straight=0.25,  # where velocities do not hang on places, little can be asked
    ),
    "medium": CollisionTier(
        ("at rest", "head-on", "crossing"),
        Range(0.5, 5.0),
        Range(0.5, 3.0),
        ("elastic", "partial", "partial"),
        {**PLAIN, "angle?": 0.6, "angle": Range(5.0, 30.0), "gliders": Count(2, 3), "left?": 0.4, "right?": 0.4},
    ),
    "hard": CollisionTier(
        ("in turn", "in turn", "crossing"),
        Range(0.5, 8.0),
        Range(1.0, 5.0),
        ("elastic", "partial", "partial", "partial", "dead"),
        {
            "angle": Range(5.0, 30.0),
            "gliders": Count(3, 3),
            "left?": 0.3,
            "right?": 0.2,
            "joined": Count(0, 1),
            "buffers": Count(0, 1),
            "pairs": Count(0, 1),
        },
        0.4,
        straight=0.6,
    ),
}

COLLISION_WEIGHTS = {
    "count": 0.3,  # three collisions, or before some
    "state": 0.1,  # places, where velocities are worth asking for
    "time_to_event": 0.15,
    "reverse.state": 0.1,
    "reverse.sum": 0.3,
    "comparison": 0.2,
    "extremum": 0.1,
    "limit": 0.0,  # which few laws answer
    "optimum": 0.0,
}


@recipe("collision", weights=COLLISION_WEIGHTS)
def draw_collision(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """Pucks that collide off centre, or balls, carts and walls on a straight track."""
    tier = COLLISION_TIERS[difficulty]
    if rng.random() < tier.straight:
        restitution = 1.0 if rng.random() < ELASTIC_FRACTION else PARTIAL
        choices = {**tier.track, "ComplexCollisionPlane.restitution": restitution, "restitution": PARTIAL}
        return draw_idea((Idea(ComplexCollisionPlane.__name__, choices, suits=_meets),), rng, "track")
    meeting = tier.meetings[int(rng.integers(len(tier.meetings)))]
    radius = _drawn(TwoDCollisionPlane, "radius", rng)
    restitution = _restitution(tier, rng)
    pucks = MEETINGS[meeting](radius, tier, rng)
    moving = all(puck.vx or puck.vy for puck in pucks)
    tilt = _drawn(Table, "angle", rng, Range(2.0, 30.0)) if moving and rng.random() < tier.tilt else 0.0
    entity = TwoDCollisionPlane(table=Table(angle=tilt), radius=radius, pucks=pucks, restitution=restitution)
    return Scene(entities=(Named(name="table", entity=entity),))


def _meets(track: ComplexCollisionPlane) -> bool:
    """Return whether some bodies on a track approach each other."""
    speeds = [glider.v for glider in track.gliders]
    ends = [0.0] if track.left is not None else []
    speeds = [*ends, *speeds, *([0.0] if track.right is not None else [])]
    return any(one > other for one, other in pairwise(speeds))


def _drawn(kind: type, name: str, rng: np.random.Generator, drawn: Range | None = None) -> float:
    """Return a random value of a field of a class, from its own range or a narrower one."""
    field = field_types(kind)[name]
    interval = drawn or field.drawn
    assert field.measure is not None
    assert interval is not None
    return field.measure.draw(rng, interval.low, interval.high)


def _puck(
    tier: CollisionTier, rng: np.random.Generator, position: PlaneVector, velocity: PlaneVector = PLANE_ORIGIN
) -> Puck:
    """Return a puck of random mass."""
    x, y, vx, vy = (round_as_stated(Puck, name, part) for name, part in zip(PARTS, (*position, *velocity), strict=True))
    return Puck(mass=_drawn(Puck, "mass", rng, tier.mass), x=x, y=y, vx=vx, vy=vy)


def _draw_uniform(interval: Range, rng: np.random.Generator) -> float:
    return float(rng.uniform(interval.low, interval.high))


def _draw_path_offset(radius: float, rng: np.random.Generator) -> float:
    """Return a random signed offset of a path from a centre, m."""
    return float(rng.choice([-1.0, 1.0])) * _draw_uniform(OFFSET, rng) * radius


def _draw_at_rest(radius: float, tier: CollisionTier, rng: np.random.Generator) -> tuple[Puck, ...]:
    """Return a puck that moves along the x axis, and one at rest that it hits off centre."""
    position = (-2.0 * radius - _draw_uniform(APART, rng), _draw_path_offset(radius, rng))
    return _puck(tier, rng, position, (_draw_uniform(tier.speed, rng), 0.0)), _puck(tier, rng, PLANE_ORIGIN)


def _head_on(radius: float, tier: CollisionTier, rng: np.random.Generator) -> tuple[Puck, ...]:
    """Return two pucks that move towards each other on parallel paths."""
    position, toward = (
        (2.0 * radius + _draw_uniform(APART, rng), _draw_path_offset(radius, rng)),
        (-_draw_uniform(tier.speed, rng), 0.0),
    )
    return _puck(tier, rng, PLANE_ORIGIN, (_draw_uniform(tier.speed, rng), 0.0)), _puck(tier, rng, position, toward)


def _crossing(radius: float, tier: CollisionTier, rng: np.random.Generator) -> tuple[Puck, ...]:
    """Return two pucks on perpendicular paths; the second is a little early or late where the paths cross."""
    ahead = _draw_uniform(tier.speed, rng)
    up = _draw_uniform(ALIKE, rng) * ahead
    time = (2.0 * radius + _draw_uniform(APART, rng)) / min(ahead, up)
    late = _draw_path_offset(radius, rng) * hypot(ahead, up) / ahead  # so much that the centres pass at that distance
    first = _puck(tier, rng, (-ahead * time, 0.0), (ahead, 0.0))
    return first, _puck(tier, rng, (0.0, late - up * time), (0.0, up))


def _in_turn(radius: float, tier: CollisionTier, rng: np.random.Generator) -> tuple[Puck, ...]:
    """Return a puck that hits one at rest, which then hits another at rest: it moves off along the line of centres."""
    first, second = _draw_at_rest(radius, tier, rng)
    across = -first.y / (2.0 * radius)
    along = sqrt(1.0 - across**2)
    distance, beside = (
        2.0 * radius + _draw_uniform(APART, rng),
        float(rng.uniform(-MAX_PATH_DISTANCE, MAX_PATH_DISTANCE)) * radius,
    )
    position = (along * distance - across * beside, across * distance + along * beside)
    return first, second, _puck(tier, rng, position)


PARTS = "x", "y", "vx", "vy"
MEETINGS = {"at rest": _draw_at_rest, "head-on": _head_on, "crossing": _crossing, "in turn": _in_turn}


def _restitution(tier: CollisionTier, rng: np.random.Generator) -> float:
    kind = tier.restitution[int(rng.integers(len(tier.restitution)))]
    if kind == "partial":
        return _drawn(PairRestitution, "restitution", rng, PARTIAL)
    return 1.0 if kind == "elastic" else 0.0


ROCKET = "RocketEntity"


def _waits(rocket: RocketEntity) -> bool:
    """Return whether the thrust cannot lift the rocket before some fuel is burnt."""
    return rocket.thrust < rocket.rocket.mass * GRAVITY


ROCKET_IDEAS = {
    "easy": (Idea(ROCKET, {"place": ("DeepSpace",)}),),
    "medium": (  # with weight, often with a wait until it can lift off
        Idea(ROCKET, {"place": ("LevelGround",)}, 0.6),
        Idea(ROCKET, {"place": ("LevelGround",)}, suits=_waits),
    ),
    "hard": (  # with a weight that falls off, or too heavy to lift off at once
        Idea(ROCKET, {"place": ("AirlessPlanet",)}, 2.0),
        Idea(ROCKET, {"place": ("LevelGround",)}, suits=_waits),
    ),
}

ROCKET_WEIGHTS = {
    "time_to_event": 0.2,  # which are often about a minute
    "state": 0.4,
    "extremum": 0.03,
    "optimum": 0.0,
}


@recipe("rocket", weights=ROCKET_WEIGHTS)
def draw_rocket(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """A rocket that burns its fuel: in deep space, above level ground, or leaving a planet."""
    return draw_idea(ROCKET_IDEAS[difficulty], rng, "rocket")

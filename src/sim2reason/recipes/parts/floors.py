"""Where strings would put slopes, seen from the floor on which one of them stands."""

from sim2reason.dsl.builder import Builder
from sim2reason.dsl.connection import Joint
from sim2reason.dsl.ports import Stop, StringEnd
from sim2reason.dsl.scene import Scene

LEVEL = 1e-9  # of a direction, or m: less is rounding


def leads_below_floor(scene: Scene, joint: Joint) -> bool:
    """Whether a string comes on the level from the foot of a slope, which stands on a floor, to the top of another.

    The other slope would lie below the floor. What hangs there may: beyond the edge of a table, say.
    """
    ends = [stop for stop in joint.stops if isinstance(stop.port, StringEnd)]
    return any(_leaves_at_foot(scene, end) for end in ends) and any(_leaves_upwards(scene, end) for end in ends)


def _leaves_at_foot(scene: Scene, end: Stop) -> bool:
    """Whether a string goes down to a corner of its own entity, and leaves that on the level."""
    return _climb(scene, end) < -LEVEL and abs(_steepness(scene, end)) < LEVEL


def _leaves_upwards(scene: Scene, end: Stop) -> bool:
    """Whether a string goes up a slope, be it to a corner of its entity, or away from that."""
    return _climb(scene, end) > LEVEL or LEVEL < _steepness(scene, end) < 1.0 - LEVEL


def _climb(scene: Scene, end: Stop) -> float:
    """How much higher a string leaves an entity than it is tied to it, m."""
    alone = _alone(scene, end)
    return alone.position(end.sites[-1])[2] - alone.position(end.sites[0])[2]


def _steepness(scene: Scene, end: Stop) -> float:
    """The sine of the angle at which a string leaves an entity; zero where it may leave in any direction."""
    face = _alone(scene, end).faces.get(end.sites[-1])
    return face[2] if face is not None else 0.0


def _alone(scene: Scene, end: Stop) -> Builder:
    """The entity to which an end of a string belongs, built by itself."""
    return next(named.alone for named in scene.entities if named.name == end.owner.partition(".")[0])

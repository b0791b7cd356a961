"""Tests of a mechanism before its motion is known: whether two bodies collide at most once, or one goes straight up."""

from math import inf

from sim2reason.scenes.dsl.mechanism import Coordinate, Mechanism, Meeting, Prop
from sim2reason.scenes.dsl.vectors import inner
from sim2reason.simulation.quantities.subjects.paths import EVEN, parallel


def moves_freely(mechanism: Mechanism) -> bool:
    """Return whether nothing but contacts without friction acts between collisions, on bodies that do not turn."""
    acts = (mechanism.lines, mechanism.forces, mechanism.attractions, mechanism.burns, mechanism.feet)
    rubs = any(face.friction > 0.0 for face in mechanism.faces)
    return not any(acts) and not rubs and all(c.kind == "slide" for c in mechanism.coordinates)


def meets_once(mechanism: Mechanism) -> bool:
    """Return whether at most one collision can happen: of two bodies that move freely along the same directions.

    What accelerates them is the same for both, so that they never come together again.
    """
    if len(mechanism.meetings) != 1 or len(mechanism.meetings[0].names) != 2 or not moves_freely(mechanism):
        return False
    one, other = ([c.axis for c in mechanism.body[name].coordinates] for name in mechanism.meetings[0].names)
    return len(one) == len(other) and all(map(parallel, one, other))


def goes_straight_up(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body that nothing guides starts straight up: sent off so, or driven from the ground."""
    body = mechanism.body[name]
    lines = (line for line in mechanism.lines if not isinstance(line.law, Prop))
    tied = {mechanism.site[site].body for line in lines for site in line.through}
    struck = any(name in meeting.names and not _is_ground(meeting) for meeting in mechanism.meetings)
    pushed = any(force.body == name for force in mechanism.forces)
    if body.parent or name in mechanism.contacts or name in tied or struck or pushed:
        return False
    moved = [c for c in body.coordinates if c.speed or abs(c.axis[2]) > EVEN or len(body.coordinates) == 1]
    if len(moved) != 1 or any(c.kind != "slide" for c in body.coordinates):
        return False
    return _is_thrown(mechanism, moved[0]) or _takes_off(mechanism, moved[0])


def _is_ground(meeting: Meeting) -> bool:
    """Return whether a body bounces off the room below it."""
    return meeting.a is None and meeting.normal is not None and meeting.normal[2] > 1.0 - EVEN


def _is_thrown(mechanism: Mechanism, way: Coordinate) -> bool:
    """Return whether a body moves against gravity at the start, and burns nothing."""
    burns = any(burn.body == way.body for burn in mechanism.burns)
    against = parallel(way.axis, (0.0, 0.0, 1.0)) and inner(way.axis, mechanism.gravity) * way.speed < 0.0
    return against and not burns and not mechanism.attractions


def _takes_off(mechanism: Mechanism, way: Coordinate) -> bool:
    """Return whether a body is driven away from the ground on which it stands, the limit of its coordinate."""
    drives = [burn.direction for burn in mechanism.burns if burn.body == way.body]
    stands = (way.lower, way.upper, way.speed) == (0.0, inf, 0.0)
    return stands and bool(drives) and all(inner(way.axis, drive) > 0.0 for drive in drives)

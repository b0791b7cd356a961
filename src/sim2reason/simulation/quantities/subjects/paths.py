"""Possible motions of the parts of a mechanism, derived from its tree of bodies without simulation."""

from dataclasses import dataclass
from math import hypot

from sim2reason.scenes.dsl.mechanism import ZERO, Coordinate, Mechanism, RigidBody
from sim2reason.scenes.dsl.vectors import Vector, add, outer, scale

RIMS = ("left", "right"), ("in", "out")  # the sites where a string meets a pulley, of an entity and of a string
DIRECTION_TOL = 1e-9  # largest vertical component of a horizontal direction; length of a vanishing direction


@dataclass(frozen=True, slots=True)
class CenterPath:
    """The possible motions of the centre of mass of a body in the world frame.

    `ways` are the initial directions in which its coordinates can move it, those of the body itself first; parallel
    ones count once. `bends` tells whether they change with the motion, `turns` are the axes about which the body can
    rotate, and `swings` tells whether one of these rotations moves its centre of mass.
    """

    ways: tuple[Vector, ...]
    bends: bool
    turns: tuple[Vector, ...]
    swings: bool

    @property
    def straight(self) -> bool:
        """Return whether the path is one straight line."""
        return len(self.ways) == 1 and not self.bends

    @property
    def rises(self) -> bool:
        """Return whether the centre of mass can move up or down."""
        return any(abs(way[2]) > DIRECTION_TOL for way in self.ways) or (
            self.bends and any(not upright(t) for t in self.turns)
        )


def upright(axis: Vector) -> bool:
    """Return whether an axis is vertical, so that rotation about it keeps heights constant."""
    return hypot(axis[0], axis[1]) <= DIRECTION_TOL


def chain(mechanism: Mechanism, name: str) -> list[RigidBody]:
    """Return a body and all bodies that carry it, innermost first."""
    found: list[RigidBody] = []
    step: str | None = name
    while step is not None:
        found.append(mechanism.body[step])
        step = found[-1].parent
    return found


def center_path(mechanism: Mechanism, name: str) -> CenterPath:
    """Return the possible motions of the centre of mass of a body."""
    bodies = chain(mechanism, name)
    ways: list[Vector] = []
    turns: list[Vector] = []
    bends = swings = False
    arm = bodies[0].center  # from the frame of the body at hand to the centre of mass; all axes are the room's
    later: list[Coordinate] = []  # slides that act after the coordinate at hand, so that hinges before turn them
    for body in bodies:
        for coordinate in reversed(body.coordinates):
            if coordinate.kind == "slide":
                ways.append(coordinate.axis)
                later.append(coordinate)
                continue
            turns.append(coordinate.axis)
            sweep = outer(coordinate.axis, arm)
            if hypot(*sweep) > DIRECTION_TOL:
                ways.append(scale(1.0 / hypot(*sweep), sweep))
                swings = True
            bends = bends or hypot(*sweep) > DIRECTION_TOL or any(not parallel(s.axis, coordinate.axis) for s in later)
        arm = add(arm, body.at)
    distinct: list[Vector] = []
    for way in ways:
        if not any(parallel(way, other) for other in distinct):
            distinct.append(way)
    return CenterPath(tuple(distinct), bends, tuple(turns), swings)


def parallel(one: Vector, other: Vector) -> bool:
    """Return whether two unit vectors are parallel or antiparallel."""
    return hypot(*outer(one, other)) <= DIRECTION_TOL


def turning_axes(mechanism: Mechanism, name: str) -> list[tuple[str, Vector]]:
    """Return the hinges that rotate a body, by name, each with its initial axis; the innermost first."""
    return [
        (c.name, c.axis) for body in chain(mechanism, name) for c in reversed(body.coordinates) if c.kind == "hinge"
    ]


def is_pulley_wheel(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body is the wheel of a pulley, with its rim marked on its carrier."""
    return f"{name}.left" in mechanism.site and f"{name}.right" in mechanism.site


def rim_of(mechanism: Mechanism, address: str) -> tuple[str, str] | None:
    """Return the names of the two sites at the rim of a pulley; None if there is no pulley at the address."""
    found = ((f"{address}.{one}", f"{address}.{other}") for one, other in RIMS)
    return next((pair for pair in found if all(site in mechanism.site for site in pair)), None)


def rides(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body moves on a sliding body, so that its motion is ambiguous without a reference."""
    own = False
    for body in chain(mechanism, name):
        if own and any(c.kind == "slide" for c in body.coordinates):
            return True
        own = own or bool(body.coordinates)
    return False


def is_welded_part(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body is one of several welded to the same light body, and so part of a rigid body."""
    body = mechanism.body[name]
    if body.parent is None or body.coordinates:
        return False
    beside = [b for b in mechanism.bodies if b.parent == body.parent and b.mass > 0.0 and not b.coordinates]
    return len(beside) > 1


def extended(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body has a moment of inertia."""
    return any(mechanism.body[name].inertia)


def at_start(mechanism: Mechanism, name: str | None) -> Vector:
    """Return the initial position of a body's frame in the world frame, m; their axes then coincide."""
    return add(*(body.at for body in chain(mechanism, name))) if name is not None else ZERO


def point_directions(mechanism: Mechanism, name: str | None, at: Vector) -> dict[str, Vector]:
    """Return the initial direction of motion of a point `at` in a body's frame for each coordinate that moves it."""
    found: dict[str, Vector] = {}
    arm = at
    for body in chain(mechanism, name) if name is not None else []:
        for coordinate in body.coordinates:
            way = coordinate.axis if coordinate.kind == "slide" else outer(coordinate.axis, arm)
            if hypot(*way) > DIRECTION_TOL:
                found[coordinate.name] = way
        arm = add(arm, body.at)
    return found


def carried_by(mechanism: Mechanism, name: str) -> list[RigidBody]:
    """Return a body and all bodies that it carries."""
    found = {name}
    for body in mechanism.bodies:  # a parent stands before its children
        if body.parent in found:
            found.add(body.name)
    return [body for body in mechanism.bodies if body.name in found]

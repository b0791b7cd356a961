"""How the parts of a mechanism can move, as its tree of bodies tells without any motion."""

from dataclasses import dataclass
from math import hypot

from sim2reason.scenes.dsl.mechanism import ZERO, Coordinate, Mechanism, RigidBody
from sim2reason.scenes.dsl.vectors import Vector, add, outer, scale

RIMS = ("left", "right"), ("in", "out")  # the sites where a string meets a pulley, of an entity and of a string
EVEN = 1e-9  # the vertical part of a direction that is level; the length of a direction that is none


@dataclass(frozen=True, slots=True)
class CenterPath:
    """How the centre of mass of a body can move in the room.

    `ways` are the directions, at the start, in which its coordinates can move it, those of the body itself first;
    parallel ones count once. `bends` says whether they change as it moves, `turns` are the axes about which the body
    can turn, and `swings` says whether one of them moves its centre of mass.
    """

    ways: tuple[Vector, ...]
    bends: bool
    turns: tuple[Vector, ...]
    swings: bool

    @property
    def straight(self) -> bool:
        """Return whether it is one straight line."""
        return len(self.ways) == 1 and not self.bends

    @property
    def rises(self) -> bool:
        """Return whether it can go up or down."""
        return any(abs(way[2]) > EVEN for way in self.ways) or (self.bends and any(not upright(t) for t in self.turns))


def upright(axis: Vector) -> bool:
    """Return whether an axis is vertical, so that what turns about it stays level."""
    return hypot(axis[0], axis[1]) <= EVEN


def chain(mechanism: Mechanism, name: str) -> list[RigidBody]:
    """Return a body and all that carry it, itself first."""
    found: list[RigidBody] = []
    step: str | None = name
    while step is not None:
        found.append(mechanism.body[step])
        step = found[-1].parent
    return found


def center_path(mechanism: Mechanism, name: str) -> CenterPath:
    """Return how the centre of mass of a body can move."""
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
            if hypot(*sweep) > EVEN:
                ways.append(scale(1.0 / hypot(*sweep), sweep))
                swings = True
            bends = bends or hypot(*sweep) > EVEN or any(not parallel(s.axis, coordinate.axis) for s in later)
        arm = add(arm, body.at)
    distinct: list[Vector] = []
    for way in ways:
        if not any(parallel(way, other) for other in distinct):
            distinct.append(way)
    return CenterPath(tuple(distinct), bends, tuple(turns), swings)


def parallel(one: Vector, other: Vector) -> bool:
    """Return whether two unit vectors lie on one line."""
    return hypot(*outer(one, other)) <= EVEN


def turning_axes(mechanism: Mechanism, name: str) -> list[tuple[str, Vector]]:
    """Return the hinges that turn a body, by name, each with its axis at the start; the innermost first."""
    return [
        (c.name, c.axis) for body in chain(mechanism, name) for c in reversed(body.coordinates) if c.kind == "hinge"
    ]


def is_pulley_wheel(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body is the wheel of a pulley: its rim is marked on what carries it."""
    return f"{name}.left" in mechanism.site and f"{name}.right" in mechanism.site


def rim_of(mechanism: Mechanism, address: str) -> tuple[str, str] | None:
    """Return the names of the two sites at the rim of a pulley; None if there is no pulley at the address."""
    found = ((f"{address}.{one}", f"{address}.{other}") for one, other in RIMS)
    return next((pair for pair in found if all(site in mechanism.site for site in pair)), None)


def rides(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body moves on another one that slides, so that its motion could be taken as relative to that."""
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
    """Return whether a body has a size that turning shows."""
    return any(mechanism.body[name].inertia)


def at_start(mechanism: Mechanism, name: str | None) -> Vector:
    """Return where the frame of a body stands in the room at the start, m; its axes are then those of the room."""
    return add(*(body.at for body in chain(mechanism, name))) if name is not None else ZERO


def ways_of(mechanism: Mechanism, name: str | None, at: Vector) -> dict[str, Vector]:
    """Return how a point `at` in the frame of a body moves, at the start, with each coordinate that does move it."""
    found: dict[str, Vector] = {}
    arm = at
    for body in chain(mechanism, name) if name is not None else []:
        for coordinate in body.coordinates:
            way = coordinate.axis if coordinate.kind == "slide" else outer(coordinate.axis, arm)
            if hypot(*way) > EVEN:
                found[coordinate.name] = way
        arm = add(arm, body.at)
    return found


def carried_by(mechanism: Mechanism, name: str) -> list[RigidBody]:
    """Return a body and all that it carries."""
    found = {name}
    for body in mechanism.bodies:  # a parent stands before its children
        if body.parent in found:
            found.add(body.name)
    return [body for body in mechanism.bodies if body.name in found]

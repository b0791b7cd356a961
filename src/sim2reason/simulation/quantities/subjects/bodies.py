"""Single bodies and the whole system as kinds of subjects, and the motions that bodies can make."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from math import hypot

from sim2reason.base.records import record
from sim2reason.scenes.dsl.mechanism import ZERO, Coordinate, Mechanism, RigidBody
from sim2reason.scenes.dsl.structure import rotates_one_way
from sim2reason.scenes.dsl.vectors import Vector, add, outer, scale
from sim2reason.simulation.quantities.subjects import Sense, Subject, is_stated, is_stated_for_all

RIMS = ("left", "right"), ("in", "out")  # the sites where a string meets a pulley, of an entity and of a string
DIRECTION_TOL = 1e-9  # largest vertical component of a horizontal direction; length of a vanishing direction


@record(slots=True)
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
        return any(abs(direction[2]) > DIRECTION_TOL for direction in self.ways) or (
            self.bends and any(not is_vertical(t) for t in self.turns)
        )


def is_vertical(axis: Vector) -> bool:
    """Return whether an axis is vertical, so that rotation about it keeps heights constant."""
    return hypot(axis[0], axis[1]) <= DIRECTION_TOL


def ancestor_chain(mechanism: Mechanism, name: str) -> list[RigidBody]:
    """Return a body and all bodies that carry it, innermost first."""
    bodies: list[RigidBody] = []
    step: str | None = name
    while step is not None:
        bodies.append(mechanism.body[step])
        step = bodies[-1].parent
    return bodies


def center_path(mechanism: Mechanism, name: str) -> CenterPath:
    """Return the possible motions of the centre of mass of a body, computed once for each mechanism and body."""
    return mechanism.memoize(("center path", name), lambda: _path_of(ancestor_chain(mechanism, name)))


def _path_of(bodies: list[RigidBody]) -> CenterPath:
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
    for direction in ways:
        if not any(parallel(direction, other) for other in distinct):
            distinct.append(direction)
    return CenterPath(tuple(distinct), bends, tuple(turns), swings)


def parallel(one: Vector, other: Vector) -> bool:
    """Return whether two unit vectors are parallel or antiparallel."""
    return hypot(*outer(one, other)) <= DIRECTION_TOL


def turning_axes(mechanism: Mechanism, name: str) -> list[tuple[str, Vector]]:
    """Return the hinges that rotate a body, by name, each with its initial axis; the innermost first."""
    return [
        (c.name, c.axis)
        for body in ancestor_chain(mechanism, name)
        for c in reversed(body.coordinates)
        if c.kind == "hinge"
    ]


def is_pulley_wheel(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body is the wheel of a pulley, with its rim marked on its carrier."""
    return f"{name}.left" in mechanism.site and f"{name}.right" in mechanism.site


def rim_sites(mechanism: Mechanism, address: str) -> tuple[str, str] | None:
    """Return the names of the two sites at the rim of a pulley; None if there is no pulley at the address."""
    candidates = ((f"{address}.{one}", f"{address}.{other}") for one, other in RIMS)
    return next((pair for pair in candidates if all(site in mechanism.site for site in pair)), None)


def moves_on_slider(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body moves on a sliding body, so that its motion is ambiguous without a reference."""
    own = False
    for body in ancestor_chain(mechanism, name):
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


def initial_position(mechanism: Mechanism, name: str | None) -> Vector:
    """Return the initial position of a body's frame in the world frame, m; their axes then coincide."""
    return add(*(body.at for body in ancestor_chain(mechanism, name))) if name is not None else ZERO


def point_directions(mechanism: Mechanism, name: str | None, at: Vector) -> dict[str, Vector]:
    """Return the initial direction of motion of a point `at` in a body's frame for each coordinate that moves it."""
    directions: dict[str, Vector] = {}
    arm = at
    for body in ancestor_chain(mechanism, name) if name is not None else []:
        for coordinate in body.coordinates:
            direction = coordinate.axis if coordinate.kind == "slide" else outer(coordinate.axis, arm)
            if hypot(*direction) > DIRECTION_TOL:
                directions[coordinate.name] = direction
        arm = add(arm, body.at)
    return directions


def carried_bodies(mechanism: Mechanism, name: str) -> list[RigidBody]:
    """Return a body and all bodies that it carries."""
    names = {name}
    for body in mechanism.bodies:  # a parent stands before its children
        if body.parent in names:
            names.add(body.name)
    return [body for body in mechanism.bodies if body.name in names]


UP, RIGHT = "up", "right"
OPPOSITE = {UP: "down", RIGHT: "left"}
HORIZONTAL, VERTICAL = "horizontal", "vertical"
OFF_AXIS_SHARE = 0.3  # relative frequency of a component along no axis of the text, or along one of two
AXES = ("x", "y", "z")  # labels of coordinates along axes that the text defines


@dataclass(frozen=True)
class Bodies(Subject):
    """Bodies as subjects; texts ask about those whose centre of mass can move."""

    name = slot = "body"
    extras = frozenset({"ground"})

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of all bodies, including massless bodies and wheels."""
        return tuple(mechanism.body)

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return the phrases of the movable bodies, except the wheels of pulleys, which the text does not follow."""
        return {name: mentions[name] for name in mechanism.body if name in mentions and can_move(mechanism, name)}

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return whether the body has the property `need` and the text states it at the body's address."""
        return getattr(mechanism.body[name], need, 1.0) != 0.0 and is_stated(need, name, said)

    def fills(self, mechanism: Mechanism, name: str, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return *relative to the ground* for a body that another body carries."""
        del mentions
        return {"ground": " relative to the ground" if moves_on_slider(mechanism, name) else ""}

    def point(self, mechanism: Mechanism, name: str, phrase: str) -> str:
        """Return the phrase of the centre of mass for an extended swinging body, else that of the body itself."""
        swings = any(mechanism.body[name].inertia) and center_path(mechanism, name).swings
        return f"the centre of mass of {phrase}" if swings else phrase

    def senses(self, mechanism: Mechanism, name: str) -> list[Sense]:
        """Return the directions up, up the slope, and along the axes that the text defines."""
        own = [c for c in mechanism.body[name].coordinates if c.label in AXES and c.kind == "slide"]
        path = center_path(mechanism, name)
        if own and len(own) == len(path.ways):
            share = OFF_AXIS_SHARE if len(own) > 1 else 1.0  # of a plane motion rather how fast, how far and which way
            return [Sense(f"along the {c.label} axis", c.axis, c.label, share=share, fixed=True) for c in own]
        right = [Sense(RIGHT, c.axis) for c in mechanism.body[name].coordinates if c.label == RIGHT]
        return _of_path(path) or (right if path.straight else [])

    def directions(self, mechanism: Mechanism, name: str) -> list[Vector]:
        """Return the directions of motion of the body and of its carriers; an empty list if any direction changes."""
        path = center_path(mechanism, name)
        return [] if path.bends else list(path.ways)

    def label(self, phrase: str) -> str:
        """Return the letter or the noun of the phrase."""
        return phrase.removeprefix("the ") if phrase.startswith("the ") else phrase.rpartition(" ")[2]


def can_move(mechanism: Mechanism, name: str) -> bool:
    """Return whether the centre of mass of a body can move, and the body is not the wheel of a pulley.

    A massless rotating body, such as a light arm on a carriage, has no centre of mass.
    """
    body = mechanism.body[name]
    pointless = not body.mass and any(coordinate.kind == "hinge" for coordinate in body.coordinates)
    return bool(center_path(mechanism, name).ways) and not pointless and not is_pulley_wheel(mechanism, name)


def moves_in_plane(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body moves freely along two axes of the text, as projectiles, pucks and planets do."""
    return sum(coordinate.label in AXES for coordinate in mechanism.body[name].coordinates) > 1


def _of_path(path: CenterPath) -> list[Sense]:
    """Return the directions up, or up the slope, of a centre of mass that can rise; none for any other path."""
    if not path.rises:
        return []
    if not path.straight:
        return [Sense(UP, (0.0, 0.0, 1.0), VERTICAL, share=OFF_AXIS_SHARE)]
    direction = path.ways[0] if path.ways[0][2] > 0.0 else scale(-1.0, path.ways[0])
    return [Sense(UP if direction[2] > 1.0 - DIRECTION_TOL else "up the slope", direction)]


ROD = "rod"  # the last part of a rod's address


@dataclass(frozen=True)
class SuspendedBodies(Subject):
    """Small bodies at the end of a light rod on a hinge, on which only the rod and gravity act, as subjects."""

    name, slot = "hung body", "rod"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of the bodies."""
        return tuple(body.name for body in mechanism.bodies if _hangs(mechanism, body))

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return the text's phrase for the rod of each body."""
        rods = {name: f"{name.rpartition('.')[0]}.{ROD}" for name in self.names(mechanism)}
        return {name: mentions[rod] for name, rod in rods.items() if rod in mentions}

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return whether the text states `need` for every body, since the force in a rod depends on all of them."""
        del name
        return is_stated_for_all(need, mechanism, said)


def _hangs(mechanism: Mechanism, body: RigidBody) -> bool:
    hinged = [coordinate.kind for coordinate in body.coordinates] == ["hinge"] and body.parent is not None
    small = body.mass > 0.0 and not any(body.inertia) and len(list(carried_bodies(mechanism, body.name))) == 1
    pulled = {mechanism.site[site].body for line in mechanism.lines for site in line.through}
    acted = {force.body for force in mechanism.forces} | {burn.body for burn in mechanism.burns}
    drawn = {name for pull in mechanism.attractions for name in (pull.a, pull.b)}
    return hinged and small and body.name not in pulled | acted | drawn | mechanism.contacts.keys()


@dataclass(frozen=True)
class TurningBodies(Subject):
    """Bodies that turn about a hinge, their own or that of a body that carries them, as subjects."""

    name, slot = "turning body", "body"
    extras = frozenset({"net"})

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of all rotating bodies, including wheels of pulleys."""
        return tuple(name for name in mechanism.body if turning_axes(mechanism, name))

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return the phrases of the bodies with visible rotation: no pulleys and no point masses."""
        seen = [name for name in self.names(mechanism) if name in mentions and not is_pulley_wheel(mechanism, name)]
        return {name: mentions[name] for name in seen if _has_size(mechanism, name)}

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return whether the body has the property `need` and the text states it at the body's address."""
        return Bodies().gives(need, mechanism, name, said)

    def fills(self, mechanism: Mechanism, name: str, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return *net* for the angle of a body that may reverse its rotation."""
        del mentions
        return {"net": "" if rotates_one_way(mechanism, name) else "net "}


def _has_size(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body is not a point: it has a moment of inertia, or it is light and on its own hinge."""
    body = mechanism.body[name]
    return any(body.inertia) or (body.mass == 0.0 and any(c.kind == "hinge" for c in body.coordinates))


WHOLE_SCENE = ""  # the only name of this kind


@dataclass(frozen=True)
class WholeScene(Subject):
    """The whole scene as a subject, which questions do not name."""

    name, slot = "whole", "all"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the single name of the whole scene."""
        del mechanism
        return (WHOLE_SCENE,)

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return an empty phrase, as questions do not name the scene."""
        del mechanism, mentions
        return {WHOLE_SCENE: ""}

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return whether the text states `need` for every body that has it."""
        del name
        return is_stated_for_all(need, mechanism, said)

    def senses(self, mechanism: Mechanism, name: str) -> list[Sense]:
        """Return the directions that the text can name if they are the same for all bodies with a mass; else none."""
        del name
        each = [Bodies().senses(mechanism, body.name) for body in mechanism.bodies if body.mass > 0.0]
        return each[0] if each and all(senses == each[0] for senses in each) else []

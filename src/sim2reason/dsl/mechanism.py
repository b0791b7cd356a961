"""What an engine simulates: a frozen, engine-neutral value of bodies, strings, contacts and collisions.

Frames never turn relative to the room, but for wheels about their own axle; so every vector here is in
room coordinates, x to the right, y away from the reader, z up, in SI units.
"""

from dataclasses import dataclass
from functools import cached_property
from math import inf
from typing import Literal

Vector = tuple[float, float, float]
X: Vector = (1.0, 0.0, 0.0)
Y: Vector = (0.0, 1.0, 0.0)
Z: Vector = (0.0, 0.0, 1.0)
ZERO: Vector = (0.0, 0.0, 0.0)
GRAVITY = 9.8


@dataclass(frozen=True, slots=True)
class Coordinate:
    """One way in which a body may move relative to its parent, zero at the start of the motion."""

    name: str
    kind: Literal["slide", "hinge"]
    axis: Vector  # unit vector; a hinge turns right-handed about it
    speed: float = 0.0  # at the start: m/s, or rad/s for a hinge
    lower: float = -inf  # travel limits; reaching one ends the motion that is described
    upper: float = inf


@dataclass(frozen=True, slots=True)
class Contact:
    """A body lies on its parent's face: it may slide along it, press on it, but not pull on it."""

    along: str  # the coordinate of sliding
    normal: Vector  # unit vector, out of the parent's face
    friction: float = 0.0  # one coefficient, static and kinetic


@dataclass(frozen=True, slots=True)
class Body:
    """A rigid body; its parent's frame carries it. Mass 0 means massless."""

    name: str
    parent: str | None  # None: the room
    at: Vector  # of its centre of mass in the parent's frame at the start
    mass: float = 0.0
    inertia: float = 0.0  # about its hinge, kg m²
    coordinates: tuple[Coordinate, ...] = ()  # none: welded to the parent
    contact: Contact | None = None


@dataclass(frozen=True, slots=True)
class Site:
    """A point fixed on a body, or in the room."""

    name: str
    body: str | None
    at: Vector  # in the body's frame


@dataclass(frozen=True, slots=True)
class Wheel:
    """A string's grip on a massive pulley: its free length changes by `radius` times the pulley's angle."""

    coordinate: str
    radius: float  # signed, in metres


@dataclass(frozen=True, slots=True)
class String:
    """A light inextensible string of one tension, straight between its sites; it can go slack.

    Its constraint is: sum of distances between consecutive sites + Σ radius·angle over its wheels ≤ its
    value at the start + `slack`. A string that passes a massive pulley is several of these, one for each
    part, all with the same `whole`.
    """

    name: str
    whole: str
    through: tuple[str, ...]  # site names, from end to end
    wheels: tuple[Wheel, ...] = ()
    slack: float = 0.0  # metres to spare at the start


@dataclass(frozen=True, slots=True)
class Pull:
    """A constant force that draws a string in: the generalised force is −force · d(length)/dq."""

    name: str
    through: tuple[str, ...]
    force: float  # N, at least 0
    wheels: tuple[Wheel, ...] = ()


@dataclass(frozen=True, slots=True)
class Collision:
    """Two bodies that bounce when their centres come within `distance` of each other."""

    a: str
    b: str
    distance: float  # m
    restitution: float  # ratio of normal relative speeds, 0 to 1


@dataclass(frozen=True)
class Mechanism:
    """Everything that an engine needs, and nothing that only a reader needs.

    `bodies` are in order: a parent stands before its children.
    """

    bodies: tuple[Body, ...]
    sites: tuple[Site, ...] = ()
    strings: tuple[String, ...] = ()
    pulls: tuple[Pull, ...] = ()
    collisions: tuple[Collision, ...] = ()
    gravity: Vector = (0.0, 0.0, -GRAVITY)

    @cached_property
    def coordinates(self) -> tuple[Coordinate, ...]:
        """All coordinates, body by body: the order of q, v and a in every engine and trace."""
        return tuple(c for body in self.bodies for c in body.coordinates)

    @cached_property
    def body(self) -> dict[str, Body]:
        """Bodies by name."""
        return {body.name: body for body in self.bodies}

    @cached_property
    def site(self) -> dict[str, Site]:
        """Sites by name."""
        return {site.name: site for site in self.sites}

    @cached_property
    def contacts(self) -> dict[str, Contact]:
        """Contacts by the name of the body that lies on its parent."""
        return {body.name: body.contact for body in self.bodies if body.contact is not None}

"""Where the bodies and sites of a mechanism are, as linear functions of its slide coordinates.

Frames never turn, so a point stands at `at` + Σ axis·q over the slides that carry it, and hinges move no
point: they turn wheels about their own axles.
"""

import itertools
from dataclasses import dataclass
from math import hypot

import numpy as np

from sim2reason.dsl.mechanism import ZERO, Body, Mechanism, Site, Vector
from sim2reason.dsl.state import Array
from sim2reason.errors import UnsupportedError

ALIGNED = 1e-9  # how far two unit vectors may differ and still be called parallel

Steps = tuple[tuple[int, Vector], ...]  # (number of a coordinate or contact, unit vector)


@dataclass(frozen=True, slots=True)
class Point:
    """A point that slides carry; `normals` are the directions in which contacts hold what carries it."""

    at: Vector  # in the room, at the start, m
    slides: Steps = ()  # numbers in the order of `mechanism.coordinates`
    normals: Steps = ()  # numbers in the order of `mechanism.contacts`


@dataclass(frozen=True, slots=True)
class Kinematics:
    """The points of a mechanism; those of a body stand for its centre of mass."""

    bodies: dict[str | None, Point]
    sites: dict[str, Point]
    hinges: dict[str, int]  # the number of the hinge of each body that has one


def dot(a: Vector, b: Vector) -> float:
    """The scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def kinematics(mechanism: Mechanism) -> Kinematics:
    """Walk the tree of bodies once.

    Raises:
        UnsupportedError: a hinge carries something off its axle, so that a frame would turn.
    """
    bodies: dict[str | None, Point] = {None: Point(ZERO)}
    hinges: dict[str, int] = {}
    first = contacts = 0
    for body in mechanism.bodies:
        parent = bodies[body.parent]
        if body.parent in hinges:
            _check_carried(body, _axis(mechanism.body[str(body.parent)]))
        slides, hinge = _steps(body, first)
        if hinge is not None:
            hinges[body.name] = hinge
        normals: Steps = () if body.contact is None else ((contacts, _plain(body.contact.normal)),)
        bodies[body.name] = Point(_sum(parent.at, body.at), parent.slides + slides, parent.normals + normals)
        first += len(body.coordinates)
        contacts += len(normals)
    return Kinematics(bodies, _sites(mechanism, bodies, hinges), hinges)


def _sites(mechanism: Mechanism, bodies: dict[str | None, Point], hinges: dict[str, int]) -> dict[str, Point]:
    sites: dict[str, Point] = {}
    for site in mechanism.sites:
        if site.body is not None and site.body in hinges:
            _check_on_axle(site.name, site.at, _axis(mechanism.body[site.body]))
        carrier = bodies[site.body]
        sites[site.name] = Point(_sum(carrier.at, site.at), carrier.slides, carrier.normals)
    return sites


def _steps(body: Body, first: int) -> tuple[Steps, int | None]:
    """The slides of a body itself, and the number of its hinge."""
    slides: Steps = ()
    hinge: int | None = None
    for number, coordinate in enumerate(body.coordinates, start=first):
        if coordinate.kind == "slide":
            slides = (*slides, (number, _plain(coordinate.axis)))
        elif hinge is None:
            hinge = number
        else:
            raise UnsupportedError(f"{body.name}: it turns about two axes; give a wheel one axle")
    return slides, hinge


def _axis(wheel: Body) -> Vector:
    return next(c.axis for c in wheel.coordinates if c.kind == "hinge")


def _check_carried(body: Body, axis: Vector) -> None:
    """What a wheel carries must not notice that it turns: a welded point mass on the axle."""
    _check_on_axle(body.name, body.at, axis)
    if body.coordinates or body.inertia:
        raise UnsupportedError(f"{body.name}: a turning wheel carries it; fix it to what carries the axle")


def _check_on_axle(name: str, at: Vector, axis: Vector) -> None:
    along = dot(at, axis)
    off = hypot(at[0] - along * axis[0], at[1] - along * axis[1], at[2] - along * axis[2])
    if off > ALIGNED * (1.0 + abs(along)):
        raise UnsupportedError(f"{name}: it lies {off:.3g} m off the axle of the wheel that carries it")


def _sum(a: Vector, b: Vector) -> Vector:
    return _plain((a[0] + b[0], a[1] + b[1], a[2] + b[2]))


def _plain(vector: Vector) -> Vector:
    """Whoever computes a direction with NumPy passes its scalars on, which are slow and print badly."""
    return (float(vector[0]), float(vector[1]), float(vector[2]))


def slides_of(mechanism: Mechanism, body: str | None) -> Steps:
    """The slides that carry one body, from the room outwards; KeyError for a name that is no body's."""
    slides: Steps = ()
    while body is not None:
        found = mechanism.body[body]
        own = tuple((_number(mechanism, c.name), c.axis) for c in found.coordinates if c.kind == "slide")
        slides, body = own + slides, found.parent
    return slides


def hinge_of(mechanism: Mechanism, body: str) -> int | None:
    """The number of a body's own hinge, or None."""
    return next((_number(mechanism, c.name) for c in mechanism.body[body].coordinates if c.kind == "hinge"), None)


def points_of(mechanism: Mechanism, sites: tuple[str, ...]) -> tuple[Point, ...]:
    """Some sites, without a look at all the others."""
    return tuple(_point_of(mechanism, mechanism.site[name]) for name in sites)


def _point_of(mechanism: Mechanism, site: Site) -> Point:
    at, body = site.at, site.body
    while body is not None:
        at, body = _sum(at, mechanism.body[body].at), mechanism.body[body].parent
    return Point(at, slides_of(mechanism, site.body))


def _number(mechanism: Mechanism, coordinate: str) -> int:
    return next(number for number, c in enumerate(mechanism.coordinates) if c.name == coordinate)


def carried(slides: Steps, values: Array) -> Array:
    """Σ axis·value over slides: from q a displacement, from v a velocity, from a an acceleration.

    `values` has the shape (n, number of coordinates), the result (n, 3).
    """
    total = np.zeros((len(values), 3))
    for number, axis in slides:
        total += values[:, number, None] * np.array(axis)
    return total


def lengths(points: tuple[Point, ...], q: Array, v: Array) -> tuple[Array, Array]:
    """The sum of the distances between consecutive points, m, and its rate, m/s; both (n,).

    Where two points coincide their distance has no rate, and 0 stands for it.
    """
    length, rate = np.zeros(len(q)), np.zeros(len(q))
    for a, b in itertools.pairwise(points):
        apart = np.subtract(b.at, a.at) + carried(b.slides, q) - carried(a.slides, q)
        parting = carried(b.slides, v) - carried(a.slides, v)
        distance = np.sqrt(np.einsum("ij,ij->i", apart, apart))
        length += distance
        rate += np.einsum("ij,ij->i", apart, parting) / np.where(distance > 0.0, distance, 1.0)
    return length, rate

"""A mechanism as numbers: mass matrix, forces and the gradients of all that can act, constant throughout.

Unknowns are the n coordinates and, for each of the c contacts, the distance that the body would rise from
its face. That distance stays zero; its row of the equations of motion gives the normal force.
"""

from dataclasses import dataclass
from math import hypot

from sim2reason.dsl.kinematics import ALIGNED, Kinematics, Point, Steps, dot, kinematics
from sim2reason.dsl.mechanism import Body, Collision, Mechanism, Pull, String, Vector
from sim2reason.errors import SceneError, UnsupportedError
from sim2reason.simulation.engines.exact.linear import Row, solve

TOUCHING = 1e-9  # m; two lengths that differ by less are one length


@dataclass(frozen=True, slots=True)
class Gradient:
    """How a length changes with the coordinates, and with the rises of the contacts."""

    along: Row  # (n,)
    lift: Row  # (c,)
    terms: tuple[tuple[int, float], ...]  # the entries of `along` that are not zero

    def rate(self, values: Row) -> float:
        """The rate of change, from velocities or accelerations."""
        return sum(factor * values[number] for number, factor in self.terms)


@dataclass(frozen=True, slots=True)
class Run:
    """A straight piece of string between two sites that move towards or away from each other."""

    sites: tuple[str, str]
    length: float  # m, at the start
    gradient: Gradient


@dataclass(frozen=True, slots=True)
class Limit:
    """One end of a coordinate's travel: the room left is `room` + `sign`·q."""

    coordinate: int
    name: str
    room: float
    sign: float


@dataclass(frozen=True, slots=True)
class Grip:
    """A rough contact: its number among the contacts, and the coordinate along which it rubs."""

    contact: int
    coordinate: int
    friction: float


@dataclass(frozen=True, slots=True)
class Pair:
    """Two bodies that may collide: their separation is `apart` + Σ axis·q."""

    names: tuple[str, str]
    distance: float
    restitution: float
    apart: Vector
    slides: Steps
    normals: Steps
    movable: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Equations:
    """Mass matrix, loads and gradients; a square matrix M for the coordinates, `lifted` for the rises."""

    mechanism: Mechanism
    mass: list[Row]  # (n, n), kg or kg m²
    lifted: list[Row]  # (c, n), kg
    force: Row  # (n,), gravity and pulls, N or N m
    press: Row  # (c,), N
    strings: tuple[Gradient, ...]
    slack: Row  # of each string at the start, m
    runs: tuple[Run, ...]
    limits: tuple[Limit, ...]
    grips: tuple[Grip, ...]
    pairs: tuple[Pair, ...]
    weightless: tuple[Row, ...]  # motions that need no force at all: a basis of the null space of `mass`


def equations(mechanism: Mechanism) -> Equations:
    """Read a mechanism; its numbers become plain floats, whatever they were.

    Raises:
        UnsupportedError: a string would bend as it moves, a wheel carries something off its axle, or a
            rough body slides in two directions.
        SceneError: two bodies overlap, or two sites of a string coincide, at the start.
    """
    points = kinematics(mechanism)
    n, c = len(mechanism.coordinates), len(mechanism.contacts)
    index = {coordinate.name: number for number, coordinate in enumerate(mechanism.coordinates)}
    grips = _grips(mechanism, index)
    mass, lifted, force, press = _inertia(mechanism, points, n, c)
    runs: dict[tuple[str, str], Run] = {}
    strings = tuple(_gradient(line, points, index, (n, c), runs) for line in mechanism.strings)
    for pull in mechanism.pulls:
        gradient = _gradient(pull, points, index, (n, c), runs)
        hand = float(pull.force)
        force = [a - hand * b for a, b in zip(force, gradient.along, strict=True)]
        press = [a - hand * b for a, b in zip(press, gradient.lift, strict=True)]
    pairs = tuple(_pair(collision, points) for collision in mechanism.collisions)
    weightless: tuple[Row, ...] = ()
    if any(body.coordinates and body.mass == 0.0 for body in mechanism.bodies):
        weightless = tuple(solve([[*row, 0.0] for row in mass]).nulls)
    limits, slack = _limits(mechanism), [float(string.slack) for string in mechanism.strings]
    return Equations(
        mechanism, mass, lifted, force, press, strings, slack, tuple(runs.values()), limits, grips, pairs, weightless
    )


def _inertia(mechanism: Mechanism, points: Kinematics, n: int, c: int) -> tuple[list[Row], list[Row], Row, Row]:
    """M = Σ m JᵀJ + hinge inertias, and the weight of each body on what carries it."""
    mass = [[0.0] * n for _ in range(n)]
    lifted = [[0.0] * n for _ in range(c)]
    force, press = [0.0] * n, [0.0] * c
    for body in mechanism.bodies:
        hinge = points.hinges.get(body.name)
        if hinge is not None:
            mass[hinge][hinge] += float(body.inertia)
        if body.mass == 0.0:
            continue
        point, weight = points.bodies[body.name], float(body.mass)
        for steps, matrix, load in ((point.slides, mass, force), (point.normals, lifted, press)):
            for i, axis in steps:
                load[i] += weight * dot(axis, mechanism.gravity)
                row = matrix[i]
                for j, other in point.slides:
                    row[j] += weight * dot(axis, other)
    return mass, lifted, force, press


def _gradient(
    line: String | Pull,
    points: Kinematics,
    index: dict[str, int],
    size: tuple[int, int],
    runs: dict[tuple[str, str], Run],
) -> Gradient:
    """The gradient of a string's length; enters its runs, which strings may share, into `runs`."""
    along, lift = [0.0] * size[0], [0.0] * size[1]
    for wheel in line.wheels:
        along[index[wheel.coordinate]] += float(wheel.radius)
    for pair in zip(line.through, line.through[1:], strict=False):
        run = runs.get(pair) or _run(line.name, pair, points, size)
        if run is None:
            continue
        runs[pair] = run
        along = [a + b for a, b in zip(along, run.gradient.along, strict=True)]
        lift = [a + b for a, b in zip(lift, run.gradient.lift, strict=True)]
    return _filled(along, lift)


def _run(name: str, sites: tuple[str, str], points: Kinematics, size: tuple[int, int]) -> Run | None:
    """The run between two sites, or None if they never move relative to each other."""
    first, last = points.sites[sites[0]], points.sites[sites[1]]
    slides, normals = _relative(first, last)
    if not slides and not normals:
        return None
    apart = _difference(first, last)
    length = hypot(*apart)
    if length <= TOUCHING:
        raise SceneError(name, f"sites {sites[0]} and {sites[1]} coincide at the start", "leave some string between")
    direction = (apart[0] / length, apart[1] / length, apart[2] / length)
    along, lift = [0.0] * size[0], [0.0] * size[1]
    for number, axis in slides:
        part = dot(axis, direction)
        if hypot(*(a - part * d for a, d in zip(axis, direction, strict=True))) > ALIGNED:
            raise UnsupportedError(f"{name}: it bends as it moves, between {sites[0]} and {sites[1]}")
        along[number] += part
    for number, axis in normals:
        lift[number] += dot(axis, direction)
    return Run(sites, length, _filled(along, lift))


def _filled(along: Row, lift: Row) -> Gradient:
    return Gradient(along, lift, tuple((number, part) for number, part in enumerate(along) if part != 0.0))


def _relative(first: Point, last: Point) -> tuple[Steps, Steps]:
    """The slides and normals that move `last` but not `first`, and, turned round, those that move only `first`."""
    return _uncommon(first.slides, last.slides), _uncommon(first.normals, last.normals)


def _uncommon(first: Steps, last: Steps) -> Steps:
    common = 0
    for a, b in zip(first, last, strict=False):
        if a[0] != b[0]:
            break
        common += 1
    turned = tuple((number, (-axis[0], -axis[1], -axis[2])) for number, axis in first[common:])
    return turned + last[common:]


def _difference(first: Point, last: Point) -> Vector:
    return (last.at[0] - first.at[0], last.at[1] - first.at[1], last.at[2] - first.at[2])


def _limits(mechanism: Mechanism) -> tuple[Limit, ...]:
    limits: list[Limit] = []
    for number, coordinate in enumerate(mechanism.coordinates):
        if coordinate.lower > -float("inf"):
            limits.append(Limit(number, coordinate.name, -float(coordinate.lower), 1.0))
        if coordinate.upper < float("inf"):
            limits.append(Limit(number, coordinate.name, float(coordinate.upper), -1.0))
    return tuple(limits)


def _grips(mechanism: Mechanism, index: dict[str, int]) -> tuple[Grip, ...]:
    grips: list[Grip] = []
    for number, (name, contact) in enumerate(mechanism.contacts.items()):
        _check_face(mechanism.body[name])
        if contact.friction > 0.0:
            grips.append(Grip(number, index[contact.along], float(contact.friction)))
    return tuple(grips)


def _check_face(body: Body) -> None:
    """A contact's normal is square to all ways in which its body moves, and a rough body moves in one."""
    contact = body.contact
    slides = [coordinate for coordinate in body.coordinates if coordinate.kind == "slide"]
    if contact is None or not any(slide.name == contact.along for slide in slides):
        raise SceneError(body.name, "it rests on a face but has no slide along it", "let it slide along the face")
    if any(abs(dot(slide.axis, contact.normal)) > ALIGNED for slide in slides):
        raise UnsupportedError(f"{body.name}: it slides off the face that it rests on")
    if contact.friction > 0.0 and len(slides) > 1:
        raise UnsupportedError(f"{body.name}: a rough contact that slides in two directions has no model here")


def _pair(collision: Collision, points: Kinematics) -> Pair:
    first, last = points.bodies[collision.a], points.bodies[collision.b]
    slides, normals = _relative(first, last)
    apart = _difference(first, last)
    if hypot(*apart) < collision.distance - TOUCHING:
        raise SceneError(collision.a, f"it overlaps {collision.b} at the start", "move them apart")
    movable = tuple(name for name in (collision.a, collision.b) if points.bodies[name].slides)
    names = (collision.a, collision.b)
    return Pair(names, float(collision.distance), float(collision.restitution), apart, slides, normals, movable)

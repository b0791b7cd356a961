"""Mirrored and scaled scenes, and integrals of powers and forces over a motion."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from sim2reason.scenes.dsl.fields import Law
from sim2reason.scenes.dsl.mechanism import Coordinate, Force, Line, Mechanism, RigidBody
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.vectors import Maths, Number, Region, Triple, Vector, subtract_triples
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.trace import Trace


def polar(vector: Triple) -> Triple:
    """Return the mirror image of a polar vector, such as a position, velocity, force or direction."""
    return (-vector[0], vector[1], vector[2])


def axial(vector: Vector) -> Vector:
    """Return the mirror image of an axial vector, such as an angular velocity."""
    return (vector[0], -vector[1], -vector[2])


@dataclass(frozen=True, slots=True)
class MirroredLaw:
    """The mirror image of a force law, evaluated at mirrored positions."""

    law: Law

    def force(self, place: Triple, velocity: Triple, time: Number, maths: Maths) -> Triple:
        """Return the mirror image of the law's force at the mirrored position."""
        return polar(self.law.force(polar(place), polar(velocity), time, maths))

    def potential(self, place: Triple, maths: Maths) -> Number | None:
        """Return the potential at the mirrored position."""
        return self.law.potential(polar(place), maths)

    @property
    def constant(self) -> bool:
        """Return whether the original law is constant."""
        return self.law.constant

    def moved(self, by: Vector) -> "MirroredLaw":
        """Return the mirrored force law after a shift of its origin."""
        return MirroredLaw(self.law.moved(polar(by)))


@dataclass(frozen=True, slots=True)
class MirroredRegion:
    """The mirror image of a region."""

    region: Region

    def margins(self, place: Triple, maths: Maths) -> tuple[Number, ...]:
        """Return the distances of a position from the borders of the mirrored region."""
        return self.region.margins(polar(place), maths)

    def moved(self, by: Vector) -> "MirroredRegion":
        """Return the mirrored region shifted by a vector."""
        return MirroredRegion(self.region.moved(polar(by)))


def mirrored(mechanism: Mechanism) -> Mechanism:
    """Return the mirror image of a mechanism, with the same coordinate values."""
    return replace(
        mechanism,
        bodies=tuple(map(_body, mechanism.bodies)),
        sites=tuple(replace(site, at=polar(site.at)) for site in mechanism.sites),
        faces=tuple(replace(face, normal=polar(face.normal)) for face in mechanism.faces),
        feet=tuple(replace(foot, normal=polar(foot.normal), along=polar(foot.along)) for foot in mechanism.feet),
        forces=tuple(
            replace(
                force,
                law=MirroredLaw(force.law),
                region=None if force.region is None else MirroredRegion(force.region),
            )
            for force in mechanism.forces
        ),
        burns=tuple(replace(burn, direction=polar(burn.direction)) for burn in mechanism.burns),
        meetings=tuple(
            replace(hit, normal=None if hit.normal is None else polar(hit.normal)) for hit in mechanism.meetings
        ),
        gravity=polar(mechanism.gravity),
    )


def _body(body: RigidBody) -> RigidBody:
    xx, yy, zz, xy, xz, yz = body.inertia
    return replace(
        body,
        at=polar(body.at),
        center=polar(body.center),
        inertia=(xx, yy, zz, -xy, -xz, yz),
        coordinates=tuple(map(_coordinate, body.coordinates)),
    )


def _coordinate(coordinate: Coordinate) -> Coordinate:
    axis = polar(coordinate.axis) if coordinate.kind == "slide" else axial(coordinate.axis)
    return replace(coordinate, axis=axis)


GAUSS_NODES = 10  # Gauss-Legendre nodes in each piece of an interval between events
MAX_HALVINGS = 12  # at most
CONVERGENCE_RTOL = 1e-10  # relative change at which an integral has converged
RATE_FLOOR = 1e-9  # m/s; slower lines do no work, whatever their tension
POINTS, WEIGHTS = np.polynomial.legendre.leggauss(GAUSS_NODES)


def intervals(trace: Trace, end: float) -> list[tuple[float, float]]:
    """Return the intervals between events, s, up to a time."""
    times = [event.time for event in trace.events if event.changes_motion and 0.0 < event.time < end]
    return [(a, b) for a, b in pairwise([0.0, *sorted(times), end]) if b - a > 1e-9 * end]


class Integrals(NamedTuple):
    """Integrals over time, and those of the absolute values."""

    values: Array
    sizes: Array


def integrals(trace: Trace, start: float, stop: float, integrand: Callable[[State], Array], floor: float) -> Integrals:
    """Return the integrals of k functions, with values (k, n) from `integrand`, by Gauss-Legendre quadrature.

    Both results have the shape (k,); NaN where a value is unknown. Pieces are halved until their integrals converge.
    Integrals much smaller than `floor` count as zero.
    """
    pieces = np.array([[start, stop]])
    values, sizes = _pieces(trace, pieces, integrand)
    total, size = np.zeros(values.shape[0]), np.zeros(values.shape[0])
    for _ in range(MAX_HALVINGS):
        middle = pieces.mean(axis=1)
        halves = np.stack([pieces[:, 0], middle, middle, pieces[:, 1]], axis=1).reshape(-1, 2)
        finer, larger = _pieces(trace, halves, integrand)
        scale = max(float(np.max(size + larger.sum(axis=1), initial=0.0)), floor)
        errors = np.abs(finer.reshape(len(finer), -1, 2).sum(axis=2) - values)
        rough = (errors > CONVERGENCE_RTOL * scale).any(axis=0)
        kept = np.repeat(~rough, 2)
        total, size = total + finer[:, kept].sum(axis=1), size + larger[:, kept].sum(axis=1)
        pieces, values, sizes = halves[~kept], finer[:, ~kept], larger[:, ~kept]
        if not len(pieces):
            break
    return Integrals(total + values.sum(axis=1), size + sizes.sum(axis=1))


def _pieces(trace: Trace, pieces: Array, integrand: Callable[[State], Array]) -> tuple[Array, Array]:
    """Return the integrals of k functions and of their absolute values over m pieces, both (k, m)."""
    half, middle = 0.5 * (pieces[:, 1] - pieces[:, 0]), pieces.mean(axis=1)
    times = middle[:, None] + half[:, None] * POINTS
    values = integrand(trace.sample(times.ravel())).reshape(-1, *times.shape)
    return np.einsum("kmn,n,m->km", values, WEIGHTS, half), np.einsum("kmn,n,m->km", np.abs(values), WEIGHTS, half)


def edges(start: float, stop: float) -> Array:
    """Return the times just after the start and just before the end of an interval, s."""
    return np.array([start, stop - 1e-12 * max(stop, stop - start)])


def kinetic(state: State) -> Array:
    """Return the kinetic energy of all bodies, J, (n,)."""
    return np.sum([QUANTITIES["kinetic energy"].evaluate(state, name) for name in state.mechanism.body], axis=0)


def powers(state: State) -> dict[str, Array]:
    """Return the power of each force that does work, W, by name; NaN where a force is undetermined."""
    mechanism, power_by_name = state.mechanism, dict[str, Array]()
    g = np.array(mechanism.gravity)
    for body in mechanism.bodies:
        power_by_name[f"weight of {body.name}"] = body.mass * _velocity(state, body.name) @ g
    for line in mechanism.lines:
        power_by_name[f"tension of {line.name}"] = _working(state.tension[line.name], -_rate(state, line))
    for face in mechanism.faces:
        slip = sum(factor * state.v[:, mechanism.number[name]] for name, factor in face.slip)
        power_by_name[f"friction under {face.subject}"] = _working(
            state.friction[face.subject], slip + np.zeros(state.times.shape)
        )
    for force in mechanism.forces:
        power_by_name[f"the force {force.name}"] = np.einsum(
            "ij,ij->i", acting(state, force), _velocity(state, force.body)
        )
    for pair, pull in attractions(state):
        parting = _velocity(state, pair[0]) - _velocity(state, pair[1])
        power_by_name[f"attraction of {' and '.join(pair)}"] = np.einsum("ij,ij->i", pull, parting)
    return power_by_name


def _velocity(state: State, body: str) -> Array:
    return QUANTITIES["velocity"].evaluate(state, body)


def _working(force: Array, rate: Array) -> Array:
    """Return force times rate; zero where the rate is zero, even if the force is undetermined."""
    idle = np.abs(rate) <= RATE_FLOOR
    return np.where(idle, 0.0, np.where(idle, 0.0, force) * rate)


def _rate(state: State, line: Line) -> Array:
    """Return the rate of change of a line's free length, with the feed of winches, m/s."""
    return state.free_length(line)[1]


def acting(state: State, force: Force) -> Array:
    """Return an applied force at all times, N, (n, 3); zero outside its region."""
    center = state.frames.center(force.body)
    force_vectors = state.vector(force.law.force(center.place, center.velocity, state.times, np))
    if force.region is None:
        return force_vectors
    margins = [state.vector((margin, 0.0, 0.0))[:, 0] for margin in force.region.margins(center.place, np)]
    return force_vectors * (np.min(margins, axis=0) > 0.0)[:, None]


def attractions(state: State) -> Iterator[tuple[tuple[str, str], Array]]:
    """Yield the pairs of attracting bodies, with the force on the first, N, (n, 3)."""
    mechanism = state.mechanism
    for pair in mechanism.attractions:
        separation = state.vector(
            subtract_triples(state.frames.center(pair.b).place, state.frames.center(pair.a).place)
        )
        distance = np.linalg.norm(separation, axis=1)[:, None]
        strength = pair.constant * mechanism.body[pair.a].mass * mechanism.body[pair.b].mass
        yield (pair.a, pair.b), strength * separation / distance ** (pair.power + 1.0)


def movable(mechanism: Mechanism) -> Iterator[Coordinate]:
    """Yield the coordinates along which a body slides before any rotation."""
    for body in mechanism.bodies:
        if body.parent is None:
            for coordinate in body.coordinates:
                if coordinate.kind == "hinge":
                    break
                yield coordinate


def carried_bodies(mechanism: Mechanism, root: str) -> set[str | None]:
    """Return the names of a body and all bodies that it carries, directly or indirectly."""
    names: set[str | None] = {root}
    for body in mechanism.bodies:
        if body.parent in names:
            names.add(body.name)
    return names


def momentum(state: State, coordinate: Coordinate) -> Array:
    """Return the momentum of a body with all that it carries along a coordinate, kg m/s, (n,)."""
    names = carried_bodies(state.mechanism, coordinate.body)
    parts = [QUANTITIES["momentum"].evaluate(state, name) for name in state.mechanism.body if name in names]
    return np.sum(parts, axis=0) @ np.array(coordinate.axis)


def external_force(state: State, coordinate: Coordinate) -> Array:
    """Return the external force on a body with all that it carries along a coordinate, N, (n,)."""
    mechanism, axis = state.mechanism, np.array(coordinate.axis)
    names = carried_bodies(mechanism, coordinate.body)
    mass = sum(body.mass for body in mechanism.bodies if body.name in names)
    total = np.full(state.times.shape, mass * float(np.dot(mechanism.gravity, axis)))
    for line in mechanism.lines:
        for first, last in pairwise(line.through):
            inside = [mechanism.site[site].body in names for site in (first, last)]
            if inside[0] != inside[1]:
                segment = subtract_triples(state.frames.site(last).place, state.frames.site(first).place)
                along = state.vector(segment) @ axis / np.linalg.norm(state.vector(segment), axis=1)
                total = total + _working(state.tension[line.name], along * (1.0 if inside[0] else -1.0))
    for face in mechanism.faces:
        factor = dict(face.slip).get(coordinate.name, 0.0)
        if factor:
            total = total + factor * state.friction[face.subject]
    for force in mechanism.forces:
        if force.body in names:
            total = total + acting(state, force) @ axis
    for pair, pull in attractions(state):
        total = total + (pull @ axis) * ((pair[0] in names) - (pair[1] in names))
    return total

"""Balances of a motion: energy and work, momentum and impulse, angular momentum and the impulse of torques.

Integrals are taken by Gauss's rule over every step of the exact engine; positions and velocities are sums over bodies,
written here with `Frames` alone, and forces are those that the engine reports.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from sim2reason.scenes.dsl.frames import Frames
from sim2reason.scenes.dsl.mechanism import ConstantTension, Elastic, Force, Inextensible, Line
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.engines.exact import Motion

NODES, WEIGHTS = np.polynomial.legendre.leggauss(8)
BEFORE = 1e-12  # s: how long before an event its left side is looked at
SHORT = 1e-6  # s: what lasts less is no span of time to integrate over


def array(vector: object, like: Array) -> Array:
    """Return a triple of numbers or arrays as an array of shape (m, 3)."""
    return np.stack([np.broadcast_to(np.asarray(part, dtype=float), like.shape) for part in vector], axis=1)  # type: ignore[attr-defined]


class Moment:
    """Mechanism at many instants."""

    def __init__(self, state: State) -> None:
        self.state, self.mechanism, self.times = state, state.mechanism, state.times
        self.frames = Frames(state.mechanism, list(state.q.T), list(state.v.T), np)
        self.moving = {body.name for body in self.mechanism.bodies if self.frames.center(body.name).gradient}

    def place(self, body: str) -> Array:
        return array(self.frames.center(body).place, self.times)

    def velocity(self, body: str) -> Array:
        return array(self.frames.center(body).velocity, self.times)

    # ---- energy

    def kinetic(self) -> Array:
        total = np.zeros(len(self.times))
        for body in self.mechanism.bodies:
            velocity = self.velocity(body.name)
            total += 0.5 * body.mass * (velocity * velocity).sum(axis=1)
            frame = self.frames[body.name]
            if frame.spin is not None and any(body.inertia):
                xx, yy, zz, xy, xz, yz = body.inertia
                tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
                spin = array(frame.to_body_axes(frame.spin), self.times)
                total += 0.5 * np.einsum("mi,ij,mj->m", spin, tensor, spin)
        return total

    def potential(self) -> Array:
        """Return the potential energy of weight, springs, attractions and forces with a potential."""
        total = np.zeros(len(self.times))
        for body in self.mechanism.bodies:
            total -= body.mass * self.place(body.name) @ np.array(self.mechanism.gravity)
        for line in self.mechanism.lines:
            if isinstance(line.law, Elastic):
                total += 0.5 * line.law.stiffness * (self.length(line) - line.law.length) ** 2
        for pair in self.mechanism.attractions:
            apart = np.linalg.norm(self.place(pair.a) - self.place(pair.b), axis=1)
            masses = self.mechanism.body[pair.a].mass * self.mechanism.body[pair.b].mass
            total -= pair.constant * masses / apart
        for force in self.mechanism.forces:
            found = force.law.potential(self.frames.center(force.body).place, np)
            if force.region is None and found is not None:
                total += found
        return total

    def power(self) -> Array:
        """Return the power of friction, damping, hands, winches and forces without a potential."""
        total = np.zeros(len(self.times))
        number = self.mechanism.number
        for face in self.mechanism.faces:
            slip = sum(factor * self.state.v[:, number[name]] for name, factor in face.slip)
            total += np.where(np.abs(slip) > 1e-9, slip * self.state.friction[face.subject], 0.0)
        for line in self.mechanism.lines:
            if isinstance(line.law, Elastic):
                total -= line.law.damping * self.rate(line) ** 2
            elif isinstance(line.law, ConstantTension):
                total -= line.law.force * self.rate(line)
            elif isinstance(line.law, Inextensible) and line.law.reel:
                total += line.law.reel * self.state.tension[line.name]
        for force in self.mechanism.forces:
            if force.region is not None or force.law.potential(self.frames.center(force.body).place, np) is None:
                total += (self.field(force) * self.velocity(force.body)).sum(axis=1)
        return total

    # ---- forces

    def length(self, line: Line) -> Array:
        return np.asarray(self.frames.length(line)) + self._wheels(line, self.state.q)

    def rate(self, line: Line) -> Array:
        runs = (self.frames.distance(*sites).rate for sites in pairwise(line.through))
        return sum(runs, self._wheels(line, self.state.v))

    def _wheels(self, line: Line, values: Array) -> Array:
        found = np.zeros(len(self.times))
        for wheel in line.wheels:
            found += wheel.radius * values[:, self.mechanism.number[wheel.coordinate]]
        return found

    def tension(self, line: Line) -> Array:
        law = line.law
        if isinstance(law, Elastic):
            return law.stiffness * (self.length(line) - law.length) + law.damping * self.rate(line)
        return (
            np.full(len(self.times), law.force) if isinstance(law, ConstantTension) else self.state.tension[line.name]
        )

    def field(self, force: Force) -> Array:
        """Return a force, which is zero outside its region."""
        point = self.frames.center(force.body)
        found = array(force.law.force(point.place, point.velocity, self.times, np), self.times)
        if force.region is None:
            return found
        margins = np.array([np.broadcast_to(m, self.times.shape) for m in force.region.margins(point.place, np)])
        return found * (margins > 0.0).all(axis=0)[:, None]

    def outside(self) -> Iterator[tuple[Array, Array]]:
        """Yield the point of action and the value of every force on a moving body, each of shape (m, 3).

        Pairs of internal forces cancel in the sum.
        """
        for body in self.mechanism.bodies:
            if body.name in self.moving:
                weight = body.mass * np.array(self.mechanism.gravity)
                yield self.place(body.name), np.broadcast_to(weight, (len(self.times), 3))
        for force in self.mechanism.forces:
            yield self.place(force.body), self.field(force)
        for pair in self.mechanism.attractions:
            apart = self.place(pair.b) - self.place(pair.a)
            masses = self.mechanism.body[pair.a].mass * self.mechanism.body[pair.b].mass
            pull = pair.constant * masses * apart / np.linalg.norm(apart, axis=1)[:, None] ** 3
            for name, sign in ((pair.a, 1.0), (pair.b, -1.0)):
                if name in self.moving:
                    yield self.place(name), sign * pull
        yield from self._pulled()
        yield from self._pressed()

    def _pulled(self) -> Iterator[tuple[Array, Array]]:
        """Yield the forces of lines at the points through which they lead."""
        for line in self.mechanism.lines:
            tension = self.tension(line)[:, None]
            for first, last in pairwise(line.through):
                one, other = (array(self.frames.site(name).place, self.times) for name in (first, last))
                pull = tension * (other - one) / np.linalg.norm(other - one, axis=1)[:, None]
                for site, place, sign in ((first, one, 1.0), (last, other, -1.0)):
                    if self.mechanism.site[site].body in self.moving:
                        yield place, sign * pull

    def _pressed(self) -> Iterator[tuple[Array, Array]]:
        """Yield the forces of the room's faces on the bodies that touch them."""
        for face in self.mechanism.faces:
            body = self.mechanism.body[face.subject]
            if body.parent is None:
                along = np.array(body.coordinates[0].axis)
                normal, friction = self.state.normal[face.subject], self.state.friction[face.subject]
                yield self.place(face.subject), np.outer(normal, face.normal) + np.outer(friction, along)

    def momentum(self) -> Array:
        masses = self.mechanism.body
        return sum((masses[name].mass * self.velocity(name) for name in self.moving), np.zeros((len(self.times), 3)))

    def angular_momentum(self) -> Array:
        """Return the angular momentum of all particles about the room's origin."""
        each = (
            self.mechanism.body[name].mass * np.cross(self.place(name), self.velocity(name)) for name in self.moving
        )
        return sum(each, np.zeros((len(self.times), 3)))


@dataclass(frozen=True)
class Account:
    """Errors of the balances over a time interval without events, relative to the largest entry of each."""

    energy: float
    momentum: float
    angular: float


def spans(motion: Motion) -> Iterator[tuple[float, float]]:
    """Return the time intervals between events."""
    borders = [*(segment.start for segment in motion.segments), motion.end]
    return ((a, b) for a, b in pairwise(borders) if b - a > SHORT)


def account(motion: Motion, start: float, end: float) -> Account:
    """Return the balances of one time interval."""
    last = end - BEFORE
    inner = motion.knots[(motion.knots > start) & (motion.knots < last)]
    edges = np.array([start, *inner, last])
    half = 0.5 * np.diff(edges)
    times = (0.5 * (edges[1:] + edges[:-1])[:, None] + half[:, None] * NODES[None, :]).ravel()
    weights = (half[:, None] * WEIGHTS[None, :]).ravel()
    during, ends = Moment(motion.state(times)), Moment(motion.state(np.array([start, last])))
    kinetic, potential, work = ends.kinetic(), ends.potential(), weights @ during.power()
    energy = kinetic + potential
    scale = max(float(during.kinetic().max()), float(np.abs(during.potential() - potential[0]).max()), abs(work), 1e-3)
    push, twist = np.zeros(3), np.zeros(3)
    for place, force in during.outside():
        push += weights @ force
        twist += weights @ np.cross(place, force)
    momentum, angular = ends.momentum(), ends.angular_momentum()
    return Account(
        abs(energy[1] - energy[0] - work) / scale,
        _relative(momentum, push, during.momentum()),
        _relative(angular, twist, during.angular_momentum()),
    )


def _relative(ends: Array, change: Array, during: Array) -> float:
    scale = max(float(np.abs(during).max()), float(np.abs(change).max()), 1e-3)
    return float(np.abs(ends[1] - ends[0] - change).max()) / scale

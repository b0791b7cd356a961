"""Equivalence of parsed scenes: same named bodies with the same motions, whatever entities they are made of.

Motions follow from the masses, the applied forces, and the dependence of bodies, lines and faces on the coordinates.
The choice of coordinates is arbitrary, so it is eliminated: with rows r, each the gradient of a meaningful quantity (a
body's position, a string's length, the distance of a body from its face), and the kinetic energy K, with a unit mass
added to every body, the products r·K⁻¹·s depend neither on the coordinates, nor on hidden lengths, nor on the position
of a part of the scene. They are compared together with the labels of the rows, up to the order of those without a name
in the text.

Where gradients change, they are compared at several positions, together with the curvature of paths and the forces of
springs and fields.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import chain, pairwise
from math import dist

import numpy as np

from sim2reason.scenes.dsl.frames import Frames, Point
from sim2reason.scenes.dsl.mechanism import (
    ZERO,
    CollisionPair,
    Elastic,
    Force,
    Line,
    Mechanism,
    PlaneContact,
    RigidBody,
    X,
    Y,
    Z,
)
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.state import Array
from sim2reason.scenes.dsl.structure import changing
from sim2reason.scenes.dsl.vectors import Tensor, apply_tensor, dot, subtract_triples

Label = tuple[object, ...]
Signature = tuple[object, ...]
GRADIENT_FLOOR = 1e-9  # √kg; a mass-weighted gradient shorter than this counts as zero
REFINEMENT_ROUNDS = 3  # of refining the labels of rows by those of their neighbours
TRIAL_DISPLACEMENTS = (0.0, 0.37, -0.23)  # displacements from the start at which mechanisms are compared: m, rad or s


def signature(scene: Scene, names: Mapping[str, str]) -> Signature:
    """Return a value that is equal for two equivalent scenes; `names` maps addresses to the bodies' names."""
    mechanism = scene.mechanism
    bending = bool(changing(mechanism))
    stages = TRIAL_DISPLACEMENTS if bending else TRIAL_DISPLACEMENTS[:1]
    compared = (_compared(_Rows(mechanism, names, stage, bending=bending)) for stage in stages)
    return (mechanism.gravity, mechanism.units.name, *compared)


def _compared(rows: "_Rows") -> tuple[object, ...]:
    """Return labels of all collisions, forces and attractions, and the refined labels of all gradients."""
    mechanism = rows.mechanism
    for body in mechanism.bodies:
        rows.body(body)
    for line in mechanism.lines:
        rows.line(line)
    for number, face in enumerate(mechanism.faces):
        rows.rise(("face", _rounded(face.friction), _rounded(face.static_ratio), face.guided, face.turning), number)
    for foot in mechanism.feet:
        rows.foot(foot)
    loads = sorted([*map(rows.hit, mechanism.meetings), *map(rows.push, mechanism.forces), *rows.pairs()], key=repr)
    return (tuple(loads), rows.refined())


class _Rows:
    """Labelled gradients of positions and lengths, with respect to coordinates and distances from surfaces."""

    def __init__(self, mechanism: Mechanism, names: Mapping[str, str], stage: float, *, bending: bool) -> None:
        self.mechanism, self._names, self._stage = mechanism, names, stage
        self._n = len(mechanism.coordinates)
        self._frames = self._going([coordinate.speed for coordinate in mechanism.coordinates])
        self._width = self._n + len(mechanism.faces)
        self._labels: list[Label] = []
        self._rows: list[Array] = []
        self._bends = self._curvature() if bending else {}

    def _going(self, speeds: Sequence[float]) -> Frames:
        return Frames(self.mechanism, [self._stage] * self._n, speeds, math)

    def _curvature(self) -> dict[str, Array]:
        """Return the curvature of each body's path, by name: 1/m times the square root of a mass.

        This is the mean curvature of the configuration surface in the metric of the masses: the component of the
        accelerations at q̈ = 0 orthogonal to the surface, summed over an orthonormal basis of rates.
        """
        bodies = self.mechanism.bodies
        roots = np.repeat([math.sqrt(body.mass + 1.0) for body in bodies], 3)
        spread = np.vstack([self._spread(self._frames.center(body.name))[:, : self._n] for body in bodies])
        basis, sizes, rates = np.linalg.svd(roots[:, None] * spread, full_matrices=False)
        kept = sizes > GRADIENT_FLOOR
        basis, rates = basis[:, kept], rates[kept] / sizes[kept, None]

        def biases(speeds: Array) -> Array:
            frames = self._going([float(speed) for speed in speeds])
            return roots * np.concatenate([frames.center(body.name).bias for body in bodies])

        total = sum((biases(speeds) for speeds in rates), np.zeros(len(roots))) - len(rates) * biases(np.zeros(self._n))
        total -= basis @ (basis.T @ total)
        return dict(zip((body.name for body in bodies), total.reshape(-1, 3), strict=True))

    def _name_of(self, address: str | None) -> str:
        return self._names.get(address or "", "")

    def _add(self, label: Label, row: Array) -> None:
        self._labels.append(label)
        self._rows.append(row)

    def _spread(self, point: Point) -> Array:
        """Return the gradient of a point's position, (3, n), by the coordinates and the distances from surfaces."""
        gradient = np.zeros((3, self._width))
        for number, axis in point.gradient.items():
            gradient[:, number] += axis
        for number, normal in point.lift.items():
            gradient[:, self._n + number] += normal
        return gradient

    def body(self, body: RigidBody) -> None:
        """Add a body's gradients, labelled by initial state and path curvature: three of position, more if it rotates.

        The principal moments of inertia are part of the label, since they affect rolling bodies at rest.
        """
        point, called = self._frames.center(body.name), self._name_of(body.name)
        spread = self._spread(point)
        bends = self._bends.get(body.name, np.zeros(3))
        for axis in range(3):
            bent = map(_rounded, (point.velocity[axis], point.bias[axis], round(bends[axis], 7)))
            self._add(("body", called, axis, body.mass, *bent, *_ends(body)), spread[axis])
        turns = self._turns(body)
        if turns:
            frame, inertia = self._frames[body.name], _matrix(body.inertia)
            spin = np.array(frame.to_body_axes(frame.turning.velocity))
            own = [*map(_rounded, np.linalg.eigvalsh(inertia)), _rounded(float(spin @ inertia @ spin))]
            for row in turns:
                self._add(("turn", called, *own), row)
        for burn in self.mechanism.burns:
            if burn.body == body.name:
                thrust = self._frames[body.name].turned(burn.direction)
                label = ("burn", called, burn.rate, burn.exhaust, burn.until)
                self._add(label, np.array(thrust) @ spread)

    def _turns(self, body: RigidBody) -> list[Array]:
        """Return the gradients of a body's angular velocity, times the root of its inertia; zero rows are omitted."""
        frame = self._frames[body.name]
        if frame.spin is None or not any(body.inertia):
            return []
        own = np.zeros((3, self._width))
        for number, axis in frame.turning.gradient.items():
            own[:, number] = frame.to_body_axes(axis)
        return [row for row in _root(body.inertia) @ own if np.abs(row).max() > 0.0]

    def hit(self, hit: CollisionPair) -> Label:
        """Return the label of a possible collision: the bodies' names, the restitution and the initial gap."""
        one, other = sorted((hit.a or "", hit.b), key=self._name_of)
        places = [self._frames.center(name).place if name else ZERO for name in (one, other)]
        separation = subtract_triples(places[1], places[0])
        if hit.normal is not None:
            along = dot(hit.normal, separation)
            separation = (along, 0.0, 0.0) if hit.a is not None else (abs(along) - hit.distance, 0.0, 0.0)
        numbers = [_rounded(number) for number in (hit.distance, hit.restitution, hit.sticks, *separation)]
        return "hit", self._name_of(one), self._name_of(other), repr(numbers)

    def push(self, force: Force) -> Label:
        """Return the label of a force: its value at several velocities, and the distances from its region's borders."""
        point = self._frames.center(force.body)
        velocities = (point.velocity, X, Y, Z)
        forces = [force.law.force(point.place, velocity, self._stage, math) for velocity in velocities]
        borders = () if force.region is None else force.region.margins(point.place, math)
        return "force", self._name_of(force.body), *map(_rounded, (*chain.from_iterable(forces), *borders))

    def pairs(self) -> list[Label]:
        """Return the labels of the pairs of bodies that attract each other, with their distances."""
        labels: list[Label] = []
        for pair in self.mechanism.attractions:
            distance = dist(self._frames.center(pair.a).place, self._frames.center(pair.b).place)
            both = sorted((self._name_of(pair.a), self._name_of(pair.b)))
            labels.append(("attraction", *both, pair.constant, pair.power, _rounded(distance)))
        return labels

    def line(self, line: Line) -> None:
        """Add the gradient of the length of a string, rod, spring or actuator, labelled by its force law.

        For a spring the extension counts, not its natural length, which may be hidden.
        """
        row, wound = np.zeros(self._width), 0.0
        for wheel in line.wheels:
            row[self.mechanism.number[wheel.coordinate]] += wheel.radius
            wound += wheel.radius * self._stage
        for first, last in pairwise(line.through):
            one, other = self._frames.site(first), self._frames.site(last)
            distance = dist(one.place, other.place)
            if distance > 0.0:
                separation = np.array(subtract_triples(other.place, one.place))
                row += separation / distance @ (self._spread(other) - self._spread(one))
        law, stretch = line.law, 0.0
        if isinstance(law, Elastic):
            stretch = self._frames.length(line) + wound - law.length
            law = replace(law, length=0.0)
        self._add(("line", self._name_of(line.name), law, _rounded(stretch)), row)

    def foot(self, foot: PlaneContact) -> None:
        """Add the gradients of the position of an edge that may touch a plane, along its normal and its surface."""
        point = self._frames.site(foot.site)
        gap = dot(foot.normal, point.place) - foot.height
        for direction in (foot.normal, foot.along):
            self._add(("foot", _rounded(gap)), np.array(direction) @ self._spread(point))

    def rise(self, label: Label, number: int) -> None:
        """Add the gradient of a body's distance from its surface, which counts as an additional coordinate."""
        row = np.zeros(self._width)
        row[self._n + number] = 1.0
        self._add(label, row)

    def refined(self) -> tuple[object, ...]:
        """Return the sorted labels of all gradients, each refined by the gradient's scalar products with all others."""
        if not self._rows:
            return ()
        rows = np.array(self._rows)
        product = rows @ np.linalg.pinv(self._kinetic()) @ rows.T
        turning = np.array([label[0] == "turn" for label in self._labels])
        product = np.where(turning[:, None] | turning, abs(product), product)  # no text tells which way a wheel turns
        product = np.round(product, 7) + 0.0
        labels: list[object] = list(self._labels)
        for _ in range(REFINEMENT_ROUNDS):
            keys = [hash((repr(labels[i]), product[i, i], _near(product[i], labels))) for i in range(len(labels))]
            labels = list(keys)
        return tuple(sorted(map(repr, labels)))

    def _kinetic(self) -> Array:
        """Return the mass matrix of the mechanism, with 1 kg added to the mass of every body so that it is regular."""
        total = np.zeros((self._width, self._width))
        for body in self.mechanism.bodies:
            spread = self._spread(self._frames.center(body.name))
            total += (body.mass + 1.0) * spread.T @ spread
            for row in self._turns(body):
                total += np.outer(row, row)
        return total


def _root(inertia: Tensor) -> Array:
    """Return the symmetric square root of an inertia tensor, (3, 3)."""
    values, axes = np.linalg.eigh(_matrix(inertia))
    return axes * np.sqrt(np.maximum(values, 0.0)) @ axes.T


def _matrix(inertia: Tensor) -> Array:
    return np.array([apply_tensor(inertia, axis) for axis in (X, Y, Z)])


def _near(products: Array, labels: list[object]) -> tuple[object, ...]:
    return tuple(sorted((repr(label), float(value)) for label, value in zip(labels, products, strict=True) if value))


def _rounded(value: float) -> float:
    return round(float(value), 9) + 0.0


def _ends(body: RigidBody) -> list[float]:
    """Return the displacements from the start at which a body's travel ends, such as at the ground."""
    return sorted(_rounded(end) for c in body.coordinates for end in (c.lower, c.upper) if math.isfinite(end))

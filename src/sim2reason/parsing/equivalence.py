"""When two readings are one: the same motions of the same named bodies, whatever entities they are made of.

Motions follow from masses, from the forces that are given, and from how bodies, strings and faces depend on
the coordinates. Coordinates themselves are a matter of taste, so they are eliminated: with rows r, each the
gradient of something that has a meaning (a body's place, a string's length, the rise of a body from its
face), and the kinetic energy K of unit masses added to all bodies, the products r·K⁻¹·s do not depend on the
choice of coordinates, nor on hidden lengths. They are compared together with the labels of the rows, up to
the order of those that have no name in the text.
"""

from collections.abc import Mapping
from itertools import pairwise

import numpy as np

from sim2reason.dsl.kinematics import Point, Steps, kinematics
from sim2reason.dsl.mechanism import Collision, Mechanism, Pull, String, Wheel
from sim2reason.dsl.scene import Scene
from sim2reason.dsl.state import Array

Label = tuple[object, ...]
Signature = tuple[object, ...]
ROUNDS = 3  # of refining labels by their neighbours


def signature(scene: Scene, names: Mapping[str, str]) -> Signature:
    """What two scenes have in common if they mean the same; `names` is what bodies are called, by address."""
    mechanism = scene.mechanism
    rows = _Rows(mechanism)
    for body in mechanism.bodies:
        rows.body(body.name, names.get(body.name, ""))
    for line in (*mechanism.strings, *mechanism.pulls):
        rows.line(line)
    for name, contact in mechanism.contacts.items():
        rows.rise(("face", round(contact.friction, 9)), list(mechanism.contacts).index(name))
    hits = sorted(rows.hit(hit, names) for hit in mechanism.collisions)
    return (mechanism.gravity, tuple(hits), rows.refined())


class _Rows:
    """Rows with labels over all coordinates and all rises."""

    def __init__(self, mechanism: Mechanism) -> None:
        self._mechanism = mechanism
        self._k = kinematics(mechanism)
        self._n = len(mechanism.coordinates)
        self._width = self._n + len(mechanism.contacts)
        self._labels: list[Label] = []
        self._rows: list[Array] = []

    def _add(self, label: Label, row: Array) -> None:
        self._labels.append(label)
        self._rows.append(row)

    def _spread(self, slides: Steps, normals: Steps) -> Array:
        """The gradient of a point's three coordinates, (3, width)."""
        found = np.zeros((3, self._width))
        for number, axis in slides:
            found[:, number] += axis
        for number, normal in normals:
            found[:, self._n + number] += normal
        return found

    def body(self, name: str, called: str) -> None:
        """Its place and its start; it has three rows, and one more if it turns."""
        body, point = self._mechanism.body[name], self._k.bodies[name]
        start = self._spread(point.slides, point.normals)[:, : self._n] @ self._speeds()
        spread = self._spread(point.slides, point.normals)
        for axis in range(3):
            label = ("body", called, axis, body.mass, _rounded(start[axis]))
            self._add(label, spread[axis])
        if name in self._k.hinges:
            row = np.zeros(self._width)
            row[self._k.hinges[name]] = np.sqrt(body.inertia)
            self._add(("turn", called), row)

    def hit(self, hit: Collision, names: Mapping[str, str]) -> tuple[str, str, str]:
        """Two bodies that may bounce: what they are called, how they bounce, and how far apart they start."""
        one, other = sorted((hit.a, hit.b), key=lambda address: names.get(address, ""))
        apart = np.subtract(self._k.bodies[other].at, self._k.bodies[one].at)
        numbers = [_rounded(number) for number in (hit.distance, hit.restitution, *apart)]
        return names.get(one, ""), names.get(other, ""), repr(numbers)

    def _speeds(self) -> Array:
        return np.array([coordinate.speed for coordinate in self._mechanism.coordinates] or [0.0])[: self._n]

    def line(self, line: String | Pull) -> None:
        """The length of a string, or of one that is drawn in with a force."""
        points = [self._k.sites[site] for site in line.through]
        row = self._wheels(line.wheels)
        for one, other in pairwise(points):
            apart = np.subtract(other.at, one.at)
            distance = float(np.linalg.norm(apart))
            if distance > 0.0:
                row += apart / distance @ (self._of(other) - self._of(one))
        self._add(("pull", line.force) if isinstance(line, Pull) else ("string", line.slack), row)

    def _of(self, point: Point) -> Array:
        return self._spread(point.slides, point.normals)

    def _wheels(self, wheels: tuple[Wheel, ...]) -> Array:
        row = np.zeros(self._width)
        order = [coordinate.name for coordinate in self._mechanism.coordinates]
        for wheel in wheels:
            row[order.index(wheel.coordinate)] += wheel.radius
        return row

    def rise(self, label: Label, number: int) -> None:
        """The rise of a body from its face."""
        row = np.zeros(self._width)
        row[self._n + number] = 1.0
        self._add(label, row)

    def refined(self) -> tuple[object, ...]:
        """The labels, each refined by its products with all others; in an order of their own."""
        if not self._rows:
            return ()
        rows = np.array(self._rows)
        product = rows @ np.linalg.pinv(self._kinetic()) @ rows.T
        turning = np.array([label[0] == "turn" for label in self._labels])
        product = np.where(turning[:, None] | turning, abs(product), product)  # no text tells which way a wheel turns
        product = np.round(product, 7) + 0.0
        labels: list[object] = list(self._labels)
        for _ in range(ROUNDS):
            keys = [hash((repr(labels[i]), product[i, i], _near(product[i], labels))) for i in range(len(labels))]
            labels = list(keys)
        return tuple(sorted(map(repr, labels)))

    def _kinetic(self) -> Array:
        """The mass matrix, a unit mass being added to every body."""
        total = np.zeros((self._width, self._width))
        for body in self._mechanism.bodies:
            spread = self._of(self._k.bodies[body.name])
            total += (body.mass + 1.0) * spread.T @ spread
            if body.name in self._k.hinges:
                total[self._k.hinges[body.name], self._k.hinges[body.name]] += body.inertia
        return total


def _near(products: Array, labels: list[object]) -> tuple[object, ...]:
    return tuple(sorted((repr(label), float(value)) for label, value in zip(labels, products, strict=True) if value))


def _rounded(value: float) -> float:
    return round(float(value), 9) + 0.0

"""When two readings are one: the same motions of the same named bodies, whatever entities they are made of.

Motions follow from masses, from the forces that are given, and from how bodies, strings and faces depend on
the coordinates. Coordinates themselves are a matter of taste, so they are eliminated: with rows r, each the
gradient of something that has a meaning (a body's place, a string's length, the rise of a body from its
face), and the kinetic energy K of unit masses added to all bodies, the products r·K⁻¹·s do not depend on the
choice of coordinates, nor on hidden lengths. They are compared together with the labels of the rows, up to
the order of those that have no name in the text.

That presumes that gradients never change. Of other mechanisms all is compared that their motion follows from: how each
body stands, moves and bends its path at the start, and the laws of all that acts between which points.
"""

import math
from collections.abc import Mapping
from itertools import pairwise
from math import dist

import numpy as np

from sim2reason.dsl.constancy import changing
from sim2reason.dsl.frames import Frames, Gradient, Point, start
from sim2reason.dsl.mechanism import Line, Mechanism, Meeting
from sim2reason.dsl.scene import Scene
from sim2reason.dsl.state import Array
from sim2reason.dsl.triples import Triple, applied, minus, product
from sim2reason.dsl.vectors import Tensor, Vector

Label = tuple[object, ...]
Signature = tuple[object, ...]
ROUNDS = 3  # of refining labels by their neighbours


def signature(scene: Scene, names: Mapping[str, str]) -> Signature:
    """What two scenes have in common if they mean the same; `names` is what bodies are called, by address."""
    mechanism = scene.mechanism
    frames = start(mechanism)
    if changing(mechanism, frames):
        return _Curved(mechanism, names).signature()
    rows = _Rows(mechanism, frames)
    for body in mechanism.bodies:
        rows.body(body.name, names.get(body.name, ""))
    for line in mechanism.lines:
        rows.line(line)
    for number, face in enumerate(mechanism.faces):
        rows.rise(("face", round(face.friction, 9)), number)
    hits = sorted(rows.hit(hit, names) for hit in mechanism.meetings)
    return (mechanism.gravity, tuple(hits), rows.refined())


class _Curved:
    """The facts from which the motion of a changing mechanism follows, in an order of their own."""

    def __init__(self, mechanism: Mechanism, names: Mapping[str, str]) -> None:
        self._mechanism, self._names = mechanism, names
        speeds = [coordinate.speed for coordinate in mechanism.coordinates]
        self._frames = Frames(mechanism, [0.0] * len(speeds), speeds, math)
        first = mechanism.bodies[0].name
        self._origin = self._frames.center(first).place

    def signature(self) -> Signature:
        """All facts; where the scene stands in the room is none."""
        mechanism = self._mechanism
        facts: list[str] = [repr(mechanism.gravity), mechanism.units.name]
        facts += [repr(("body", *self._body(body.name))) for body in mechanism.bodies]
        facts += [repr(("line", line.law, *self._line(line))) for line in mechanism.lines]
        facts += [repr(("face", self._called(f.subject), f.normal, round(f.friction, 9))) for f in mechanism.faces]
        facts += [repr(("force", self._called(f.body), *self._law(f.law, f.region))) for f in mechanism.forces]
        for pair in mechanism.attractions:
            facts.append(repr(("attraction", sorted((self._called(pair.a), self._called(pair.b))), pair.constant)))
        facts += [repr(("burn", self._called(b.body), b.rate, b.exhaust, b.until)) for b in mechanism.burns]
        for meeting in mechanism.meetings:
            both = sorted(map(self._called, meeting.names))
            facts.append(repr(("meeting", both, meeting.distance, meeting.restitution, meeting.normal)))
        return tuple(sorted(facts))

    def _called(self, body: str) -> str:
        return self._names.get(body, "")

    def _body(self, name: str) -> tuple[object, ...]:
        body, point = self._mechanism.body[name], self._frames.center(name)
        place = minus(point.place, self._origin)
        moves = _vectors(point.gradient) if body.coordinates or point.gradient else ()
        inertia = tuple(round(part, 9) for part in body.inertia) if self._frames[name].spin else ()
        return (self._called(name), body.mass, inertia, *map(_rounded3, (place, point.velocity, point.bias)), moves)

    def _line(self, line: Line) -> tuple[object, ...]:
        sites = [self._mechanism.site[name] for name in line.through]
        places = [_rounded3(minus(self._frames.site(site.name).place, self._origin)) for site in sites]
        carriers = [self._called(site.body or "") for site in sites]
        ends = list(zip(places, carriers, strict=True))
        return tuple(min(ends, ends[::-1])), len(line.wheels)

    def _law(self, law: object, region: object) -> tuple[object, ...]:
        return (repr(law), repr(region))


def _vectors(gradient: Gradient) -> tuple[object, ...]:
    """The plane or line in which a point can move, as a projection: no coordinates show in it."""
    rows = np.array([list(way) for way in gradient.values()]).reshape(-1, 3)
    shadow = rows.T @ np.linalg.pinv(rows @ rows.T) @ rows if len(rows) else np.zeros((3, 3))
    return tuple(float(round(x, 7) + 0.0) for x in shadow.ravel())


def _rounded3(vector: Triple) -> tuple[float, ...]:
    return tuple(_rounded(part) for part in vector)


class _Rows:
    """Rows with labels over all coordinates and all rises."""

    def __init__(self, mechanism: Mechanism, frames: Frames) -> None:
        self._mechanism, self._frames = mechanism, frames
        self._n = len(mechanism.coordinates)
        self._width = self._n + len(mechanism.faces)
        self._labels: list[Label] = []
        self._rows: list[Array] = []

    def _add(self, label: Label, row: Array) -> None:
        self._labels.append(label)
        self._rows.append(row)

    def _spread(self, point: Point) -> Array:
        """The gradient of a point's three coordinates, (3, width)."""
        found = np.zeros((3, self._width))
        for number, axis in point.gradient.items():
            found[:, number] += axis
        for number, normal in point.lift.items():
            found[:, self._n + number] += normal
        return found

    def _hinge(self, name: str) -> int | None:
        """The number of a body's own hinge, or None."""
        own = (c for c in self._mechanism.body[name].coordinates if c.kind == "hinge")
        return next((self._mechanism.number[c.name] for c in own), None)

    def body(self, name: str, called: str) -> None:
        """Its place and its start; it has three rows, and one more if it turns."""
        body, spread = self._mechanism.body[name], self._spread(self._frames.center(name))
        began = spread[:, : self._n] @ self._speeds()
        for axis in range(3):
            self._add(("body", called, axis, body.mass, _rounded(began[axis])), spread[axis])
        hinge = self._hinge(name)
        if hinge is not None:
            row = np.zeros(self._width)
            row[hinge] = np.sqrt(_about(body.inertia, self._mechanism.coordinates[hinge].axis))
            self._add(("turn", called), row)

    def hit(self, hit: Meeting, names: Mapping[str, str]) -> tuple[str, str, str]:
        """Two bodies that may bounce: what they are called, how they bounce, and how far apart they start."""
        one, other = sorted((hit.a or "", hit.b), key=lambda address: names.get(address, ""))
        places = [self._frames.center(name).place if name else (0.0, 0.0, 0.0) for name in (one, other)]
        apart = minus(places[1], places[0])
        numbers = [_rounded(number) for number in (hit.distance, hit.restitution, *apart)]
        return names.get(one, ""), names.get(other, ""), repr(numbers)

    def _speeds(self) -> Array:
        return np.array([coordinate.speed for coordinate in self._mechanism.coordinates] or [0.0])[: self._n]

    def line(self, line: Line) -> None:
        """The length of a string, or of one that is drawn in with a force."""
        row = np.zeros(self._width)
        for wheel in line.wheels:
            row[self._mechanism.number[wheel.coordinate]] += wheel.radius
        for first, last in pairwise(line.through):
            one, other = self._frames.site(first), self._frames.site(last)
            distance = dist(one.place, other.place)
            if distance > 0.0:
                apart = np.array(minus(other.place, one.place))
                row += apart / distance @ (self._spread(other) - self._spread(one))
        self._add(("line", line.law), row)

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
            spread, hinge = self._spread(self._frames.center(body.name)), self._hinge(body.name)
            total += (body.mass + 1.0) * spread.T @ spread
            if hinge is not None:
                total[hinge, hinge] += _about(body.inertia, self._mechanism.coordinates[hinge].axis)
        return total


def _about(inertia: Tensor, axis: Vector) -> float:
    """The moment of inertia about an axis."""
    return float(product(axis, applied(inertia, axis)))


def _near(products: Array, labels: list[object]) -> tuple[object, ...]:
    return tuple(sorted((repr(label), float(value)) for label, value in zip(labels, products, strict=True) if value))


def _rounded(value: float) -> float:
    return round(float(value), 9) + 0.0

"""Mechanisms with other initial coordinates and speeds."""

import math
from collections.abc import Sequence
from dataclasses import replace

from sim2reason.errors import UnsupportedError
from sim2reason.scenes.dsl.frames import BodyFrame, Frames
from sim2reason.scenes.dsl.mechanism import (
    ZERO,
    Coordinate,
    Elastic,
    Inextensible,
    Line,
    LineLaw,
    Mechanism,
    Prop,
    RigidBody,
    Site,
    SurfaceContact,
)
from sim2reason.scenes.dsl.vectors import Tensor, dot, minus

LENGTH_TOL = 1e-9  # m; smaller differences count as zero


def displaced(mechanism: Mechanism, coordinates: Sequence[float], speeds: Sequence[float]) -> Mechanism:
    """Return the mechanism with other initial `coordinates` (n,), m or rad, and `speeds` (n,).

    The laws do not change: strings and springs keep their lengths. Time and its functions restart at 0.

    Raises:
        UnsupportedError: a strut that only pushes has been left, or a body has slid away from its own hinge.
    """
    frames = Frames(mechanism, coordinates, speeds, math)
    moved = _Displaced(mechanism, frames, coordinates, speeds)
    return replace(
        mechanism,
        bodies=tuple(moved.body(body) for body in mechanism.bodies),
        sites=tuple(moved.site(site) for site in mechanism.sites),
        lines=tuple(moved.line(line) for line in mechanism.lines),
        faces=tuple(moved.face(face) for face in mechanism.faces),
        burns=tuple(replace(burn, direction=frames[burn.body].turned(burn.direction)) for burn in mechanism.burns),
    )


class _Displaced:
    """The converter of the parts of a mechanism to other initial coordinates."""

    def __init__(
        self, mechanism: Mechanism, frames: Frames, coordinates: Sequence[float], speeds: Sequence[float]
    ) -> None:
        """Store the mechanism and its `frames` at the new coordinates."""
        self.mechanism, self.frames = mechanism, frames
        self.coordinates, self.speeds = coordinates, speeds
        rest = [0.0] * len(mechanism.coordinates)
        self.began = Frames(mechanism, rest, rest, math, still=True)

    def body(self, body: RigidBody) -> RigidBody:
        """Return the body at its new position, with the axes of its frame parallel to those of the room."""
        frame, carrier = self.frames[body.name], self.frames[body.parent]
        return replace(
            body,
            at=minus(frame.origin, carrier.origin),
            center=body.center if body.center is ZERO else frame.turned(body.center),
            inertia=_turned(frame, body.inertia),
            coordinates=tuple(self._coordinate(coordinate, frame) for coordinate in body.coordinates),
        )

    def _coordinate(self, coordinate: Coordinate, frame: BodyFrame) -> Coordinate:
        number = self.mechanism.number[coordinate.name]
        step = next(step for step in frame.steps if step.number == number)
        if step.pivot is not None and math.dist(step.pivot, frame.origin) > LENGTH_TOL:
            raise UnsupportedError(
                f"{coordinate.body}: it has slid away from its own hinge, so nothing can begin there"
            )
        gone = float(self.coordinates[number])
        return replace(
            coordinate,
            axis=step.axis,
            speed=float(self.speeds[number]),
            lower=coordinate.lower - gone,
            upper=coordinate.upper - gone,
            stated=None if coordinate.stated is None else (coordinate.stated[0], coordinate.stated[1] + gone),
        )

    def site(self, site: Site) -> Site:
        """Return the site in the new frame of its body, whose axes are parallel to those of the room."""
        return replace(site, at=self.frames[site.body].turned(site.at)) if site.body is not None else site

    def face(self, face: SurfaceContact) -> SurfaceContact:
        """Return the face with its normal in the new frame of its carrier."""
        carrier = face.subject if face.turning else self.mechanism.body[face.subject].parent
        return replace(face, normal=self.frames[carrier].turned(face.normal))

    def line(self, line: Line) -> Line:
        """Return the line with a law that accounts for the slack that remains and the length wound onto pulleys."""
        return replace(line, law=self._law(line))

    def _law(self, line: Line) -> LineLaw:
        law = line.law
        wound = sum(w.radius * float(self.coordinates[self.mechanism.number[w.coordinate]]) for w in line.wheels)
        if isinstance(law, Elastic):
            return replace(law, length=law.length - wound)
        grown = self.frames.length(line) + wound - self.began.length(line)
        if isinstance(law, Inextensible):
            spare = law.slack - grown
            return replace(law, slack=spare if spare > LENGTH_TOL else 0.0)
        if isinstance(law, Prop) and abs(grown) > LENGTH_TOL:
            raise UnsupportedError(f"{line.name}: the strut has been left, so that no motion begins with it")
        return law


def _turned(frame: BodyFrame, inertia: Tensor) -> Tensor:
    """Return the rotated inertia tensor R I Rᵀ."""
    if frame.rotation is None or not any(inertia):
        return inertia
    xx, yy, zz, xy, xz, yz = inertia
    rows = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
    half = [[dot(row, axis) for row in rows] for axis in frame.rotation]  # rows of R I

    def entry(i: int, j: int) -> float:
        return float(dot((half[i][0], half[i][1], half[i][2]), frame.rotation[j]))  # type: ignore[index]

    return (entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2))

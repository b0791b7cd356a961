"""Modified mechanisms with parts fixed, removed or simplified; and the coordinates that can move."""

from collections.abc import Callable, Iterable
from dataclasses import replace
from itertools import pairwise
from math import hypot

import numpy as np
from numpy.typing import NDArray

from sim2reason.scenes.dsl.frames import BodyFrame, Frames, initial_frames
from sim2reason.scenes.dsl.mechanism import (
    NO_INERTIA,
    ZERO,
    Inextensible,
    Line,
    Mechanism,
    Rigid,
    RigidBody,
    SurfaceContact,
)
from sim2reason.scenes.dsl.vectors import Point

RESIDUAL_MASS_RATIO = 1e-6  # fraction of a mass: mass of a removed body, so that no equation becomes singular


def fix_body(mechanism: Mechanism, name: str) -> Mechanism:
    """Return the mechanism with one body fixed to its carrier; a fixed wheel also fixes its string.

    A body that is `glued` in a scene never has coordinates, except a glued pulley, which becomes a smooth peg.
    """
    gone = {coordinate.name for coordinate in mechanism.body[name].coordinates}
    body = replace(mechanism.body[name], coordinates=())
    return replace(
        mechanism,
        bodies=_swapped(mechanism, body),
        faces=tuple(_without_slip(face, gone) for face in mechanism.faces if face.subject != name),
        lines=tuple(_without_wheels(line, gone) for line in mechanism.lines),
        feet=tuple(foot for foot in mechanism.feet if mechanism.site[foot.site].body != name),
        burns=tuple(burn for burn in mechanism.burns if burn.body != name),
    )


def remove_body(mechanism: Mechanism, name: str) -> Mechanism:
    """Return the mechanism without one body: nearly massless, without collisions or forces except those of lines."""
    body = mechanism.body[name]
    light = replace(
        body, mass=RESIDUAL_MASS_RATIO * body.mass, inertia=tuple(RESIDUAL_MASS_RATIO * part for part in body.inertia)
    )
    return replace(
        mechanism,
        bodies=_swapped(mechanism, light),
        faces=tuple(replace(face, friction=0.0) if face.subject == name else face for face in mechanism.faces),
        forces=tuple(force for force in mechanism.forces if force.body != name),
        attractions=tuple(pull for pull in mechanism.attractions if name not in (pull.a, pull.b)),
        meetings=tuple(meeting for meeting in mechanism.meetings if name not in meeting.names),
    )


def with_bodies(mechanism: Mechanism, names: Iterable[str], change: Callable[[RigidBody], RigidBody]) -> Mechanism:
    """Return the mechanism with some bodies changed by a function."""
    chosen = set(names)
    bodies = tuple(change(body) if body.name in chosen else body for body in mechanism.bodies)
    return replace(mechanism, bodies=bodies)


def with_lines(mechanism: Mechanism, names: Iterable[str], change: Callable[[Line], Line]) -> Mechanism:
    """Return the mechanism with some lines changed by a function."""
    chosen = set(names)
    return replace(mechanism, lines=tuple(change(line) if line.name in chosen else line for line in mechanism.lines))


def inertialess(body: RigidBody) -> RigidBody:
    """Return the body as a point mass at its centre of mass."""
    return replace(body, inertia=NO_INERTIA)


def _swapped(mechanism: Mechanism, body: RigidBody) -> tuple[RigidBody, ...]:
    return tuple(body if other.name == body.name else other for other in mechanism.bodies)


def _without_slip(face: SurfaceContact, gone: set[str]) -> SurfaceContact:
    slip = tuple(term for term in face.slip if term[0] not in gone)
    return face if len(slip) == len(face.slip) else replace(face, slip=slip)


def _without_wheels(line: Line, gone: set[str]) -> Line:
    wheels = tuple(wheel for wheel in line.wheels if wheel.coordinate not in gone)
    return line if len(wheels) == len(line.wheels) else replace(line, wheels=wheels)


VELOCITY_TOL = 1e-9  # fraction of a velocity of 1 m/s or 1 rad/s: smaller ones count as zero
HORIZONTAL_TOL = 1e-9  # largest vertical component of a horizontal direction


def stuck_bodies(mechanism: Mechanism) -> tuple[str, ...]:
    """Return the names of the bodies with coordinates that constraints keep from moving."""
    frames = initial_frames(mechanism)
    ways = motions(mechanism, frames)
    stuck: list[str] = []
    for body in mechanism.bodies:
        numbers = [mechanism.number[coordinate.name] for coordinate in body.coordinates]
        steps = [step.number for step in frames[body.name].steps]
        if numbers and not np.abs(ways[:, steps]).max(initial=0.0) > VELOCITY_TOL:
            stuck.append(body.name)
    return tuple(stuck)


def is_weightless(mechanism: Mechanism) -> bool:
    """Return whether some part can move without inertia, such as a light pulley without load."""
    frames = initial_frames(mechanism)
    ways = motions(mechanism, frames)
    inertia = np.zeros((len(ways), len(ways)))
    for body in mechanism.bodies:
        center = frames.center(body.name)
        moved = np.zeros((3, len(mechanism.coordinates)))
        for number, axis in center.gradient.items():
            moved[:, number] = axis
        inertia += body.mass * (ways @ moved.T) @ (moved @ ways.T)
        xx, yy, zz, xy, xz, yz = body.inertia
        tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        turned = np.zeros((3, len(mechanism.coordinates)))
        for step in frames[body.name].hinges:
            turned[:, step.number] = step.axis
        inertia += (ways @ turned.T) @ tensor @ (turned @ ways.T)
    return bool(len(ways)) and float(np.linalg.eigvalsh(inertia).min()) < VELOCITY_TOL


def motions(mechanism: Mechanism, frames: Frames) -> NDArray[np.float64]:
    """Return independent rates of the coordinates that keep all string and rod lengths, (k, coordinates)."""
    size = len(mechanism.coordinates)
    rows: list[NDArray[np.float64]] = []
    for line in mechanism.lines:
        if not isinstance(line.law, Inextensible | Rigid):
            continue
        row = np.zeros(size)
        for wheel in line.wheels:
            row[mechanism.number[wheel.coordinate]] += wheel.radius
        for first, last in pairwise(line.through):
            for number, part in frames.distance(first, last).along.items():
                row[number] += float(part)
        rows.append(row)
    if not rows or not size:
        return np.eye(size)
    _, sizes, ways = np.linalg.svd(np.array(rows))
    return ways[int((sizes > VELOCITY_TOL).sum()) :]


def weighs(mechanism: Mechanism) -> bool:
    """Return whether gravity affects the mechanism: a body presses on a face, or rises and falls."""
    return mechanism.gravity != ZERO and would_weigh(mechanism)


def would_weigh(mechanism: Mechanism) -> bool:
    """Return whether gravity, if present, would affect a mechanism, so that a text must state its absence."""
    if mechanism.contacts:
        return True
    frames = initial_frames(mechanism)
    return any(_rises(frames[body.name], frames.center(body.name)) for body in mechanism.bodies if body.mass > 0.0)


def _rises(frame: BodyFrame, center: Point) -> bool:
    """Return whether some coordinate can move a point up or down, initially or after rotation by others."""
    for step in frame.steps:
        if step.pivot is None:
            if abs(step.axis[2]) > HORIZONTAL_TOL or any(
                abs(hinge.axis[2]) < 1.0 - HORIZONTAL_TOL for hinge in frame.hinges
            ):
                return True
        elif abs(step.axis[2]) < 1.0 - HORIZONTAL_TOL and hypot(*center.gradient[step.number]) > HORIZONTAL_TOL:
            return True
    return False

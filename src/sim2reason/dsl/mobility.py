"""What a mechanism can do from where it stands, with every string taut and every face in touch."""

from itertools import pairwise
from math import hypot

import numpy as np
from numpy.typing import NDArray

from sim2reason.dsl.frames import BodyFrame, Frames, start
from sim2reason.dsl.mechanism import ZERO, Inextensible, Mechanism, Rigid
from sim2reason.dsl.points import Point

SMALL = 1e-9  # of a velocity of 1 m/s or 1 rad/s
EVEN = 1e-9  # what is vertical in a level direction


def stuck_bodies(mechanism: Mechanism) -> tuple[str, ...]:
    """The bodies that have coordinates, and yet nothing lets them begin to move."""
    frames = start(mechanism)
    ways = motions(mechanism, frames)
    stuck: list[str] = []
    for body in mechanism.bodies:
        numbers = [mechanism.number[coordinate.name] for coordinate in body.coordinates]
        steps = [step.number for step in frames[body.name].steps]
        if numbers and not np.abs(ways[:, steps]).max(initial=0.0) > SMALL:
            stuck.append(body.name)
    return tuple(stuck)


def is_weightless(mechanism: Mechanism) -> bool:
    """Whether something can move that has no inertia, such as a light pulley on which nothing hangs."""
    frames = start(mechanism)
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
    return bool(len(ways)) and float(np.linalg.eigvalsh(inertia).min()) < SMALL


def motions(mechanism: Mechanism, frames: Frames) -> NDArray[np.float64]:
    """Independent rates of the coordinates that keep the length of every string and rod, a row each."""
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
    return ways[int((sizes > SMALL).sum()) :]


def weighs(mechanism: Mechanism) -> bool:
    """Whether g can matter: something presses on a face, or rises and falls as it slides or turns."""
    return mechanism.gravity != ZERO and would_weigh(mechanism)


def would_weigh(mechanism: Mechanism) -> bool:
    """Return whether gravity would affect a mechanism, so that a text must say if there is no gravity."""
    if mechanism.contacts:
        return True
    frames = start(mechanism)
    return any(_rises(frames[body.name], frames.center(body.name)) for body in mechanism.bodies if body.mass > 0.0)


def _rises(frame: BodyFrame, center: Point) -> bool:
    """Whether some coordinate can move a point up or down, now or once others have turned it."""
    for step in frame.steps:
        if step.pivot is None:
            if abs(step.axis[2]) > EVEN or any(abs(hinge.axis[2]) < 1.0 - EVEN for hinge in frame.hinges):
                return True
        elif abs(step.axis[2]) < 1.0 - EVEN and hypot(*center.gradient[step.number]) > EVEN:
            return True
    return False

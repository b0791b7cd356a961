"""Structure of mechanisms: coordinates that can move, removal of parts, and the test for constant equations."""

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
    ConstantTension,
    Inextensible,
    Line,
    Mechanism,
    Prop,
    Rigid,
    RigidBody,
    SurfaceContact,
)
from sim2reason.scenes.dsl.vectors import Point, Triple, Vector, cross, inner, scale_triple, subtract_triples

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


def replace_bodies(mechanism: Mechanism, names: Iterable[str], change: Callable[[RigidBody], RigidBody]) -> Mechanism:
    """Return the mechanism with some bodies changed by a function."""
    chosen = set(names)
    bodies = tuple(change(body) if body.name in chosen else body for body in mechanism.bodies)
    return replace(mechanism, bodies=bodies)


def replace_lines(mechanism: Mechanism, names: Iterable[str], change: Callable[[Line], Line]) -> Mechanism:
    """Return the mechanism with some lines changed by a function."""
    chosen = set(names)
    return replace(mechanism, lines=tuple(change(line) if line.name in chosen else line for line in mechanism.lines))


def as_point_mass(body: RigidBody) -> RigidBody:
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


def is_gravity_relevant(mechanism: Mechanism) -> bool:
    """Return whether gravity affects the mechanism: a body presses on a face, or rises and falls."""
    return mechanism.gravity != ZERO and would_gravity_matter(mechanism)


def would_gravity_matter(mechanism: Mechanism) -> bool:
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


PARALLEL_TOL = 1e-9  # largest difference of parallel unit vectors


def changing(mechanism: Mechanism, frames: Frames | None = None) -> str:
    """Return the reason why the equations of motion change, in a few words; empty if they are constant."""
    return mechanism.memoize("changing", lambda: _changing(mechanism, frames))


def _changing(mechanism: Mechanism, frames: Frames | None) -> str:
    if mechanism.attractions or mechanism.burns or mechanism.feet:
        return "attraction, a burning engine or a foot"
    if any(force.region is not None or not force.law.constant for force in mechanism.forces):
        return "a force that changes"
    if any(not isinstance(line.law, Inextensible | ConstantTension | Prop) for line in mechanism.lines):
        return "a spring or a rod"
    if any(face.turning for face in mechanism.faces):
        return "a face that turns"
    frames = initial_frames(mechanism) if frames is None else frames
    bodies = (_turning_body(mechanism, frames, body) for body in mechanism.bodies)
    turning = next((name for name in bodies if name), "")
    return turning or next((name for line in mechanism.lines if (name := rotating_line(line, frames))), "")


def may_reverse(mechanism: Mechanism) -> bool:
    """Return whether a motion may reverse: by an initial speed, a collision, or a changing force."""
    sent = any(coordinate.speed for coordinate in mechanism.coordinates)
    return sent or bool(mechanism.meetings or changing(mechanism))


def rotates_one_way(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body that rolls or slips on a plane never reverses its rotation, for any parameters.

    A body that starts from rest never does if no motion may turn back. Nor does a lone body launched with its centre
    and its rim moving in one sense, not up the slope: friction slows one and speeds up the other until they agree.
    """
    if not may_reverse(mechanism):
        return True
    face = mechanism.contacts.get(name)
    if face is None or mechanism.meetings or mechanism.lines or mechanism.forces or changing(mechanism):
        return False
    slopes = [inner(mechanism.gravity, c.axis) for c in mechanism.body[name].coordinates if c.kind == "slide"]
    speeds = [(mechanism.coordinates[mechanism.number[one]], factor) for one, factor in face.slip]
    senses = [factor * c.speed * (1.0 if c.kind == "slide" else -1.0) for c, factor in speeds]
    if len(slopes) != 1 or {c.kind for c, _ in speeds} != {"slide", "hinge"}:
        return False
    down = slopes[0] if abs(slopes[0]) > PARALLEL_TOL else sum(senses)
    return all(sense * down >= 0.0 for sense in senses)


def _turning_body(mechanism: Mechanism, frames: Frames, body: RigidBody) -> str:
    """Return the name of a body whose centre of mass or direction of motion a hinge rotates; empty if none."""
    frame = frames[body.name]
    if frame.spin is None:
        return ""
    if any(_moved(step) for step in _swung(frame, frames.center(body.name))):
        return f"{body.name} swings"
    carrier = frames[body.parent]
    if carrier.spin is not None and (body.coordinates or body.name in mechanism.contacts):
        return f"{body.name} moves on a turning body"
    hinges = [step.axis for step in frame.steps if step.pivot is not None]
    if any(not _parallel(one, other) for one, other in pairwise(hinges)):
        return f"{body.name} turns about several axes"
    slides = [c.axis for c in body.coordinates[1:] if c.kind == "slide"]
    if slides and body.coordinates[0].kind == "hinge":
        return f"{body.name} slides along a turning axis"
    return ""


def _swung(frame: BodyFrame, point: Point) -> list[Triple]:
    return [point.gradient[step.number] for step in frame.steps if step.pivot is not None]


def _moved(vector: Triple) -> bool:
    return hypot(*vector) > PARALLEL_TOL


def _parallel(one: Vector, other: Vector) -> bool:
    return hypot(*cross(one, other)) <= PARALLEL_TOL


def rotating_line(line: Line, frames: Frames) -> str:
    """Return the name of a line that rotates as its sites move; empty if it does not."""
    try:
        pieces = frames.pieces(line)
    except ZeroDivisionError:  # two sites coincide, which engines refuse for themselves
        return ""
    for run in pieces:
        for number, moved in run.moved.items():
            if hypot(*subtract_triples(moved, scale_triple(run.along[number], run.direction))) > PARALLEL_TOL:
                return f"{line.name} bends"
    return ""


def constant_direction(mechanism: Mechanism, frames: Frames, first: str, last: str) -> Triple | None:
    """Return the constant unit vector from one site to another; None if the direction can change."""
    run = frames.distance(first, last)
    for number, moved in run.moved.items():
        if not _moved(moved):
            continue
        if mechanism.coordinates[number].kind == "hinge" or not _parallel(moved, run.direction):
            return None
    return run.direction


def steady(mechanism: Mechanism, frames: Frames | None = None) -> dict[tuple[str, str], Triple]:
    """Return the constant unit vectors, by end sites, of straight segments of variable length.

    `frames` are the initial ones, if they are known.
    """
    frames, directions = frames or initial_frames(mechanism), dict[tuple[str, str], Triple]()
    for ends in dict.fromkeys(ends for line in mechanism.lines for ends in pairwise(line.through)):
        try:
            parts, direction = bool(frames.distance(*ends).moved), constant_direction(mechanism, frames, *ends)
        except ZeroDivisionError:  # two sites coincide, which engines refuse for themselves
            continue
        slides = any(_slides_after_a_hinge(frames[mechanism.site[site].body]) for site in ends)
        if parts and direction is not None and not slides:  # ends that never part have no direction, only a length
            directions[ends] = direction
    return directions


def _slides_after_a_hinge(frame: BodyFrame) -> bool:
    """Return whether a body slides on a rotating body, so that a hinge may move it later."""
    return any(one.pivot is not None and other.pivot is None for one, other in pairwise(frame.steps))

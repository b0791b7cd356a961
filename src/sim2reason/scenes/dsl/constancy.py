"""Structural test for constant equations of motion, for which all motion is a quadratic function of time."""

from itertools import pairwise
from math import hypot

from sim2reason.scenes.dsl.frames import BodyFrame, Frames, initial_frames
from sim2reason.scenes.dsl.mechanism import ConstantTension, Inextensible, Line, Mechanism, Prop, RigidBody
from sim2reason.scenes.dsl.vectors import Point, Triple, Vector, cross, inner, minus, times

ALIGNED = 1e-9  # largest difference of parallel unit vectors


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
    return turning or next((name for line in mechanism.lines if (name := bending(line, frames))), "")


def may_turn_back(mechanism: Mechanism) -> bool:
    """Return whether a motion may reverse: by an initial speed, a collision, or a changing force."""
    sent = any(coordinate.speed for coordinate in mechanism.coordinates)
    return sent or bool(mechanism.meetings or changing(mechanism))


def turns_one_way(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body that rolls or slips on a plane never reverses its rotation, for any parameters.

    A body that starts from rest never does if no motion may turn back. Nor does a lone body launched with its centre
    and its rim moving in one sense, not up the slope: friction slows one and speeds up the other until they agree.
    """
    if not may_turn_back(mechanism):
        return True
    face = mechanism.contacts.get(name)
    if face is None or mechanism.meetings or mechanism.lines or mechanism.forces or changing(mechanism):
        return False
    slopes = [inner(mechanism.gravity, c.axis) for c in mechanism.body[name].coordinates if c.kind == "slide"]
    speeds = [(mechanism.coordinates[mechanism.number[one]], factor) for one, factor in face.slip]
    senses = [factor * c.speed * (1.0 if c.kind == "slide" else -1.0) for c, factor in speeds]
    if len(slopes) != 1 or {c.kind for c, _ in speeds} != {"slide", "hinge"}:
        return False
    down = slopes[0] if abs(slopes[0]) > ALIGNED else sum(senses)
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


def _moved(way: Triple) -> bool:
    return hypot(*way) > ALIGNED


def _parallel(one: Vector, other: Vector) -> bool:
    return hypot(*cross(one, other)) <= ALIGNED


def bending(line: Line, frames: Frames) -> str:
    """Return the name of a line that rotates as its sites move; empty if it does not."""
    try:
        pieces = frames.pieces(line)
    except ZeroDivisionError:  # two sites coincide, which engines refuse for themselves
        return ""
    for run in pieces:
        for number, moved in run.moved.items():
            if hypot(*minus(moved, times(run.along[number], run.way))) > ALIGNED:
                return f"{line.name} bends"
    return ""


def straight(mechanism: Mechanism, frames: Frames, first: str, last: str) -> Triple | None:
    """Return the constant unit vector from one site to another; None if the direction can change."""
    run = frames.distance(first, last)
    for number, moved in run.moved.items():
        if not _moved(moved):
            continue
        if mechanism.coordinates[number].kind == "hinge" or not _parallel(moved, run.way):
            return None
    return run.way


def steady(mechanism: Mechanism) -> dict[tuple[str, str], Triple]:
    """Return the constant unit vectors, by end sites, of straight segments of variable length."""
    frames, found = initial_frames(mechanism), dict[tuple[str, str], Triple]()
    for ends in dict.fromkeys(ends for line in mechanism.lines for ends in pairwise(line.through)):
        try:
            parts, way = bool(frames.distance(*ends).moved), straight(mechanism, frames, *ends)
        except ZeroDivisionError:  # two sites coincide, which engines refuse for themselves
            continue
        slides = any(_slides_after_a_hinge(frames[mechanism.site[site].body]) for site in ends)
        if parts and way is not None and not slides:  # ends that never part have no direction, only a length
            found[ends] = way
    return found


def _slides_after_a_hinge(frame: BodyFrame) -> bool:
    """Return whether a body slides on a rotating body, so that a hinge may move it later."""
    return any(one.pivot is not None and other.pivot is None for one, other in pairwise(frame.steps))

"""Whether the equations of a mechanism never change, as its structure proves: then its motion is quadratic."""

from itertools import pairwise
from math import hypot

from sim2reason.dsl.frames import Frame, Frames, Point
from sim2reason.dsl.mechanism import Drawn, Inextensible, Line, Mechanism, Prop, RigidBody
from sim2reason.dsl.triples import Triple, cross, minus, plus, product, times
from sim2reason.dsl.vectors import Vector

ALIGNED = 1e-9  # how far two unit vectors may differ and still be called parallel


def changing(mechanism: Mechanism, frames: Frames) -> str:
    """What makes the equations change, in a few words; empty if nothing does. `frames` are those of the start."""
    if mechanism.attractions or mechanism.burns or mechanism.feet:
        return "attraction, a burning engine or a foot"
    if any(force.region is not None or not force.law.constant for force in mechanism.forces):
        return "a force that changes"
    if any(not isinstance(line.law, Inextensible | Drawn | Prop) for line in mechanism.lines):
        return "a spring or a rod"
    if any(face.turning for face in mechanism.faces):
        return "a face that turns"
    bodies = (_turning_body(mechanism, frames, body) for body in mechanism.bodies)
    turning = next((name for name in bodies if name), "")
    return turning or next((name for line in mechanism.lines if (name := _bending(line, frames))), "")


def _turning_body(mechanism: Mechanism, frames: Frames, body: RigidBody) -> str:
    """A body whose centre of mass a hinge moves, or whose own ways of moving it turns."""
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


def _swung(frame: Frame, point: Point) -> list[Triple]:
    return [point.gradient[step.number] for step in frame.steps if step.pivot is not None]


def _moved(way: Triple) -> bool:
    return hypot(*way) > ALIGNED


def _parallel(one: Vector, other: Vector) -> bool:
    return hypot(*cross(one, other)) <= ALIGNED


def _bending(line: Line, frames: Frames) -> str:
    """A line that turns as its sites move."""
    for first, last in pairwise(line.through):
        one, other = frames.site(first), frames.site(last)
        apart = minus(other.place, one.place)
        length = hypot(*apart)
        if length == 0.0:
            continue
        for number in one.gradient.keys() | other.gradient.keys():
            way = minus(other.gradient.get(number, _NONE), one.gradient.get(number, _NONE))
            along = product(way, apart) / length
            if hypot(*plus(way, times(-along / length, apart))) > ALIGNED:
                return f"{line.name} bends"
    return ""


_NONE = (0.0, 0.0, 0.0)

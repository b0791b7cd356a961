"""Mechanisms with something held, left out or made simpler: each is a function from one mechanism to another."""

from collections.abc import Callable, Iterable
from dataclasses import replace

from sim2reason.dsl.mechanism import NO_INERTIA, Face, Line, Mechanism, RigidBody

NEARLY_NOTHING = 1e-6  # of a mass: what is left of a body that is left out, so that no equation becomes singular


def held(mechanism: Mechanism, name: str) -> Mechanism:
    """A body held where it is on what carries it; a wheel that it turned, or that it is, holds strings fast with it.

    What a scene has `glued` was never let move; only of a pulley that is something else: one that is glued is smooth.
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


def left_out(mechanism: Mechanism, name: str) -> Mechanism:
    """All but without a body: it has next to no mass, meets nothing, and nothing but lines acts on it."""
    body = mechanism.body[name]
    light = replace(
        body, mass=NEARLY_NOTHING * body.mass, inertia=tuple(NEARLY_NOTHING * part for part in body.inertia)
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
    """Some bodies changed."""
    chosen = set(names)
    bodies = tuple(change(body) if body.name in chosen else body for body in mechanism.bodies)
    return replace(mechanism, bodies=bodies)


def with_lines(mechanism: Mechanism, names: Iterable[str], change: Callable[[Line], Line]) -> Mechanism:
    """Some lines changed."""
    chosen = set(names)
    return replace(mechanism, lines=tuple(change(line) if line.name in chosen else line for line in mechanism.lines))


def inertialess(body: RigidBody) -> RigidBody:
    """A body whose mass is all at its centre of mass."""
    return replace(body, inertia=NO_INERTIA)


def _swapped(mechanism: Mechanism, body: RigidBody) -> tuple[RigidBody, ...]:
    return tuple(body if other.name == body.name else other for other in mechanism.bodies)


def _without_slip(face: Face, gone: set[str]) -> Face:
    slip = tuple(term for term in face.slip if term[0] not in gone)
    return face if len(slip) == len(face.slip) else replace(face, slip=slip)


def _without_wheels(line: Line, gone: set[str]) -> Line:
    wheels = tuple(wheel for wheel in line.wheels if wheel.coordinate not in gone)
    return line if len(wheels) == len(line.wheels) else replace(line, wheels=wheels)

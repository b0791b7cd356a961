"""Wrong ideas that a student may have of a scene, each as another mechanism; for ``worth.py``.

They are made here from the mechanism and its scene alone, so that nothing which the library's own slips overlook is
overlooked here for the same reason.
"""

from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass, replace
from math import isfinite

from sim2reason.errors import SceneError
from sim2reason.questions import SimulatedScene
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import NO_INERTIA, ZERO, Elastic, Mechanism, RigidBody

Change = Callable[[Mechanism], Mechanism]
TINY = 1e-4  # of a length or an inertia: what is left of one that is forgotten


@dataclass(frozen=True, slots=True)
class WrongIdea:
    """One wrong idea, with the motion that follows from it."""

    name: str
    study: SimulatedScene | None


def wrong_ideas(study: SimulatedScene, until: float | None, spared: Collection[str]) -> Iterator[WrongIdea]:
    """Yield all that apply to a scene, each followed until a time, s; nothing that is spared is held."""
    for name, change in _changes(study.mechanism, spared):
        yield WrongIdea(name, study.changed(("wrong idea", name), change, until))
    for name, values in _values(study):
        try:
            yield WrongIdea(name, study.with_values(values, until))
        except SceneError:
            continue


def _changes(mechanism: Mechanism, spared: Collection[str]) -> Iterator[tuple[str, Change]]:
    yield from _of_turning(mechanism)
    yield from _of_motion(mechanism, spared)
    yield from _of_faces(mechanism)
    yield from _of_lines(mechanism)
    for force in mechanism.forces:
        left = tuple(other for other in mechanism.forces if other is not force)
        yield f"no force: {force.name}", lambda found, left=left: replace(found, forces=left)
    for pull in mechanism.attractions:
        others = tuple(other for other in mechanism.attractions if other is not pull)
        yield f"no attraction: {pull.a}, {pull.b}", lambda found, left=others: replace(found, attractions=left)
    if any(meeting.restitution not in (0.0, 1.0) for meeting in mechanism.meetings):
        for value in (0.0, 1.0):
            bounced = tuple(replace(meeting, restitution=value) for meeting in mechanism.meetings)
            yield f"e = {value:g}", lambda found, all_=bounced: replace(found, meetings=all_)


def _of_turning(mechanism: Mechanism) -> Iterator[tuple[str, Change]]:
    turning = [body.name for body in mechanism.bodies if any(body.inertia) and _turns(mechanism, body)]
    for names in ([name] for name in turning):
        yield f"no inertia: {names[0]}", _bodies(names, lambda body: replace(body, inertia=_little(body)))
    if len(turning) > 1:
        yield "no inertia at all", _bodies(turning, lambda body: replace(body, inertia=_little(body)))
    for body in mechanism.bodies:
        if body.center != ZERO and _turns(mechanism, body):
            yield f"centre of mass at the centre: {body.name}", _bodies([body.name], _centred)
        if body.name in turning and any(body.center) and any(c.kind == "hinge" for c in body.coordinates):
            yield f"no parallel-axis term: {body.name}", _bodies([body.name], _without_parallel_axis)


def _of_motion(mechanism: Mechanism, spared: Collection[str]) -> Iterator[tuple[str, Change]]:
    carriers = {body.parent for body in mechanism.bodies}
    for body in mechanism.bodies:
        if body.coordinates and body.mass and body.name in carriers - {*spared}:
            yield f"fixed: {body.name}", _bodies([body.name], lambda found: replace(found, coordinates=()))
        if any(coordinate.speed for coordinate in body.coordinates):
            yield f"begins at rest: {body.name}", _bodies([body.name], _resting)


def _resting(body: RigidBody) -> RigidBody:
    return replace(body, coordinates=tuple(replace(coordinate, speed=0.0) for coordinate in body.coordinates))


def _of_faces(mechanism: Mechanism) -> Iterator[tuple[str, Change]]:
    rough = [face for face in mechanism.faces if face.friction and isfinite(face.friction)]
    frames = initial_frames(mechanism)
    for face in rough:
        yield f"no friction: {face.subject}", _friction({face.subject: 0.0})
    flat = [face.subject for face in rough if not face.turning]
    cosines = {name: abs(float(frames.normal(name)[2])) for name in flat}
    factors = {name: 1.0 / cosine for name, cosine in cosines.items() if 0.0 < cosine < 1.0 - 1e-9}
    if factors:
        yield "N = m g", _friction(factors)


def _friction(factors: dict[str, float]) -> Change:
    def other(mechanism: Mechanism) -> Mechanism:
        faces = (replace(face, friction=factors.get(face.subject, 1.0) * face.friction) for face in mechanism.faces)
        return replace(mechanism, faces=tuple(faces))

    return other


def _of_lines(mechanism: Mechanism) -> Iterator[tuple[str, Change]]:
    for line in mechanism.lines:
        law = line.law
        if not isinstance(law, Elastic):
            continue
        if law.damping:
            yield f"no damping: {line.name}", _law(line.name, replace(law, damping=0.0))
        yield f"no spring: {line.name}", _law(line.name, Elastic(0.0, law.length))


def _law(name: str, law: Elastic) -> Change:
    return lambda mechanism: replace(
        mechanism, lines=tuple(replace(line, law=law) if line.name == name else line for line in mechanism.lines)
    )


def _bodies(names: list[str], change: Callable[[RigidBody], RigidBody]) -> Change:
    return lambda mechanism: replace(
        mechanism, bodies=tuple(change(body) if body.name in names else body for body in mechanism.bodies)
    )


def _little(body: RigidBody) -> tuple[float, float, float, float, float, float]:
    xx, yy, zz, xy, xz, yz = (TINY * part for part in body.inertia)
    return (xx, yy, zz, xy, xz, yz)


def _centred(body: RigidBody) -> RigidBody:
    return replace(body, center=ZERO)


def _without_parallel_axis(body: RigidBody) -> RigidBody:
    x, y, z = body.center
    square = body.mass * (x * x + y * y + z * z)
    xx, yy, zz, xy, xz, yz = body.inertia
    return replace(body, inertia=(xx, yy - square, zz, xy, xz, yz)) if body.inertia != NO_INERTIA else body


def _turns(mechanism: Mechanism, body: RigidBody) -> bool:
    if any(coordinate.kind == "hinge" for coordinate in body.coordinates):
        return True
    return body.parent is not None and _turns(mechanism, mechanism.body[body.parent])


def _values(study: SimulatedScene) -> Iterator[tuple[str, dict[str, float]]]:
    """Numbers that a student has wrong: a hole that is not there, a wall that is thin, sine for cosine."""
    for parameter in study.scene.parameters:
        owner, _, name = parameter.path.rpartition(".")
        value = parameter.value
        if parameter.hidden or not value:
            continue
        if name == "hole":
            yield f"no hole: {owner}", {parameter.path: TINY * value}
        if name == "thickness":
            yield f"thin wall: {owner}", {parameter.path: TINY * value}
        if parameter.measure.unit == "deg" and 0.0 < value < 90.0:
            yield f"complement: {parameter.path}", {parameter.path: 90.0 - value}

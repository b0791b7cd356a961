"""What is true of a whole scene and said at the end of its text, each only where it matters."""

from collections.abc import Callable
from dataclasses import dataclass
from math import hypot

from sim2reason.dsl.frames import Frame, Point, start
from sim2reason.dsl.mechanism import ZERO
from sim2reason.dsl.scene import Scene

EVEN = 1e-9  # what is vertical in a level direction


@dataclass(frozen=True, slots=True)
class Closing:
    """A sentence in its wordings, and the scenes that need it."""

    name: str
    needed: Callable[[Scene], bool]
    wordings: tuple[str, ...]


def _from_rest(scene: Scene) -> bool:
    coordinates = scene.mechanism.coordinates
    return bool(coordinates) and all(coordinate.speed == 0.0 for coordinate in coordinates)


def _pulleys(scene: Scene) -> list[float]:
    """The masses of all pulleys."""
    return [getattr(body, "mass", 0.0) for body in scene.bodies.values() if body.nouns[0] == "pulley"]


def _has_massive_pulley(scene: Scene) -> bool:
    return any(mass > 0.0 for mass in _pulleys(scene))


def _turns(scene: Scene) -> int:
    """How many pulleys there are to speak of; small ones at corners count, too, each once for both its sides."""
    mechanism = scene.mechanism
    corners = {site for line in mechanism.lines for site in line.through[1:-1]}
    wheels = {f"{address}." for address, body in scene.bodies.items() if body.nouns[0] == "pulley"}
    return len(wheels) + len({corner for corner in corners if corner.rpartition(".")[0] + "." not in wheels})


def _has_one_light_pulley(scene: Scene) -> bool:
    return _turns(scene) == 1 and not _has_massive_pulley(scene)


def _has_light_pulleys(scene: Scene) -> bool:
    return _turns(scene) > 1 and not _has_massive_pulley(scene)


def _has_room(scene: Scene) -> bool:
    return _turns(scene) > 0 and not scene.mechanism.contacts


def _has_faces(scene: Scene) -> bool:
    return bool(scene.mechanism.contacts) and _turns(scene) == 0


def _has_both(scene: Scene) -> bool:
    return bool(scene.mechanism.contacts) and _turns(scene) > 0


def _weighs(scene: Scene) -> bool:
    """Whether g can matter: something presses on a face, or rises and falls as it slides or turns."""
    mechanism, frames = scene.mechanism, start(scene.mechanism)
    if mechanism.gravity == ZERO:
        return False
    return bool(mechanism.contacts) or any(
        _rises(frames[body.name], frames.center(body.name)) for body in mechanism.bodies if body.mass > 0.0
    )


def _rises(frame: Frame, center: Point) -> bool:
    """Whether some coordinate can move a point up or down, now or once others have turned it."""
    for step in frame.steps:
        if step.pivot is None:
            if abs(step.axis[2]) > EVEN or any(abs(hinge.axis[2]) < 1.0 - EVEN for hinge in frame.hinges):
                return True
        elif abs(step.axis[2]) < 1.0 - EVEN and hypot(*center.gradient[step.number]) > EVEN:
            return True
    return False


CLOSINGS: tuple[Closing, ...] = (
    Closing(
        "rest",
        _from_rest,
        (
            "everything is released from rest.",
            "everything starts from rest.",
            "everything is let go from rest.",
            "at first everything is held at rest, then released.",
            "the motion starts from rest.",
        ),
    ),
    Closing(
        "light pulley",
        _has_one_light_pulley,
        (
            "the pulley turns without friction.",
            "there is no friction at the pulley.",
            "friction at the pulley is negligible.",
        ),
    ),
    Closing(
        "light pulleys",
        _has_light_pulleys,
        (
            "no pulley has friction.",
            "pulleys turn without friction.",
            "friction at pulleys is negligible.",
        ),
    ),
    Closing(
        "massive pulleys",
        _has_massive_pulley,
        (
            "pulleys turn without friction, and no string slips on them.",
            "strings do not slip on the pulleys, which turn freely.",
            "axles are frictionless, and strings do not slip on pulleys.",
            "the pulleys turn freely, and strings do not slip on them.",
            "there is neither friction at axles nor slipping on pulleys.",
        ),
    ),
    Closing(
        "room for strings",
        _has_room,
        (
            "no body reaches a pulley.",
            "every string is long enough for the motion.",
            "there is string enough for the motion.",
        ),
    ),
    Closing(
        "room on faces",
        _has_faces,
        ("no edge is reached.", "no body gets to an edge.", "there is room for the motion."),
    ),
    Closing(
        "room on faces and for strings",
        _has_both,
        (
            "nothing reaches a pulley or an edge.",
            "no body gets to a pulley or an edge.",
            "there is room enough for the motion.",
        ),
    ),
    Closing(
        "g",
        _weighs,
        (
            "take g = {world.gravity}.",
            "use g = {world.gravity}.",
            "here g = {world.gravity}.",
            "let g = {world.gravity}.",
            "the free-fall acceleration is g = {world.gravity}.",
            "the acceleration due to gravity is g = {world.gravity}.",
            "the acceleration of free fall is g = {world.gravity}.",
        ),
    ),
)


def closings(scene: Scene) -> list[Closing]:
    """The closings that a scene needs, in the order in which they are said."""
    return [closing for closing in CLOSINGS if closing.needed(scene)]

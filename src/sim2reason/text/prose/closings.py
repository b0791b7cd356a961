"""Closing sentences of a text, which concern the whole scene, such as a start from rest."""

import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from math import hypot

from sim2reason.scenes.dsl.frames import Frames, initial_frames
from sim2reason.scenes.dsl.mechanism import CollisionPair, ConstantTension, Inextensible
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.structure import is_gravity_relevant, would_gravity_matter
from sim2reason.scenes.dsl.template import Role, Topic
from sim2reason.scenes.dsl.vectors import dot, subtract_triples


@dataclass(frozen=True, slots=True)
class Closing:
    """A closing sentence in several wordings, and the condition under which a scene needs it.

    `symbolic_wording` is the wording for a symbolic number, which the other wordings would not define. A closing with a
    `topic` appears only in texts of questions that it matters for.
    """

    name: str
    needed: Callable[[Scene], bool]
    wordings: tuple[str, ...]
    role: Role = "assumption"
    symbolic_wording: str = ""
    topic: Topic | None = None

    @property
    def all_wordings(self) -> tuple[str, ...]:
        """Return all wordings, with the symbolic one last."""
        return (*self.wordings, self.symbolic_wording) if self.symbolic_wording else self.wordings


def _from_rest(scene: Scene) -> bool:
    return bool(scene.mechanism.coordinates) and scene.starts_from_rest


def _strings(scene: Scene) -> int:
    """Return how many strings a closing sentence must call taut (2 means several); 0 if all are called taut before.

    A massive pulley divides one string into several lines.
    """
    taut = tuple(f"{named.name}." for named in scene.entities if named.entity.tells_taut)
    lines = [line for line in scene.mechanism.lines if isinstance(line.law, Inextensible | ConstantTension)]
    left = [line for line in lines if isinstance(line.law, Inextensible) and not line.name.startswith(taut)]
    return min(2, len({line.name.partition("/")[0] for line in lines})) if left else 0


def _slackens(scene: Scene) -> bool:
    return any(named.entity.slackens for named in scene.entities)


def is_single_body(scene: Scene) -> bool:
    """Return whether only one body moves."""
    return sum(bool(body.coordinates) for body in scene.mechanism.bodies) == 1


def _has_massive_pulley(scene: Scene) -> bool:
    pulleys = (body for body in scene.bodies.values() if body.nouns[0] == "pulley")
    return any(getattr(body, "mass", 0.0) > 0.0 for body in pulleys)


def _turns(scene: Scene) -> int:
    """Return the number of pulleys mentioned in the text; all small pulleys at corners together count as one."""
    mechanism = scene.mechanism
    corners = {site for line in mechanism.lines for site in line.through[1:-1]}
    wheels = {f"{address}." for address, body in scene.bodies.items() if body.nouns[0] == "pulley"}
    return len(wheels) + len({corner for corner in corners if corner.rpartition(".")[0] + "." not in wheels})


def _has_edges(scene: Scene) -> bool:
    """Return whether a body lies on a face of a moving body, over whose edge it could slide."""
    mechanism = scene.mechanism
    parents = {body.name: body.parent for body in mechanism.bodies}
    moving = {body.name for body in mechanism.bodies if body.coordinates}
    return any(parents[face.subject] in moving for face in mechanism.faces)


def _has_faces(scene: Scene) -> bool:
    return _turns(scene) == 0 and _has_edges(scene)


CONTACT_GAP = 1e-9  # m; smaller gaps count as contact
RELEASES = (
    "everything is released from rest{taut}.",
    "everything starts from rest{taut}.",
    "all bodies are released from rest{taut}.",
    "everything is held at rest{taut}, and then released.",
    "the motion starts from rest{taut}.",
    "the system is released from rest{taut}.",
    "all bodies are held at rest{taut}, and let go together.",
    "until t = 0 everything is held at rest{taut}.",
    "the system starts from rest{taut}.",
    "the bodies are held at rest{taut}, and then let go.",
    "the bodies are released from rest{taut}.",
)
LONE_RELEASES = (
    "the motion starts from rest{taut}.",
    "the motion begins from rest{taut}.",
)
TAUT = ("", " with the string taut", " with all strings taut")
STRETCHED = (
    (),
    ("the string is taut at the start.", "the string is taut at first.", "when the motion begins, the string is taut."),
    (
        "all strings are taut at the start.",
        "all strings are taut at first.",
        "when the motion begins, all strings are taut.",
    ),
)


def _release(strings: int, *, lone: bool) -> Closing:
    """Return the closing sentence for a start from rest, of one body or several, with 0, 1 or more taut strings."""
    wordings = LONE_RELEASES if lone else RELEASES
    return Closing(
        f"rest{' of one body' * lone}{TAUT[strings]}",
        lambda scene: _from_rest(scene) and _strings(scene) == strings and is_single_body(scene) is lone,
        tuple(wording.replace("{taut}", TAUT[strings]) for wording in wordings),
        role="start",
    )


def _stretched(strings: int) -> Closing:
    """Return the closing sentence that calls strings taut, for scenes whose entities state their initial motion."""
    return Closing(
        f"start{TAUT[strings]}",
        lambda scene: not _from_rest(scene) and _strings(scene) == strings,
        STRETCHED[strings],
        role="fact",
    )


TURNING = {  # keys: several pulleys, massive pulleys
    (False, False): (
        "the pulley is frictionless",
        "there is no friction at the pulley",
        "friction at the pulley is negligible",
        "the pulley turns freely",
    ),
    (True, False): (
        "the pulleys are frictionless",
        "there is no friction at pulleys",
        "friction at pulleys is negligible",
        "pulleys turn without friction",
    ),
    (False, True): (
        "the pulley turns without friction, no string slips on it",
        "no string slips on the pulley, which turns freely",
        "the axle is frictionless, no string slips on the pulley",
    ),
    (True, True): (
        "pulleys turn without friction, no string slips on them",
        "no string slips on the pulleys, which turn freely",
        "axles are frictionless, no string slips on a pulley",
    ),
}
SPACE_WORDINGS = {  # keys: several pulleys, edges
    (False, False): ("every string is long enough", "no body reaches it", "there is ample room to move"),
    (True, False): ("no body reaches a pulley", "every string is long enough", "all strings are long enough"),
    (False, True): (
        "no body reaches an edge",
        "there is ample room to move",
        "all surfaces are long enough",
    ),
    (True, True): (
        "no body reaches a pulley or an edge",
        "there is ample room to move",
        "all strings and surfaces are long enough",
    ),
}
_BOOLEANS = (False, True)


def _pulleys(several: bool, massive: bool, edges: bool) -> Closing:  # noqa: FBT001 - the three ways in which they differ
    """Return the closing sentence that states how pulleys turn and that bodies reach neither pulleys nor edges."""

    def needed(scene: Scene) -> bool:
        count = _turns(scene)
        return count > 0 and (count > 1, _has_massive_pulley(scene), _has_edges(scene)) == (several, massive, edges)

    pulleys = "massive " * massive + ("pulleys" if several else "pulley")
    wordings = tuple(
        f"{turning}, and {room}." for turning in TURNING[several, massive] for room in SPACE_WORDINGS[several, edges]
    )
    return Closing(f"{pulleys} and room{' on faces' * edges}", needed, wordings)


def _touches(scene: Scene) -> bool:
    """Return whether bodies touch at the start, in a scene where several pairs may bounce off each other."""
    mechanism = scene.mechanism
    bouncing = [meeting for meeting in mechanism.meetings if meeting.restitution > 0.0]
    if len(bouncing) < 2:
        return False
    frames = initial_frames(mechanism)
    return any(_gap(frames, meeting) <= CONTACT_GAP for meeting in bouncing)


def _gap(frames: Frames, meeting: CollisionPair) -> float:
    """Return the initial gap between two bodies, or a body and a surface, m."""
    other = frames.center(meeting.b).place
    separation = other if meeting.a is None else subtract_triples(other, frames.center(meeting.a).place)
    return float(hypot(*separation) if meeting.normal is None else dot(meeting.normal, separation)) - meeting.distance


CLOSINGS: tuple[Closing, ...] = (
    *(_release(strings, lone=lone) for lone in (False, True) for strings in range(3)),
    *(_stretched(strings) for strings in (1, 2)),
    Closing(
        "slack string",
        _slackens,
        (
            "whenever the string becomes taut again, the velocity along it is lost.",
            "each time the slack string becomes taut, the velocity along it is lost.",
            "if the string goes slack and becomes taut again, the velocity along it is lost at that moment.",
        ),
        topic="slack",
    ),
    Closing(
        "touching bodies",
        _touches,
        (
            "bodies that touch collide in pairs, one pair after the other.",
            "where several bodies touch, collisions pass from pair to pair.",
            "each collision is one of two bodies, also where several touch.",
        ),
    ),
    *(_pulleys(several, massive, edges) for several in _BOOLEANS for massive in _BOOLEANS for edges in _BOOLEANS),
    Closing(
        "room on faces",
        _has_faces,
        ("no body reaches an edge.", "all surfaces are long enough.", "there is ample room to move."),
    ),
    Closing(
        "g",
        lambda scene: (
            is_gravity_relevant(scene.mechanism) or (not scene.world.gravity and would_gravity_matter(scene.mechanism))
        ),
        (
            "take g = {world.gravity}.",
            "use g = {world.gravity}.",
            "here g = {world.gravity}.",
            "let g = {world.gravity}.",
            "the free-fall acceleration is g = {world.gravity}.",
            "the acceleration due to gravity is g = {world.gravity}.",
            "the acceleration of free fall is g = {world.gravity}.",
        ),
        symbolic_wording="the acceleration of free fall is {world.gravity}.",
    ),
)


REST_SENTENCES: dict[str, str] = {
    (wording[0].upper() + wording[1:]).replace("{taut}", taut): taut
    for wording in (*RELEASES, *LONE_RELEASES)
    for taut in TAUT
}
"""All sentences that say that all starts from rest, and what each says of strings."""


def closings(scene: Scene) -> list[Closing]:
    """Return the closing sentences that a scene needs, in the order of the text."""
    return [closing for closing in CLOSINGS if closing.needed(scene)]


def is_assumption(sentence: str) -> bool:
    """Return whether a closing sentence states an assumption about the whole motion, such as taut strings."""
    return _assumptions().fullmatch(sentence) is not None


@cache
def _assumptions() -> re.Pattern[str]:
    wordings = [wording for closing in CLOSINGS if closing.role == "assumption" for wording in closing.all_wordings]
    shown = (re.escape(wording[:1].upper() + wording[1:]) for wording in wordings)
    return re.compile("|".join(re.sub(r"\\\{.*?\\\}", r"\\S.{0,30}", wording) for wording in shown))

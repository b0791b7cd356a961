"""Questions for the number with which a body rolls, is halted by a collision, or keeps its angle."""

from collections.abc import Iterator
from math import inf, isclose

from sim2reason.errors import TextError
from sim2reason.quantities.subjects.bodies import Bodies, TurningBodies
from sim2reason.questions.derived_numbers import number_at
from sim2reason.questions.following import FollowedMotion
from sim2reason.questions.moments.parts.slip_change import rolls
from sim2reason.questions.ordinary.meaning import Understood
from sim2reason.questions.ordinary.reading import Reading
from sim2reason.questions.ordinary.whatif.condition_rows import GRIPS, HALTED, SPINS
from sim2reason.questions.ordinary.whatif.conditions import StatedCondition
from sim2reason.questions.ordinary.whatif.frames import WantedFrame
from sim2reason.questions.ordinary.whatif.numbers import NamedNumber, paths_of
from sim2reason.questions.ordinary.whens import AFTER
from sim2reason.questions.posing import GREATEST, VALUE
from sim2reason.questions.structured import START, StructuredQuestion, measured
from sim2reason.questions.targets import OWN_AXLE, OWN_PATH
from sim2reason.questions.unknown import limits_of
from sim2reason.questions.words import Words

NEEDED = "coefficient of friction needed"
NEARLY = 1.0 - 1e-9
SAME = 1e-6  # relative


def special_outcome(
    frame: WantedFrame, condition: StatedCondition, path: str, who: str, motion: FollowedMotion, words: Words
) -> Iterator[Reading]:
    """Yield the readings of a question for the number that makes a body roll, stop in a collision, or keep its angle.

    The number is at the address `path`, and `who` is the text's phrase for the body; it may be empty.
    """
    outcome, bodies = condition.outcome, {said: name for name, said in words.called(Bodies()).items()}
    friction = frame.number.kind == "friction"
    if outcome == GRIPS and friction and frame.end != GREATEST and not words.released:
        yield from friction_needed(path, who or next(iter(frame.number.owners), ""), motion, words, stopped=False)
    elif outcome == SPINS and friction and path and not words.released:
        body = bodies.get(who) or (next(iter(bodies.values())) if len(bodies) == 1 else "")
        if body and rolls(words, body):
            yield Reading(StructuredQuestion(path, body, START, OWN_PATH, "acceleration = 0 m/s^2"))
    elif outcome == HALTED and path and who in bodies:
        yield Reading(StructuredQuestion(path, bodies[who], "collided", OWN_PATH, "velocity = 0 m/s"))
    elif outcome not in (GRIPS, SPINS, HALTED) and path and words.released and _is_at(condition, motion, words):
        arms = {said: name for name, said in words.called(TurningBodies()).items()}
        if who in arms:
            yield Reading(StructuredQuestion(path, arms[who], START, OWN_AXLE, "angular acceleration = 0 rad/s^2"))


def _is_at(condition: StatedCondition, motion: FollowedMotion, words: Words) -> bool:
    """Return whether an angle that a condition states, if it does, is the one that the scene begins with."""
    if not condition.stated:
        return True
    paths = paths_of(NamedNumber("swing angle"), motion.study, words)
    try:
        stated = measured("question", condition.stated, "deg")
    except TextError:
        return False
    return len(paths) == 1 and isclose(abs(number_at(motion.study.scene, paths[0])), stated, rel_tol=SAME)


def friction_needed(path: str, who: str, motion: FollowedMotion, words: Words, *, stopped: bool) -> Iterator[Reading]:
    """Yield the question for the least coefficient of friction with which a body stays at rest, or rolls.

    If `stopped`, the body is set moving at the start, and is to stay at rest where it first stops.
    """
    if words.released if stopped else not words.released and not _rolling(words):
        return
    bodies = {said: name for name, said in words.called(Bodies()).items()}
    rough = {name for name, contact in words.mechanism.contacts.items() if contact.friction > 0.0}
    if not path and any(words.mechanism.contacts[name].friction < inf for name in rough):
        return  # the scene has a coefficient, but not the one that is meant
    of = bodies.get(who, "") if bodies.get(who) in rough else next(iter(rough), "") if len(rough) == 1 else ""
    if of and path and path.partition(".")[0] != of.partition(".")[0]:  # the number of another face
        if words.mechanism.contacts[of].friction < inf:
            return
        path = ""
    if of:
        change = f"{path} = {limits_of(motion.study.scene, path)[1]:g}" if path else ""
        slips = words.mechanism.contacts[of].friction < inf and rolls(words, of) and not words.released
        when = f"{of} stopped" if stopped else f"{of} stopped slipping" if slips else START
        asked = StructuredQuestion(NEEDED, of, when, change=change, compare=VALUE if change else "")
        yield Reading(asked, side=AFTER, steady=not change)


def slips_nevertheless(found: Understood) -> bool:
    """Return whether a body slips even with the greatest coefficient of friction that a scene can have."""
    if found.asked.find != NEEDED or found.posed.varied is None or found.followed.answer is None:
        return False
    _, most = found.posed.varied.values[0]
    return found.followed.answer >= NEARLY * most


def _rolling(words: Words) -> bool:
    return any(rolls(words, name) for name in words.mechanism.contacts)

"""Questions for the number with which an outcome occurs, such as that a block slips."""

from collections.abc import Iterator, Sequence
from math import inf, isclose

import numpy as np

from sim2reason.errors import TextError
from sim2reason.questions.following import FollowedMotion, simulate_scene
from sim2reason.questions.moments.occurrence import can_roll
from sim2reason.questions.ordinary.hearing import ALL_WORD
from sim2reason.questions.ordinary.moment_phrases import AFTER, addresses
from sim2reason.questions.ordinary.reading import Reading, UnderstoodQuestion
from sim2reason.questions.ordinary.wanted import lies_on_rough_face, without_acceleration
from sim2reason.questions.ordinary.whatif.conditions import (
    BOUND,
    CIRCULAR,
    CLIMBS,
    DESCENDS,
    ESCAPES,
    GRIPS,
    HALTED,
    HOLDS,
    LIFTS,
    RESTS,
    RISES,
    ROUND,
    SINKS,
    SLACK,
    SLIDES,
    SLIPS,
    SPINS,
    STAYS,
    TAUT,
    TILTED,
    TIPS,
    StatedCondition,
)
from sim2reason.questions.ordinary.whatif.frames import WantedFrame
from sim2reason.questions.ordinary.whatif.numbers import NamedNumber, paths_of
from sim2reason.questions.outcomes.strings import Rises
from sim2reason.questions.posing import GREATEST, LEAST, VALUE, pose_question
from sim2reason.questions.query import OWN_AXLE, OWN_PATH
from sim2reason.questions.structured import START, StructuredQuestion, parse_amount
from sim2reason.questions.unknown import find_limits, number_at, with_number
from sim2reason.questions.words import Words
from sim2reason.simulation.quantities.kinematics import Acceleration, Velocity
from sim2reason.simulation.quantities.subjects.bodies import Bodies, TurningBodies
from sim2reason.simulation.quantities.subjects.interactions import PAIR_SEPARATOR

NEEDED = "coefficient of friction needed"
BELOW_THRESHOLD_FACTOR = 1.0 - 1e-9
SAME_VALUE_RTOL = 1e-6  # relative


def special_outcome(
    frame: WantedFrame, condition: StatedCondition, path: str, who: str, motion: FollowedMotion, words: Words
) -> Iterator[Reading]:
    """Yield the readings of a question for the number that makes a body roll, stop in a collision, or keep its angle.

    The number is at the address `path`, and `who` is the text's phrase for the body; it may be empty.
    """
    outcome, bodies = condition.outcome, {phrase: name for name, phrase in words.subject_phrases(Bodies()).items()}
    friction = frame.number.kind == "friction"
    if outcome == GRIPS and friction and frame.end != GREATEST and not words.released:
        yield from friction_needed(path, who or next(iter(frame.number.owners), ""), motion, words, stopped=False)
    elif outcome == SPINS and friction and path and not words.released:
        body = bodies.get(who) or (next(iter(bodies.values())) if len(bodies) == 1 else "")
        if body and can_roll(words, body):
            yield Reading(StructuredQuestion(path, body, START, OWN_PATH, "acceleration = 0 m/s^2"))
    elif outcome == HALTED and path and who in bodies:
        yield Reading(StructuredQuestion(path, bodies[who], "collided", OWN_PATH, "velocity = 0 m/s"))
    elif outcome not in (GRIPS, SPINS, HALTED) and path and words.released and _is_at(condition, motion, words):
        arms = {phrase: name for name, phrase in words.subject_phrases(TurningBodies()).items()}
        if who in arms:
            yield Reading(StructuredQuestion(path, arms[who], START, OWN_AXLE, "angular acceleration = 0 rad/s^2"))


def _is_at(condition: StatedCondition, motion: FollowedMotion, words: Words) -> bool:
    """Return whether the angle of a condition, if it states one, is that of the initial scene."""
    if not condition.stated:
        return True
    paths = paths_of(NamedNumber("swing angle"), motion.study, words)
    try:
        stated = parse_amount("question", condition.stated, "deg")
    except TextError:
        return False
    return len(paths) == 1 and isclose(abs(number_at(motion.study.scene, paths[0])), stated, rel_tol=SAME_VALUE_RTOL)


def friction_needed(path: str, who: str, motion: FollowedMotion, words: Words, *, stopped: bool) -> Iterator[Reading]:
    """Yield the question for the least coefficient of friction with which a body stays at rest, or rolls.

    If `stopped`, the body is set moving at the start, and is to stay at rest where it first stops.
    """
    if words.released if stopped else not words.released and not _rolling(words):
        return
    bodies = {phrase: name for name, phrase in words.subject_phrases(Bodies()).items()}
    rough = {name for name, contact in words.mechanism.contacts.items() if contact.friction > 0.0}
    if not path and any(words.mechanism.contacts[name].friction < inf for name in rough):
        return  # the scene has a coefficient, but not the one that is meant
    of = bodies.get(who, "") if bodies.get(who) in rough else next(iter(rough), "") if len(rough) == 1 else ""
    if of and path and path.partition(".")[0] != of.partition(".")[0]:  # the number of another face
        if words.mechanism.contacts[of].friction < inf:
            return
        path = ""
    if of:
        change = f"{path} = {find_limits(motion.study.scene, path)[1]:g}" if path else ""
        slips = words.mechanism.contacts[of].friction < inf and can_roll(words, of) and not words.released
        when = f"{of} stopped" if stopped else f"{of} stopped slipping" if slips else START
        question = StructuredQuestion(NEEDED, of, when, change=change, compare=VALUE if change else "")
        yield Reading(question, side=AFTER, steady=not change)


def slips_nevertheless(meaning: UnderstoodQuestion) -> bool:
    """Return whether a body slips even with the greatest coefficient of friction that a scene allows."""
    if meaning.asked.find != NEEDED or meaning.posed_question.varied is None or meaning.simulated_answer.answer is None:
        return False
    _, most = meaning.posed_question.varied.values[0]
    return meaning.simulated_answer.answer >= BELOW_THRESHOLD_FACTOR * most


def _rolling(words: Words) -> bool:
    return any(can_roll(words, name) for name in words.mechanism.contacts)


CIRCULAR_SPEED = "circular speed"
BEYOND_THRESHOLD_FACTOR = 1.0 + 1e-3  # factor on a threshold, to find the outcome beyond it
PLANE_DIRECTIONS = 2  # directions of a body that does not move on a line
ZERO_ACCELERATION_RTOL = 1e-6  # of g: smaller accelerations are zero
RIGHT_ANGLE_COSINE_TOL = 1e-9  # the cosine of a right angle
THRESHOLDS = {
    HOLDS: (("slides", False), ("slips rolling", False)),
    SLIPS: (("slides", True), ("slips rolling", True)),
    RISES: (("rises", True), ("lifts off", True)),
    SINKS: (("rises", False),),
    LIFTS: (("lifts off", True), ("rises", True)),
    ROUND: (("goes round", True), ("circles", True)),
    TAUT: (("goes slack", False),),
    SLACK: (("goes slack", True),),
    SLIDES: (("sinks", False),),
    TIPS: (("tips over", True),),
}
"""By the outcome that a sentence names, the outcomes of the library to try, and whether each is to happen."""


def by_outcome(
    frame: WantedFrame, condition: StatedCondition, path: str, motion: FollowedMotion, words: Words
) -> Iterator[Reading]:
    """Yield the readings of a question such as *what mass must B have for A to stay at rest*.

    The number (the mass of B) is at the address `path`; it is empty if the scene has no such number, which only a
    needed coefficient of friction allows. The outcome (A stays at rest) is that of `condition`.
    """
    who, outcome = condition.subject.removeprefix(f"{ALL_WORD} "), condition.outcome
    who = "" if " & " in who else who
    friction = frame.number.kind == "friction"
    outcome = _without_slipping(outcome, words, friction=friction, end=frame.end)
    if friction and outcome in (HOLDS, STAYS):
        of = who or next(iter(frame.number.owners), "")
        stopped = outcome == STAYS
        yield from friction_needed(path, of, motion, words, stopped=stopped) if frame.end != GREATEST else ()
    elif path and outcome in (CLIMBS, DESCENDS) and lies_on_rough_face(words):
        yield from _steadily(frame, condition, path, who, words)
    elif outcome in (GRIPS, SPINS, HALTED, TILTED):
        yield from special_outcome(frame, condition, path, who, motion, words)
    elif path and outcome in (RESTS, CLIMBS, DESCENDS):
        yield from _balanced(path, who, words)
    elif outcome in (ESCAPES, BOUND, CIRCULAR):
        for pair in _orbits(who, words):
            if outcome == CIRCULAR and frame.number.kind == "speed" and frame.compare == VALUE and not frame.end:
                yield Reading(StructuredQuestion(CIRCULAR_SPEED, pair, START))
            elif path:
                yield from _orbiting(outcome, path, pair, motion, words)
    elif path and outcome in THRESHOLDS:
        yield from _thresholds(frame, condition, THRESHOLDS[outcome], path, who)


def _without_slipping(outcome: str, words: Words, *, friction: bool, end: str) -> str:
    """Return the outcome meant by *not slide down* or *stay at rest* if friction decides about it."""
    if outcome == SLIDES and friction:
        return HOLDS if words.released else STAYS
    return HOLDS if outcome == RESTS and (friction or (end and lies_on_rough_face(words))) else outcome


def _steadily(frame: WantedFrame, condition: StatedCondition, path: str, who: str, words: Words) -> Iterator[Reading]:
    """Yield the questions for the number with which a body just begins to move up or down a rough slope.

    What just begins to climb then goes on without acceleration, if kinetic friction is as great as static friction.
    """
    row = ("rises", True) if condition.outcome == CLIMBS else ("sinks", True)
    if _as_rough_at_rest(words):
        for body in (who,) if who else _inclined(words):
            yield from _thresholds(frame, condition, (row,), path, body)


def _thresholds(
    frame: WantedFrame, condition: StatedCondition, rows: Sequence[tuple[str, bool]], path: str, who: str
) -> Iterator[Reading]:
    """Yield the questions for the number at which an outcome changes, for the named or the only possible subject."""
    is_minimum = {LEAST: True, GREATEST: False}.get(frame.end)
    rows = rows[1:] if condition.outcome == ROUND and condition.taut else rows
    for rank, (does, happens) in enumerate(rows):
        for after, of in enumerate(dict.fromkeys((who, ""))):
            question = StructuredQuestion(path, when=f"{of} {does}".strip())
            yield Reading(question, rank=2 * rank + after, least=is_minimum, happens=happens)


def _inclined(words: Words) -> Iterator[str]:
    """Yield the phrases of the bodies that lie on inclined faces and ride on no other body."""
    for name, phrase in words.subject_phrases(Bodies()).items():
        if name in words.mechanism.contacts and name in Rises.candidates(words):
            yield phrase


def _as_rough_at_rest(words: Words) -> bool:
    return all(contact.static_ratio == 1.0 for contact in words.mechanism.contacts.values())


def on_the_other_side(
    meaning: UnderstoodQuestion, frame: WantedFrame, condition: StatedCondition, motion: FollowedMotion, words: Words
) -> bool:
    """Return whether the outcome occurs on the other side of the threshold than the question presumes."""
    value, path = meaning.simulated_answer.answer, meaning.asked.find
    if condition.outcome not in (ESCAPES, BOUND) or not frame.end or value is None or not meaning.asked.given:
        return False
    factor = BEYOND_THRESHOLD_FACTOR if frame.end == LEAST else 1.0 / BEYOND_THRESHOLD_FACTOR
    there = simulate_scene(with_number(motion.study.scene, path, value * factor))
    shape = (
        pose_question(StructuredQuestion("eccentricity", meaning.asked.of, START), there, words)
        .simulate_answer(there)
        .answer
    )
    return shape is None or (shape > 1.0) != (condition.outcome == ESCAPES)


def moves_nevertheless(
    meaning: UnderstoodQuestion, condition: StatedCondition, motion: FollowedMotion, words: Words
) -> bool:
    """Return whether a condition fails with the number found.

    It fails if a body that is to stay at rest is accelerated, or one that is to move meanwhile is not.
    """
    value, path = meaning.simulated_answer.answer, meaning.asked.find
    if (
        condition.outcome != RESTS
        or not meaning.asked.given
        or value is None
        or meaning.asked.compare not in ("", VALUE)
    ):
        return False
    study = simulate_scene(with_number(motion.study.scene, path, value)).study
    start, subject_phrases = study.trace.at(0.0), condition.subject.removeprefix(f"{ALL_WORD} ").split(" & ")
    named = {name for name, phrase in words.subject_phrases(Bodies()).items() if phrase in subject_phrases}
    arms = any(phrase in subject_phrases for phrase in words.subject_phrases(TurningBodies()).values())
    names = named or ({meaning.asked.of} & study.mechanism.body.keys() if condition.subject and not arms else None)
    largest = max(float(np.linalg.norm(study.mechanism.gravity)), 1.0)

    def moves(name: str) -> bool:
        return float(np.linalg.norm(Acceleration.evaluate(start, name)[0])) > ZERO_ACCELERATION_RTOL * largest

    moving_names = [name for name, phrase in words.subject_phrases(Bodies()).items() if phrase in condition.moving]
    return any(map(moves, names or words.subject_phrases(Bodies()))) or not all(map(moves, moving_names))


def _balanced(path: str, who: str, words: Words) -> Iterator[Reading]:
    """Yield the questions for the number with which a body, or each body, has no acceleration.

    With friction, a whole range of numbers does, so that there are none but for a named body on a smooth face.
    """
    alone = addresses(words).get(who)
    if lies_on_rough_face(words):
        contact = words.mechanism.contacts.get(alone or "")
        if contact is None or contact.friction > 0.0:
            return  # within a whole range of numbers
    bodies = words.subject_phrases(Bodies())
    senses = Bodies().senses(words.mechanism, alone) if alone in words.mechanism.body else []
    yield from without_acceleration(
        path, (alone,) if alone is not None and len(senses) < PLANE_DIRECTIONS else bodies, words
    )


def _orbits(who: str, words: Words) -> Iterator[str]:
    """Yield names of pairs of bodies that attract each other, such as *A & B*; only those with a named body, if any."""
    name = addresses(words).get(who, "")
    for pull in words.mechanism.attractions:
        if not name or name in (pull.a, pull.b):
            yield f"{pull.a} & {pull.b}"


def _orbiting(outcome: str, path: str, pair: str, motion: FollowedMotion, words: Words) -> Iterator[Reading]:
    """Yield the question for the number with which an orbit is a parabola or a circle.

    If the velocity at the start is perpendicular to the line between the two bodies, the orbit is a circle where its
    semi-major axis is the distance at the start; else no number makes it a circle.
    """
    if outcome != CIRCULAR:
        yield Reading(StructuredQuestion(path, pair, START, given="eccentricity = 1"))
        return
    study, (a, b) = motion.study, pair.split(PAIR_SEPARATOR)
    start = study.trace.at(0.0)
    separation = start.vector(start.frames.center(a).place)[0] - start.vector(start.frames.center(b).place)[0]
    velocity = Velocity.evaluate(start, a)[0] - Velocity.evaluate(start, b)[0]
    sizes = float(np.linalg.norm(separation) * np.linalg.norm(velocity))
    if abs(float(separation @ velocity)) <= RIGHT_ANGLE_COSINE_TOL * sizes:
        distance = f"{float(np.linalg.norm(separation)):.15g} {words.units.spell('m')}"
        yield Reading(StructuredQuestion(path, pair, START, given=f"semi-major axis = {distance}"))

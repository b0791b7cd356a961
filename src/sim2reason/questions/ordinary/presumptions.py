"""Presumptions of a question in ordinary English, and their tests in a motion."""

from collections.abc import Callable, Mapping
from math import isclose
from typing import NamedTuple

import numpy as np

from sim2reason.errors import TextError
from sim2reason.questions.following import SimulatedAnswer
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.occurrence import can_roll, slip_velocity
from sim2reason.questions.ordinary.moment_phrases import addresses
from sim2reason.questions.ordinary.vocabulary import (
    ABOVE_GROUND,
    CARRIED_AT_REST,
    COMPRESSED,
    FALLS,
    FIELDS_ALONE,
    GAINED,
    LASTS,
    LEVEL,
    ONCE,
    ONE_LINE,
    ONE_WAY,
    ONLY,
    OVER,
    RELAXED,
    RESTS,
    RISING,
    ROLLING,
    SETS_OFF,
    SLOWER,
    SMALL_OSCILLATIONS,
    SMOOTH,
    STRAIGHT,
    STRETCHED,
    UNMOVED,
)
from sim2reason.questions.query import Query
from sim2reason.questions.recurrence import ends_at_rest
from sim2reason.questions.structured import resolve_name
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.fields import Magnetic, Push
from sim2reason.scenes.dsl.mechanism import ZERO, Mechanism
from sim2reason.simulation.equilibrium import equilibrium
from sim2reason.simulation.quantities.force_laws import Extension
from sim2reason.simulation.quantities.kinematics import Acceleration, Displacement, Velocity
from sim2reason.simulation.quantities.subjects.bodies import Bodies, center_path
from sim2reason.simulation.quantities.subjects.interactions import Springs

STEADY, EVEN = 1e-6, 1e-9  # relative
OF_PLACES = "spring energy", "extension", "spring length", "height above the ground", "distance", "mass", "fuel left"
DURATION_MARGIN = 1.05  # factor on the end of an interval: least duration of the known motion


class Case(NamedTuple):
    """A case of a presumption to test: a subject, the motion, the query and the instant, s."""

    who: str
    followed: SimulatedAnswer
    query: Query
    then: float
    words: Words


def find_named_body(who: str, words: Words) -> str:
    """Return the name of the body that a phrase of the text denotes; empty if there is none."""
    try:
        return resolve_name("of", who, words.subject_phrases(Bodies()))
    except TextError:
        return addresses(words).get(who, "")


def _falls(mechanism: Mechanism, name: str) -> bool:
    return mechanism.gravity != ZERO and center_path(mechanism, name).rises


def is_only_force(force: str, who: str, words: Words) -> bool:
    """Return whether only one type of force acts on a body: magnetic, electric or one gravitational force."""
    mechanism, name = words.mechanism, find_named_body(who, words)
    laws = [applied_force.law for applied_force in mechanism.forces if applied_force.body == name]
    pulls = [pull for pull in mechanism.attractions if name in (pull.a, pull.b)]
    if not name or _falls(mechanism, name) or mechanism.lines or mechanism.contacts or (laws and pulls):
        return False
    kinds = {"magnetic force": Magnetic, "electric force": Push}
    if force in kinds:
        return bool(laws) and all(isinstance(law, kinds[force]) for law in laws)
    return len(pulls) == 1 and not laws


def _carried_at_rest(case: Case) -> bool:
    """Return whether the carrier of a body, if any, is at rest at the instant in question."""
    name, mechanism = find_named_body(case.who, case.words), case.words.mechanism
    if not name:
        return False
    parent = mechanism.body[name].parent
    scan = case.followed.study.trace
    if parent is None:
        return False
    fastest = float(np.abs(scan.scan.v).max(initial=0.0))
    return float(np.linalg.norm(Velocity.evaluate(scan.at(case.then), parent))) <= STEADY * fastest


def _aloft(case: Case) -> bool:
    """Return whether the answer, a height above the ground, is greater than zero."""
    return (case.followed.answer or 0.0) > EVEN


def _small(case: Case) -> bool:
    """Return whether no body swings under gravity."""
    mechanism = case.words.mechanism
    hinges = [c for c in mechanism.coordinates if c.kind == "hinge" and abs(c.axis[2]) < 1.0 - EVEN]
    return mechanism.gravity == ZERO or not hinges or bool(mechanism.contacts)


def _slower(case: Case) -> bool:
    state, name = case.followed.study.trace.at(case.then), find_named_body(case.who, case.words)
    return bool(name) and float(np.sum(Velocity.evaluate(state, name) * Acceleration.evaluate(state, name))) < 0.0


def _compressed(case: Case) -> bool:
    spring = resolve_name("of", case.who, case.words.subject_phrases(Springs()))
    return float(Extension.evaluate(case.followed.study.trace.at(case.then), spring)[0]) < 0.0


def _stretched(case: Case) -> bool:
    spring = resolve_name("of", case.who, case.words.subject_phrases(Springs()))
    return float(Extension.evaluate(case.followed.study.trace.at(case.then), spring)[0]) > 0.0


def relaxed_at_rest(case: Case) -> bool:
    """Return whether the only spring is neither stretched nor compressed in equilibrium."""
    rest = equilibrium(case.words.mechanism)
    springs = list(case.words.subject_phrases(Springs()))
    if rest is None or rest.free or len(springs) != 1:
        return False
    size = float(np.abs(Extension.evaluate(case.followed.study.trace.scan, springs[0])).max())
    return abs(float(Extension.evaluate(rest.state, springs[0])[0])) <= STEADY * size


def _once(case: Case) -> bool:
    events = case.followed.study.trace.events
    return sum(event.kind == "collision" and event.time <= case.then * (1.0 + EVEN) for event in events) == 1


def _only(case: Case) -> bool:
    return sum(event.kind == "collision" for event in case.followed.study.trace.events) == 1


def _over(case: Case) -> bool:
    """Return whether a functional keeps its value from the instant asked about to a later end of the known motion."""
    trace = case.followed.study.trace
    if not isinstance(case.query, StretchQuery) or trace.stable_until < DURATION_MARGIN * case.then:
        return False
    late = FUNCTIONALS[case.query.functional].loose_value(trace, case.query.name, trace.stable_until)
    return late is not None and isclose(late, case.followed.answer or 0.0, rel_tol=STEADY)


def _rising(case: Case) -> bool:
    """Return whether the answer, a height above the start, is greater than zero."""
    scan = case.followed.study.trace.scan
    moved = max(float(np.abs(Displacement.evaluate(scan, name)).max()) for name in case.words.subject_phrases(Bodies()))
    return (case.followed.answer or 0.0) > STEADY * moved


def _rolling(case: Case) -> bool:
    """Return whether a body has rolled without slipping since the start; true for a body that cannot roll on a face."""
    name, trace = find_named_body(case.who, case.words), case.followed.study.trace
    if name not in case.words.mechanism.contacts or not can_roll(case.words, name):
        return True
    scan = trace.scan
    slipping = np.abs(slip_velocity(scan, name))[scan.times <= case.then]
    return float(slipping.max(initial=0.0)) <= STEADY * float(np.abs(scan.v).max(initial=0.0))


def _rests(case: Case) -> bool:
    """Return whether all bodies are at rest for good from the instant asked about on."""
    trace = case.followed.study.trace
    speeds = np.abs(trace.scan.v).max(axis=1, initial=0.0)
    late = speeds[trace.scan.times > case.then * (1.0 + EVEN)]
    still = float(late.max(initial=0.0)) <= STEADY * float(speeds.max(initial=0.0))
    return trace.stable_until > DURATION_MARGIN * case.then and still and ends_at_rest(trace)


def _lasts(case: Case) -> bool:
    """Return whether a quantity keeps its value from the instant asked about to a later end of the known motion."""
    trace = case.followed.study.trace
    if case.query.target is None or trace.stable_until < DURATION_MARGIN * case.then:
        return False
    late = case.query.target.values(trace.scan)[trace.scan.times >= case.then * (1.0 + EVEN)]
    return bool(np.allclose(late, case.followed.answer or 0.0, rtol=STEADY, atol=0.0))


def _straight(case: Case) -> bool:
    """Return whether a body has moved in a straight line, without turning back, up to the instant asked about."""
    name, scan = find_named_body(case.who, case.words), case.followed.study.trace.scan
    if not name:
        return False
    velocities = Velocity.evaluate(scan, name)[scan.times <= case.then]
    speeds = np.linalg.norm(velocities, axis=1)
    direction = velocities[int(speeds.argmax())] / max(float(speeds.max()), np.finfo(float).tiny)
    return bool((np.abs(velocities @ direction - speeds) <= STEADY * float(speeds.max())).all())


def one_way(case: Case) -> bool:
    """Return whether a body moves vertically, or along its only possible line, at the instant in question."""
    name = find_named_body(case.who, case.words)
    if not name:
        return False
    velocity = Velocity.evaluate(case.followed.study.trace.at(case.then), name)[0]
    senses = list(Bodies().senses(case.words.mechanism, name))
    lines = [(0.0, 0.0, 1.0), *(senses[0].vector for _ in senses if len(senses) == 1)]
    speed = float(np.linalg.norm(velocity))
    return any(abs(float(velocity @ np.array(line))) >= (1.0 - EVEN) * speed for line in lines)


def _gained(case: Case) -> bool:
    """Return whether the answer, a difference, is greater than zero."""
    return (case.followed.answer or 0.0) > 0.0


def _level(case: Case) -> bool:
    """Return whether a body can move horizontally only."""
    name = find_named_body(case.who, case.words)
    return bool(name) and not center_path(case.words.mechanism, name).rises


def _smooth(case: Case) -> bool:
    """Return whether the face on which a body lies exerts no friction on it."""
    contact = case.words.mechanism.contacts.get(find_named_body(case.who, case.words))
    return contact is not None and contact.friction == 0.0


def _fields_alone(case: Case) -> bool:
    """Return whether only fields and gravitation act on the bodies of a scene."""
    mechanism, name = case.words.mechanism, find_named_body(case.who, case.words)
    return bool(name) and not _falls(mechanism, name) and not mechanism.lines and not mechanism.contacts


def _one_line(case: Case) -> bool:
    """Return whether a body can move along one straight line only."""
    name = find_named_body(case.who, case.words)
    return bool(name) and center_path(case.words.mechanism, name).straight


def _sets_off(case: Case) -> bool:
    """Return whether a body begins to move at once; True if no body is named."""
    name, start = find_named_body(case.who, case.words), case.followed.study.trace.at(0.0)
    moves = (float(np.linalg.norm(quantity.evaluate(start, name))) for quantity in (Velocity, Acceleration) if name)
    return not name or any(size > EVEN for size in moves)


def _unmoved(case: Case) -> bool:
    """Return whether the quantity depends on positions only, so that it is the same before and after release."""
    return case.words.released and case.query.target is not None and case.query.target.quantity in OF_PLACES


def _only_falls(case: Case) -> bool:
    """Return whether a body never moves upwards before the instant asked about."""
    name, scan = find_named_body(case.who, case.words), case.followed.study.trace.scan
    rates = Velocity.evaluate(scan, name)[scan.times <= case.then, 2] if name else np.ones(1)
    return float(rates.max(initial=0.0)) <= STEADY * float(np.abs(rates).max(initial=0.0))


MOTION_PRESUMPTIONS: Mapping[str, tuple[str, Callable[[Case], bool]]] = {
    CARRIED_AT_REST: ("{who} rides on something that moves", _carried_at_rest),
    ABOVE_GROUND: ("{who} is on the ground then", _aloft),
    SMALL_OSCILLATIONS: ("the oscillations are not small, and their period depends on how far they go", _small),
    SLOWER: ("{who} does not slow down", _slower),
    COMPRESSED: ("{who} is not compressed", _compressed),
    RELAXED: ("the spring is not relaxed in equilibrium", relaxed_at_rest),
    ONCE: ("it is not the first collision", _once),
    ONLY: ("it is not the only collision", _only),
    ONE_WAY: ("{who} goes sideways, too", one_way),
    STRETCHED: ("{who} is not stretched", _stretched),
    FALLS: (
        "{who} does not only fall, so say from where on it falls",
        _only_falls,
    ),
    STRAIGHT: ("{who} does not go straight ahead", _straight),
    RESTS: ("it does not stay at rest", _rests),
    LASTS: ("it changes after that", _lasts),
    RISING: ("nothing rises above where it starts", _rising),
    ROLLING: ("{who} slips", _rolling),
    SETS_OFF: ("{who} does not move at first", _sets_off),
    UNMOVED: ("nothing is told of the time before the start", _unmoved),
    GAINED: ("it is the other way round", _gained),
    SMOOTH: ("there is friction, too", _smooth),
    FIELDS_ALONE: ("there are other forces", _fields_alone),
    ONE_LINE: ("{who} does not move along a line", _one_line),
    LEVEL: ("{who} does not move on a level face", _level),
    OVER: ("it goes on after that", _over),
}
"""By the name of a presumption, the message if it fails, and its test; `PRESUMED` has these and more."""

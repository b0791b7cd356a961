"""Presumptions of a question in ordinary English, such as that a quantity is steady or that a body goes up."""

from collections.abc import Callable, Iterator, Mapping
from math import isclose
from typing import NamedTuple

import numpy as np

from sim2reason.dsl.fields import Magnetic, Push
from sim2reason.dsl.mechanism import ZERO, Mechanism
from sim2reason.dsl.state import State
from sim2reason.errors import TextError
from sim2reason.quantities import QUANTITIES
from sim2reason.quantities.height import Height
from sim2reason.quantities.kinematics import Acceleration, Displacement, Velocity
from sim2reason.quantities.springs import Extension
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.paths import center_path
from sim2reason.quantities.subjects.springs import Springs
from sim2reason.questions.following import Followed
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.kinds.parts.stretch_kind import StretchQuery
from sim2reason.questions.moments.parts.slip_change import rolls, slip
from sim2reason.questions.ordinary.reading import Reading
from sim2reason.questions.ordinary.vocabulary import (
    ALOFT,
    CARRIED_AT_REST,
    COMPRESSED,
    FIXED_FACE,
    LASTS,
    ON,
    ONCE,
    ONE_WAY,
    ONLY,
    ORIGIN,
    OVER,
    RELAXED,
    RESTS,
    RISING,
    ROLLING,
    SLOWER,
    SMALL,
    SOLE,
    STRAIGHT,
    STRETCHED,
)
from sim2reason.questions.ordinary.whens import AFTER
from sim2reason.questions.query import Query
from sim2reason.questions.recurrence import ends_at_rest
from sim2reason.questions.structured import resolved
from sim2reason.questions.study import Study
from sim2reason.questions.targets import Target
from sim2reason.questions.words import Words
from sim2reason.simulation.rest.equilibrium import equilibrium
from sim2reason.simulation.trace import Trace

STEADY, EVEN = 1e-6, 1e-9  # relative
EARLY = 0.5  # of a stretch: then it goes the way that it goes
AXES = {"up": (0.0, 0.0, 1.0), "down": (0.0, 0.0, -1.0), "right": (1.0, 0.0, 0.0), "left": (-1.0, 0.0, 0.0)}
LATER = 1.05  # times the end of what is over: so long at least it must have been


class Case(NamedTuple):
    """A case in which to test a presumption: a subject, the motion, the query, and the instant asked about, s."""

    who: str
    followed: Followed
    query: Query
    then: float
    words: Words


def steady(target: Target, trace: Trace, *, during: bool, vanishes: bool, vector: bool) -> str:
    """Return a clause that says why a quantity asked for without a moment has no single value; empty if there is one.

    A value is single if it does not change, its direction included for a `vector`. It may change from the first event
    on if the question asks `during` the motion before that event, or if everything is at rest afterwards. If the
    question's wording implies a value other than zero (`vanishes`), it may also be zero afterwards.
    """
    values = target.values(trace.scan)[:, None]
    if vector:
        values = QUANTITIES[target.quantity].evaluate(trace.scan, target.subject)
    times, changed = trace.scan.times, np.linalg.norm(values - values[0], axis=1)
    first = min((event.time for event in trace.events if event.changes_motion and event.time > 0.0), default=np.inf)
    early, late = times < first * (1.0 - EVEN), times > first * (1.0 + EVEN)
    size = float(np.linalg.norm(values[early], axis=1).max(initial=0.0))
    if float(changed[early].max(initial=0.0)) > STEADY * size:
        return "it changes with time, and no moment is named"
    fastest = float(np.abs(trace.scan.v).max(initial=0.0))
    rests = float(np.abs(trace.scan.v[late]).max(initial=0.0)) <= STEADY * fastest
    gone = vanishes and float(np.linalg.norm(values[late], axis=1).max(initial=0.0)) <= STEADY * size
    same = float(changed.max(initial=0.0)) <= STEADY * size
    return "" if during or rests or gone or same else "it changes when something happens, and no moment is named"


def two_sided(query: Query, study: Study, side: str) -> bool:
    """Return whether the quantity of a query jumps at the query's moment while the question names no side."""
    moment, target = query.moment, query.target
    if moment is None or target is None or moment.sided is not None or moment.ahead is not None or side == AFTER:
        return False
    time = study.time(moment)
    if time is None:
        return False
    before, then = (target.value(study.trace.at(instant)) for instant in (float(np.nextafter(time, 0.0)), time))
    return abs(before - then) > STEADY * max(abs(before), abs(then))


def presumed(reading: Reading, followed: Followed, query: Query, words: Words) -> Iterator[str]:
    """Yield a clause for each presumption of a reading that fails, and an empty string for each that holds."""
    trace = followed.study.trace
    time = followed.study.time(query.moment) if query.moment is not None else None
    events = (event.time for event in trace.events if event.time > 0.0)
    early = EARLY * min(next(iter(sorted(events)), np.inf), float(trace.state.times[-1]))
    then = early if not time else float(np.nextafter(time, 0.0))
    for kind, ways in ((Displacement, reading.gone), (Velocity, reading.moving)):
        for who, way in ways:
            if way in AXES:
                yield "" if _goes(kind, who, way, trace.at(then), words) else f"{who} does not go {way}"
            elif way.startswith(ORIGIN):
                yield "" if _from_origin(who, way[-1], trace.at(0.0), words) else f"{who} does not start at the origin"
            elif way.startswith(SOLE):
                told = way.removeprefix(SOLE)
                yield "" if _alone(told, who, words) else f"{told} is not the only force on {who}"
            elif way.startswith(ON):
                face = way.removeprefix(ON)
                yield "" if _lies(who, face, words) else f"{who} does not lie on {face}"
            else:
                told, holds = OTHERS[way]
                yield "" if holds(Case(who, followed, query, then, words)) else told.format(who=who)


def _goes(kind: type[Displacement | Velocity], who: str, way: str, state: State, words: Words) -> bool:
    name = _name(who, words)
    found = kind.evaluate(state, name)[0] if name else np.zeros(3)
    return float(found @ np.array(AXES[way])) > EVEN * float(np.linalg.norm(found))


def _name(who: str, words: Words) -> str:
    try:
        return resolved("of", who, words.called(Bodies()))
    except TextError:
        return ""


def _lies(who: str, face: str, words: Words) -> bool:
    name = _name(who, words)
    if face == FIXED_FACE:
        return name in words.mechanism.contacts and words.mechanism.body[name].parent is None
    return bool(name) and words.mechanism.body[name].parent == _name(face, words)


def _from_origin(who: str, axis: str, start: State, words: Words) -> bool:
    """Return whether a body starts at the origin of an axis; false where heights count from the ground."""
    name = _name(who, words)
    if not name or Height().subjects(words.mechanism):
        return False
    place = start.vector(start.frames.center(name).place)[0]
    sense = next((sense for sense in Bodies().senses(words.mechanism, name) if sense.axis == axis), None)
    return sense is not None and abs(float(place @ np.array(sense.vector))) <= EVEN


def _falls(mechanism: Mechanism, name: str) -> bool:
    return mechanism.gravity != ZERO and center_path(mechanism, name).rises


def _alone(force: str, who: str, words: Words) -> bool:
    """Return whether forces of one kind alone act on a body: those of a magnetic field, an electric one, or another body."""
    mechanism, name = words.mechanism, _name(who, words)
    laws = [found.law for found in mechanism.forces if found.body == name]
    pulls = [pull for pull in mechanism.attractions if name in (pull.a, pull.b)]
    if not name or _falls(mechanism, name) or mechanism.lines or mechanism.contacts or (laws and pulls):
        return False
    kinds = {"magnetic force": Magnetic, "electric force": Push}
    if force in kinds:
        return bool(laws) and all(isinstance(law, kinds[force]) for law in laws)
    return len(pulls) == 1 and not laws


def _carried_at_rest(case: Case) -> bool:
    """Return whether what carries a body, if anything does, is at rest at the instant asked about."""
    name, mechanism = _name(case.who, case.words), case.words.mechanism
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
    """Return whether nothing swings under gravity."""
    mechanism = case.words.mechanism
    hinges = [c for c in mechanism.coordinates if c.kind == "hinge" and abs(c.axis[2]) < 1.0 - EVEN]
    return mechanism.gravity == ZERO or not hinges or bool(mechanism.contacts)


def _slower(case: Case) -> bool:
    state, name = case.followed.study.trace.at(case.then), _name(case.who, case.words)
    return bool(name) and float(np.sum(Velocity.evaluate(state, name) * Acceleration.evaluate(state, name))) < 0.0


def _compressed(case: Case) -> bool:
    spring = resolved("of", case.who, case.words.called(Springs()))
    return float(Extension.evaluate(case.followed.study.trace.at(case.then), spring)[0]) < 0.0


def _stretched(case: Case) -> bool:
    spring = resolved("of", case.who, case.words.called(Springs()))
    return float(Extension.evaluate(case.followed.study.trace.at(case.then), spring)[0]) > 0.0


def _relaxed_at_rest(case: Case) -> bool:
    """Return whether the only spring is neither stretched nor compressed in equilibrium."""
    rest = equilibrium(case.words.mechanism)
    springs = list(case.words.called(Springs()))
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
    if not isinstance(case.query, StretchQuery) or trace.stable_until < LATER * case.then:
        return False
    late = FUNCTIONALS[case.query.functional].loose_value(trace, case.query.name, trace.stable_until)
    return late is not None and isclose(late, case.followed.answer or 0.0, rel_tol=STEADY)


def _rising(case: Case) -> bool:
    """Return whether the answer, a height above the start, is greater than zero."""
    scan = case.followed.study.trace.scan
    moved = max(float(np.abs(Displacement.evaluate(scan, name)).max()) for name in case.words.called(Bodies()))
    return (case.followed.answer or 0.0) > STEADY * moved


def _rolling(case: Case) -> bool:
    """Return whether a body has rolled without slipping since the start; true for a body that cannot roll on a face."""
    name, trace = _name(case.who, case.words), case.followed.study.trace
    if name not in case.words.mechanism.contacts or not rolls(case.words, name):
        return True
    scan = trace.scan
    slipping = np.abs(slip(scan, name))[scan.times <= case.then]
    return float(slipping.max(initial=0.0)) <= STEADY * float(np.abs(scan.v).max(initial=0.0))


def _rests(case: Case) -> bool:
    """Return whether all bodies are at rest for good by the end of the motion."""
    trace = case.followed.study.trace
    return trace.stable_until > LATER * case.then and ends_at_rest(trace)


def _lasts(case: Case) -> bool:
    """Return whether a quantity keeps its value from the instant asked about to a later end of the known motion."""
    trace = case.followed.study.trace
    if case.query.target is None or trace.stable_until < LATER * case.then:
        return False
    late = case.query.target.values(trace.scan)[trace.scan.times >= case.then * (1.0 + EVEN)]
    return bool(np.allclose(late, case.followed.answer or 0.0, rtol=STEADY, atol=0.0))


def _straight(case: Case) -> bool:
    """Return whether a body has moved in a straight line, without turning back, up to the instant asked about."""
    name, scan = _name(case.who, case.words), case.followed.study.trace.scan
    if not name:
        return False
    velocities = Velocity.evaluate(scan, name)[scan.times <= case.then]
    speeds = np.linalg.norm(velocities, axis=1)
    way = velocities[int(speeds.argmax())] / max(float(speeds.max()), np.finfo(float).tiny)
    return bool((np.abs(velocities @ way - speeds) <= STEADY * float(speeds.max())).all())


def _one_way(case: Case) -> bool:
    """Return whether a body moves straight up or down, or along the only line on which the body can move."""
    name = _name(case.who, case.words)
    if not name:
        return False
    velocity = Velocity.evaluate(case.followed.study.trace.at(case.then), name)[0]
    senses = list(Bodies().senses(case.words.mechanism, name))
    lines = [(0.0, 0.0, 1.0), *(senses[0].vector for _ in senses if len(senses) == 1)]
    speed = float(np.linalg.norm(velocity))
    return any(abs(float(velocity @ np.array(line))) >= (1.0 - EVEN) * speed for line in lines)


OTHERS: Mapping[str, tuple[str, Callable[[Case], bool]]] = {
    CARRIED_AT_REST: ("{who} rides on something that moves", _carried_at_rest),
    ALOFT: ("{who} is on the ground then", _aloft),
    SMALL: ("the oscillations are not small, and their period depends on how far they go", _small),
    SLOWER: ("{who} does not slow down", _slower),
    COMPRESSED: ("{who} is not compressed", _compressed),
    RELAXED: ("the spring is not relaxed in equilibrium", _relaxed_at_rest),
    ONCE: ("it is not the first collision", _once),
    ONLY: ("it is not the only collision", _only),
    ONE_WAY: ("{who} goes sideways, too", _one_way),
    STRETCHED: ("{who} is not stretched", _stretched),
    STRAIGHT: ("{who} does not go straight ahead", _straight),
    RESTS: ("it does not stay at rest", _rests),
    LASTS: ("it changes after that", _lasts),
    RISING: ("nothing rises above where it starts", _rising),
    ROLLING: ("{who} slips", _rolling),
    OVER: ("it goes on after that", _over),
}
"""By what is taken for granted: what is said where it is not so, and whether it is."""

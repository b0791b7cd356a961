"""Presumptions of a question: a constant quantity, a direction of motion, the interval after the moment."""

from collections.abc import Iterator

import numpy as np

from sim2reason.questions.following import SimulatedAnswer
from sim2reason.questions.moments.turning_points import Stopped
from sim2reason.questions.ordinary.hearing import ALL_WORD
from sim2reason.questions.ordinary.moment_phrases import AFTER
from sim2reason.questions.ordinary.presumed_of_scenes import PRESUMPTIONS, is_carried, is_fixed_spring_of
from sim2reason.questions.ordinary.presumptions import EVEN, STEADY, Case, find_named_body, is_only_force
from sim2reason.questions.ordinary.reading import Reading
from sim2reason.questions.ordinary.vocabulary import (
    BELOW_CARRIER_PREFIX,
    CARRIED_BY_PREFIX,
    FIXED_FACE,
    HELD,
    ON,
    ONLY_FORCE_PREFIX,
    ORIGIN,
    ROUND,
    THEN_GOES,
)
from sim2reason.questions.query import Query, Target
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.state import State
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.quantities.kinematics import Acceleration, Displacement, Velocity
from sim2reason.simulation.quantities.positions import Height
from sim2reason.simulation.quantities.subjects.bodies import Bodies, center_path
from sim2reason.simulation.trace import Trace

SOON, LATE = 0.01, 0.9  # of the interval up to the next event, or to the end of the known motion
UP = {"up": 1.0, "down": -1.0}


def goes_then(case: Case, direction: str) -> bool:
    """Return whether a body moves up, or down, after the moment, while the quantity keeps its value."""
    name, trace, target = find_named_body(case.who, case.words), case.followed.study.trace, case.query.target
    began = float(np.nextafter(case.then, np.inf))
    later = [event.time for event in trace.events if event.time > began * (1.0 + EVEN) and event.changes_motion]
    end = min([*later, trace.stable_until])
    if not name or target is None or end <= began:
        return False
    states = [trace.at(began + share * (end - began)) for share in (SOON, LATE)]
    moves = all(float(Velocity.evaluate(state, name)[0, 2]) * UP[direction] > 0.0 for state in states)
    answer = case.followed.answer or 0.0
    return moves and all(bool(np.isclose(target.value(state), answer, rtol=STEADY, atol=0.0)) for state in states)


DIRECTION_FRACTION = 0.5  # of an interval: by then the direction of motion is established
AXES = {"up": (0.0, 0.0, 1.0), "down": (0.0, 0.0, -1.0), "right": (1.0, 0.0, 0.0), "left": (-1.0, 0.0, 0.0)}


def unsteadiness_reason(target: Target, trace: Trace, *, during: bool, vanishes: bool, vector: bool) -> str:
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


def two_sided(query: Query, study: SimulatedScene, side: str) -> bool:
    """Return whether the quantity of a query jumps at the query's moment while the question names no side."""
    moment, target = query.moment, query.target
    if moment is None or target is None or moment.sided is not None or moment.stated_time is not None or side == AFTER:
        return False
    time = study.time(moment)
    if time is None:
        return False
    before, then = (target.value(study.trace.at(instant)) for instant in (float(np.nextafter(time, 0.0)), time))
    size = float(np.nanmax(np.abs(target.values(study.trace.scan)), initial=0.0))  # of what is zero there
    return abs(before - then) > STEADY * max(abs(before), abs(then)) and abs(before - then) > EVEN * size


def bounces_before(moment: Stopped, trace: Trace) -> bool:
    """Return whether a body hits something fixed before it first stops, and only turns back where it does."""
    time = moment.time(trace)
    if time is None:
        return False
    hits = any(
        event.kind == "collision" and event.subjects == (moment.name,) and event.time < time for event in trace.events
    )
    return hits and float(np.linalg.norm(Acceleration.evaluate(trace.at(time), moment.name))) > EVEN


def check_presumptions(reading: Reading, followed: SimulatedAnswer, query: Query, words: Words) -> Iterator[str]:
    """Yield a clause for each presumption of a reading that fails, and an empty string for each that holds."""
    trace = followed.study.trace
    time = followed.study.time(query.moment) if query.moment is not None else None
    events = (event.time for event in trace.events if event.time > 0.0)
    early = DIRECTION_FRACTION * min(next(iter(sorted(events)), np.inf), float(trace.state.times[-1]))
    then = early if not time else float(np.nextafter(time, 0.0))
    late = (
        time if time and reading.side == AFTER else then
    )  # what is asked for just after an event moves as it does then
    for kind, ways, instant in ((Displacement, reading.gone, then), (Velocity, reading.present_directions, late)):
        for who, presumption in ways:
            if presumption in AXES:
                fails = (
                    f"{who} has not moved {presumption} by then"
                    if kind is Displacement
                    else f"{who} does not move {presumption} then"
                )
                yield "" if _goes(kind, who, presumption, trace.at(instant), words) else fails
            elif presumption.startswith(ORIGIN):
                yield (
                    ""
                    if _from_origin(who, presumption[-1], followed.study, words)
                    else f"{who} does not start at the origin"
                )
            elif presumption.startswith(ONLY_FORCE_PREFIX):
                text = presumption.removeprefix(ONLY_FORCE_PREFIX)
                yield "" if is_only_force(text, who, words) else f"{text} is not the only force on {who}"
            elif presumption.startswith(ON):
                face = presumption.removeprefix(ON)
                yield "" if _lies(who, face, words) else f"{who} does not lie on {face}"
            elif presumption.startswith(THEN_GOES):
                goes = goes_then(Case(who, followed, query, then, words), presumption.removeprefix(THEN_GOES))
                yield "" if goes else f"{who} does not go that way after that, or it changes then"
            elif presumption == ALL_WORD or presumption.startswith(
                (HELD, ROUND, CARRIED_BY_PREFIX, BELOW_CARRIER_PREFIX)
            ):
                yield _beside(who, presumption, words)
            else:
                text, holds = PRESUMPTIONS[presumption]
                yield "" if holds(Case(who, followed, query, then, words)) else text.format(who=who)


def _goes(kind: type[Displacement | Velocity], who: str, direction: str, state: State, words: Words) -> bool:
    name = find_named_body(who, words)
    vector = kind.evaluate(state, name)[0] if name else np.zeros(3)
    return float(vector @ np.array(AXES[direction])) > EVEN * float(np.linalg.norm(vector))


def _beside(who: str, presumption: str, words: Words) -> str:
    """Return a message if a presumption that relates a body to other objects fails; empty if the presumption holds."""
    if presumption == ALL_WORD:
        return "" if _all_bodies(who, words) else f"{who} are not all that moves"
    if presumption.startswith(HELD):
        spring = presumption.removeprefix(HELD)
        return "" if is_fixed_spring_of(who, spring, words) else f"{spring} is not fixed at its other end"
    if presumption.startswith(CARRIED_BY_PREFIX):
        return (
            ""
            if is_carried(who, presumption.removeprefix(CARRIED_BY_PREFIX), words)
            else f"{presumption.removeprefix(CARRIED_BY_PREFIX)} does not carry {who}"
        )
    if presumption.startswith(BELOW_CARRIER_PREFIX):
        carrier = presumption.removeprefix(BELOW_CARRIER_PREFIX)
        level = (
            is_carried(who, carrier, words) and not center_path(words.mechanism, find_named_body(carrier, words)).rises
        )
        return "" if level else f"{who} does not swing below {carrier}"
    center = find_named_body(presumption.removeprefix(ROUND), words)
    pulled = {frozenset((pull.a, pull.b)) for pull in words.mechanism.attractions}
    return "" if frozenset((find_named_body(who, words), center)) in pulled else f"{who} does not go round that"


def _all_bodies(who: str, words: Words) -> bool:
    """Return whether a joint phrase names all bodies that have a mass."""
    names = {find_named_body(each, words) for each in who.removeprefix(f"{ALL_WORD} ").split(" & ")}
    return names == {body.name for body in words.mechanism.bodies if body.mass > 0.0}


def _lies(who: str, face: str, words: Words) -> bool:
    name = find_named_body(who, words)
    if face == FIXED_FACE:
        return name in words.mechanism.contacts and words.mechanism.body[name].parent is None
    return bool(name) and words.mechanism.body[name].parent == find_named_body(face, words)


def _from_origin(who: str, axis: str, study: SimulatedScene, words: Words) -> bool:
    """Return whether a body starts at the origin of an axis; false where heights count from the ground."""
    name, start = find_named_body(who, words), study.trace.at(0.0)
    if not name or Height().subjects(words.mechanism):
        return False
    given = next((p.value for p in study.scene.parameters if p.path == f"{name}.{axis}"), None)
    if given is not None:  # the origin of the mechanism need not be that of the text
        return given == 0.0
    position = start.vector(start.frames.center(name).place)[0]
    sense = next((sense for sense in Bodies().senses(words.mechanism, name) if sense.axis == axis), None)
    return sense is not None and abs(float(position @ np.array(sense.vector))) <= EVEN

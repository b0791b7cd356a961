"""What a question in ordinary English takes for granted: that something is steady, that a body goes up, or slows."""

from collections.abc import Iterator

import numpy as np

from sim2reason.errors import TextError
from sim2reason.quantities.kinematics import Acceleration, Displacement, Velocity
from sim2reason.quantities.springs import Extension
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.springs import Springs
from sim2reason.questions.ordinary.reading import Reading
from sim2reason.questions.ordinary.whens import AFTER
from sim2reason.questions.query import Query
from sim2reason.questions.structured import resolved
from sim2reason.questions.study import Study
from sim2reason.questions.targets import Target
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace

STEADY, EVEN = 1e-6, 1e-9  # relative
EARLY = 0.5  # of a stretch: then it goes the way that it goes
AXES = {"up": (0.0, 0.0, 1.0), "down": (0.0, 0.0, -1.0), "right": (1.0, 0.0, 0.0), "left": (-1.0, 0.0, 0.0)}
SLOWER, COMPRESSED = "slower", "compressed"


def steady(target: Target, trace: Trace, *, during: bool) -> str:
    """Why what is asked for without a moment is not one number, in a clause; empty if it is.

    It is if it does not change; or until something happens, `during` which it is asked for, or after which all rests.
    """
    times, values = trace.scan.times, target.values(trace.scan)
    first = min((event.time for event in trace.events if event.changes_motion and event.time > 0.0), default=np.inf)
    early = values[times < first * (1.0 - EVEN)]
    size = float(np.abs(early).max(initial=0.0))
    if len(early) and float(np.abs(early - early[0]).max()) > STEADY * size:
        return "it changes with time, and no moment is named"
    later = trace.scan.v[times > first * (1.0 + EVEN)]
    fastest = float(np.abs(trace.scan.v).max(initial=0.0))
    rests = float(np.abs(later).max(initial=0.0)) <= STEADY * fastest
    same = float(np.abs(values - early[0]).max(initial=0.0)) <= STEADY * size if len(early) else True
    return "" if during or rests or same else "it changes when something happens, and no moment is named"


def two_sided(query: Query, study: Study, side: str) -> bool:
    """Whether a quantity jumps at a moment of which no side is named."""
    moment, target = query.moment, query.target
    if moment is None or target is None or moment.sided is not None or moment.ahead is not None or side == AFTER:
        return False
    time = study.time(moment)
    if time is None:
        return False
    before, then = (target.value(study.trace.at(instant)) for instant in (float(np.nextafter(time, 0.0)), time))
    return abs(before - then) > STEADY * max(abs(before), abs(then))


def presumed(reading: Reading, trace: Trace, time: float | None, words: Words) -> Iterator[str]:
    """What a reading takes for granted that is not so, in clauses; empty ones for what is."""
    events = (event.time for event in trace.events if event.time > 0.0)
    early = EARLY * min(next(iter(sorted(events)), np.inf), float(trace.state.times[-1]))
    then = early if not time else float(np.nextafter(time, 0.0))
    for kind, ways in ((Displacement, reading.gone), (Velocity, reading.moving)):
        for who, way in ways:
            yield "" if _goes(kind, who, way, trace, then, words) else f"{who} does not go {way}"


def _goes(kind: type[Displacement | Velocity], who: str, way: str, trace: Trace, time: float, words: Words) -> bool:
    state = trace.at(time)
    try:
        if way == COMPRESSED:
            return float(Extension.evaluate(state, resolved("of", who, words.called(Springs())))[0]) < 0.0
        name = resolved("of", who, words.called(Bodies()))
    except TextError:
        return False
    if way == SLOWER:
        return float(np.sum(Velocity.evaluate(state, name) * Acceleration.evaluate(state, name))) < 0.0
    found = kind.evaluate(state, name)[0]
    return float(found @ np.array(AXES[way])) > EVEN * float(np.linalg.norm(found)) if way in AXES else True

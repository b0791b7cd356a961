"""Filters of motions that no problem should have."""

from collections.abc import Iterator

import numpy as np

from sim2reason.generation.filters import FILTERS, Candidate, Filter
from sim2reason.questions.choices import AT_ONCE, has_met
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.dsl.magnitudes import BENCH, FLIGHT, Span, natural_lengths, outside, strained
from sim2reason.scenes.dsl.measures import join_unit
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import State
from sim2reason.scenes.dsl.units import parse_unit
from sim2reason.simulation.trace import Trace, happened

SHOWN = 5  # collisions
MOST: dict[Difficulty, int] = {"easy": 5, "medium": 8, "hard": 12}  # that one has to follow, unless they are counted


class Collision(Filter):
    """Something may collide, but nothing has when the question is asked, so that the collision has no bearing.

    Or where pairs have a restitution of their own, only these have collided: that of *all others* has no bearing. Or
    more collisions come before than anybody would follow.
    """

    order = 1

    def reason(self, candidate: Candidate) -> str:
        """A collision must come before the moment, or be what has just happened; and one of every restitution."""
        time, moment = candidate.time, candidate.question.query.moment
        just_after = moment is not None and bool(moment.sided)
        met = time is None or has_met(candidate.study.trace, time, just_after=just_after)
        if not met:
            return "nothing has collided before"
        if time is not None and not _all_bear(candidate.study.trace, time):
            return "restitution: that of some pairs has no bearing"
        hits = sum(kind == "collision" for kind, _ in candidate.study.trace.story(0.0 if time is None else time))
        if hits > MOST[candidate.difficulty] and not candidate.kind.measured(candidate.question.query).whole:
            return f"many: {hits} collisions"
        return ""

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield when the first collisions are."""
        hits = [event for event in candidate.study.trace.events if event.kind == "collision"]
        yield from (f"{' and '.join(hit.subjects)} collide at {hit.time:.4g} s" for hit in hits[:SHOWN])


def _all_bear(trace: Trace, time: float) -> bool:
    """Return whether there has been a collision, up to a time, of every restitution that pairs have."""
    told = {frozenset(meeting.names): meeting.restitution for meeting in trace.mechanism.meetings}
    if len(set(told.values())) == 1:
        return True
    hits = (event for event in trace.events if event.kind == "collision" and event.time <= time * (1.0 + AT_ONCE))
    return {told.get(frozenset(hit.subjects)) for hit in hits} >= {*told.values()}


FILTERS.add("collision", Collision())


class Jerk(Filter):
    """A slack string becomes taut again before the moment, with a jerk: what it takes from the motion must be told.

    Engines take the velocity along the string. Texts say so of entities whose strings are expected to go slack.
    """

    order = 2

    def reason(self, candidate: Candidate) -> str:
        """Look for strings that become taut before the moment, or before the end of what is followed."""
        told = {named.name for named in candidate.study.scene.entities if named.entity.slackens}
        lines = (line for _, line in _again(candidate))
        return next((f"{line} becomes taut again" for line in lines if line.partition(".")[0] not in told), "")

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield when strings become taut again, or until when none does."""
        if not candidate.study.mechanism.strings:
            return
        again = [f"{line} becomes taut again at {time:.4g} s" for time, line in _again(candidate)]
        yield from again or [f"until {_end(candidate):.4g} s no string becomes taut again"]


def _end(candidate: Candidate) -> float:
    """Return the moment, or the end of what is followed, s."""
    return candidate.time if candidate.time is not None else candidate.study.trace.stable_until


def _again(candidate: Candidate) -> Iterator[tuple[float, str]]:
    """Yield the strings that become taut again before that, with the times, s."""
    for event in happened(candidate.study.trace.events, _end(candidate)):
        if event.kind == "taut":
            yield from ((event.time, line) for line in event.subjects)


FILTERS.add("jerk", Jerk())


class PlausibleOutcome(Filter):
    """The answer, or the result that is given, is not plausible; or a spring is squeezed or stretched too far."""

    order = 1

    def reason(self, candidate: Candidate) -> str:
        """Compare both with the table, and springs with their natural lengths until the moment that is asked about."""
        return next(self.findings(candidate), "")

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield all that is not plausible."""
        question, mechanism = candidate.question, candidate.study.mechanism
        yield from _implausible("the answer", question.answer, question.unit, mechanism)
        if question.given is not None:
            yield from _implausible("the given result", question.given.value, question.given.unit, mechanism)
        natural = natural_lengths(candidate.study.scene)
        if natural:
            yield from strained(natural, mechanism, _lengths(candidate, tuple(natural)))


def _implausible(what: str, value: float, unit: str, mechanism: Mechanism) -> Iterator[str]:
    name = parse_unit(unit).name
    span = (FLIGHT if mechanism.burns else BENCH).get(name)
    if span is not None and outside(value, span):
        yield f"{what} is {join_unit(f'{value:.3g}', name)}"


def _lengths(candidate: Candidate, names: tuple[str, ...]) -> dict[str, Span]:
    """The least and the greatest lengths of some springs until all has happened that the answer depends on, m."""
    trace, time = candidate.study.trace, candidate.time
    state = trace.scan if time is None else trace.sample(_instants(trace.scan, time))
    lines = (line for line in state.mechanism.lines if line.name in names and line.circle is None)
    found = ((line.name, np.asarray(state.frames.length(line))) for line in lines)
    return {name: (float(lengths.min()), float(lengths.max())) for name, lengths in found}


def _instants(state: State, time: float) -> np.ndarray:
    earlier = state.times[state.times < time]
    return np.append(earlier, time)


FILTERS.add("outcome", PlausibleOutcome())


FARTHEST = 4.0  # m along a board, a box or a wedge that moves itself


class Slide(Filter):
    """By the time that is asked about something has slid farther than `FARTHEST` on a body that can move.

    Planes that are fixed have no end.
    """

    order = 1

    def reason(self, candidate: Candidate) -> str:
        """Return a reason if a body slides too far along another one before the moment asked about."""
        far = {name: way for name, way in _slides(candidate).items() if way > FARTHEST}
        return next((f"{name} slides {way:.2g} m on what carries it" for name, way in far.items()), "")

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield the sliding distance of each body that slides on another one."""
        yield from (f"{name} slides {way:.3g} m on what carries it" for name, way in _slides(candidate).items())


def _slides(candidate: Candidate) -> dict[str, float]:
    """Return the greatest displacement, in m, of each body relative to the movable body on which it slides."""
    mechanism, trace, until = candidate.study.mechanism, candidate.study.trace, candidate.time
    if until is None:
        return {}
    moving = {body.name for body in mechanism.bodies if body.coordinates}
    riding = [mechanism.body[face.subject] for face in mechanism.faces if not face.turning]
    scan = trace.scan
    within = np.append(np.flatnonzero(scan.times <= until), np.argmin(np.abs(scan.times - until)))
    found: dict[str, float] = {}
    for body in riding:
        slides = [mechanism.number[c.name] for c in body.coordinates if c.kind == "slide"]
        if body.parent in moving and slides:
            ways = scan.q[:, slides] - scan.q[:1, slides]
            found[body.name] = float(np.abs(ways[within]).max(initial=0.0))
    return found


FILTERS.add("slide", Slide())

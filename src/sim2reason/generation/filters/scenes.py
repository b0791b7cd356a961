"""Filters that reject a scene or its motion: magnitudes, accelerations, slack strings, collisions and slides."""

from collections.abc import Iterator

import numpy as np

from sim2reason.generation.filters import FILTERS, Candidate, Filter, SceneFilter
from sim2reason.questions import SimulatedScene
from sim2reason.questions.choices import EVENT_TIME_RTOL, has_collided
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.dsl.magnitudes import (
    BENCH,
    FLIGHT,
    Span,
    implausible_numbers,
    implausible_spring_lengths,
    is_outside,
    natural_lengths,
)
from sim2reason.scenes.dsl.measures import join_unit
from sim2reason.scenes.dsl.mechanism import Inextensible, Mechanism
from sim2reason.scenes.dsl.state import State
from sim2reason.scenes.dsl.structure import changing
from sim2reason.scenes.dsl.units import parse_unit
from sim2reason.simulation.quantities.kinematics import Acceleration
from sim2reason.simulation.trace import Trace, events_before


class Magnitudes(SceneFilter):
    """Filter for implausible numbers: stated values, densities, mass ratios or initial lengths of springs."""

    def scene_reason(self, study: SimulatedScene) -> str:
        """Return a reason if a number of the scene, such as a density or a spring's initial length, is implausible."""
        return study.memoize("implausible numbers", lambda: next(implausible_numbers(study.scene), ""))

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield report lines: all implausible values."""
        return implausible_numbers(candidate.study.scene)


FILTERS.add("magnitudes", Magnitudes())


ACCELERATION_FLOOR = 1e-6  # m/s²
MIN_PARTS = 2  # parts of a scene from which on the filter applies


class Opposed(SceneFilter):
    """Filter for scenes in which all weights of several entities descend, so that none opposes another.

    A row of blocks on one slope belongs to one entity. Springs and swinging bodies are ignored.
    """

    def scene_reason(self, study: SimulatedScene) -> str:
        """Return a reason if bodies of several entities accelerate downwards just after the start and none upwards."""
        if not study.mechanism.strings or changing(study.mechanism):
            return ""
        up = _accelerations(study)
        down = {name.partition(".")[0] for name, upwards in up.items() if upwards < -ACCELERATION_FLOOR}
        rises = any(upwards > ACCELERATION_FLOOR for upwards in up.values())
        return "all that has a weight runs down together" if len(down) >= MIN_PARTS and not rises else ""

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield report lines: whether each accelerated body first accelerates upwards or downwards."""
        moving = {name: up for name, up in _accelerations(candidate.study).items() if abs(up) > ACCELERATION_FLOOR}
        yield from (f"{name} is accelerated {'up' if up > 0.0 else 'down'}" for name, up in moving.items())


def _accelerations(study: SimulatedScene) -> dict[str, float]:
    """Return the vertical accelerations of all bodies with mass just after the start, m/s², positive upwards."""
    state = study.trace.at(0.0)
    heavy = [body.name for body in state.mechanism.bodies if body.mass > 0.0]
    return {name: float(Acceleration.evaluate(state, name)[0, 2]) for name in heavy}


FILTERS.add("opposed", Opposed())


TENSION_FLOOR = 1e-9  # N


class Taut(SceneFilter):
    """Filter for scenes with a string called taut whose tension is zero just after the start."""

    def scene_reason(self, study: SimulatedScene) -> str:
        """Return the first string whose tension is zero just after the start."""
        return next(
            (f"{name} is slack from the start on" for name, t in _tensions(study).items() if t <= TENSION_FLOOR), ""
        )

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield a report line with the smallest string tension just after the start."""
        tensions = _tensions(candidate.study)
        if tensions:
            name = min(tensions, key=lambda each: tensions[each])
            unit = candidate.study.mechanism.units.spell("N")
            yield f"the least tension just after the start is {join_unit(f'{tensions[name]:.4g}', unit)}, in {name}"


def _tensions(study: SimulatedScene) -> dict[str, float]:
    """Return the tensions of all strings just after the start, N."""
    law, tension = Inextensible(), study.trace.at(0.0).tension
    return {line.name: float(tension[line.name][0]) for line in study.mechanism.strings if line.law == law}


FILTERS.add("taut", Taut())


MAX_LISTED_COLLISIONS = 5  # collisions in the findings
MAX_COLLISIONS: dict[Difficulty, int] = {"easy": 5, "medium": 8, "hard": 12}  # collisions before the moment, at most


class Collision(Filter):
    """Filter for questions without a relevant collision in a scene that allows one, or with too many collisions.

    If pairs have different stated restitutions, collisions of every restitution are required, since otherwise a stated
    value is irrelevant.
    """

    order = 1

    def reason(self, candidate: Candidate) -> str:
        """Return a reason if no relevant collision, or too many, occur at or before the moment asked about."""
        time, moment = candidate.time, candidate.question.query.moment
        just_after = moment is not None and bool(moment.sided)
        met = time is None or has_collided(candidate.study.trace, time, just_after=just_after)
        if not met:
            return "nothing has collided before"
        if time is not None and not _all_bear(candidate.study.trace, time):
            return "restitution: that of some pairs has no bearing"
        hits = sum(kind == "collision" for kind, _ in candidate.study.trace.story(0.0 if time is None else time))
        if hits > MAX_COLLISIONS[candidate.difficulty] and not candidate.kind.measured(candidate.question.query).whole:
            return f"many: {hits} collisions"
        return ""

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield report lines: the times of the first collisions."""
        hits = [event for event in candidate.study.trace.events if event.kind == "collision"]
        yield from (f"{' and '.join(hit.subjects)} collide at {hit.time:.4g} s" for hit in hits[:MAX_LISTED_COLLISIONS])


def _all_bear(trace: Trace, time: float) -> bool:
    """Return whether, for each stated coefficient of restitution, some pair has collided up to a time."""
    restitutions = {frozenset(meeting.names): meeting.restitution for meeting in trace.mechanism.meetings}
    if len(set(restitutions.values())) == 1:
        return True
    hits = (
        event for event in trace.events if event.kind == "collision" and event.time <= time * (1.0 + EVENT_TIME_RTOL)
    )
    return {restitutions.get(frozenset(hit.subjects)) for hit in hits} >= {*restitutions.values()}


FILTERS.add("collision", Collision())


class Jerk(Filter):
    """Filter for motions in which a slack string becomes taut again, unless the text states the result.

    Engines remove the velocity component along the string. Only entities whose strings are expected to go slack state
    this.
    """

    order = 2

    def reason(self, candidate: Candidate) -> str:
        """Return the reason if a slack string becomes taut again before the moment in question; else an empty text."""
        slackening = {named.name for named in candidate.study.scene.entities if named.entity.slackens}
        lines = (line for _, line in _again(candidate))
        return next((f"{line} becomes taut again" for line in lines if line.partition(".")[0] not in slackening), "")

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield report lines: the times when strings become taut again, or the end of the search."""
        if not candidate.study.mechanism.strings:
            return
        again = [f"{line} becomes taut again at {time:.4g} s" for time, line in _again(candidate)]
        yield from again or [f"until {_end(candidate):.4g} s no string becomes taut again"]


def _end(candidate: Candidate) -> float:
    """Return the time of the moment asked about, or of the end of the motion if there is none, s."""
    return candidate.time if candidate.time is not None else candidate.study.trace.stable_until


def _again(candidate: Candidate) -> Iterator[tuple[float, str]]:
    """Yield the strings that become taut again before the moment asked about, each with the time, s."""
    for event in events_before(candidate.study.trace.events, _end(candidate)):
        if event.kind == "taut":
            yield from ((event.time, line) for line in event.subjects)


FILTERS.add("jerk", Jerk())


class PlausibleOutcome(Filter):
    """Filter for implausible answers or given results, and for excessive compression or extension of springs."""

    order = 1

    def reason(self, candidate: Candidate) -> str:
        """Return a reason if the answer or the given result is implausible, or a spring is strained too much."""
        return next(self.findings(candidate), "")

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield report lines: all implausible values."""
        question, mechanism = candidate.question, candidate.study.mechanism
        yield from _implausible("the answer", question.answer, question.unit, mechanism)
        if question.given is not None:
            yield from _implausible("the given result", question.given.value, question.given.unit, mechanism)
        natural = natural_lengths(candidate.study.scene)
        if natural:
            yield from implausible_spring_lengths(natural, mechanism, _lengths(candidate, tuple(natural)))


def _implausible(what: str, value: float, unit: str, mechanism: Mechanism) -> Iterator[str]:
    name = parse_unit(unit).name
    span = (FLIGHT if mechanism.burns else BENCH).get(name)
    if span is not None and is_outside(value, span):
        yield f"{what} is {join_unit(f'{value:.3g}', name)}"


def _lengths(candidate: Candidate, names: tuple[str, ...]) -> dict[str, Span]:
    """Return the smallest and largest length of each named spring up to the moment asked about, m."""
    trace, time = candidate.study.trace, candidate.time
    state = trace.scan if time is None else trace.sample(_instants(trace.scan, time))
    lines = (line for line in state.mechanism.lines if line.name in names and line.circle is None)
    pairs = ((line.name, np.asarray(state.frames.length(line))) for line in lines)
    return {name: (float(lengths.min()), float(lengths.max())) for name, lengths in pairs}


def _instants(state: State, time: float) -> np.ndarray:
    earlier = state.times[state.times < time]
    return np.append(earlier, time)


FILTERS.add("outcome", PlausibleOutcome())


MAX_SLIDE = 4.0  # m, on a movable board, box or wedge


class Slide(Filter):
    """Filter for motions in which a body slides more than 4 m on a movable body before the moment.

    Fixed planes have no end.
    """

    order = 1

    def reason(self, candidate: Candidate) -> str:
        """Return a reason if a body slides too far along another one before the moment asked about."""
        far = {name: displacement for name, displacement in _slides(candidate).items() if displacement > MAX_SLIDE}
        return next(
            (f"{name} slides {displacement:.2g} m on what carries it" for name, displacement in far.items()), ""
        )

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield report lines: the sliding distance of each body that slides on another one."""
        yield from (
            f"{name} slides {displacement:.3g} m on what carries it"
            for name, displacement in _slides(candidate).items()
        )


def _slides(candidate: Candidate) -> dict[str, float]:
    """Return the greatest displacement, in m, of each body relative to the movable body on which it slides."""
    mechanism, trace, until = candidate.study.mechanism, candidate.study.trace, candidate.time
    if until is None:
        return {}
    moving = {body.name for body in mechanism.bodies if body.coordinates}
    riding = [mechanism.body[face.subject] for face in mechanism.faces if not face.turning]
    scan = trace.scan
    within = np.append(np.flatnonzero(scan.times <= until), np.argmin(np.abs(scan.times - until)))
    displacements: dict[str, float] = {}
    for body in riding:
        slides = [mechanism.number[c.name] for c in body.coordinates if c.kind == "slide"]
        if body.parent in moving and slides:
            ways = scan.q[:, slides] - scan.q[:1, slides]
            displacements[body.name] = float(np.abs(ways[within]).max(initial=0.0))
    return displacements


FILTERS.add("slide", Slide())

"""Simulation of a motion until a query has an answer, or is known never to have one."""

from functools import partial
from math import isclose
from typing import NamedTuple

import numpy as np

from sim2reason.errors import SimulationError
from sim2reason.questions.dependence import roomy
from sim2reason.questions.kinds import KINDS
from sim2reason.questions.kinds.parts.nested import NestedQuery, answered
from sim2reason.questions.kinds.threshold import ThresholdQuery
from sim2reason.questions.moments.times import WholeMotion
from sim2reason.questions.query import Query
from sim2reason.questions.recurrence import nothing_new, why_never
from sim2reason.questions.study import BEYOND, Study
from sim2reason.scenes.dsl.constancy import changing
from sim2reason.scenes.dsl.scene import Scene

SAMPLES = 41
GROWTH = 2.0  # factor on the duration of a motion that has not yet led to an answer
DOUBLINGS, FEWER = 40, 12  # maximum number of doublings; the second for integrated motions, whose cost grows
SHORTER, TRIES = 0.25, 8  # factor on the duration of a motion that cannot be simulated, and number of attempts
ROOM = "reach"  # kind of the event that ends a motion for which an unstated length is too short
ENDLESS = "nothing ends this motion, since the text leaves open how far it can go; say up to which moment"
ALIKE = 1e-9  # relative: answers that differ by less do not depend on how far a motion goes
UNDECIDED = "it happens for every value of that number, or for none, or the number has several such limits"
FOLLOWED_NO_LONGER = "followed no longer"  # how a reason ends where one motion takes all the work that is allowed
BEFORE = 1.0 - 1e-6  # of the time at which a motion becomes singular: until then it is followed


class Followed(NamedTuple):
    """A scene with a sufficiently long motion and the answer to a query, or None and the reason."""

    study: Study
    answer: float | None
    reason: str = ""


class FollowedMotion(NamedTuple):
    """A scene with its motion, and the reason if the motion is shorter than requested."""

    study: Study
    limit: str = ""


def motion_of(scene: Scene, until: float | None = None) -> FollowedMotion:
    """Return a scene's motion up to a time, s, by default the scene's horizon; or as far as the simulation succeeds.

    Raises:
        SceneError, UnsupportedError, SimulationError: the scene cannot be built, modelled or solved.
    """
    until = scene.horizon if until is None else until
    limit: SimulationError | None = None
    for _ in range(TRIES):
        try:
            return FollowedMotion(Study.of(scene, np.linspace(0.0, until, SAMPLES)), _without_remedy(limit))
        except SimulationError as error:
            limit = limit or error
            until = BEFORE * error.reached if 0.0 < error.reached < until else SHORTER * until
    assert limit is not None
    raise limit


def _without_remedy(limit: SimulationError | None) -> str:
    """Return the text of a simulation error without its remedy, which a caller cannot apply; empty without an error."""
    return str(limit).partition("; ")[0] if limit is not None else ""


def follow(query: Query, begun: FollowedMotion) -> Followed:
    """Return the answer to a query, doubling the duration of the motion until there is an answer.

    Without an answer, `reason` says why there never is one, or which limit of work was reached.
    """
    found = _followed(query, begun)
    to_its_end = isinstance(query.moment, WholeMotion)
    if (
        (found.answer is None or to_its_end)
        and found.study.trace.cut == ROOM
        and (scene := roomy(begun.study.scene)) != begun.study.scene
    ):
        longer = _followed(query, motion_of(scene))  # the text says that there is ample room
        if to_its_end and not _agree(found.answer, longer.answer):
            return Followed(found.study, None, ENDLESS)
        return longer if longer.answer is not None else found
    return found


def _agree(one: float | None, other: float | None) -> bool:
    return one is not None and other is not None and isclose(one, other, rel_tol=ALIKE)


def _followed(query: Query, begun: FollowedMotion) -> Followed:
    study, limit = begun
    ahead = query.moment.ahead if query.moment is not None else None
    if ahead is not None and (until := BEYOND * ahead) > _end(study) and not limit:
        study, limit = study.once(("motion until", until), partial(motion_of, study.scene, until))
    for _ in range(FEWER if changing(study.mechanism) else DOUBLINGS):
        answer, reason = _looked_for(query, study)
        if answer is not None or reason:
            return Followed(study, answer, reason)
        if limit:
            break
        longer, limit = _longer(study)
        if _end(longer) <= _end(study):
            break
        study = longer
    return Followed(study, None, _given_up(study, limit))


def _longer(study: Study) -> FollowedMotion:
    """Return a scene's motion with `GROWTH` times the duration, cached for all queries."""
    return study.once("longer motion", lambda: motion_of(study.scene, GROWTH * _end(study)))


def _given_up(study: Study, limit: str) -> str:
    """Return the reason to report if a motion reaches a limit of work before a query has an answer."""
    by = f"it has not happened by {_end(study):.6g} {study.mechanism.units.time}"
    return f"{by}, and this motion is {FOLLOWED_NO_LONGER}{f': {limit}' if limit else ''}"


def _end(study: Study) -> float:
    return float(study.trace.state.times[-1])


def _looked_for(query: Query, study: Study) -> tuple[float | None, str]:
    """Return a query's answer in a motion; or None and the reason, which is empty if an answer may come later."""
    kind, trace = KINDS[query.kind], study.trace
    time = kind.time(query, study)
    found = kind.answer(query, study)
    if found is None and time is not None:
        found = kind.loose_answer(query, study)
    if found is not None and np.isfinite(found):
        return found, ""
    unit = trace.mechanism.units.time
    if found is not None:
        return None, f"at {time or 0.0:.6g} {unit} the scene leaves it open: more forces hold than equations tell"
    if isinstance(query, NestedQuery):
        return None, _why_not_nested(query, study)
    if isinstance(query, ThresholdQuery):
        return None, UNDECIDED
    if time is None and (query.moment is not None or kind.awaited):
        return None, why_never(query.moment, trace)
    return None, "the scene has no such value" if time is None else f"it has no value at {time:.6g} {unit}"


def _why_not_nested(query: NestedQuery, study: Study) -> str:
    """Return the reason why a nested query has no answer in its motions; empty if an answer may come later."""
    for other in (study, *query.others(study)):
        if other is None:
            return "with the other number there is no such scene, or none whose motion can be followed"
        if answered(query.inner, other, loosely=True) is None:
            reason = why_never(query.moment, other.trace)
            if reason:
                return reason if other is study else f"with the other number {reason}"
    return ""


def eventful(begun: FollowedMotion) -> FollowedMotion:
    """Return a motion, doubled in duration until an event occurs or the motion ends or repeats; else unchanged."""
    study, limit = begun
    for _ in range(FEWER if changing(study.mechanism) else DOUBLINGS):
        if limit or study.trace.cut or study.trace.events or nothing_new(study.trace):
            return FollowedMotion(study, limit)
        if why_never(None, study.trace):
            break
        study, limit = _longer(study)
    return begun

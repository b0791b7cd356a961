"""Simulation of a motion until a query has an answer, or is known never to have one."""

from functools import partial
from math import isclose
from typing import NamedTuple

import numpy as np

from sim2reason.errors import SimulationError
from sim2reason.questions.kinds import KINDS
from sim2reason.questions.kinds.nested import NestedQuery, usable_answer
from sim2reason.questions.kinds.threshold import ThresholdQuery
from sim2reason.questions.moments.times import WholeMotion
from sim2reason.questions.query import Query
from sim2reason.questions.recurrence import has_known_continuation, why_never
from sim2reason.questions.study import TIME_MARGIN, SimulatedScene
from sim2reason.questions.unknown import lengthen_strings
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.structure import changing

SAMPLES = 41
DURATION_GROWTH = 2.0  # factor on the duration of a motion that has not yet led to an answer
MAX_DOUBLINGS, FEWER = 40, 12  # maximum number of doublings; the second for integrated motions, whose cost grows
SHORTER, MAX_RETRIES = 0.25, 8  # factor on the duration of a motion that cannot be simulated, and number of attempts
SPACE_LIMIT_EVENT = "reach"  # kind of the event that ends a motion for which an unstated length is too short
ENDLESS = "nothing ends this motion, since the text leaves open how far it can go; say up to which moment"
ANSWER_RTOL = 1e-9  # relative: answers that differ by less do not depend on how far a motion goes
UNDECIDED = "it happens for every value of that number, or for none, or the number has several such limits"
FOLLOWED_NO_LONGER = "followed no longer"  # how a reason ends where one motion takes all the work that is allowed
SINGULARITY_MARGIN = 1.0 - 1e-6  # of the time at which a motion becomes singular: until then it is followed


class SimulatedAnswer(NamedTuple):
    """A scene with a sufficiently long motion and the answer to a query, or None and the reason."""

    study: SimulatedScene
    answer: float | None
    reason: str = ""


class FollowedMotion(NamedTuple):
    """A scene with its motion, and the reason if the motion is shorter than requested."""

    study: SimulatedScene
    limit: str = ""


def simulate_scene(scene: Scene, until: float | None = None) -> FollowedMotion:
    """Return a scene's motion up to a time, s, by default the scene's horizon; or as far as the simulation succeeds.

    Raises:
        SceneError, UnsupportedError, SimulationError: the scene cannot be built, modelled or solved.
    """
    until = scene.horizon if until is None else until
    limit: SimulationError | None = None
    for _ in range(MAX_RETRIES):
        try:
            return FollowedMotion(SimulatedScene.of(scene, np.linspace(0.0, until, SAMPLES)), _without_remedy(limit))
        except SimulationError as error:
            limit = limit or error
            until = SINGULARITY_MARGIN * error.reached if 0.0 < error.reached < until else SHORTER * until
    assert limit is not None
    raise limit


def _without_remedy(limit: SimulationError | None) -> str:
    """Return the text of a simulation error without its advice, which does not apply here; empty without an error."""
    return str(limit).partition("; ")[0] if limit is not None else ""


def simulate_until_answer(query: Query, begun: FollowedMotion) -> SimulatedAnswer:
    """Return the answer to a query, doubling the duration of the motion until there is an answer.

    Without an answer, `reason` says why there never is one, or which limit of work was reached.
    """
    simulated = _extend_motion(query, begun)
    to_its_end = isinstance(query.moment, WholeMotion)
    if (
        (simulated.answer is None or to_its_end)
        and simulated.study.trace.cut == SPACE_LIMIT_EVENT
        and (scene := lengthen_strings(begun.study.scene)) != begun.study.scene
    ):
        longer = _extend_motion(query, simulate_scene(scene))  # the text says that there is ample room
        if to_its_end and not _agree(simulated.answer, longer.answer):
            return SimulatedAnswer(simulated.study, None, ENDLESS)
        return longer if longer.answer is not None else simulated
    return simulated


def _agree(one: float | None, other: float | None) -> bool:
    return one is not None and other is not None and isclose(one, other, rel_tol=ANSWER_RTOL)


def _extend_motion(query: Query, begun: FollowedMotion) -> SimulatedAnswer:
    study, limit = begun
    ahead = query.moment.stated_time if query.moment is not None else None
    if ahead is not None and (until := TIME_MARGIN * ahead) > _end(study) and not limit:
        study, limit = study.memoize(("motion until", until), partial(simulate_scene, study.scene, until))
    for _ in range(FEWER if changing(study.mechanism) else MAX_DOUBLINGS):
        answer, reason = _find_answer(query, study)
        if answer is not None or reason:
            return SimulatedAnswer(study, answer, reason)
        if limit:
            break
        longer, limit = _simulate_longer(study)
        if _end(longer) <= _end(study):
            break
        study = longer
    return SimulatedAnswer(study, None, _given_up(study, limit))


def _simulate_longer(study: SimulatedScene) -> FollowedMotion:
    """Return a scene's motion with `DURATION_GROWTH` times the duration, cached for all queries."""
    return study.memoize("longer motion", lambda: simulate_scene(study.scene, DURATION_GROWTH * _end(study)))


def _given_up(study: SimulatedScene, limit: str) -> str:
    """Return the reason to report if a motion reaches a limit of work before a query has an answer."""
    by = f"it has not happened by {_end(study):.6g} {study.mechanism.units.time}"
    return f"{by}, and this motion is {FOLLOWED_NO_LONGER}{f': {limit}' if limit else ''}"


def _end(study: SimulatedScene) -> float:
    return float(study.trace.state.times[-1])


def _find_answer(query: Query, study: SimulatedScene) -> tuple[float | None, str]:
    """Return a query's answer in a motion; or None and the reason, which is empty if an answer may come later."""
    kind, trace = KINDS[query.kind], study.trace
    time = kind.time(query, study)
    answer = kind.answer(query, study)
    if answer is None and time is not None:
        answer = kind.loose_answer(query, study)
    if answer is not None and np.isfinite(answer):
        return answer, ""
    unit = trace.mechanism.units.time
    if answer is not None:
        return None, f"at {time or 0.0:.6g} {unit} the scene leaves it open: more forces hold than equations tell"
    if isinstance(query, NestedQuery):
        return None, _why_not_nested(query, study)
    if isinstance(query, ThresholdQuery):
        return None, UNDECIDED
    if time is None and (query.moment is not None or kind.awaited):
        return None, why_never(query.moment, trace)
    return None, "the scene has no such value" if time is None else f"it has no value at {time:.6g} {unit}"


def _why_not_nested(query: NestedQuery, study: SimulatedScene) -> str:
    """Return the reason why a nested query has no answer in its motions; empty if an answer may come later."""
    for other in (study, *query.others(study)):
        if other is None:
            return "with the other number there is no such scene, or none whose motion can be followed"
        if usable_answer(query.inner, other, loosely=True) is None:
            reason = why_never(query.moment, other.trace)
            if reason:
                return reason if other is study else f"with the other number {reason}"
    return ""


def simulate_until_event(begun: FollowedMotion) -> FollowedMotion:
    """Return a motion, doubled in duration until an event occurs or the motion ends or repeats; else unchanged."""
    study, limit = begun
    for _ in range(FEWER if changing(study.mechanism) else MAX_DOUBLINGS):
        if limit or study.trace.cut or study.trace.events or has_known_continuation(study.trace):
            return FollowedMotion(study, limit)
        if why_never(None, study.trace):
            break
        study, limit = _simulate_longer(study)
    return begun

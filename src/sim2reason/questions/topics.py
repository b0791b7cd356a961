"""Topics of sentences that matter only to some questions."""

from collections.abc import Callable, Collection, Iterator
from math import inf, isclose
from typing import get_args

from sim2reason.questions import KINDS, Question, SimulatedScene
from sim2reason.questions.moments.parts.reached import Reached
from sim2reason.questions.query import Query
from sim2reason.questions.regimes.strings import AllStayTaut, StaysTaut
from sim2reason.questions.study import TIME_MARGIN
from sim2reason.questions.unknown import range_of
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.template import Topic
from sim2reason.simulation.trace import events_before

STRIDE = 6  # stride through the range of an unknown number
AXES = "x", "y", "z"
STRAIN = ".strain.by"  # final part of the address of a spring's initial strain
SHIFTED, FROM_NONE = 0.9, (0.05, 0.01)  # altered strains: a factor, and values in m for a relaxed spring
ANSWER_RTOL = 1e-6  # relative, and in SI units: answers that differ by less are equal
TOPICS: tuple[Topic, ...] = get_args(Topic)


def irrelevant(question: Question, study: SimulatedScene, among: Collection[Topic] = TOPICS) -> frozenset[Topic]:
    """Return the topics that do not matter to a question, so that the text may omit their sentences.

    With an unknown number, a topic is irrelevant only if it is for all usual values of the number.
    """
    return frozenset(topic for topic, matters in MATTERS.items() if topic in among and not matters(question, study))


def _uses_axes(question: Question, study: SimulatedScene) -> bool:
    """Return whether a question is about a component along an axis, or its moment refers to one."""
    del study
    moment = question.query.moment
    targets = question.query.target, moment.target if isinstance(moment, Reached) else None
    return any(held is not None and held.sense is not None and held.sense.axis in AXES for held in targets)


def _slackens(question: Question, study: SimulatedScene) -> bool:
    """Return whether a string goes slack before the moment, or may with other values of the unknown number."""
    query = question.query
    if query.hides:
        return True
    time = KINDS[query.kind].time(query, study)
    ends = any(event.kind == "slack" and event.time == time for event in study.trace.events)
    if time == 0.0 or ends or any(isinstance(held, StaysTaut | AllStayTaut) for held in question.assumed):
        return _has_slackened(question, study)
    if question.formula is not None:
        return True
    return any(_has_slackened(question, held) for held in (study, *_others(question, study)))


def _others(question: Question, study: SimulatedScene) -> Iterator[SimulatedScene]:
    """Yield motions with other values of the unknown number, for the usual duration of the question."""
    time = KINDS[question.query.kind].time(question.query, study)
    until = time * TIME_MARGIN if time is not None else None
    values = range_of(study.scene, question.unknown)[::STRIDE] if question.unknown else ()
    yield from filter(None, (study.with_values({question.unknown: value}, until) for value in values))


def _has_slackened(question: Question, study: SimulatedScene) -> bool:
    """Return whether a string goes slack before the moment, or before the end if the moment does not occur."""
    time = KINDS[question.query.kind].time(question.query, study)
    return any(event.kind == "slack" for event in events_before(study.trace.events, inf if time is None else time))


def depends_on_start(query: Query, study: SimulatedScene) -> bool:
    """Return whether the answer to a query depends on the initial motion or the initial strain of springs.

    Springs between two walls exert forces in equilibrium, too. These depend on the natural lengths, which a text tells
    by the initial strain.
    """
    kind = KINDS[query.kind]
    if kind.of_motion(query):
        return True
    others = (study.with_values(values, 0.0) for values in _other_strains(study.scene))
    mine = kind.answer(query, study)
    its = (kind.answer(query, other) for other in others if other is not None)
    return not all(isclose(mine or 0.0, answer or 0.0, rel_tol=ANSWER_RTOL, abs_tol=ANSWER_RTOL) for answer in its)


def _other_strains(scene: Scene) -> Iterator[dict[str, float]]:
    """Yield other initial strains of each spring, by address."""
    for parameter in scene.parameters:
        if parameter.path.endswith(STRAIN):
            values = (SHIFTED * parameter.value,) if parameter.value else FROM_NONE
            yield from ({parameter.path: value} for value in values)


def _depends_on_start(question: Question, study: SimulatedScene) -> bool:
    """Return whether the answer to a question depends on the initial motion."""
    return depends_on_start(question.query, study)


MATTERS: dict[Topic, Callable[[Question, SimulatedScene], bool]] = {
    "axes": _uses_axes,
    "slack": _slackens,
    "start": _depends_on_start,
}
"""By topic, whether a question has to do with it, given the motion that it is about."""

"""The answer to a query as a function of one number of the scene, with its roots and extremes."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from math import inf, isfinite
from typing import NamedTuple

import numpy as np

from sim2reason.errors import SceneError, SimulationError, UnsupportedError
from sim2reason.questions.kinds import KINDS
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.query import Query
from sim2reason.questions.recurrence import has_known_continuation, subjects_escape
from sim2reason.questions.study import (
    COARSE_STEP_ERROR,
    MIN_VARIANT_FRACTION,
    TIME_MARGIN,
    SimulatedScene,
    change_directions,
)
from sim2reason.questions.unknown import with_number
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.simulation.certify import RECORDED
from sim2reason.simulation.trace import DEFAULT_STEP_RTOL, ENGINES, Trace

LATE_HORIZON_FACTOR = 2.0  # times the scene's own horizon: simulation time for an event that may occur later;
LAST_HORIZON_FACTOR = 8.0  # or for a query whose answer exists however late the event occurs
BORDER_BISECTIONS = 12  # bisections towards the limit beyond which there is no answer
EVENT_TIME_RTOL = 1e-6  # relative
RELATIVE_STEP = 1e-4  # relative step of numerical derivatives
SECANTS, ROUNDS, ROOT_RTOL = 8, 60, 1e-10  # secant steps, bracketed steps, and relative accuracy of the root
GROUND = "limit"  # kind of the event that ends the motion of a falling body

EventCourse = tuple[tuple[tuple[str, tuple[str, ...]], ...], tuple[float, ...]]
"""Events in turn, by kind and subjects, which way each coordinate has changed, and whether it stands."""


class AnswerFunction:
    """The answer to a query as a function of the number at one address of the scene."""

    def __init__(
        self,
        query: Query,
        study: SimulatedScene,
        path: str,
        error: float = DEFAULT_STEP_RTOL,
        scene: Scene | None = None,
        likely: Callable[[float], float] | None = None,
        patience: Sequence[float] = (),
    ) -> None:
        """Prepare to vary the number at `path`, given the study of a scene in which that number has any value.

        `error` is the error allowed in an integration step. If the study's mechanism is changed, the mechanisms of the
        scenes with other values are changed likewise.

        `scene` may be another scene that a text cannot tell from the study's. `likely` answers are tried first, if a
        kind searches for its answers. `patience` lists further multiples of a scene's horizon: an event that has not
        occurred by the usual time is awaited until then.
        """
        moment = query.moment.first() if query.moment is not None else None
        self._query, self._study, self._path = replace(query, moment=moment), study, path
        self._likely, self._patience = likely, patience
        self._scene = scene or study.scene
        self._as_asked = moment == query.moment
        self._error = error
        self._known: dict[float, float | None] = {}
        self._times: dict[float, float] = {}  # when what is asked about came; inf where it was waited for in vain
        self._courses: dict[float, EventCourse] = {}
        self._late = set[float]()  # where it may come yet when the motion is no longer followed

    def record_answer(self, value: float, answer: float) -> None:
        """Record the answer for the value of the number in the study's scene, which need not be simulated again."""
        if self._as_asked:
            self._known[value] = answer
            self._record_course(value, self._study)

    def coarser(self, error: float) -> "AnswerFunction":
        """Return the same function with less accurate integration; both share the known simulation times."""
        coarse = AnswerFunction(self._query, self._study, self._path, error, self._scene, self._likely, self._patience)
        coarse._times, coarse._late = self._times, self._late
        return coarse

    def __call__(self, value: float) -> float | None:
        """Return the answer for a value; inf for a time beyond the simulated motion, None if there is no answer."""
        if value not in self._known:
            self._known[value] = self._answer(value)
        return self._known[value]

    def is_late(self, value: float) -> bool:
        """Return whether the answer for a value is missing only because the simulation ends too early."""
        self(value)
        return value in self._late

    def course(self, value: float) -> EventCourse | None:
        """Return the course of events until the answer for a value is known; None if there is no answer."""
        self(value)
        return self._courses.get(value)

    def _answer(self, value: float) -> float | None:
        try:
            scene = with_number(self._scene, self._path, value)
        except (SceneError, ValueError):
            return None
        for stages in self._simulation_times(value, scene):
            try:
                return self._simulate_until_answer(value, scene, stages)
            except (SceneError, SimulationError, UnsupportedError):
                continue
        return None

    def _simulate_until_answer(self, value: float, scene: Scene, stages: Sequence[float]) -> float | None:
        """Return the answer for a value, found by simulations of increasing duration.

        If the simulation fails at some duration, the answer may still exist at a later time.
        """
        kind = KINDS[self._query.kind]
        query = kind.with_likely_answer(self._query, self._likely(value) if self._likely is not None else 0.0)
        for until in stages:
            change = self._study.change
            mechanism = scene.mechanism if change is None else change(scene.mechanism)
            other = SimulatedScene(scene, ENGINES[RECORDED](mechanism, np.array([0.0, until]), self._error), change)
            answer = kind.loose_answer(query, other)
            self._late.discard(value)
            if answer is not None:
                self._record_course(value, other)
                return answer if isfinite(answer) else None
            if other.trace.cut or other.trace.stable_until < until:
                return self._answer_after_landing(other)
            if (self._later_counts or self._patience) and self._never(other.trace):
                break
            if self._later_counts:
                self._late.add(value)
        self._times[value] = inf
        return kind.late_answer(self._query)

    def _answer_after_landing(self, study: SimulatedScene) -> float | None:
        """Return the answer at a time after a landing, if it is a length or a total, which then stays; else None.

        Lengths and totals of an interval remain valid after the landing; speeds and forces do not.
        """
        moment, end = self._query.moment, study.trace.stable_until * (1.0 - EVENT_TIME_RTOL)
        lasts = isinstance(self._query, StretchQuery) or KINDS[self._query.kind].measured(self._query).unit == "m"
        if study.trace.cut != GROUND or moment is None or not lasts:
            return None
        if moment.stated_time is None or moment.kind == "start":
            return None
        return KINDS[self._query.kind].loose_answer(replace(self._query, moment=moment.having([end])), study)

    def _never(self, trace: Trace) -> bool:
        """Return whether an event that has not occurred by the end of a motion is known never to occur."""
        return has_known_continuation(trace) or subjects_escape(self._query.moment, trace)

    @property
    def _later_counts(self) -> bool:
        """Return whether the query asks for another quantity than a time, at a moment without a stated time."""
        timed = KINDS[self._query.kind].measured(self._query).name == "time"
        return not timed and self._query.moment is not None and self._query.moment.stated_time is None

    def _record_course(self, value: float, study: SimulatedScene) -> None:
        """Record the time of the query's moment in a motion, s, and the course of events before it."""
        self._times[value] = time = KINDS[self._query.kind].time(self._query, study) or 0.0
        events = tuple((e.kind, e.subjects) for e in study.trace.events if e.time < time * (1.0 - EVENT_TIME_RTOL))
        self._courses[value] = events, change_directions(study, time)

    def _simulation_times(self, value: float, scene: Scene) -> list[tuple[float, ...]]:
        """Return sequences of simulation times, s, to try in turn for a value of the number.

        It comes about when it came at the nearest of the values that are known. Where it did not come there at all, the
        motion is followed as long as can be at once; if something then is amiss, that may be after it has come.
        """
        moment, end = self._query.moment, scene.horizon
        later = tuple(times * end for times in self._patience)
        if moment is None and not KINDS[self._query.kind].awaited:
            known = [time for time in self._times.values() if time < inf]
            if known and not any(known):  # the motion has no part in it
                return [(MIN_VARIANT_FRACTION * end,)]
            if known:
                return [(max(end, LATE_HORIZON_FACTOR * max(known)),)]
            return [(end, LATE_HORIZON_FACTOR * end, LAST_HORIZON_FACTOR * end, *later)]
        if moment is not None and (known := moment.stated_time) is not None:
            return [(max(TIME_MARGIN * known, MIN_VARIANT_FRACTION * end),)]
        near = self._times[min(self._times, key=lambda known: abs(known - value))] if self._times else 0.0
        last = (LAST_HORIZON_FACTOR * end,) if self._later_counts or later else ()
        usual = end, LATE_HORIZON_FACTOR * end, *last, *later
        if not near:
            return [usual]
        return [usual[1:], usual] if near == inf else [(min(1.2 * near, usual[-1]), *usual)]

    def rate(self, value: float) -> float | None:
        """Return the one-sided derivative of the answer, to a relative accuracy of `RELATIVE_STEP`; None if none."""
        here, beside = self(value), self(value * (1.0 + RELATIVE_STEP))
        if here is None or beside is None or inf in (here, beside):
            return None
        return (beside - here) / (RELATIVE_STEP * value)

    def solve_from(self, value: float, near: float) -> float | None:
        """Return the number for which the answer is `value`, by secants from `near`; None if they do not converge.

        Once the answer is accurate to `ROOT_RTOL`, one more secant step, which is not verified, improves the number.
        """
        a, b = near, near * (1.0 + RELATIVE_STEP)
        fa, fb = self._excess(a, value), self._excess(b, value)
        for _ in range(SECANTS):
            if fa is None or fb is None or not (isfinite(fa) and isfinite(fb)):
                return None
            close = abs(fb) <= ROOT_RTOL * abs(value)
            if fa == fb:
                return b if close else None
            a, b, fa = b, b - fb * (b - a) / (fb - fa), fb
            if close:
                return b
            fb = self._excess(b, value)
        return None

    def find_root_between(self, value: float, low: float, high: float) -> float | None:
        """Return the number between `low` and `high` for which the answer is `value`; None at a discontinuity.

        The rule of false position, whose standing end counts half (Illinois).
        """
        fa, fb = self._excess(low, value), self._excess(high, value)
        if fa is None or fb is None:
            return None
        a, b = low, high
        size = abs(value) or max((abs(end) for end in (fa, fb) if isfinite(end)), default=0.0)
        for _ in range(ROUNDS):
            if abs(b - a) <= ROOT_RTOL * abs(b) or abs(fb) <= ROOT_RTOL * size:
                break
            plain = isfinite(fa) and isfinite(fb)
            middle = b - fb * (b - a) / (fb - fa) if plain else 0.5 * (a + b)
            excess = self._excess(middle, value)
            if excess is None:
                return None
            if (excess > 0.0) != (fb > 0.0):
                a, fa = b, fb
            elif plain:
                fa *= 0.5
            b, fb = middle, excess
        here = self(b)
        return b if here is not None and abs(here - value) <= 1e-6 * size else None

    def _excess(self, at: float, value: float) -> float | None:
        answer = self(at)
        return None if answer is None else answer - value


def bisect_border(dependence: Callable[[float], float | None], one: float, other: float) -> Iterator[float]:
    """Yield numbers that approach, by bisection, the limit between a number with an answer and one without."""
    has = [dependence(at) is not None for at in (one, other)]
    inside, outside = (one, other) if has[0] else (other, one)
    for _ in range(BORDER_BISECTIONS if has[0] != has[1] else 0):
        middle = 0.5 * (inside + outside)
        yield middle
        inside, outside = (middle, outside) if dependence(middle) is not None else (inside, middle)


def find_roots(dependence: AnswerFunction, values: Sequence[float], given: float) -> list[float]:
    """Return the numbers with answer `given`, each between neighbouring `values` with a smaller and a greater answer.

    Limits between values with and without an answer are located by bisection and included in the search.
    """
    coarse = dependence.coarser(COARSE_STEP_ERROR)
    points = sorted({*values, *(at for pair in pairwise(values) for at in bisect_border(coarse, *pair))})
    excess = [(at, result - given) for at in points if (result := coarse(at)) is not None]
    pairs = [(low, high) for (low, a), (high, b) in pairwise(excess) if (a > 0.0) != (b > 0.0)]
    result = (dependence.find_root_between(given, low, high) for low, high in pairs)
    return [root for root in result if root is not None]


FIRST_PASS_VALUES = 5  # values of the first pass; without a single reversal among them the search ends
SECOND_PASS_STRIDE = 2  # stride through the values of the second pass
STENCIL_STEP = 0.01  # relative: step of finite differences
NEWTON_STEPS = 6  # iterations of Newton's method
MAX_RELATIVE_SHIFT = 0.2  # relative: largest total step
CONVERGENCE_RTOL, KNOWN_EXTREME_RTOL = 1e-8, 5e-7  # relative: tolerance of convergence; tolerance for a known extreme


class StationaryValue(NamedTuple):
    """An extreme: the value of the number, the answer there, and whether it is a maximum."""

    argument: float
    value: float
    greatest: bool


class ExtremeSearch:
    """A search for the unique extreme of an answer as a function of a number."""

    def __init__(self, dependence: AnswerFunction) -> None:
        """Prepare the search, given the answer as a function of the number."""
        self._answer = dependence

    def among(self, values: Sequence[float]) -> StationaryValue | None:
        """Return the only extreme among at least three values in ascending order.

        None if there are several or none, or not all values have an answer.
        """
        last, few = len(values) - 1, FIRST_PASS_VALUES
        coarse = [values[n * last // (few - 1)] for n in range(few)] if last >= few else values
        for some in (coarse, sorted({*coarse, *values[::SECOND_PASS_STRIDE]})):
            turn = self._turn(some)
            if turn is None:
                return None
        low, middle, high, greatest = turn
        points = [(at, self._answer(at) or 0.0) for at in (low, middle, high)]
        return self.find_extreme_near(_vertex(points), greatest=greatest)

    def _turn(self, values: Sequence[float]) -> tuple[float, float, float, bool] | None:
        """Return three neighbouring values around the answer's only extreme, and whether it is a maximum; else None."""
        answers = list[float]()
        for value in values:
            answer = self._answer(value)
            if answer is None or not isfinite(answer):
                return None
            answers.append(answer)
        rises = [after > before for before, after in pairwise(answers)]
        turns = [n for n, (one, other) in enumerate(pairwise(rises)) if one != other]
        if len(turns) != 1:
            return None
        n = turns[0]
        return values[n], values[n + 1], values[n + 2], rises[n]

    def find_extreme_near(self, about: float, *, greatest: bool) -> StationaryValue | None:
        """Return the extreme close to a value, by Newton's method; None if there is none."""
        at = about
        for turn in range(NEWTON_STEPS):
            step = STENCIL_STEP * abs(at)
            answers = [self._answer(at + n * step) for n in (-2, -1, 0, 1, 2)]
            plain = [answer for answer in answers if answer is not None and isfinite(answer)]
            if len(plain) < len(answers):
                return None
            far_below, below, here, above, far_above = plain
            slope = (far_below - 8.0 * below + 8.0 * above - far_above) / (12.0 * step)
            bend = (16.0 * (below + above) - far_below - far_above - 30.0 * here) / (12.0 * step**2)
            if not (bend < 0.0 if greatest else bend > 0.0):
                return None
            shift = -slope / bend
            if abs(shift) > MAX_RELATIVE_SHIFT * abs(about):
                return None
            if turn == 0 and abs(shift) <= KNOWN_EXTREME_RTOL * abs(at):
                return StationaryValue(at, here, greatest)
            at += shift
            if abs(shift) <= CONVERGENCE_RTOL * abs(at):
                break
        value = self._answer(at)
        return StationaryValue(at, value, greatest) if value is not None else None


def _vertex(points: Sequence[tuple[float, float]]) -> float:
    """Return the position of the vertex of the parabola through three points."""
    (low, a), (middle, b), (high, c) = points
    left, right = (middle - low) * (b - c), (middle - high) * (b - a)
    return middle - 0.5 * ((middle - low) * left - (middle - high) * right) / (left - right)

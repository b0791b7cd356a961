"""Values of a number of the scene that give an answer, and thresholds at which an outcome changes."""

from collections.abc import Iterable, Sequence
from itertools import islice, pairwise
from typing import NamedTuple

import numpy as np

from sim2reason.errors import SceneError, SimulationError, UnsupportedError
from sim2reason.questions.dependence import AnswerFunction, find_roots
from sim2reason.questions.outcomes import PossibleOutcome
from sim2reason.questions.query import Query
from sim2reason.questions.study import COARSE_STEP_ERROR, EXACT_STEP_ERROR, SimulatedScene
from sim2reason.questions.unknown import Unknown, beyond_range, lengthen_strings, range_of, usual_range, with_number
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.structure import changing
from sim2reason.simulation.certify import RECORDED
from sim2reason.simulation.trace import DEFAULT_STEP_RTOL, ENGINES

PATIENCE = {False: tuple(4.0**n for n in range(2, 12)), True: (16.0, 64.0)}
"""Times the horizon, till when results are waited for with no value found; fewer where motions are integrated."""
MAX_EXTREMA = 4  # greatest number of extrema of the answer that are examined
GOLDEN_RATIO = (5.0**0.5 - 1.0) / 2.0
GOLDEN_SECTION_STEPS = 60  # of golden-section search
TOUCHED, ZERO = 1e-9, 1e-7  # relative: how closely an extremum is found, and what is no distance from it
NEIGHBOR_STEP = 1e-3  # relative: distance of a number from a root at which an answer is no longer the given one
SPARSE_STRIDE = 4  # only every fourth point of a range is tried with simulations of long duration


def values_giving(query: Query, given: float, unknown: Unknown, study: SimulatedScene) -> list[float]:
    """Return the values of an unknown number that give a query's answer, from the usual range or else from beyond."""

    def looked_for() -> list[float]:
        scene, path = study.scene, unknown.path
        dependence = AnswerFunction(query, study, path, EXACT_STEP_ERROR, lengthen_strings(scene))
        roots = find_roots(dependence, range_of(scene, path), given)
        patient = AnswerFunction(
            query,
            study,
            path,
            EXACT_STEP_ERROR,
            lengthen_strings(scene),
            None,
            PATIENCE[bool(changing(study.mechanism))],
        )
        for values in () if roots else (range_of(scene, path)[::SPARSE_STRIDE], *beyond_range(scene, path)):
            roots += find_roots(patient, values, given)
        return roots or _approached(dependence, range_of(scene, path), beyond_range(scene, path), given)

    return study.memoize(("values giving", query, given, unknown.path), looked_for)


def is_one_of_a_range(root: float, query: Query, given: float, unknown: Unknown, study: SimulatedScene) -> bool:
    """Return whether all numbers on one side of a root have the given answer, too, as friction that suffices has."""
    dependence = AnswerFunction(query, study, unknown.path, EXACT_STEP_ERROR, lengthen_strings(study.scene))
    beside = (dependence(root * (1.0 + step)) for step in (NEIGHBOR_STEP, -NEIGHBOR_STEP))
    return any(answer is not None and abs(answer - given) <= TOUCHED * abs(given) for answer in beside)


def _approached(
    dependence: AnswerFunction, usual: Sequence[float], beyond: Sequence[Sequence[float]], given: float
) -> list[float]:
    """Return the numbers for which an answer touches `given`, or just passes it and returns, near one of its extremes.

    An answer that is a magnitude does not change sign where it is zero: on both sides it is greater.
    """
    coarse = dependence.coarser(COARSE_STEP_ERROR)
    points = sorted({*usual, *(value for values in beyond for value in values)})
    deviations = [(at, abs(answer - given)) for at in points if (answer := coarse(at)) is not None]
    triples = zip(deviations, deviations[1:], deviations[2:], strict=False)
    dips = [(one[0], other[0]) for one, middle, other in triples if middle[1] < min(one[1], other[1])]
    return [root for low, high in dips[:MAX_EXTREMA] for root in _in_dip(dependence, low, high, given)]


def _in_dip(dependence: AnswerFunction, low: float, high: float, given: float) -> list[float]:
    """Return the numbers between `low` and `high` with answer `given`, near an extreme of the answer between them.

    The golden-section search ends where the answer is as given or beyond; there it passes twice.
    """
    start = dependence(low)
    if start is None:
        return []
    side, size = start > given, abs(start - given)
    points = [low, high - GOLDEN_RATIO * (high - low), low + GOLDEN_RATIO * (high - low), high]
    for _ in range(GOLDEN_SECTION_STEPS):
        answers = [dependence(at) for at in points[1:3]]
        if answers[0] is None or answers[1] is None:
            return []
        for at, answer in zip(points[1:3], answers, strict=True):
            if answer is not None and (answer > given) is not side and answer != given:
                ends = dependence.find_root_between(given, low, at), dependence.find_root_between(given, at, high)
                return [end for end in ends if end is not None]
        nearer = abs(answers[0] - given) < abs(answers[1] - given)
        one, other = (points[0], points[2]) if nearer else (points[1], points[3])
        points = [one, other - GOLDEN_RATIO * (other - one), one + GOLDEN_RATIO * (other - one), other]
        if other - one <= TOUCHED * abs(other):
            break
    middle = 0.5 * (points[0] + points[3])
    extreme = dependence(middle)
    return [middle] if extreme is not None and abs(extreme - given) <= ZERO * size else []


def why_not_one(unknown: Unknown, roots: Sequence[float], scene: Scene) -> str:
    """Return a clause explaining why an unknown number has no single value; empty if there is exactly one."""
    if len(roots) == 1:
        return ""
    if roots:
        return f"several values of {unknown.symbol} do: {', '.join(f'{value:.6g} {unknown.unit}' for value in roots)}"
    ends = [end for values in (range_of(scene, unknown.path), *beyond_range(scene, unknown.path)) for end in values]
    return f"no value of {unknown.symbol} from {min(ends):.3g} to {max(ends):.3g} {unknown.unit} does"


SAMPLES = 65
SCAN_STRIDE = 16  # stride of the first pass: without a change in it the search ends
MAX_DOUBLINGS = 7  # greatest number of doublings of the duration
THRESHOLD_RTOL, ROUGH = 1e-9, 1e-5  # relative: accuracy of the threshold, and of one for mere comparison
WRONG_THRESHOLD_RTOL = 1e-3  # relative: accuracy of a threshold known to be wrong
SAME_THRESHOLD_RTOL = 5e-7  # relative: two closer thresholds are equal
SEARCH_RTOL, WIDER, WIDEST = 0.004, 5.0, 5  # relative distance of the first search near a threshold; its growth; steps
SECANT_MARGIN = 2.0  # factor on the distance of a secant from a parabola about zero: margin of the search
MAX_SECANT_GUESSES = 2  # guesses that should halve the bracket


class _OutcomeSample(NamedTuple):
    """The result of one simulation: whether the outcome occurs, and its distance from the threshold."""

    happens: bool
    excess: float | None


class ThresholdSearch:
    """A search for the value of the number at an address at which an outcome starts, or ceases, to occur."""

    def __init__(self, study: SimulatedScene, outcome: PossibleOutcome, path: str, engine: str = RECORDED) -> None:
        """Prepare the search, given the study of a scene in which that number has any value."""
        self._scene, self._outcome, self._path, self._engine = study.scene, outcome, path, engine
        self._change = study.change
        self._known: dict[tuple[float, float], _OutcomeSample | None] = {}
        self._doublings: dict[float, int] = {}  # of the outcome's own duration, until it was clear

    def __call__(self, value: float, error: float = DEFAULT_STEP_RTOL) -> bool | None:
        """Return whether the outcome occurs for a value; None without a motion. `error` bounds integration steps."""
        result = self._tried(value, error)
        return None if result is None else result.happens

    def _tried(self, value: float, error: float) -> _OutcomeSample | None:
        if (value, error) not in self._known:
            self._known[value, error] = None
            for begin in sorted({self._usual_doublings(value), 0}, reverse=True):
                try:
                    self._known[value, error] = self._followed(value, error, begin)
                    break
                except (SceneError, SimulationError, UnsupportedError, ValueError):
                    continue  # what is amiss may come after it is clear
        return self._known[value, error]

    def _usual_doublings(self, value: float) -> int:
        """Return how many doublings of the duration decided about the outcome for the nearest known value."""
        near = min(self._doublings, key=lambda known_value: abs(known_value - value), default=None)
        return self._doublings[near] if near is not None else 0

    def _followed(self, value: float, error: float, begin: int) -> _OutcomeSample | None:
        """Return the result for one value, from motions of doubling duration.

        At first it is as long as so many doublings make it.
        """
        scene = with_number(self._scene, self._path, value)
        duration = self._outcome.duration(scene)
        mechanism = scene.mechanism if self._change is None else self._change(scene.mechanism)
        for doublings in range(begin, MAX_DOUBLINGS):
            trace = ENGINES[self._engine](mechanism, np.linspace(0.0, duration * 2.0**doublings, SAMPLES), error)
            happens = self._outcome.happens(trace)
            if happens is not None:
                self._doublings[value] = doublings
                return _OutcomeSample(happens, self._outcome.excess(trace) if happens is self._outcome.tells else None)
        return None

    def change(self) -> float | None:
        """Return the only threshold in the number's range or, without one there, up to far beyond it; else None."""
        usual = range_of(self._scene, self._path)
        turns = self._change_brackets(usual) if self._coarse_bracket() is not None else self._far_turns(usual)
        return self.find_change_between(*turns[0]) if len(turns) == 1 else None

    def _far_turns(self, usual: tuple[float, ...]) -> list[tuple[float, float]]:
        """Return up to two pairs of neighbouring values, in the range or far beyond, around changes of the outcome."""
        beyond = beyond_range(self._scene, self._path)
        return (
            self._change_brackets(sorted({*usual, *(value for values in beyond for value in values)})) if beyond else []
        )

    def changes_at(self, value: float, *, above: bool, error: float = DEFAULT_STEP_RTOL) -> bool:
        """Return whether the outcome occurs just above a value and not just below it, or the reverse.

        `error` is the error allowed in an integration step, reduced if necessary to resolve the two sides.
        """
        error = min(error, EXACT_STEP_ERROR)
        return self(value * (1.0 + SAME_THRESHOLD_RTOL), error) is above and self(
            value * (1.0 - SAME_THRESHOLD_RTOL), error
        ) is (not above)

    def rough_change(self, *, above: bool, error: float = DEFAULT_STEP_RTOL) -> float | None:
        """Return the only threshold on a coarse grid, if the outcome above it is as `above` says; else None.

        `error` is the error allowed in an integration step; a large one also lowers the accuracy of the result.
        """
        turn = self._coarse_bracket()
        if turn is None or self(turn[1], COARSE_STEP_ERROR) is not above:
            return None
        return self.find_change_between(*turn, THRESHOLD_RTOL if error <= EXACT_STEP_ERROR else ROUGH, error)

    def usual_change(self) -> float | None:
        """Return the threshold in the usual range, if a coarse grid shows a single one; else None.

        There may be others between the points of the grid; `changes_only_at` tests that at a higher cost.
        """
        turn = self._coarse_bracket()
        if turn is None or not self._is_usual(*turn):
            return None
        low, high = self._halved([v for v in range_of(self._scene, self._path) if turn[0] <= v <= turn[1]])
        return self.find_change_between(low, high) if self._is_usual(low, high) else None

    def changes_only_at(self, value: float) -> bool:
        """Return whether a threshold is the only one in the number's range."""
        turns = self._change_brackets(range_of(self._scene, self._path))
        return len(turns) == 1 and turns[0][0] <= value <= turns[0][1]

    def _coarse_bracket(self) -> tuple[float, float] | None:
        """Return the only pair of neighbours on a coarse grid between which the outcome changes; None if not unique."""
        values = range_of(self._scene, self._path)
        turns = self._change_brackets((*values[::SCAN_STRIDE], values[-1]))
        return turns[0] if len(turns) == 1 else None

    def _halved(self, values: list[float]) -> tuple[float, float]:
        """Return two neighbours among values between which the outcome changes, by bisection."""
        first = self(values[0], COARSE_STEP_ERROR)
        while len(values) > 2:
            middle = len(values) // 2
            happens = self(values[middle], COARSE_STEP_ERROR)
            if happens is None:
                values.pop(middle)
            else:
                values = values[middle:] if happens == first else values[: middle + 1]
        return values[0], values[-1]

    def _change_brackets(self, values: Iterable[float]) -> list[tuple[float, float]]:
        """Return up to two pairs of neighbours among values between which the outcome changes."""
        outcomes = ((value, happens) for value in values if (happens := self(value, COARSE_STEP_ERROR)) is not None)
        return list(islice(((low, high) for (low, one), (high, other) in pairwise(outcomes) if one != other), 2))

    def _is_usual(self, low: float, high: float) -> bool:
        """Return whether an interval lies within the usual range of the number."""
        smallest, most = usual_range(self._scene, self._path)
        return low <= most and high >= smallest

    def close_to(self, about: float, within: float) -> float | None:
        """Return the threshold within a relative distance of a number; None if the outcome is equal at the ends."""
        sides = {self(about * (1.0 - within), COARSE_STEP_ERROR), self(about * (1.0 + within), COARSE_STEP_ERROR)}
        return self.find_change_near(about) if sides == {True, False} else None

    def within(self, about: float, times: float) -> float | None:
        """Return the threshold within a factor of a number, if the outcome differs at the ends; else None."""
        smallest, *_, most = range_of(self._scene, self._path)
        low, high = max(smallest, about / times), min(most, about * times)
        return self.find_change_between(low, high, WRONG_THRESHOLD_RTOL, COARSE_STEP_ERROR)

    def find_change_near(self, about: float) -> float | None:
        """Return the threshold nearest to a number, searched at growing distances; None if there is none."""
        for width in (SAME_THRESHOLD_RTOL, *(SEARCH_RTOL * WIDER**turn for turn in range(WIDEST))):
            low, high = about / (1.0 + width), about * (1.0 + width)
            if {self(low, EXACT_STEP_ERROR), self(high, EXACT_STEP_ERROR)} == {True, False}:
                return (
                    about
                    if width == SAME_THRESHOLD_RTOL
                    else self.find_change_between(low, high, ROUGH, EXACT_STEP_ERROR)
                )
        return None

    def find_change_between(
        self, low: float, high: float, exact: float = THRESHOLD_RTOL, error: float = DEFAULT_STEP_RTOL
    ) -> float | None:
        """Return the threshold between two numbers; None if the outcome does not differ or a motion fails.

        Secants are used on a side on which the distance from the threshold is known, bisection otherwise.
        """
        below = self(low, error)
        if {below, self(high, error)} != {True, False}:
            return None
        low, high = self._narrowed(low, high, error)
        left, guesses = high - low, 0
        while high - low > exact * abs(high):
            aimed = self._aimed(low, high, exact) if guesses < MAX_SECANT_GUESSES else None
            at = 0.5 * (low + high) if aimed is None else aimed
            happens = self(at, error)
            if happens is None:
                return None
            low, high = (at, high) if happens == below else (low, at)
            guesses += 1
            if high - low <= 0.5 * left:
                left, guesses = high - low, 0
        return 0.5 * (low + high)

    def _narrowed(self, low: float, high: float, error: float) -> tuple[float, float]:
        """Return the closest known numbers, from `low` to `high`, between which the outcome changes."""
        known = sorted((at, f.happens) for (at, by), f in self._known.items() if by == error and f is not None)
        between = [entry for entry in known if low <= entry[0] <= high]
        return next((one, other) for (one, a), (other, b) in pairwise(between) if a != b)

    def _aimed(self, low: float, high: float, exact: float) -> float | None:
        """Return a guess for the threshold by a secant, in turn just above and just below its root; else None."""
        excess_by_value = {
            at: candidate.excess
            for (at, _), candidate in self._known.items()
            if candidate and candidate.excess is not None
        }
        near = next((end for end in (low, high) if end in excess_by_value), None)
        other = min(excess_by_value.keys() - {near}, key=lambda at: min(abs(at - low), abs(at - high)), default=None)
        if near is None or other is None or excess_by_value[near] == excess_by_value[other]:
            return None
        change = near - excess_by_value[near] * (other - near) / (excess_by_value[other] - excess_by_value[near])
        aside = max(0.4 * exact * abs(high), SECANT_MARGIN * abs((near - change) * (other - change) / (change or 1.0)))
        far, ahead = (high, 1.0) if near == low else (low, -1.0)
        candidate = change + ahead * (aside if abs(far - change) > 2.0 * aside else -aside)
        return candidate if low < candidate < high else None

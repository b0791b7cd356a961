"""Questions that state a result and ask for an unknown number, and tests of the uniqueness of that number."""

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import isfinite

from sim2reason.questions.accuracy import StatedResult
from sim2reason.questions.dependence import AnswerFunction, bisect_border
from sim2reason.questions.kinds import KINDS
from sim2reason.questions.query import Noun, Query
from sim2reason.questions.unknown import Unknown
from sim2reason.questions.words import Words

SCAN_STRIDES = (16, 4)  # steps of the scan: a coarse pass first
MAX_CUBIC_ERROR = (
    0.1  # of the smaller distance from the given result: maximum error of a cubic interpolation, if smooth
)
ROOT_RTOL = 0.01  # relative: values closer to the root are the same root
MAX_PARABOLIC_GUESSES = 3  # parabolic guesses for a minimum of the difference between answer and given result
MAX_DIP_FRACTION = 0.3  # of the smallest known difference: a parabolic guess above this fraction is not evaluated
NEAR_MARGINS = 10.0  # smallest significant differences: only nearer answers are recomputed, and searched for kinks
MAX_KINK_HALVINGS = 10  # halvings near a minimum that is a kink
EDGE_RTOL = 0.01  # relative: distance from the root at which a missing answer is tested
EXTRAPOLATION_STEPS = 3.0  # steps of the scan: extrapolation distance beyond an end of the range
MAX_LINE_ERROR = 0.3  # of the smallest distance from the given result: maximum error of a line on an even interval
MAX_REFINEMENTS = 3  # refinements of uneven intervals
MAX_COURSE_HALVINGS = 5  # halvings between numbers with different courses of events


class UniquenessScan:
    """A search for values of a number, apart from a known one, whose answer also equals or crosses the given result.

    The numbers with the given result are roots. If the known one is the only root, answers below and above it lie on
    opposite sides of the given result. Differences from that are counted in smallest significant differences, the
    margins.
    """

    def __init__(
        self, dependence: AnswerFunction, root: float, given: float, margin: float, coarse: AnswerFunction | None = None
    ) -> None:
        """Prepare the search; `margin` is the smallest significant difference between an answer and the given result.

        Where the answer is far from the given result, the cheaper `coarse` dependence suffices.
        """
        rate = dependence.rate(root)
        self._dependence, self._coarse, self._root, self._given = dependence, coarse or dependence, root, given
        self._scale = margin if rate is not None and rate > 0.0 else -margin
        self._known: dict[float, float | None] = {}

    def find_other_root(self, values: Sequence[float]) -> float | None:
        """Return a number whose answer may equal the given result or be on its unexpected side; None if there is none.

        A number whose answer may lie beyond the end of the simulation counts as well. Candidates are all `values`,
        limits of the range with an answer, minima of dips, and midpoints of intervals in which the answer oscillates.
        """
        return next((at for at in self._tried(values) if self._could_be(at)), None)

    def find_missing_answer(self, values: Sequence[float]) -> float | None:
        """Return a number next to the known root, within `values`, for which there is no answer; else None."""
        beside = sorted(self._root + side * EDGE_RTOL * abs(self._root) for side in (-1.0, 1.0))
        return next((at for at in beside if values[0] <= at <= values[-1] and self._coarse(at) is None), None)

    def find_distant_root(self, values: Sequence[float]) -> float | None:
        """Return one of the distant `values` whose answer is close to the given result or past that result; else None.

        Intermediate values are not tested: beyond another root all answers are on the wrong side.
        """
        clear = ((at, self._scaled_distance(at)) for at in values)
        return next((at for at, by in clear if by is not None and by <= 1.0), None)

    def find_extrapolated_root(self, values: Sequence[float]) -> float | None:
        """Return an end of the range of `values` beyond which extrapolation suggests another root; None if neither.

        No text states the end of the range, and a reader who searches a little farther finds that root, too.
        """
        for last, before in ((values[0], values[1]), (values[-1], values[-2])):
            here, inside = self._scaled_distance(last), self._scaled_distance(before)
            if (
                here is not None
                and inside is not None
                and isfinite(inside)
                and here <= EXTRAPOLATION_STEPS * (inside - here)
            ):
                return last
        return None

    def _tried(self, values: Sequence[float]) -> Iterator[float]:
        for stride in SCAN_STRIDES:
            yield from filter(self._is_apart, values[stride // 2 :: stride])
        yield from filter(self._is_apart, self._between(values))
        yield from self._borders()
        yield from filter(self._is_apart, self._turning_points())
        yield from self._dips()
        yield from filter(self._is_apart, self._swings())

    def _between(self, values: Sequence[float]) -> Iterator[float]:
        """Yield those of `values` that the coarse passes omit, except in intervals where the answer is smooth."""
        stride = SCAN_STRIDES[-1]
        first = stride // 2
        last = len(values) - 1 - (len(values) - 1 - first) % stride
        yield from (*values[:first], *values[last + 1 :])
        for low in range(first, last, stride):
            yield values[low + stride // 2]
            if not self._is_smooth(values, low):
                yield from (values[at] for at in range(low + 1, low + stride) if at != low + stride // 2)

    def _is_smooth(self, values: Sequence[float], low: int) -> bool:
        """Return whether the answer is monotonic around a value and agrees with a cubic interpolation."""
        stride = SCAN_STRIDES[-1]
        ends = [values[at] for at in (low, low + stride)]
        middle = values[low + stride // 2]
        if ends[0] <= self._root <= ends[1] or any(self._differ(middle, end) for end in ends):
            return False
        a, b, c = (self._known.get(at) for at in (ends[0], middle, ends[1]))
        if a is None or b is None or c is None or not min(a, c) < b < max(a, c) or not isfinite(max(a, c)):
            return False
        before, after = (
            self._beside(values, at, end) for at, end in ((low - stride, ends[0]), (low + 2 * stride, ends[1]))
        )
        if before is not None and after is not None:
            guess = (9.0 * (a + c) - before - after) / 16.0
        elif before is not None or after is not None:
            near, far, beyond = (c, a, before) if before is not None else (a, c, after)
            assert beyond is not None
            guess = (3.0 * near + 6.0 * far - beyond) / 8.0
        else:
            return False
        return abs(b - guess) <= MAX_CUBIC_ERROR * min(a, c)

    def _beside(self, values: Sequence[float], index: int, end: float) -> float | None:
        """Return the known distance of the answer at `values[index]` from the given result; None if unknown."""
        if not 0 <= index < len(values) or (values[index] < self._root) != (end < self._root):
            return None
        distance = self._known.get(values[index])
        return None if distance is None or not isfinite(distance) or self._differ(values[index], end) else distance

    def _is_apart(self, at: float) -> bool:
        return abs(at - self._root) > ROOT_RTOL * abs(self._root)

    def _could_be(self, at: float) -> bool:
        clear = self._scaled_distance(at)
        return self._coarse.is_late(at) if clear is None else clear <= 1.0

    def _scaled_distance(self, at: float) -> float | None:
        """Return the answer for a number less the given result, in units of the smallest significant difference.

        It is positive on the correct side of the result. None without an answer.
        """
        if at not in self._known:
            clear = self._signed_distance(at, self._coarse(at))
            self._known[at] = (
                clear if clear is None or clear > NEAR_MARGINS else self._signed_distance(at, self._dependence(at))
            )
        return self._known[at]

    def _signed_distance(self, at: float, found: float | None) -> float | None:
        side = 1.0 if at > self._root else -1.0
        return None if found is None else side * (found - self._given) / self._scale

    def _borders(self) -> Iterator[float]:
        """Yield numbers that approach, by bisection, the limits beyond which there is no answer."""
        for one, other in pairwise(sorted({*self._known, self._root})):
            yield from bisect_border(self._coarse, one, other)

    def _turning_points(self) -> Iterator[float]:
        """Yield midpoints of neighbouring numbers that have different courses of events.

        If a midpoint has no answer, numbers that approach the limits of the range with an answer follow.
        """
        pairs = list(pairwise(sorted({*self._known, self._root})))
        for _ in range(MAX_COURSE_HALVINGS):
            differing = [pair for pair in pairs if self._differ(*pair)]
            middles = [0.5 * (low + high) for low, high in differing]
            yield from middles
            for (low, high), at in zip(differing, middles, strict=True):
                if self._coarse(at) is None:
                    yield from (*bisect_border(self._coarse, low, at), *bisect_border(self._coarse, at, high))
            pairs = [
                half for (low, high), at in zip(differing, middles, strict=True) for half in ((low, at), (at, high))
            ]

    def _differ(self, one: float, other: float) -> bool:
        """Return whether two numbers lead to different courses of events."""
        courses = [self._coarse.course(at) for at in (one, other)]
        return None not in courses and courses[0] != courses[1]

    def _dips(self) -> Iterator[float]:
        """Yield guesses for the local minima of the difference between the answer and the given result."""
        for side in (-1.0, 1.0):
            beyond = sorted(at for at in self._known if (at - self._root) * side > 0.0)
            for index in range(1, len(beyond) - 1):
                yield from self._bottom(beyond[index - 1], beyond[index], beyond[index + 1])

    def _bottom(self, low: float, middle: float, high: float) -> Iterator[float]:
        for guess in range(MAX_PARABOLIC_GUESSES + MAX_KINK_HALVINGS):
            a, b, c = (self._scaled_distance(at) for at in (low, middle, high))
            if a is None or b is None or c is None or not (isfinite(a) and isfinite(c) and b < a and b <= c):
                return
            bottom, depth = _lowest((low, a), (middle, b), (high, c))
            if guess >= MAX_PARABOLIC_GUESSES or depth > MAX_DIP_FRACTION * b or bottom in self._known:
                if b > NEAR_MARGINS:
                    return
                bottom = 0.5 * (middle + max(low, high, key=lambda end: abs(end - middle)))
            yield bottom
            lower = self._scaled_distance(bottom)
            if lower is None:
                return
            if lower < b:
                low, middle, high = (low, bottom, middle) if bottom < middle else (middle, bottom, high)
            else:
                low, high = (bottom, high) if bottom < middle else (low, bottom)

    def _swings(self) -> Iterator[float]:
        """Yield midpoints of intervals in which the answer varies unevenly and may oscillate."""
        for _ in range(MAX_REFINEMENTS):
            known = [(at, clear) for at, clear in sorted(self._known.items()) if clear is not None and isfinite(clear)]
            uneven = (each for each in zip(known, known[1:], known[2:], strict=False) if _is_uneven(*each))
            finer = {0.5 * (one[0] + other[0]) for each in uneven for one, other in pairwise(each)}
            yield from sorted(finer)


def _is_uneven(low: tuple[float, float], middle: tuple[float, float], high: tuple[float, float]) -> bool:
    """Return whether a line through the outer two of three points (x, y) misses the middle point by far."""
    share = (middle[0] - low[0]) / (high[0] - low[0])
    line = (1.0 - share) * low[1] + share * high[1]
    return abs(middle[1] - line) > MAX_LINE_ERROR * min(low[1], middle[1], high[1])


def _lowest(*points: tuple[float, float]) -> tuple[float, float]:
    """Return the minimum (x, y) of the parabola through three points, of which the middle one is lowest."""
    (low, a), (middle, b), (high, c) = points
    left, right = (middle - low) * (b - c), (middle - high) * (b - a)
    bottom = middle - 0.5 * ((middle - low) * left - (middle - high) * right) / (left - right)
    bend = ((a - b) / (middle - low) + (c - b) / (high - middle)) / (high - low)
    return bottom, b - bend * (bottom - middle) ** 2


def asking_for(unknown: Unknown, query: Query, given: StatedResult, words: Words, noun: Noun | None) -> tuple[str, ...]:
    """Return all sentences that ask for the value of the unknown with which a query has the given result."""
    kind, sense = KINDS[query.kind], query.target.sense if query.target is not None else None
    wanted, statements = kind.condition_phrases(query, words, noun), kind.statements(query, words, noun, given.text)
    plain = [f"{called} is {given.text}" for called in kind.noun_phrases(query, words, noun)[:1]]
    clauses = tuple(dict.fromkeys((*statements[:1], *plain)))
    counted = f", {sense.positive} being positive" if sense is not None and not sense.fixed else ""
    shapes = (
        shape
        for phrase in unknown.phrases
        for shape in (
            *_stated(statements, clauses, phrase, counted),
            *(shape for name in wanted for shape in _wanted(name, given.text, phrase, unknown.symbol, counted)),
        )
    )
    return tuple(dict.fromkeys(shapes))


def _stated(statements: tuple[str, ...], clauses: tuple[str, ...], unknown: str, counted: str) -> Iterator[str]:
    """Yield sentences that state the result first, as a statement of its own or as a clause."""
    for statement in statements:
        if statement[0].isalpha():
            yield f"{statement}{counted}. What is {unknown}?"
            yield f"{statement}{counted}. Find {unknown}."
            yield f"{statement}{counted}. Determine {unknown}."
    for clause in clauses:
        yield f"find {unknown}, given that {clause}{counted}."
        yield f"calculate {unknown} if {clause}{counted}."
        yield f"what is {unknown} if {clause}{counted}?"


def _wanted(called: str, value: str, unknown: str, symbol: str, counted: str) -> Iterator[str]:
    """Yield sentences that state the result as a requirement, as in *what must m be if the speed is to be 2 m/s?*."""
    yield f"what must {unknown} be if {called} is to be {value}{counted}?"
    yield f"determine {unknown} so that {called} is {value}{counted}."
    yield f"for which value of {symbol} is {called} equal to {value}{counted}?"

"""Variations: the same question in scenes with other numbers, each simulated by the exact engine."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import islice
from math import copysign, exp, inf

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.errors import SceneError, SimulationError, UnsupportedError
from sim2reason.generation.modes.problem_formula import (
    ProblemSymbol,
    Variation,
    answered,
    find_sign,
    find_sums,
    likely_answer,
    turns,
)
from sim2reason.questions import KINDS, Query, SimulatedScene
from sim2reason.questions.regimes import Regime
from sim2reason.questions.study import EXACT_STEP_ERROR, MIN_VARIANT_FRACTION, TIME_MARGIN
from sim2reason.questions.unknown import lengthen_strings
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.state import Array
from sim2reason.scenes.dsl.structure import changing
from sim2reason.simulation.certify import RECORDED
from sim2reason.simulation.trace import DEFAULT_STEP_RTOL, ENGINES
from sim2reason.solutions.algebra.expressions import Expression

WAIT_FACTOR = 3.0  # factor on the time of an event within which it is awaited in variations
ABSENCE_FACTOR = 4.0  # times that, after which the event is considered absent
LOOKED, EACH = 240, 2  # numbers at which signs of sums are evaluated; uses of each sign change
MAX_WIDE_VARIATIONS = (
    (160, 40),
    (24, 24),
)  # numbers tried and answers found, at most; second pair: if the motion is integrated
MAX_DRAWS = 4  # draws per wanted variation, at most
TURN_FACTOR = 0.02  # fraction of the way beyond the numbers at which a sum changes its sign
TIME_FACTORS = (
    0.4,
    1.2,
)  # factors on the first simulated time of orbits, and on the last one of other integrated motions
STEEPEST, STRAIGHT = 89.0, 180.0  # degrees
MAX_SHIFT = 2.0  # times the largest number of a unit, by which signed numbers are shifted


@dataclass(frozen=True)
class Variations:
    """A problem in which all stated numbers can be replaced, for tests of its formula."""

    study: SimulatedScene
    query: Query
    symbols: Sequence[ProblemSymbol]
    formula: Expression | None = None  # which likely gives the answers, if one is known
    factor: float = 1.0  # which makes the engine's answers those of formulas

    def own(self) -> Variation | None:
        """Return the problem with its own numbers; None if it has no answer."""
        outcome = answered(self.query, self.study)
        return (
            None
            if outcome is None
            else Variation(self._in_formula_units([symbol.value for symbol in self.symbols]), *outcome)
        )

    def drawn(
        self, rng: np.random.Generator, width: float, tries: int, unanswered: list[SimulatedScene] | None = None
    ) -> Iterator[Variation | None]:
        """Yield problems with each number multiplied by a random factor between exp(−`width`) and exp(`width`).

        None stands for a problem without an answer; motions without an answer are added to `unanswered`.
        """
        for values in self._draw_around([symbol.value for symbol in self.symbols], rng, width, tries):
            yield self._simulate_at(values, unanswered)

    def widely(self, rng: np.random.Generator, width: float, unanswered: list[SimulatedScene]) -> Iterator[Variation]:
        """Yield many problems with random numbers; fewer if the motion must be integrated, which is far slower."""
        tries, wanted = MAX_WIDE_VARIATIONS[bool(changing(self.study.mechanism))]
        found = (each for each in self.drawn(rng, width, tries, unanswered) if each is not None)
        yield from islice(found, wanted)

    def across(self, rng: np.random.Generator, width: float, tries: int) -> Iterator[Variation]:
        """Yield problems whose moment is a value on the other side of the initial one, such as 1.25 instead of 0.8.

        None are drawn for numbers that are restricted to one side.
        """
        moment = self.query.moment
        other = moment.mirrored_values(self.study.trace) if moment is not None else None
        if other is None:
            return
        numbers = iter(other)
        mirrored = [symbol.value if symbol.path else next(numbers) for symbol in self.symbols]
        for values in self._draw_around(mirrored, rng, width, tries):
            variation = self._simulate_at(values, None, (self.study.scene.horizon,))
            if variation is not None:
                yield variation

    def draw_turned(
        self, rng: np.random.Generator, formulas: Sequence[Expression], width: float, unanswered: list[SimulatedScene]
    ) -> Iterator[Variation]:
        """Yield problems with numbers at which a sum in one of the formulas changes its sign or vanishes.

        Formulas likely fail there, and random numbers may miss such a small region. Numbers just beyond the change of
        sign are included; a sum that random numbers never change is changed deliberately.
        """
        here = [entry.value for entry in self.symbols]
        sums = [*dict.fromkeys(entry for formula in formulas for entry in (formula, *find_sums(formula)))]
        signs, tries = [find_sign(each, self._in_formula_units(here)) for each in sums], [0] * len(sums)
        drawn = [*self._draw_around(here, rng, width, LOOKED)]
        turning = [self._turns(each, sign, drawn) for each, sign in zip(sums, signs, strict=True)]
        for number, values in enumerate(drawn):
            other = [n for n, at in enumerate(turning) if tries[n] < MAX_DRAWS and at[number]]
            closer = [self._just_beyond(values, sums[n], signs[n]) for n in other]
            variations = [
                self.having(numbers, unanswered) for numbers in dict.fromkeys((tuple(values), *closer)) if other
            ]
            for n in other:
                tries[n] += MAX_DRAWS // EACH if any(variations) else 1
            yield from (each for each in variations if each is not None)
        corners = (self._corner(sums[n], width) for n, count in enumerate(tries) if not count)
        for values in dict.fromkeys(corner for corner in corners if corner is not None):
            yield from self._moving(values, unanswered)

    def _turns(self, held: Expression, sign: float | None, drawn: Sequence[Sequence[float]]) -> list[bool]:
        """Return, for each set of numbers, whether a sum's value differs in sign from `sign`, or is undefined."""
        return turns(held, sign, self.columns(np.array(drawn)))

    def columns(self, drawn: Array) -> dict[str, Array]:
        """Return the values (n,) of each symbol in sets of numbers (n, s), in the units of formulas."""
        return {
            symbol.symbol: symbol.counted(1.0) * numbers for symbol, numbers in zip(self.symbols, drawn.T, strict=True)
        }

    def _just_beyond(self, values: Sequence[float], held: Expression, sign: float | None) -> tuple[float, ...]:
        """Return numbers between the problem's own and `values` at which a sum has just changed its sign."""
        low, high = 0.0, 1.0
        while high - low > TURN_FACTOR / 2.0:
            middle = (low + high) / 2.0
            beyond = find_sign(held, self._in_formula_units(self._towards(values, middle))) != sign
            low, high = (low, middle) if beyond else (middle, high)
        return self._towards(values, min(1.0, high + TURN_FACTOR))

    def _towards(self, values: Sequence[float], share: float) -> tuple[float, ...]:
        """Return numbers at a fraction of the way from the problem's own to `values`, on a logarithmic scale."""
        return tuple(
            symbol.value * (to / symbol.value) ** share for symbol, to in zip(self.symbols, values, strict=True)
        )

    def vary_one_by_one(self, width: float, unanswered: list[SimulatedScene]) -> Iterator[Variation]:
        """Yield problems with one number far smaller or larger than all others of the same unit.

        Symbols state neither which of several numbers is the largest, nor whether an angle is acute.
        """
        here = [symbol.value for symbol in self.symbols]
        for n, (smallest, most) in enumerate(zip(self._sizes(min), self._sizes(max), strict=True)):
            own = abs(here[n])
            ends = [
                size * exp(side * width) for sizes, side in (((smallest, own), -1), ((own, most), 1)) for size in sizes
            ]
            ends += [STRAIGHT - own] if self.symbols[n].unit == "deg" else []
            for end in dict.fromkeys(ends):
                yield from self._moving([*here[:n], copysign(end, here[n]), *here[n + 1 :]], unanswered)

    def mirrored(self, rng: np.random.Generator, width: float) -> Iterator[Variation]:
        """Yield problems with one signed number negated, then with random signs and shifts of all signed numbers.

        A text in symbols does not state their signs. Cheap motions are drawn more often, since most of these variations
        have no answer.
        """
        unanswered: list[SimulatedScene] = []
        here, may = [symbol.value for symbol in self.symbols], np.array([symbol.signed for symbol in self.symbols])
        for n in np.flatnonzero(may).tolist():
            yield from self._moving([*here[:n], -here[n], *here[n + 1 :]], unanswered)
        tries = (EACH if changing(self.study.mechanism) else LOOKED) // 2  # of either
        sizes = self._sizes(max)
        for drawn in self._draw_around(here, rng, width, tries if may.any() else 0):
            values = np.array(drawn)
            signs = np.where(may, rng.choice((-1.0, 1.0), len(may)), 1.0)
            shifts = rng.uniform(0.0, MAX_SHIFT) * np.array(sizes) * rng.uniform(-1.0, 1.0, len(may))
            yield from self._moving((values * signs).tolist(), unanswered)
            yield from self._moving(np.where(may, np.array(here) + shifts, values).tolist(), unanswered)

    def _sizes(self, extreme: Callable[[Iterable[float]], float]) -> list[float]:
        """Return, for each number, the largest (or smallest) magnitude among all numbers of its unit."""
        return [
            extreme(abs(each.value) for each in self.symbols if each.unit == symbol.unit) for symbol in self.symbols
        ]

    def having(
        self, values: Sequence[float], unanswered: list[SimulatedScene] | None = None, told: Sequence[Regime] = ()
    ) -> Variation | None:
        """Return the problem with given numbers; None if it has no answer, or an angle is nearly a right angle.

        None also if its motion never satisfies one of the assumptions `told`, and that shows before the answer.
        """
        return None if self._is_steep(values) else self._simulate_at(values, unanswered, told=told)

    def _moving(self, values: Sequence[float], unanswered: list[SimulatedScene]) -> Iterator[Variation]:
        variation = self.having(values, unanswered)
        if variation is not None:
            yield variation

    def _corner(self, held: Expression, width: float) -> tuple[float, ...] | None:
        """Return numbers, each at an end of its range, for which a sum changes its sign; None if there are none."""
        values = [held.value for held in self.symbols]
        sign = find_sign(held, self._in_formula_units(values))
        for n in range(len(values)):
            ends = ([*values[:n], values[n] * times, *values[n + 1 :]] for times in (exp(-width), exp(width)))
            values = min((end for end in ends if not self._is_steep(end)), key=lambda end: self._size(held, end, sign))
        return tuple(values) if find_sign(held, self._in_formula_units(values)) != sign else None

    def _size(self, held: Expression, values: Sequence[float], sign: float | None) -> float:
        """Return a sum's value for some numbers, times its original sign: negative if the sum has changed its sign."""
        try:
            return held.value(self._in_formula_units(values)).real * (sign or 1.0)
        except (ValueError, ArithmeticError):
            return -inf

    def _is_steep(self, values: Sequence[float]) -> bool:
        """Return whether an angle is nearly a right angle although the text's is not."""
        return any(
            symbol.unit == "deg" and abs(symbol.value) <= STEEPEST < abs(value) < STRAIGHT - STEEPEST
            for symbol, value in zip(self.symbols, values, strict=True)
        )

    def _draw_around(
        self, middle: Sequence[float], rng: np.random.Generator, width: float, tries: int
    ) -> Iterator[list[float]]:
        """Yield random numbers around given ones, without angles close to a right angle."""
        factors = np.exp(rng.uniform(-width, width, (tries, len(self.symbols))))
        yield from (values for values in (np.array(middle) * factors).tolist() if not self._is_steep(values))

    def _simulate_at(
        self,
        values: Sequence[float],
        unanswered: list[SimulatedScene] | None,
        ends: tuple[float, ...] = (),
        told: Sequence[Regime] = (),
    ) -> Variation | None:
        """Return the problem with given numbers, simulated to each of the times `ends` (s) until there is an answer."""
        assigned = {symbol.path: value for symbol, value in zip(self.symbols, values, strict=True) if symbol.path}
        query, seen = self._asking(values), None
        error = (
            DEFAULT_STEP_RTOL if unanswered is None else EXACT_STEP_ERROR
        )  # far away nothing is recorded: a formula holds or does not
        try:
            scene = self._roomy.having_all(assigned)
            if scene.mechanism.routes != self.study.mechanism.routes:
                return None  # the text tells another course of a string
            ends = ends or self._ends(query)
            for end in ends if unanswered is None or not self._waits(query) else (*ends, ABSENCE_FACTOR * ends[-1]):
                seen = SimulatedScene(scene, ENGINES[RECORDED](scene.mechanism, np.array([0.0, end]), error))
                if any(regime.never_holds(seen) for regime in told):
                    return None
                outcome = answered(query, seen)
                if outcome is not None:
                    return Variation(self._in_formula_units(values), *outcome)
        except (SceneError, SimulationError, UnsupportedError, ValueError):
            return None
        if unanswered is not None and seen is not None:
            unanswered.append(seen)
        return None

    @cached_property
    def _roomy(self) -> Scene:
        """Return the scene with strings and faces so long that other numbers cause no collision with their ends."""
        return lengthen_strings(self.study.scene)

    def _in_formula_units(self, values: Sequence[float]) -> dict[str, float]:
        return {symbol.symbol: symbol.counted(value) for symbol, value in zip(self.symbols, values, strict=True)}

    def _asking(self, values: Sequence[float]) -> Query:
        """Return the query with the question's numbers replaced, and with the answer that the formula predicts."""
        moment = self.query.moment
        numbers = [value for symbol, value in zip(self.symbols, values, strict=True) if not symbol.path]
        query = replace(self.query, moment=moment.having(numbers)) if moment is not None else self.query
        if self.formula is None or not KINDS[query.kind].takes_likely_answer:
            return query
        answer = likely_answer(self.formula, self._in_formula_units(values), self.factor)
        return KINDS[query.kind].with_likely_answer(query, answer)

    @staticmethod
    def _waits(query: Query) -> bool:
        """Return whether the moment asked about is an event or a reached value, whose time follows from the motion."""
        return query.moment is not None and bool(query.moment.event or query.moment.channels)

    def _ends(self, query: Query) -> tuple[float, ...]:
        """Return the times to which the motion is simulated, s: a stated one, else multiples of the original time."""
        here, minimum = (
            KINDS[self.query.kind].time(self.query, self.study) or 0.0,
            MIN_VARIANT_FRACTION * self.study.scene.horizon,
        )
        moment = query.moment
        times = [number for number, unit in moment.stated if unit == "s"] if moment is not None else []
        if times and not self._waits(query):
            return (max(TIME_MARGIN * times[0], minimum),)
        comes = self._waits(query) or KINDS[query.kind].awaited
        mechanism = self.study.mechanism
        sooner = TIME_FACTORS if mechanism.attractions else TIME_FACTORS[-1:] if changing(mechanism) else ()
        factors = sooner if comes and WAIT_FACTOR * here > minimum else ()
        return tuple(max(factor * here, minimum) for factor in (*factors, WAIT_FACTOR))

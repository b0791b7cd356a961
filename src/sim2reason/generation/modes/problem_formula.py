"""The formula that answers a problem: its symbols, the signs of its sums, and the values it gives."""

from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from math import copysign, isfinite

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.errors import SimulationError
from sim2reason.questions import KINDS, Query, SimulatedScene, Words
from sim2reason.questions.regimes import Regime
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.certify import RECORDED
from sim2reason.simulation.trace import ENGINES
from sim2reason.solutions.algebra.expressions import Expression, Sum
from sim2reason.solutions.algebra.functions import array_values
from sim2reason.solutions.closed_forms import ClosedFormError, combined_formula
from sim2reason.solutions.derivation import derivation
from sim2reason.text.prose.description import formula_unit_factor


@dataclass(frozen=True, slots=True)
class ProblemSymbol:
    """A symbol of a problem, with its unit and value as stated, and the address of its number.

    Numbers of the question itself have no address. A `signed` symbol may stand for a negative number.
    """

    symbol: str
    unit: str
    value: float
    path: str = ""
    signed: bool = False

    @property
    def of_world(self) -> bool:
        """Return whether the symbol belongs to the world, as g does, not to an object in it."""
        return self.path.startswith("world.")

    def counted(self, value: float) -> float:
        """Return a value in the units of formulas: radians for degrees, metres for kilometres."""
        return value * formula_unit_factor(self.unit)


@dataclass(frozen=True)
class Variation:
    """A scene with other numbers: the values in formula units, the motion and the answer."""

    values: Mapping[str, float]
    study: SimulatedScene
    query: Query
    answer: float

    @cached_property
    def until(self) -> float:
        """Return the latest time on which the answer depends, s."""
        return KINDS[self.query.kind].time(self.query, self.study) or 0.0

    def satisfies(self, regime: Regime) -> bool:
        """Return whether an assumption holds up to the latest time on which the answer depends, cached."""
        return self.study.memoize((regime, self.until), lambda: regime.holds(self.study, self.until))

    @property
    def story(self) -> tuple[tuple[str, tuple[str, ...]], ...]:
        """Return the events up to the latest time on which the answer depends, in order, without turning points."""
        return self.study.trace.story(self.until)

    @property
    def finer(self) -> "Variation | None":
        """Return the variation simulated with the smallest steps; None without an answer, or if it already is."""
        scene, trace = self.study.scene, self.study.trace
        if not trace.tolerance:
            return None
        try:
            outcome = answered(self.query, SimulatedScene(scene, ENGINES[RECORDED](scene.mechanism, trace.state.times)))
        except SimulationError:
            return None
        return None if outcome is None else Variation(self.values, *outcome)


def answered(query: Query, study: SimulatedScene) -> tuple[SimulatedScene, Query, float] | None:
    """Return the motion, query and answer, simulated as long as needed; None if there is no answer."""
    answer = KINDS[query.kind].loose_answer(query, study)
    time = KINDS[query.kind].time(query, study)
    if answer is None or not isfinite(answer) or time is None or time > study.trace.stable_until:
        return None
    return study, query, answer


def find_sums(expression: Expression) -> Iterator[Sum]:
    """Yield all sums in a formula."""
    if isinstance(expression, Sum):
        yield expression
    for part in expression.parts:
        yield from find_sums(part)


def find_sign(expression: Expression, at: Mapping[str, float]) -> float | None:
    """Return the sign of a formula's value, 1 or -1; None where it has no value."""
    try:
        return copysign(1.0, expression.value(at).real)
    except (ValueError, ArithmeticError):
        return None


def turns(expression: Expression, sign: float | None, at: Mapping[str, Array]) -> list[bool]:
    """Return, for each set of numbers (m,), whether a formula's value differs in sign from `sign`, or is undefined."""
    values = array_values(expression, at)
    other = np.isfinite(values) if sign is None else np.isnan(values) | (np.copysign(1.0, values) != sign)
    return other.tolist()


def likely_answers(query: Query, study: SimulatedScene, words: Words, path: str) -> Callable[[float], float] | None:
    """Return the likely answer as a function of the number at an address, for a question about its limit.

    The function returns 0 where the formula has no value. None for other queries, and if no formula is derived.
    """
    if not query.hides or path not in words.symbols:
        return None
    solution = derivation(query, study, words)
    try:
        expression = combined_formula(solution) if solution.derived else None
    except ClosedFormError:
        return None
    if expression is None:
        return None
    symbol, formula = words.symbols[path], expression
    given = formula_unit_factor(next(p.measure.unit for p in study.scene.parameters if p.path == path))
    wanted = formula_unit_factor(KINDS[query.kind].measured(query).unit)

    return lambda value: likely_answer(formula, {**solution.values, symbol: given * value}, wanted)


def likely_answer(formula: Expression, at: Mapping[str, float], factor: float) -> float:
    """Return the value of a formula in the answer's unit (`factor`); 0 if undefined."""
    with suppress(ValueError, ArithmeticError):
        return formula.value(at).real / factor
    return 0.0

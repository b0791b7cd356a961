"""Search for numbers at which a formula ceases to be valid, or has no value."""

from collections.abc import Callable, Iterator, Sequence
from functools import cache
from itertools import chain, islice
from math import inf

import numpy as np

from sim2reason.generation.modes.problem_formula import Variation
from sim2reason.generation.modes.variations import Variations
from sim2reason.questions.regimes import Regime
from sim2reason.scenes.dsl.state import Array
from sim2reason.scenes.dsl.structure import changing
from sim2reason.solutions.algebra.expressions import Expression
from sim2reason.solutions.algebra.functions import array_values

Margin = Callable[[Variation], float | None]
"""How far a scene is from where something is no longer done; None where that says nothing."""
Factors = tuple[float, ...]
Distant = tuple[Variation | None, float]
"""A scene with its distance from violating a condition; infinite if that is unknown, or it violates another one."""

GUESSES, CORNER_SEED = 4000, 0  # combinations of range ends for which margins are estimated
KNOWN_STARTS = 2  # known scenes from which the search starts, beside the best guess
CLOSE_MARGIN = 0.1  # margin; if one start does not come closer to zero, others rarely do (2 of 230 searches)
FACTOR_COUNT = 5  # factors tried for the question's own numbers
UNCHANGED_MARGIN = 1e-9  # smaller changes of a margin count as none


def find_corner(
    variations: Variations, margin: Margin, told: Sequence[Regime], known: Sequence[Variation]
) -> Variation | None:
    """Return the scene with numbers at the ends of their ranges that comes closest to violating an assumption.

    The ends are guessed by adding the effects of the single numbers, taken from the `known` variations. Starting from
    the best guess, and from some `known` scenes, each number is tried at both ends. None if nothing is known about the
    margin. The scene satisfies the assumptions `told`.
    """
    own, others = variations.own(), [_kept(regime) for regime in told]
    here = [each(own) for each in (margin, *others)] if own is not None else [None]
    if own is None or here[0] is None:
        return None
    conditions = [each for each, value in zip((margin, *others), here, strict=True) if value is not None]
    factors, changes = _alone(variations, conditions, known, own)
    ends = np.random.default_rng(CORNER_SEED).integers(0, factors.shape[1], (GUESSES, len(factors)))
    for n, symbol in enumerate(variations.symbols):  # what is asked about comes sooner, where that is all the same
        if not symbol.path and np.abs(changes[0, n]).max() <= UNCHANGED_MARGIN:
            ends[:, n] = np.argmin(factors[n])
    start = np.array([value for value in here if value is not None])
    guessed = start[:, None] + changes[:, np.arange(len(factors)), ends].sum(2)
    fitting = np.flatnonzero((guessed[1:] > 0.0).all(0))
    starts = _least(conditions, known, own)
    if fitting.size:
        starts.append(factors[np.arange(len(factors)), ends[fitting[np.argmin(guessed[0, fitting])]]].tolist())
    best, at = (None, inf), _distances(variations, conditions, told)
    for times in starts:
        best = min(best, _descended(variations, at, factors, tuple(times)), key=lambda value: value[1])
        if best[1] <= 0.0 or CLOSE_MARGIN < best[1] < inf:
            break
    return best[0]


def _kept(regime: Regime) -> Margin:
    """Return a function of a scene: its distance from violating an assumption, negative if it violates it."""

    def margin(other: Variation) -> float:
        distance = regime.margin(other.study, other.until) if other.satisfies(regime) else -1.0
        return 1.0 if distance is None else distance

    return margin


def _least(conditions: Sequence[Margin], known: Sequence[Variation], own: Variation) -> list[list[float]]:
    """Return the factors on all numbers for the known scenes that come closest to violating a condition."""
    within = [other for other in known if all((each(other) or 0.0) > 0.0 for each in conditions[1:])]
    margins = {n: margin for n, other in enumerate(within) if (margin := conditions[0](other)) is not None}
    closest = sorted(margins, key=lambda n: margins[n])[:KNOWN_STARTS]
    return [[by / own.values[symbol] for symbol, by in within[n].values.items()] for n in closest]


def _alone(
    variations: Variations, conditions: Sequence[Margin], known: Sequence[Variation], own: Variation
) -> tuple[Array, Array]:
    """Return the factors tried on each number, (n, s), and the change of each margin by each alone, (m, n, s).

    The first factor is 1; shorter lists are padded with 1.
    """
    here, single = np.array([each(own) or 0.0 for each in conditions]), list[dict[float, Array]]()
    for symbol in variations.symbols:
        others = [other for other in known if _moved(other, own) == [symbol.symbol]]
        gained = {
            o.values[symbol.symbol] / own.values[symbol.symbol]: [each(o) or 0.0 for each in conditions] for o in others
        }
        single.append({1.0: 0.0 * here, **{by: np.array(effects) - here for by, effects in gained.items() if by > 0.0}})
    most = max(map(len, single))
    factors = np.array([[*effects, *([1.0] * (most - len(effects)))] for effects in single])
    changes = np.array(
        [[effects.get(by, 0.0 * here) for by in row] for effects, row in zip(single, factors, strict=True)]
    )
    return factors, changes.transpose(2, 0, 1)


def _moved(other: Variation, own: Variation) -> list[str]:
    return [symbol for symbol, value in other.values.items() if value != own.values[symbol]]


def _distances(
    variations: Variations, conditions: Sequence[Margin], told: Sequence[Regime]
) -> Callable[[Factors], Distant]:
    """Return a cached function of factors on all numbers: the scene, and its distance from violating a condition."""

    @cache
    def at(times: Factors) -> Distant:
        values = [symbol.value * by for symbol, by in zip(variations.symbols, times, strict=True)]
        outcome = variations.having(values, [], told)
        if outcome is None or any((each(outcome) or 0.0) < 0.0 for each in conditions[1:]):
            return outcome, inf
        margin = conditions[0](outcome)
        return outcome, inf if margin is None else margin

    return at


def _descended(variations: Variations, at: Callable[[Factors], Distant], factors: Array, times: Factors) -> Distant:
    """Return the scene after a change of one number at a time towards violation, and its distance from it.

    One pass suffices. For numbers of the question, intermediate factors are tried too, because an event may fail to
    occur at both ends.
    """
    outcome = at(times)
    for n, symbol in enumerate(variations.symbols):
        for factor in _steps(factors[n], fine=not symbol.path):
            if outcome[1] <= 0.0:
                return outcome
            other = (*times[:n], factor, *times[n + 1 :])
            if other != times and (better := at(other))[1] < outcome[1]:
                times, outcome = other, better
    return outcome


def _steps(factors: Array, *, fine: bool) -> list[float]:
    smallest, most = float(factors.min()), float(factors.max())
    between: list[float] = np.geomspace(smallest, most, FACTOR_COUNT).tolist()
    return between if fine else [smallest, 1.0, most]


DRAWN, COUNTEREXAMPLE_SEED = 2000, 0  # sets of numbers for which the formula is evaluated
CHANGED_SHARE = 0.3  # fraction of numbers changed in every second set
MAX_SIMULATIONS = (
    600,
    60,
)  # of those where it is negative, and of those without a value, at most; where motions are integrated
CLOSEST, SCATTERED = 8, 8  # of either kind first; the search ends if none of these scenes has an answer
MAX_OTHER_SIGN = 3.0  # distance assigned to a change of sign, equal to that of a factor e³
ZERO_RTOL = 1e-9  # of the answer; smaller magnitudes count as zero


def counterexample(
    variations: Variations,
    formula: Expression,
    is_counterexample: Callable[[Variation], bool],
    width: float,
    told: Sequence[Regime] = (),
    *,
    signed: bool,
) -> Variation | None:
    """Return a scene with other numbers for which the formula fails, such as by its sign; None if none is found.

    A counterexample satisfies the assumptions `told`. All or some numbers are multiplied by factors with logarithms of
    at most `width`; half of the sets have random signs.
    """
    own = variations.own()
    if own is None:
        return None
    drawn = _drawn(variations, width)
    values = array_values(formula, variations.columns(drawn))
    negative = drawn[:0] if signed else drawn[values < -ZERO_RTOL * abs(own.answer)]
    each = (_tried(variations, unfit, is_counterexample, told) for unfit in (negative, drawn[np.isnan(values)]))
    return next((other for other in each if other is not None), None)


def _tried(
    variations: Variations, unfit: Array, is_counterexample: Callable[[Variation], bool], told: Sequence[Regime]
) -> Variation | None:
    """Return the first scene, among sets of numbers (n, s), in which the formula fails; None if none does.

    Once some scene has an answer, those that never satisfy the assumptions `told` need none.
    """
    here, answered = np.array([symbol.value for symbol in variations.symbols]), False
    distance = (np.abs(np.log(np.abs(unfit / here))) + MAX_OTHER_SIGN * (unfit * here < 0.0)).sum(1)
    most = MAX_SIMULATIONS[bool(changing(variations.study.mechanism))]
    for attempt, number in enumerate(_in_turn(np.argsort(distance, kind="stable").tolist(), most)):
        if attempt == CLOSEST + SCATTERED and not answered:
            return None
        other = variations.having(unfit[number].tolist(), [], told if answered else ())
        if other is not None and is_counterexample(other):
            return other
        answered = answered or other is not None
    return None


def _in_turn(closest: list[int], most: int) -> Iterator[int]:
    """Yield at most `most` of the given indices: the first few, then some spread over the rest, then the others."""
    first, beyond = closest[:CLOSEST], closest[CLOSEST:]
    scattered = beyond[:: max(1, len(beyond) // SCATTERED)][:SCATTERED]
    rest = (number for number in beyond if number not in scattered)
    yield from islice(chain(first, scattered, rest), most)


def _drawn(variations: Variations, width: float) -> Array:
    """Return random sets of the numbers of a problem, (n, s), around the stated ones, without repetitions."""
    rng, here = np.random.default_rng(COUNTEREXAMPLE_SEED), np.array([symbol.value for symbol in variations.symbols])
    changed = rng.random((DRAWN, len(here))) < np.where(np.arange(DRAWN) % 2, CHANGED_SHARE, 1.0)[:, None]
    drawn = here * np.exp(np.where(changed, rng.uniform(-width, width, changed.shape), 0.0))
    may = np.array([symbol.signed for symbol in variations.symbols])
    drawn[DRAWN // 2 :] *= np.where(may, rng.choice((-1.0, 1.0), (DRAWN - DRAWN // 2, len(here))), 1.0)
    unique: Array = np.unique(drawn, axis=0)
    return unique

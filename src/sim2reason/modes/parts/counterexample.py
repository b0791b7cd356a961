"""Numbers for which a formula has no value, or gives a size less than nothing, though all is as its text tells.

Which these can be is seen from the formula alone, for thousands of numbers at once. Only such scenes are simulated,
above all those closest to the scene's own: there what is told holds most often.
"""

from collections.abc import Callable, Iterator
from itertools import chain, islice

import numpy as np

from sim2reason.dsl.constancy import changing
from sim2reason.dsl.state import Array
from sim2reason.modes.parts.variation import Variation
from sim2reason.modes.parts.variations import Variations
from sim2reason.solutions.algebra.expressions import Expression
from sim2reason.solutions.algebra.functions import values

DRAWN, SEED = 2000, 0  # sets of numbers for which the formula is worked out
CHANGED = 0.3  # of the numbers of every second set: the others are the scene's own
SIMULATED = (
    600,
    60,
)  # of those where it is negative, and of those without a value, at most; where motions are integrated
CLOSEST, SCATTERED = 8, 8  # so many of either first; if there is an answer in none of these scenes, that is all
OTHER_SIGN = 3.0  # the distance of a number from itself with the other sign, as of one e³ times as large
TINY = 1e-9  # of the answer: a size of less is none, whatever its sign


def counterexample(
    variations: Variations,
    formula: Expression,
    is_counterexample: Callable[[Variation], bool],
    width: float,
    *,
    signed: bool,
) -> Variation | None:
    """A scene that is a counterexample, sought where the formula is negative, if not `signed`, or has no value.

    Numbers are the scene's own times factors whose logarithms are at most `width`, all or some of them; half of them
    have any signs. None if none is found.
    """
    own = variations.own()
    if own is None:
        return None
    drawn = _drawn(variations, width)
    found = values(formula, variations.columns(drawn))
    negative = drawn[:0] if signed else drawn[found < -TINY * abs(own.answer)]
    each = (_tried(variations, unfit, is_counterexample) for unfit in (negative, drawn[np.isnan(found)]))
    return next((other for other in each if other is not None), None)


def _tried(variations: Variations, unfit: Array, is_counterexample: Callable[[Variation], bool]) -> Variation | None:
    """The first counterexample among some sets of numbers, (n, s)."""
    here, answered = np.array([held.value for held in variations.symbols]), False
    distance = (np.abs(np.log(np.abs(unfit / here))) + OTHER_SIGN * (unfit * here < 0.0)).sum(1)
    most = SIMULATED[bool(changing(variations.study.mechanism))]
    for tried, number in enumerate(_in_turn(np.argsort(distance, kind="stable").tolist(), most)):
        if tried == CLOSEST + SCATTERED and not answered:
            return None
        other = variations.having(unfit[number].tolist(), [])
        if other is not None and is_counterexample(other):
            return other
        answered = answered or other is not None
    return None


def _in_turn(closest: list[int], most: int) -> Iterator[int]:
    """Yield the closest, some from everywhere, and then the next to these, `most` at most."""
    first, beyond = closest[:CLOSEST], closest[CLOSEST:]
    scattered = beyond[:: max(1, len(beyond) // SCATTERED)][:SCATTERED]
    rest = (number for number in beyond if number not in scattered)
    yield from islice(chain(first, scattered, rest), most)


def _drawn(variations: Variations, width: float) -> Array:
    """Numbers around the scene's own, (n, s), no set of them twice."""
    rng, here = np.random.default_rng(SEED), np.array([held.value for held in variations.symbols])
    changed = rng.random((DRAWN, len(here))) < np.where(np.arange(DRAWN) % 2, CHANGED, 1.0)[:, None]
    drawn = here * np.exp(np.where(changed, rng.uniform(-width, width, changed.shape), 0.0))
    may = np.array([held.signed for held in variations.symbols])
    drawn[DRAWN // 2 :] *= np.where(may, rng.choice((-1.0, 1.0), (DRAWN - DRAWN // 2, len(here))), 1.0)
    found: Array = np.unique(drawn, axis=0)
    return found

"""Numbers for which a formula has no value, or a size is negative, though all that its text tells holds: few may.

Which these can be is seen from the formula alone, for thousands of numbers at once. Only such scenes are simulated, the
closest to the scene's own first: there what is told holds most likely.
"""

from collections.abc import Callable

import numpy as np

from sim2reason.dsl.state import Array
from sim2reason.modes.parts.variations import Variation, Variations
from sim2reason.solutions.expressions import Expression
from sim2reason.solutions.functions import values

LOOKED, SEED = 2000, 0  # numbers for which a formula alone is worked out
CHANGED = 0.3  # of the numbers, in every second draw: the others are the scene's own
TRIES, HOPELESS = 60, 16  # of those for which it is not fit; without any answer, after which none is expected
OTHER_SIGN = 3.0  # as far as a factor of e³: a number with the other sign
TINY = 1e-9  # of the answer: a size of less is none, whatever its sign


def counterexample(
    variations: Variations, formula: Expression, missed: Callable[[Variation], bool], width: float, *, signed: bool
) -> Variation | None:
    """A scene that a formula has `missed`, as it has no value there, or is negative though the answer is not `signed`.

    Numbers are the scene's own times factors whose logarithms are at most `width`, all or some of them; half of them
    have any signs.
    """
    own = variations.own()
    if own is None:
        return None
    drawn = _drawn(variations, width)
    found = values(formula, {held.symbol: held.counted(1.0) * drawn[:, n] for n, held in enumerate(variations.symbols)})
    unfit = np.flatnonzero(np.isnan(found) | (not signed) & (found < -TINY * abs(own.answer)))
    here = np.array([held.value for held in variations.symbols])
    far = np.abs(np.log(np.abs(drawn[unfit] / here))) + OTHER_SIGN * (drawn[unfit] * here < 0.0)
    answered = False
    for tried, number in enumerate(unfit[np.argsort(far.sum(1), kind="stable")][:TRIES].tolist()):
        if tried == HOPELESS and not answered:
            return None
        other = variations.having(drawn[number].tolist(), [])
        answered = answered or other is not None
        if other is not None and missed(other):
            return other
    return None


def _drawn(variations: Variations, width: float) -> Array:
    """Numbers around the scene's own, (n, s)."""
    rng, here = np.random.default_rng(SEED), np.array([held.value for held in variations.symbols])
    changed = rng.random((LOOKED, len(here))) < np.where(np.arange(LOOKED) % 2, CHANGED, 1.0)[:, None]
    drawn = here * np.exp(np.where(changed, rng.uniform(-width, width, changed.shape), 0.0))
    may = np.array([held.signed for held in variations.symbols])
    drawn[LOOKED // 2 :] *= np.where(may, rng.choice((-1.0, 1.0), (LOOKED - LOOKED // 2, len(here))), 1.0)
    return drawn

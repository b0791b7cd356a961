"""Shares with intervals, means over repeated samples, pass@k, paired differences and rank correlation."""

from collections.abc import Sequence
from math import atanh, comb, sqrt, tanh
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["Estimate", "difference", "mean_of_items", "pass_at", "rank_correlation", "wilson"]

LEVEL: Final = 0.95
NORMAL: Final = 1.959963984540054  # the quantile of the normal distribution for that level, both sides
RESAMPLES: Final = 4000
SEED: Final = 20_260  # of the resampling: the same data give the same interval
BLOCK: Final = 2**22  # numbers that are drawn at once

Floats = NDArray[np.float64]


class Estimate(NamedTuple):
    """A number with the ends of its 95 % interval, and how that was found."""

    value: float
    low: float
    high: float
    method: str

    @property
    def shown(self) -> str:
        """In per cent, for people."""
        return f"{100 * self.value:.1f} [{100 * self.low:.1f}, {100 * self.high:.1f}]"


def wilson(right: int, total: int) -> Estimate:
    """A share of independent trials, with the score interval of Wilson (1927).

    ValueError for no trials, or for more right ones than there are.
    """
    if total <= 0 or not 0 <= right <= total:
        raise ValueError("a share needs trials, and no more right ones than those")
    share, z2 = right / total, NORMAL**2
    middle = (share + z2 / (2 * total)) / (1 + z2 / total)
    half = NORMAL * sqrt(share * (1 - share) / total + z2 / (4 * total**2)) / (1 + z2 / total)
    # The ends at no and at all right are 0 and 1; rounding may miss them.
    low = 0.0 if right == 0 else middle - half
    high = 1.0 if right == total else middle + half
    return Estimate(share, low, high, "wilson")


def _resampled(values: Floats) -> Floats:
    """Means of as many values, drawn from them with repetition (Efron, 1979)."""
    draws = np.random.default_rng(SEED)
    count, means = len(values), list[Floats]()
    rows = max(1, min(RESAMPLES, BLOCK // count))
    left = RESAMPLES
    while left > 0:
        places = draws.integers(0, count, size=(min(rows, left), count))
        means.append(values[places].mean(axis=1))
        left -= rows
    return np.concatenate(means)


def _interval(values: Floats, least: float) -> Estimate:
    """The mean of values from `least` to 1, with the ends of its interval.

    Where all values are alike a bootstrap sees no spread; then the ends are as far as Wilson's are from none of n.
    """
    mean = float(values.mean())
    if np.ptp(values) == 0.0:
        reach = wilson(0, len(values)).high
        return Estimate(mean, max(least, mean - reach), min(1.0, mean + reach), "score")
    low, high = np.quantile(_resampled(values), [(1 - LEVEL) / 2, (1 + LEVEL) / 2])
    return Estimate(mean, float(low), float(high), "bootstrap")


def mean_of_items(points: Sequence[Sequence[float]]) -> Estimate:
    """mean@k: the mean over items of their mean points, each with its own samples.

    Items are the trials. With one sample each, right or wrong, the interval is Wilson's; else it is a bootstrap over
    items.
    """
    means = np.array([sum(held) / len(held) for held in points], dtype=np.float64)
    if all(len(held) == 1 and held[0] in {0.0, 1.0} for held in points):
        return wilson(int(means.sum()), len(means))
    return _interval(means, 0.0)


def pass_at(points: Sequence[Sequence[float]], k: int) -> float | None:
    """pass@k: the chance that of k samples of an item one is wholly right, without bias; None where items have fewer.

    1 - C(n - c, k)/C(n, k) for c right ones of n: Chen et al., *Evaluating Large Language Models Trained on Code*
    (2021).
    """
    if any(len(held) < k for held in points):
        return None
    right = ((len(held), sum(point >= 1.0 for point in held)) for held in points)
    return sum(1.0 - comb(n - c, k) / comb(n, k) for n, c in right) / len(points)


def difference(mine: Sequence[float], theirs: Sequence[float]) -> Estimate:
    """The mean of `theirs` less that of `mine`, item by item, with a bootstrap over items (a ValueError for none)."""
    if len(mine) != len(theirs) or not mine:
        raise ValueError("a paired difference needs the same items, and at least one")
    values = np.array(theirs, dtype=np.float64) - np.array(mine, dtype=np.float64)
    return _interval(values, -1.0)


def _ranks(values: Floats) -> Floats:
    """Ranks from 1 on, equal values sharing their mean rank."""
    _, place, counts = np.unique(values, return_inverse=True, return_counts=True)
    last = np.cumsum(counts)
    return ((last - counts + 1 + last) / 2.0)[place]


def rank_correlation(x: Sequence[float], y: Sequence[float]) -> Estimate | None:
    """Spearman's ρ with the interval of Bonett and Wright (2000): Fisher's z with variance (1 + ρ²/2)/(n - 3).

    None for fewer than three pairs, or where one side has no two values; with three, the interval is all of [-1, 1].
    At ρ = ±1, where z is infinite, the inner end is that of the next ρ, with two neighbours exchanged.
    """
    count = len(x)
    if count != len(y) or count < 3 or len(set(x)) < 2 or len(set(y)) < 2:
        return None
    one, other = (_ranks(np.array(values, dtype=np.float64)) for values in (x, y))
    rho = max(-1.0, min(1.0, float(np.corrcoef(one, other)[0, 1])))
    if count == 3:
        return Estimate(rho, -1.0, 1.0, "none")
    next_to = 1.0 - 12.0 / (count * (count**2 - 1))
    held = max(-next_to, min(next_to, rho))
    half = NORMAL * sqrt((1 + held**2 / 2) / (count - 3))
    low, high = tanh(atanh(held) - half), tanh(atanh(held) + half)
    return Estimate(rho, -1.0 if rho < -next_to else low, 1.0 if rho > next_to else high, "bonett-wright")

"""Results of a run: accuracies with intervals, means over samples, pass@k, and rank correlation."""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from math import atanh, comb, sqrt, tanh
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, ConfigDict

from sim2reason.evaluation.benchmarks import BenchmarkItem
from sim2reason.evaluation.benchmarks.runs.config import RunFolder
from sim2reason.evaluation.benchmarks.runs.run import Ending, SampleOutcome

__all__ = [
    "Estimate",
    "Group",
    "Result",
    "RunReport",
    "Share",
    "difference",
    "item_mean",
    "pass_at",
    "points_by_item",
    "rank_correlation",
    "result",
    "wilson_interval",
]

CONFIDENCE_LEVEL: Final = 0.95
NORMAL_QUANTILE: Final = 1.959963984540054  # two-sided quantile of the normal distribution for that level
RESAMPLE_COUNT: Final = 4000
SEED: Final = 20_260  # of the resampling, so that equal data give the same interval
BLOCK_SIZE: Final = 2**22  # random numbers generated at once

Floats = NDArray[np.float64]


class Estimate(NamedTuple):
    """A measured number with the ends of its 95 % interval, and the method by which the interval was computed."""

    value: float
    low: float
    high: float
    method: str

    @property
    def shown(self) -> str:
        """Return the estimate in per cent as readable text."""
        return f"{100 * self.value:.1f} [{100 * self.low:.1f}, {100 * self.high:.1f}]"


def wilson_interval(right: int, total: int) -> Estimate:
    """Return a fraction of independent trials, with the score interval of Wilson (1927).

    ValueError for no trials, or for more successes than trials.
    """
    if total <= 0 or not 0 <= right <= total:
        raise ValueError("a share needs trials, and no more right ones than those")
    share, z2 = right / total, NORMAL_QUANTILE**2
    middle = (share + z2 / (2 * total)) / (1 + z2 / total)
    half = NORMAL_QUANTILE * sqrt(share * (1 - share) / total + z2 / (4 * total**2)) / (1 + z2 / total)
    # The ends at no and at all right are 0 and 1; rounding may miss them.
    low = 0.0 if right == 0 else middle - half
    high = 1.0 if right == total else middle + half
    return Estimate(share, low, high, "wilson")


def _resampled(values: Floats) -> Floats:
    """Return the means of bootstrap resamples (Efron, 1979)."""
    draws = np.random.default_rng(SEED)
    count, means = len(values), list[Floats]()
    rows = max(1, min(RESAMPLE_COUNT, BLOCK_SIZE // count))
    left = RESAMPLE_COUNT
    while left > 0:
        places = draws.integers(0, count, size=(min(rows, left), count))
        means.append(values[places].mean(axis=1))
        left -= rows
    return np.concatenate(means)


def _interval(values: Floats, minimum: float) -> Estimate:
    """Return the mean of values between `minimum` and 1, with its 95 % interval.

    If all values are equal, the bootstrap interval is empty; then its width is that of Wilson's for zero of n.
    """
    mean = float(values.mean())
    if np.ptp(values) == 0.0:
        reach = wilson_interval(0, len(values)).high
        return Estimate(mean, max(minimum, mean - reach), min(1.0, mean + reach), "score")
    low, high = np.quantile(_resampled(values), [(1 - CONFIDENCE_LEVEL) / 2, (1 + CONFIDENCE_LEVEL) / 2])
    return Estimate(mean, float(low), float(high), "bootstrap")


def item_mean(points: Sequence[Sequence[float]]) -> Estimate:
    """Return mean@k: the mean over items of their mean points, each over its own samples.

    Items are the trials. With one sample each, correct or not, the interval is Wilson's; else it is a bootstrap over
    items.
    """
    means = np.array([sum(item_points) / len(item_points) for item_points in points], dtype=np.float64)
    if all(len(item_points) == 1 and item_points[0] in {0.0, 1.0} for item_points in points):
        return wilson_interval(int(means.sum()), len(means))
    return _interval(means, 0.0)


def pass_at(points: Sequence[Sequence[float]], k: int) -> float | None:
    """Return pass@k, the estimated probability that one of k samples is fully correct; None for too few samples.

    The formula is 1 - C(n - c, k)/C(n, k) for c correct ones of n: Chen et al., *Evaluating Large Language Models
    Trained on Code* (2021).
    """
    if any(len(item_points) < k for item_points in points):
        return None
    right = ((len(item_points), sum(point >= 1.0 for point in item_points)) for item_points in points)
    return sum(1.0 - comb(n - c, k) / comb(n, k) for n, c in right) / len(points)


def difference(mine: Sequence[float], theirs: Sequence[float]) -> Estimate:
    """Return the mean paired difference (theirs minus mine), with a bootstrap interval over items."""
    if len(mine) != len(theirs) or not mine:
        raise ValueError("a paired difference needs the same items, and at least one")
    values = np.array(theirs, dtype=np.float64) - np.array(mine, dtype=np.float64)
    return _interval(values, -1.0)


def _ranks(values: Floats) -> Floats:
    """Return the ranks from 1; equal values share their mean rank."""
    _, inverse, counts = np.unique(values, return_inverse=True, return_counts=True)
    last = np.cumsum(counts)
    return ((last - counts + 1 + last) / 2.0)[inverse]


def rank_correlation(x: Sequence[float], y: Sequence[float]) -> Estimate | None:
    """Return Spearman's ρ with the interval of Bonett and Wright (2000) from Fisher's z.

    None for fewer than three pairs, or if one side has equal values only; with three, the interval is [-1, 1]. At ρ =
    ±1, where z is infinite, the inner end is that of the next smaller |ρ|, with two neighbours exchanged.
    """
    count = len(x)
    if count != len(y) or count < 3 or len(set(x)) < 2 or len(set(y)) < 2:
        return None
    one, other = (_ranks(np.array(values, dtype=np.float64)) for values in (x, y))
    rho = max(-1.0, min(1.0, float(np.corrcoef(one, other)[0, 1])))
    if count == 3:
        return Estimate(rho, -1.0, 1.0, "none")
    next_to = 1.0 - 12.0 / (count * (count**2 - 1))
    clipped = max(-next_to, min(next_to, rho))
    half = NORMAL_QUANTILE * sqrt((1 + clipped**2 / 2) / (count - 3))
    low, high = tanh(atanh(clipped) - half), tanh(atanh(clipped) + half)
    return Estimate(rho, -1.0 if rho < -next_to else low, 1.0 if rho > next_to else high, "bonett-wright")


MAX_GROUPS = 200  # values of a tag up to which it is reported as groups
PASS_COUNTS = 1, 2, 4, 8, 16, 32, 64, 128


class _Record(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid")


class Share(_Record):
    """A mean of points, 0 to 1, with its 95 % interval, as stored in reports."""

    value: float
    low: float
    high: float
    method: str

    @classmethod
    def of(cls, estimate: Estimate) -> "Share":
        """Return the serializable form of an estimate."""
        return cls(**estimate._asdict())

    @property
    def shown(self) -> str:
        """Return the mean in per cent as readable text."""
        return Estimate(self.value, self.low, self.high, self.method).shown


class Group(_Record):
    """The number and accuracy of the problems that have one value of a tag; a problem may have several values."""

    items: int
    accuracy: Share


class Result(_Record):
    """The result of a policy on a benchmark."""

    policy: str
    benchmark: str
    items: int
    """Problems with at least one answer."""
    samples: int
    """Wanted of each problem."""
    responses: int
    missing: int
    """Samples that are wanted and not there."""
    accuracy: Share
    """mean@k, where each problem counts alike."""
    pass_at: dict[int, float]
    endings: dict[Ending, int]
    tokens: float | None
    """The mean of responses, with their thinking; None if nobody counted."""
    characters: float
    """The same."""
    judged: int
    """Samples on which a judge ruled."""
    groups: dict[str, dict[str, Group]]
    """By tag, then by its value."""


class RunReport(_Record):
    """The contents of ``report.json``."""

    run: dict[str, object]
    """The run's record: seeds, settings, hashes of the data."""
    results: tuple[Result, ...]
    pictures: tuple[str, ...] = ()


def points_by_item(outcomes: Iterable[SampleOutcome]) -> dict[str, list[float]]:
    """Return the points of each problem's samples."""
    points: dict[str, list[float]] = {}
    for outcome in outcomes:
        points.setdefault(outcome.id, []).append(outcome.points)
    return points


def result(folder: RunFolder, policy: str, benchmark: str, outcomes: Sequence[SampleOutcome]) -> Result | None:
    """Return the result of a policy on a benchmark; None if there is no answer yet."""
    if not outcomes:
        return None
    plan, points = folder.record.benchmarks[benchmark], points_by_item(outcomes)
    tokens = [outcome.tokens for outcome in outcomes if outcome.tokens is not None]
    endings = Counter(outcome.ending for outcome in outcomes)
    all_points = list(points.values())
    passes = {k: share for k in PASS_COUNTS if k <= plan.samples and (share := pass_at(all_points, k)) is not None}
    return Result(
        policy=policy,
        benchmark=benchmark,
        items=len(points),
        samples=plan.samples,
        responses=len(outcomes),
        missing=plan.items * plan.samples - len(outcomes),
        accuracy=Share.of(item_mean(all_points)),
        pass_at=passes,
        endings={ending: endings[ending] for ending in Ending},
        tokens=sum(tokens) / len(tokens) if tokens else None,
        characters=sum(outcome.characters for outcome in outcomes) / len(outcomes),
        judged=sum(outcome.judged for outcome in outcomes),
        groups=_groups(folder.items(benchmark), points),
    )


def _groups(items: Iterable[BenchmarkItem], points: Mapping[str, list[float]]) -> dict[str, dict[str, Group]]:
    sorted_out: dict[str, dict[str, list[list[float]]]] = {}
    for item in items:
        if item.id in points:
            for tag, values in item.tags.items():
                for value in values:
                    sorted_out.setdefault(tag, {}).setdefault(value, []).append(points[item.id])
    return {
        tag: {
            value: Group(items=len(group_points), accuracy=Share.of(item_mean(group_points)))
            for value, group_points in sorted(by_value.items())
        }
        for tag, by_value in sorted(sorted_out.items())
        if 1 <= len(by_value) <= MAX_GROUPS
    }

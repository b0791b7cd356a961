"""The results of a run: each policy on each benchmark, as a whole and by what tags its problems."""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence

from pydantic import BaseModel, ConfigDict

from sim2reason.benchmarks import BenchmarkItem
from sim2reason.benchmarks.runs.folder import RunFolder
from sim2reason.benchmarks.runs.outcomes import Ending, SampleOutcome
from sim2reason.reports.statistics import Estimate, mean_of_items, pass_at

__all__ = ["Group", "Result", "RunReport", "Share", "points_by_item", "result"]

MOST_GROUPS = 200  # values of one tag; more are no groups
PASSES = 1, 2, 4, 8, 16, 32, 64, 128


class _Record(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid")


class Share(_Record):
    """A mean of points with its 95 % interval."""

    value: float
    low: float
    high: float
    method: str

    @classmethod
    def of(cls, estimate: Estimate) -> "Share":
        """The same, to be written down."""
        return cls(**estimate._asdict())

    @property
    def shown(self) -> str:
        """In per cent, for people."""
        return Estimate(self.value, self.low, self.high, self.method).shown


class Group(_Record):
    """The problems that have one value of a tag. A problem may be in several, as one with two entities is."""

    items: int
    accuracy: Share


class Result(_Record):
    """A policy on a benchmark."""

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
    """All of ``report.json``."""

    run: dict[str, object]
    """The run's record: seeds, settings, hashes of the data."""
    results: tuple[Result, ...]
    pictures: tuple[str, ...] = ()


def points_by_item(outcomes: Iterable[SampleOutcome]) -> dict[str, list[float]]:
    """The points of each problem's samples."""
    found: dict[str, list[float]] = {}
    for outcome in outcomes:
        found.setdefault(outcome.id, []).append(outcome.points)
    return found


def result(folder: RunFolder, policy: str, benchmark: str, outcomes: Sequence[SampleOutcome]) -> Result | None:
    """The result of a policy on a benchmark; None if there is no answer yet."""
    if not outcomes:
        return None
    plan, points = folder.record.benchmarks[benchmark], points_by_item(outcomes)
    tokens = [outcome.tokens for outcome in outcomes if outcome.tokens is not None]
    endings = Counter(outcome.ending for outcome in outcomes)
    held = list(points.values())
    passes = {k: share for k in PASSES if k <= plan.samples and (share := pass_at(held, k)) is not None}
    return Result(
        policy=policy,
        benchmark=benchmark,
        items=len(points),
        samples=plan.samples,
        responses=len(outcomes),
        missing=plan.items * plan.samples - len(outcomes),
        accuracy=Share.of(mean_of_items(held)),
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
            value: Group(items=len(held), accuracy=Share.of(mean_of_items(held)))
            for value, held in sorted(by_value.items())
        }
        for tag, by_value in sorted(sorted_out.items())
        if 1 <= len(by_value) <= MOST_GROUPS
    }

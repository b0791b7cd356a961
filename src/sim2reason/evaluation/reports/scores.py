"""Scores of finished runs, read for comparisons."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from pydantic import ValidationError

from sim2reason.errors import EvaluationError
from sim2reason.evaluation.benchmarks.runs.folder import RunFolder
from sim2reason.evaluation.benchmarks.runs.outcomes import SampleOutcome
from sim2reason.evaluation.reports.report import SCORES

__all__ = ["PolicyScores", "all_scores", "scores_of"]


@dataclass(frozen=True)
class PolicyScores:
    """The points of one policy by benchmark and problem: a list with one number per sample of a problem."""

    name: str
    run: RunFolder
    points: dict[str, dict[str, list[float]]]

    def means(self, benchmark: str) -> dict[str, float]:
        """Return the mean points of each problem of a benchmark."""
        return {item: sum(held) / len(held) for item, held in self.points.get(benchmark, {}).items()}


def _outcomes(folder: RunFolder) -> Iterator[SampleOutcome]:
    path = folder.report / SCORES
    if not path.is_file():
        raise EvaluationError(f"{folder.path}: has no report; give its sim2reason eval again")
    with path.open("rb") as lines:
        for count, line in enumerate(lines, start=1):
            try:
                yield SampleOutcome.model_validate_json(line)
            except ValidationError:
                raise EvaluationError(f"{path}:{count}: damaged; give its sim2reason eval again") from None


def all_scores(run: Path | str) -> list[PolicyScores]:
    """Return the scores of every policy of a run; EvaluationError if it has no report."""
    folder = RunFolder(Path(run))
    points: dict[str, dict[str, dict[str, list[float]]]] = {name: {} for name in folder.record.policies}
    for found in _outcomes(folder):
        points[found.policy].setdefault(found.benchmark, {}).setdefault(found.id, []).append(found.points)
    return [PolicyScores(name, folder, held) for name, held in points.items()]


def scores_of(place: str) -> PolicyScores:
    """Return the scores of one policy, given as RUN if that has only one, or RUN:POLICY.

    EvaluationError if there is no such run or policy, or if there are several and none is named.
    """
    run, name = place, ""
    if not Path(place).exists() and ":" in place:
        run, _, name = place.rpartition(":")
    found = all_scores(run)
    chosen = [scores for scores in found if name in {"", scores.name}]
    if len(chosen) != 1:
        there = ", ".join(scores.name for scores in found)
        raise EvaluationError(f"{place}: which policy? give {run}:NAME, with one of {there}")
    return chosen[0]

"""Outcomes of samples: points, and the reasons for zero points."""

from collections.abc import Iterator
from enum import StrEnum

from pydantic import BaseModel, ConfigDict

from sim2reason.evaluation.benchmarks import BenchmarkItem
from sim2reason.evaluation.benchmarks.runs.folder import RunFolder
from sim2reason.evaluation.benchmarks.runs.run import judged_id
from sim2reason.evaluation.benchmarks.scoring import SCORINGS, Award
from sim2reason.evaluation.policies import Completion
from sim2reason.evaluation.policies.samples.journal import FinishedSample, finished

__all__ = ["Ending", "SampleOutcome", "ending_of", "outcomes"]


class Ending(StrEnum):
    """The ways in which a sample can end, such as correct or truncated; the first that applies counts."""

    CORRECT = "correct"
    PARTIAL = "partial"
    REFUSED = "refused"
    OVERFLOW = "overflow"
    """The prompt is longer than the model's context."""
    TRUNCATED = "truncated"
    EMPTY = "empty"
    UNREADABLE = "unreadable"
    """There is a text, and no answer in it that could be read."""
    WRONG = "wrong"


class SampleOutcome(BaseModel):
    """A scored sample, as stored in ``scores.jsonl``."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    policy: str
    benchmark: str
    id: str
    sample: int
    points: float
    ending: Ending
    parsed: str = ""
    why: str = ""
    tokens: int | None = None
    """Of the response, with its thinking."""
    characters: int = 0
    judged: bool = False


def ending_of(completion: Completion, award: Award) -> Ending:
    """Return how a sample ended, such as correct or truncated: by its points, finish status and parsed answer."""
    if award.points > 0.0:
        return Ending.CORRECT if award.points >= 1.0 else Ending.PARTIAL
    by_finish = {"refused": Ending.REFUSED, "overflow": Ending.OVERFLOW, "length": Ending.TRUNCATED}
    if completion.finish in by_finish:
        return by_finish[completion.finish]
    if not completion.text.strip():
        return Ending.EMPTY
    return Ending.WRONG if award.readable else Ending.UNREADABLE


def outcomes(folder: RunFolder, policy: str, benchmark: str) -> Iterator[SampleOutcome]:
    """Yield each finished sample of a policy on a benchmark with its score, up to the planned number of samples."""
    items = {item.id: item for item in folder.items(benchmark)}
    rulings = {found.id: found.completion for found in finished(folder.judged(policy, benchmark))}
    for found in finished(folder.samples(policy, benchmark)):
        if found.id in items and found.sample < folder.record.benchmarks[benchmark].samples:
            ruling = rulings.get(judged_id(found.id, found.sample))
            yield _outcome(policy, benchmark, items[found.id], found, ruling)


def _outcome(
    policy: str, benchmark: str, item: BenchmarkItem, found: FinishedSample, ruling: Completion | None
) -> SampleOutcome:
    rule, said = SCORINGS[item.scoring], found.completion
    award = rule.award(said.whole, item.reference)
    judged = ruling is not None and award.points < 1.0
    if judged and ruling is not None:
        award = rule.ruling(ruling.text)
    return SampleOutcome(
        policy=policy,
        benchmark=benchmark,
        id=found.id,
        sample=found.sample,
        points=award.points,
        ending=ending_of(said, award),
        parsed=award.parsed[:500],
        why=award.why[:500],
        tokens=said.completion_tokens,
        characters=len(said.whole),
        judged=judged,
    )

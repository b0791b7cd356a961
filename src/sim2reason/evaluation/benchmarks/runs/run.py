"""Execution of an evaluation: all policies answer all problems, then the judge rules; and outcomes of samples."""

from collections.abc import Callable, Iterator
from enum import StrEnum
from pathlib import Path

from pydantic import BaseModel, ConfigDict

from sim2reason.base.atomic_files import lock_work_folder
from sim2reason.errors import PolicyError
from sim2reason.evaluation.benchmarks import BenchmarkItem
from sim2reason.evaluation.benchmarks.runs.config import Evaluation, RunFolder
from sim2reason.evaluation.benchmarks.scoring import SCORINGS, Award
from sim2reason.evaluation.policies import Completion, Policy, SampleRequest
from sim2reason.evaluation.policies.journal import FinishedSample, SampleJournal, read_finished
from sim2reason.evaluation.policies.samples import Budget, RequestSummary, ask, requests_for, sample_seed

__all__ = ["Ending", "SampleOutcome", "find_ending", "judged_id", "outcomes", "run", "total_samples"]

Advance = Callable[[int], object]


def total_samples(evaluation: Evaluation, folder: RunFolder) -> int:
    """Return the number of samples in an evaluation."""
    each = (
        folder.record.benchmarks[benchmark.name].items * evaluation.samples_of(benchmark)
        for benchmark in evaluation.benchmarks
    )
    return len(evaluation.policies) * sum(each)


def run(
    evaluation: Evaluation,
    *,
    begun: Callable[[int], object] = lambda _: None,
    advance: Advance = lambda _: None,
) -> tuple[RunFolder, list[str]]:
    """Run an evaluation; return its folder, and the reasons for samples without an answer.

    `begin` receives the number of samples, `advance` the numbers of newly finished ones.

    Raises:
        EvaluationError: a benchmark, or a folder, that can't be used.
        PolicyError: a policy that can't be asked, or whose limit is reached; what was finished is kept.
    """
    with lock_work_folder(evaluation.out):
        folder = RunFolder.begin(evaluation)
        begun(total_samples(evaluation, folder))
        left = [why for policy in evaluation.policies for why in _answers(evaluation, folder, policy, advance)]
        if evaluation.judge is not None:
            left += _judge(evaluation, folder, evaluation.judge)
        return folder, left


def _answers(evaluation: Evaluation, folder: RunFolder, policy: Policy, advance: Advance) -> list[str]:
    """Request the answers of one policy to all problems; return the reasons for missing ones."""
    wanted: list[tuple[Path, list[SampleRequest]]] = []
    for benchmark in evaluation.benchmarks:
        prompts = ((item.id, item.prompt) for item in folder.items(benchmark.name))
        requests = list(requests_for(prompts, evaluation.samples_of(benchmark), evaluation.seed))
        wanted.append((folder.samples(policy.name, benchmark.name), requests))
    return _asked(policy, wanted, advance)


def _asked(policy: Policy, wanted: list[tuple[Path, list[SampleRequest]]], advance: Advance) -> list[str]:
    """Send requests, each list with its own journal, within one budget; return the reasons for missing answers.

    PolicyError if no request was answered, however few there were.
    """
    budget, results = Budget(policy), list[RequestSummary]()
    for path, requests in wanted:
        budget.charge_finished(path, requests)
    for path, requests in wanted:
        with SampleJournal(path) as journal:
            results.append(ask(policy, requests, journal, budget=budget, advance=advance))
    left = [why for each in results for why in each.open]
    if left and not any(each.finished_now for each in results):
        raise PolicyError(f"{left[-1]}; not one request was answered; try again later")
    return left


def judged_id(item: str, sample: int) -> str:
    """Return the id of a sample in the judge's journal."""
    return f"{item}#{sample}"


def _judge(evaluation: Evaluation, folder: RunFolder, judge: Policy) -> list[str]:
    """Request rulings from the judge for samples that the rules leave undecided."""
    wanted = [
        (folder.judged(policy.name, benchmark.name), requests)
        for policy in evaluation.policies
        for benchmark in evaluation.benchmarks
        if (requests := list(_questions(evaluation, folder, policy.name, benchmark.name)))
    ]
    return _asked(judge, wanted, lambda _: None)


def _questions(evaluation: Evaluation, folder: RunFolder, policy: str, benchmark: str) -> Iterator[SampleRequest]:
    items: dict[str, BenchmarkItem] = {item.id: item for item in folder.items(benchmark)}
    for finished_sample in read_finished(folder.samples(policy, benchmark)):
        item = items.get(finished_sample.id)
        if item is None:
            continue
        rule, response = SCORINGS[item.scoring], finished_sample.completion.whole
        question = rule.question(response, item.reference, item.prompt)
        if question is not None and rule.award(response, item.reference).points < 1.0:
            name = judged_id(finished_sample.id, finished_sample.sample)
            yield SampleRequest(name, 0, question, sample_seed(evaluation.seed, name, 0))


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


def find_ending(completion: Completion, award: Award) -> Ending:
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
    rulings = {
        finished_sample.id: finished_sample.completion
        for finished_sample in read_finished(folder.judged(policy, benchmark))
    }
    for finished_sample in read_finished(folder.samples(policy, benchmark)):
        if finished_sample.id in items and finished_sample.sample < folder.record.benchmarks[benchmark].samples:
            ruling = rulings.get(judged_id(finished_sample.id, finished_sample.sample))
            yield _outcome(policy, benchmark, items[finished_sample.id], finished_sample, ruling)


def _outcome(
    policy: str, benchmark: str, item: BenchmarkItem, finished_sample: FinishedSample, ruling: Completion | None
) -> SampleOutcome:
    rule, completion = SCORINGS[item.scoring], finished_sample.completion
    award = rule.award(completion.whole, item.reference)
    judged = ruling is not None and award.points < 1.0
    if judged and ruling is not None:
        award = rule.ruling(ruling.text)
    return SampleOutcome(
        policy=policy,
        benchmark=benchmark,
        id=finished_sample.id,
        sample=finished_sample.sample,
        points=award.points,
        ending=find_ending(completion, award),
        parsed=award.parsed[:500],
        why=award.why[:500],
        tokens=completion.completion_tokens,
        characters=len(completion.whole),
        judged=judged,
    )

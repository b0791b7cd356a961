"""Rejection sampling: correct responses of a policy as solutions for fine-tuning.

    OUT/solutions.jsonl   each solution that is kept: id, prompt, completion, and which try it was
    OUT/sampled.json      what was asked of whom, how all tries ended, and hashes; written last
    OUT/samples.jsonl     every answer, one line each, on disk as soon as it is finished; with OUT/plan.json

A completion is the whole response: where an endpoint gives the thinking apart, it stands first, in its tags
(``<think>…</think>``), as models write it that think in their text.
"""

import json
from collections import Counter
from collections.abc import Callable, Iterator
from importlib.metadata import version
from pathlib import Path

from sim2reason.base.atomic_files import canonical, checksum, put, put_text
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.plan import ALL, Names
from sim2reason.errors import EvaluationError
from sim2reason.evaluation.benchmarks.own import benchmark_item
from sim2reason.evaluation.benchmarks.runs.outcomes import Ending, ending_of
from sim2reason.evaluation.benchmarks.scoring import SCORINGS
from sim2reason.evaluation.policies import Completion
from sim2reason.evaluation.policies.samples.journal import FinishedSample, finished
from sim2reason.evaluation.policy_pass import MOST_TRIES, SAMPLES, PolicyPass, PolicySource, asked
from sim2reason.generation.item import Item, Record

__all__ = ["RESULT", "SOLUTIONS", "Sampled", "sample_solutions"]

SOLUTIONS, RESULT = "solutions.jsonl", "sampled.json"
TRIES, KEEP = 8, 4
DUPLICATE, BEYOND = "duplicate", "beyond keep"


class Sampled(Record):
    """The result of `sample_solutions`, as written to ``sampled.json``.

    Attributes:
        plan: The dataset, the policy and the seed.
        splits: Splits whose problems were asked.
        tries: Number of tries for each problem.
        keep: Greatest number of solutions to keep for each problem.
        items: Number of problems.
        solved: Number of problems with a solution that was kept.
        kept: Number of solutions.
        left_out: Numbers of other tries by outcome, including duplicates and right responses beyond `keep`.
        samples: SHA-256 of the journal of responses.
        solutions: SHA-256 of the solutions.
        versions: Versions of the packages.
    """

    plan: PolicyPass
    splits: tuple[str, ...]
    """Those of the dataset whose problems were asked."""
    tries: int
    keep: int
    items: int
    solved: int
    """Problems with a solution that is kept."""
    kept: int
    left_out: dict[str, int]
    """Tries that are not kept, by how they ended; right ones as duplicates, or beyond so many of one problem."""
    samples: str
    """The SHA-256 of the journal of answers."""
    solutions: str
    """That of the solutions."""
    versions: dict[str, str]


def sample_solutions(  # noqa: PLR0913 - what the command takes
    dataset: Dataset | Path | str,
    out: Path | str,
    policy: PolicySource,
    *,
    k: int = TRIES,
    keep: int = KEEP,
    split: Names = ALL,
    seed: int = 0,
    advance: Callable[[int], object] = lambda _: None,
) -> Sampled:
    r"""Ask a policy to solve the problems of a dataset, and keep its right responses to learn from.

    A response is kept if it earns the full reward, is not truncated, and repeats no other. Responses of an earlier call
    with the same folder are reused: with more tries, another `keep`, further splits, or after an interruption.

    Args:
        dataset: A dataset, or the folder that `generate` has finished.
        out: Folder for the responses and the solutions.
        policy: A policy, a mapping with its settings, or a YAML file with them.
        k: Number of tries for each problem.
        keep: Greatest number of solutions for each problem; the first tries are taken.
        split: Splits whose problems are asked: one name, several, or ``all``.
        seed: Seed of the samples.
        advance: Callback that takes the number of further responses that are finished.

    Returns:
        The numbers of problems, solutions and other responses.

    Raises:
        EvaluationError: `k` or `keep` is invalid, or the folder contains something else.
        PolicyError: The policy cannot be asked; finished responses are stored.
        DatasetError: There is no finished dataset, a file is damaged, or there is no such split.

    Examples:
        >>> import sim2reason
        >>> data = sim2reason.generate("problems", items=2, recipe="pulley", difficulty="easy", workers=1)
        >>> one = {"kind": "constant", "name": "one", "text": r"\boxed{1}"}
        >>> result = sim2reason.sample_solutions("problems", "solutions", one, k=1)
        >>> result.items, result.kept, result.left_out
        (2, 0, {'wrong': 2})
    """
    if not 1 <= k <= MOST_TRIES or not 1 <= keep <= MOST_TRIES:
        raise EvaluationError(f"{k} tries of which {keep} are kept: give numbers from 1 to {MOST_TRIES}")
    source, out = Dataset(dataset), Path(out)
    chosen = source.splits(split)
    items = [item for name in chosen for item in source.items(name)]
    with asked(source, items, out, policy, k=k, seed=seed, advance=advance) as plan:
        return _finished(items, out, plan, chosen, k, keep)


def _finished(items: list[Item], out: Path, plan: PolicyPass, splits: tuple[str, ...], k: int, keep: int) -> Sampled:
    """Grade all responses and write the solutions."""
    (out / RESULT).unlink(missing_ok=True)
    left_out = Counter[str]()
    rows = list(_kept(items, out / SAMPLES, k, keep, left_out))
    _put_rows(out, rows)
    found = Sampled(
        plan=plan,
        splits=splits,
        tries=k,
        keep=keep,
        items=len(items),
        solved=len({row["id"] for row in rows}),
        kept=len(rows),
        left_out=dict(sorted(left_out.items())),
        samples=checksum(out / SAMPLES),
        solutions=checksum(out / SOLUTIONS),
        versions={"sim2reason": version("sim2reason")},
    )
    put_text(out / RESULT, canonical(found.model_dump(mode="json")), out)
    return found


def _put_rows(out: Path, rows: list[dict[str, str | int]]) -> None:
    def write(temporary: Path) -> None:
        with temporary.open("w", encoding="utf-8", newline="\n") as file:
            file.writelines(f"{json.dumps(row, ensure_ascii=False)}\n" for row in rows)

    put(out / SOLUTIONS, write, out)


def _kept(
    items: list[Item], journal: Path, k: int, keep: int, left_out: Counter[str]
) -> Iterator[dict[str, str | int]]:
    """Yield the solutions in the order of the items and of their tries, whatever the order of responses."""
    by_id = {item.id: list[FinishedSample]() for item in items}
    for found in finished(journal):
        if found.sample < k and found.id in by_id:
            by_id[found.id].append(found)
    for item in items:
        seen = set[str]()
        for found in sorted(by_id[item.id], key=lambda each: each.sample):
            why = _why_not(item, found.completion, seen, keep)
            if why:
                left_out[why] += 1
                continue
            seen.add(_told(found.completion))
            yield {
                "id": item.id,
                "prompt": item.prompt,
                "completion": found.completion.whole,
                "sample": found.sample,
            }


def _why_not(item: Item, said: Completion, seen: set[str], keep: int) -> str:
    """Return the reason why a response is not kept as a solution; empty if it is kept."""
    asked_for = benchmark_item(item)
    ending = ending_of(said, SCORINGS[asked_for.scoring].award(said.whole, asked_for.reference))
    if ending is not Ending.CORRECT:
        return str(ending)
    if said.finish not in ("stop", "unknown"):  # a right answer, and then no end, or a filter
        return str(Ending.TRUNCATED if said.finish == "length" else Ending.REFUSED)
    if _told(said) in seen:
        return DUPLICATE
    return BEYOND if len(seen) >= keep else ""


def _told(said: Completion) -> str:
    """Return a response with all white space reduced to single spaces."""
    return " ".join(said.whole.split())

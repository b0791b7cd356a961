"""Corpora of solutions: worked ones, and correct responses of a policy, found by rejection sampling.

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
from itertools import islice
from pathlib import Path
from typing import Annotated, Self

from annotated_types import Ge, Le
from pydantic import ValidationError, model_validator

from sim2reason.base.atomic_files import canonical, checksum, put_text, write_atomically
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.plan import ALL_NAMES, Names
from sim2reason.errors import EvaluationError, TrainingError
from sim2reason.evaluation.benchmarks.own import benchmark_item
from sim2reason.evaluation.benchmarks.runs.run import Ending, find_ending
from sim2reason.evaluation.benchmarks.scoring import SCORINGS
from sim2reason.evaluation.policies import Completion
from sim2reason.evaluation.policies.journal import FinishedSample, read_finished
from sim2reason.evaluation.policy_pass import MAX_TRIES, SAMPLES, PolicyPass, PolicySource, open_answers
from sim2reason.generation.certified import worked_solution
from sim2reason.generation.item import Item, Record
from sim2reason.generation.item_search import ItemSearch
from sim2reason.generation.make import build_item
from sim2reason.generation.request import Request
from sim2reason.training.corpora import CORPORA, Corpus, Row
from sim2reason.training.corpora.rows import drawn_rows, read_rows
from sim2reason.training.sources.problems import Fresh, fingerprint

__all__ = ["RESULT", "SOLUTIONS", "JsonLines", "SampledSolutions", "SamplingResult", "Worked", "sample_solutions"]

SOLUTIONS, RESULT = "solutions.jsonl", "sampled.json"
TRIES, KEEP = 8, 4
DUPLICATE, BEYOND = "duplicate", "beyond keep"


class SamplingResult(Record):
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
    split: Names = ALL_NAMES,
    seed: int = 0,
    advance: Callable[[int], object] = lambda _: None,
) -> SamplingResult:
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
    if not 1 <= k <= MAX_TRIES or not 1 <= keep <= MAX_TRIES:
        raise EvaluationError(f"{k} tries of which {keep} are kept: give numbers from 1 to {MAX_TRIES}")
    source, out = Dataset(dataset), Path(out)
    chosen = source.splits(split)
    items = [item for name in chosen for item in source.items(name)]
    with open_answers(source, items, out, policy, k=k, seed=seed, advance=advance) as plan:
        return _finished(items, out, plan, chosen, k, keep)


def _finished(
    items: list[Item], out: Path, plan: PolicyPass, splits: tuple[str, ...], k: int, keep: int
) -> SamplingResult:
    """Grade all responses and write the solutions."""
    (out / RESULT).unlink(missing_ok=True)
    left_out = Counter[str]()
    rows = list(_kept(items, out / SAMPLES, k, keep, left_out))
    _put_rows(out, rows)
    record = SamplingResult(
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
    put_text(out / RESULT, canonical(record.model_dump(mode="json")), out)
    return record


def _put_rows(out: Path, rows: list[dict[str, str | int]]) -> None:
    def write(temporary: Path) -> None:
        with temporary.open("w", encoding="utf-8", newline="\n") as file:
            file.writelines(f"{json.dumps(row, ensure_ascii=False)}\n" for row in rows)

    write_atomically(out / SOLUTIONS, write, out)


def _kept(
    items: list[Item], journal: Path, k: int, keep: int, left_out: Counter[str]
) -> Iterator[dict[str, str | int]]:
    """Yield the solutions in the order of the items and of their tries, whatever the order of responses."""
    by_id = {item.id: list[FinishedSample]() for item in items}
    for sample in read_finished(journal):
        if sample.sample < k and sample.id in by_id:
            by_id[sample.id].append(sample)
    for item in items:
        seen = set[str]()
        for sample in sorted(by_id[item.id], key=lambda each: each.sample):
            why = _why_not(item, sample.completion, seen, keep)
            if why:
                left_out[why] += 1
                continue
            seen.add(_normalize_spaces(sample.completion))
            yield {
                "id": item.id,
                "prompt": item.prompt,
                "completion": sample.completion.whole,
                "sample": sample.sample,
            }


def _why_not(item: Item, completion: Completion, seen: set[str], keep: int) -> str:
    """Return the reason why a response is not kept as a solution; empty if it is kept."""
    asked_for = benchmark_item(item)
    ending = find_ending(completion, SCORINGS[asked_for.scoring].award(completion.whole, asked_for.reference))
    if ending is not Ending.CORRECT:
        return str(ending)
    if completion.finish not in ("stop", "unknown"):  # a right answer, and then no end, or a filter
        return str(Ending.TRUNCATED if completion.finish == "length" else Ending.REFUSED)
    if _normalize_spaces(completion) in seen:
        return DUPLICATE
    return BEYOND if len(seen) >= keep else ""


def _normalize_spaces(completion: Completion) -> str:
    """Return a response with all white space reduced to single spaces."""
    return " ".join(completion.whole.split())


@CORPORA.register("jsonl")
class JsonLines(Corpus):
    """JSON lines of any origin, each with a prompt and a completion."""

    file: Path
    prompt: str = "prompt"
    """The name of the field with the prompt."""
    completion: str = "completion"
    """The name of that with the completion."""

    def rows(self, left_out: Counter[str]) -> Iterator[Row]:
        """Yield the prompts with completions in the file."""
        del left_out
        return read_rows(self.file, self.prompt, self.completion)

    def check(self) -> None:
        """Read all requested rows of the file, so that errors occur before a run."""
        if not sum(1 for _ in islice(self.rows(Counter()), self.limit)):
            raise TrainingError(f"{self.file}: holds no row")


@CORPORA.register("sampled")
class SampledSolutions(Corpus):
    """Responses of a policy that were graded as correct."""

    folder: Path

    def rows(self, left_out: Counter[str]) -> Iterator[Row]:
        """Yield the prompts with correct responses in the folder of solutions, after checking its hash."""
        del left_out
        try:
            record = SamplingResult.model_validate_json((self.folder / RESULT).read_bytes())
        except FileNotFoundError:
            raise TrainingError(
                f"{self.folder}: no {RESULT} here; give a folder that sim2reason sample-solutions has finished"
            ) from None
        except ValidationError:
            raise TrainingError(f"{self.folder / RESULT}: damaged; give the same sample-solutions again") from None
        if checksum(self.folder / SOLUTIONS) != record.solutions:
            raise TrainingError(f"{self.folder / SOLUTIONS}: changed or missing; give the same sample-solutions again")
        return read_rows(self.folder / SOLUTIONS)

    def check(self) -> None:
        """Check that the folder of solutions exists and is unchanged since it was written."""
        self.rows(Counter())


UNSOLVED = "no worked solution"


@CORPORA.register("worked")
class Worked(Corpus):
    """Worked solutions with boxed answers, from a dataset or generated from a seed."""

    dataset: Path | None = None
    """A folder that ``sim2reason generate --solutions`` has finished; else problems are drawn."""
    split: str | None = None
    """Of the dataset; by default all."""
    problems: Fresh | None = None
    """What is drawn, as a source of prompts has it; of another seed than those that are trained or evaluated on."""
    items: Annotated[int, Ge(1), Le(10**7)] = 1000
    """How many problems are drawn."""
    workers: Annotated[int, Ge(1), Le(1024)] = 1
    """Processes that make the problems; they never change which."""

    @model_validator(mode="after")
    def _one_source(self) -> Self:
        if (self.dataset is None) == (self.problems is None):
            raise ValueError("give either dataset, a folder, or problems, to draw some")
        if self.split is not None and self.dataset is None:
            raise ValueError("split is one of a dataset")
        if "items" in self.model_fields_set and self.problems is None:
            raise ValueError("items is of problems that are drawn; of a dataset say limit")
        return self

    def rows(self, left_out: Counter[str]) -> Iterator[Row]:
        """Yield the rows in the order of the dataset or of generation, without unsolved problems."""
        if self.problems is not None:
            yield from drawn_rows(self.problems, self.rows_of, self.items, self.workers, left_out, UNSOLVED)
            return
        for item in self._items():
            if item.solution is None:
                left_out[UNSOLVED] += 1
            else:
                yield _row(item, item.solution.text)

    def check(self) -> None:
        """Open the dataset of worked solutions, so that errors occur before a run."""
        if self.dataset is not None:
            self._items()

    def rows_of(self, request: Request) -> list[Row] | None:
        """Return the rows of one problem; None if there is no such problem."""
        certified = ItemSearch(request).find()
        if certified is None:
            return None
        item = build_item(request, certified)
        solution = worked_solution(request, certified)
        return [] if solution.answer is None else [_row(item, solution.text)]

    def _items(self) -> Iterator[Item]:
        assert self.dataset is not None
        source = Dataset(self.dataset)
        if not source.manifest.config.solutions:
            raise TrainingError(f"{source.path}: its problems have no solutions; generate it with --solutions")
        return source.items(self.split)


def _row(item: Item, text: str) -> Row:
    return Row(item.prompt, text, right=True, fingerprint=fingerprint(item))

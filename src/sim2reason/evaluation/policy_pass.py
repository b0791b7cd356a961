"""Passes of a policy over a dataset: several answers to every problem, and the problems that it solves sometimes.

    OUT/plan.json          the dataset, the policy, and the seed of its samples
    OUT/samples.jsonl      every answer, one line each, on disk as soon as it is finished

What is made of the answers is made anew each time; the solvable filter and rejection sampling share them. A policy's
answers are no function of a problem, so the solvable filter is no filter of the maker but a pass over a finished
dataset, whose result is a folder with hashes of all that it rests on:

    OUT/solvable.json      the dataset, the policy, tries, bounds, and what was found; written last
    OUT/pass_rates.jsonl   of each problem: right answers, tries, and whether it was kept
    OUT/problems/          the dataset of those that were kept
"""

from collections.abc import Callable, Generator, Iterable, Iterator, Mapping
from contextlib import contextmanager
from importlib.metadata import version
from pathlib import Path

from pydantic import JsonValue, ValidationError

from sim2reason.base.atomic_files import canonical, checksum, lock_work_folder, put_text
from sim2reason.base.settings import read_settings
from sim2reason.datasets.build import write_subset
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.manifest import MANIFEST
from sim2reason.errors import EvaluationError
from sim2reason.evaluation.policies import Policy, build_policy
from sim2reason.evaluation.policies.journal import SampleJournal, read_finished
from sim2reason.evaluation.policies.samples import ask, requests_for
from sim2reason.generation.item import Answer, Item, Record, grade_answer

__all__ = ["MAX_TRIES", "SAMPLES", "PassRate", "PolicyPass", "PolicySource", "Solvable", "open_answers", "solvable"]

PLAN, SAMPLES = "plan.json", "samples.jsonl"
MAX_TRIES = 4096
PolicySource = Policy | Mapping[str, object] | Path | str
"""A policy, its settings, or a YAML file with them."""


class PolicyPass(Record):
    """The record of a policy's pass over a dataset: the dataset, policy and seed that determine the answers."""

    dataset: str
    """The SHA-256 of its manifest."""
    policy: dict[str, JsonValue]
    seed: int


@contextmanager
def open_answers(
    source: Dataset,
    items: Iterable[Item],
    out: Path,
    policy: PolicySource,
    *,
    k: int,
    seed: int,
    advance: Callable[[int], object],
) -> Generator[PolicyPass]:
    """Return a context with the folder `out`, in which every item has been answered `k` times.

    Existing answers are reused: with more tries, further items or after a kill, the same call continues. `advance`
    receives the numbers of newly finished answers.

    Raises:
        EvaluationError: a folder that holds something else, or tries that got no answer.
        PolicyError: a policy that can't be asked; what was finished is kept.
    """
    loaded_policy = _policy(policy)
    plan = PolicyPass.model_validate(
        {"dataset": checksum(source.path / MANIFEST), "policy": loaded_policy.decisive, "seed": seed}
    )
    with lock_work_folder(out):
        _claim(out, plan, loaded_policy)
        with SampleJournal(out / SAMPLES) as journal:
            prompts = ((item.id, item.prompt) for item in items)
            done = ask(loaded_policy, requests_for(prompts, k, seed), journal, advance=advance)
        if done.open:
            raise EvaluationError(f"{len(done.open)} tries got no answer; give the same command again. {done.open[0]}")
        yield plan


def _policy(given: PolicySource) -> Policy:
    if isinstance(given, Policy):
        return given
    return build_policy(given) if isinstance(given, Mapping) else build_policy(read_settings(Path(given)), str(given))


def _claim(out: Path, plan: PolicyPass, policy: Policy) -> None:
    """Write the plan into an empty folder or over a plan without answers, or continue with an equal plan."""
    file = out / PLAN
    if not file.is_file():
        if strangers := sorted(path.name for path in out.iterdir()):
            raise EvaluationError(f"{out}: holds {strangers[0]} and is no pass of a policy; choose a new folder")
    else:
        before = _plan_in(file)
        if before == plan:
            return
        if (out / SAMPLES).is_file() and (out / SAMPLES).stat().st_size:
            differs = next(name for name in PolicyPass.model_fields if getattr(before, name) != getattr(plan, name))
            raise EvaluationError(f"{out}: holds a pass with another {differs}; choose a new folder")
    policy.check()
    put_text(file, canonical(plan.model_dump(mode="json")), out)


def _plan_in(file: Path) -> PolicyPass:
    try:
        return PolicyPass.model_validate_json(file.read_bytes())
    except ValidationError:
        raise EvaluationError(f"{file}: damaged; choose a new folder") from None


RESULT, RATES, KEPT = "solvable.json", "pass_rates.jsonl", "problems"
TRIES, BETWEEN = 8, (0.1, 0.9)


class PassRate(Record):
    """The pass rate of a policy on one problem."""

    id: str
    right: int
    tries: int
    kept: bool

    @property
    def rate(self) -> float:
        """Return the fraction of correct answers."""
        return self.right / self.tries


class Solvable(Record):
    """The result of filtering a dataset by pass rates, as stored in ``solvable.json``."""

    plan: PolicyPass
    tries: int
    between: tuple[float, float]
    """An open interval."""
    items: int
    kept: int
    rates: dict[str, int]
    """How many problems were solved how often, by the number of right answers."""
    samples: str
    """The SHA-256 of the journal of answers."""
    versions: dict[str, str]


def solvable(
    dataset: Path | str,
    out: Path | str,
    policy: PolicySource,
    *,
    k: int = TRIES,
    between: tuple[float, float] = BETWEEN,
    seed: int = 0,
    advance: Callable[[int], object] = lambda _: None,
) -> Solvable:
    """Keep the problems whose pass rate over `k` tries is strictly `between` two bounds.

    `policy` may be a YAML file of settings. Existing answers are reused: with more tries, other bounds or after a kill,
    the same call continues. `advance` receives the numbers of newly finished answers.

    Raises:
        EvaluationError: bounds or a number of tries that make no sense, or a folder that holds something else.
        PolicyError: a policy that can't be asked; what was finished is kept.
        DatasetError: no finished dataset, or a damaged one.
    """
    low, high = between
    if not 0.0 <= low < high <= 1.0 or not 1 <= k <= MAX_TRIES:
        raise EvaluationError(f"between {low:g} and {high:g}, {k} tries: give bounds as in 0.1,0.9 and a try or more")
    source, out = Dataset(dataset), Path(out)
    with open_answers(source, source, out, policy, k=k, seed=seed, advance=advance) as plan:
        return _finished(source, out, plan, k, between)


def _finished(source: Dataset, out: Path, plan: PolicyPass, k: int, between: tuple[float, float]) -> Solvable:
    """Grade all answers, and write the results and the kept problems."""
    (out / RESULT).unlink(missing_ok=True)
    rates = {rate.id: rate for rate in _rates(source, out / SAMPLES, k, between)}
    put_text(out / RATES, "".join(f"{rate.model_dump_json()}\n" for rate in rates.values()), out)
    low, high = between
    why = (
        f"Of {len(rates)} problems those that the policy `{plan.policy.get('name')}` solved in a share of {k} tries "
        f"strictly between {low:g} and {high:g}."
    )
    manifest = write_subset(source, out / KEPT, lambda item: rates[item.id].kept, "solvable", why)
    counts = [rate.right for rate in rates.values()]
    record = Solvable(
        plan=plan,
        tries=k,
        between=between,
        items=len(rates),
        kept=manifest.rows,
        rates={str(right): counts.count(right) for right in range(k + 1)},
        samples=checksum(out / SAMPLES),
        versions={"sim2reason": version("sim2reason")},
    )
    put_text(out / RESULT, canonical(record.model_dump(mode="json")), out)
    return record


def _rates(source: Dataset, journal: Path, k: int, between: tuple[float, float]) -> Iterator[PassRate]:
    """Yield the pass rate of each problem, in the dataset's order."""
    answers: Mapping[str, Answer] = {item.id: item.answer for item in source}
    right = dict.fromkeys(answers, 0)
    for sample in read_finished(journal):
        if sample.sample < k and sample.id in answers:
            right[sample.id] += grade_answer(answers[sample.id], sample.completion.whole).reward == 1.0
    for name, count in right.items():
        yield PassRate(id=name, right=count, tries=k, kept=between[0] < count / k < between[1])

"""A pass of a policy over a dataset: several answers to every problem, each on disk immediately.

    OUT/plan.json       the dataset, the policy, and the seed of its samples
    OUT/samples.jsonl   every answer, one line each

What is made of the answers is made anew each time; the solvable filter and whoever keeps right solutions share them.
"""

from collections.abc import Callable, Generator, Iterable, Mapping
from contextlib import contextmanager
from pathlib import Path

from pydantic import JsonValue, ValidationError

from sim2reason.base.atomic_files import canonical, checksum, put_text, working_in
from sim2reason.base.settings import settings_in
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.manifest import MANIFEST
from sim2reason.errors import EvaluationError
from sim2reason.evaluation.policies import Policy, policy_from
from sim2reason.evaluation.policies.samples.ask import ask, requests_for
from sim2reason.evaluation.policies.samples.journal import SampleJournal
from sim2reason.generation.item import Item, Record

__all__ = ["MOST_TRIES", "SAMPLES", "PolicyPass", "PolicySource", "asked"]

PLAN, SAMPLES = "plan.json", "samples.jsonl"
MOST_TRIES = 4096
PolicySource = Policy | Mapping[str, object] | Path | str
"""A policy, its settings, or a YAML file with them."""


class PolicyPass(Record):
    """The record of a policy's pass over a dataset: the dataset, policy and seed that determine the answers."""

    dataset: str
    """The SHA-256 of its manifest."""
    policy: dict[str, JsonValue]
    seed: int


@contextmanager
def asked(
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
    held = _policy(policy)
    plan = PolicyPass.model_validate(
        {"dataset": checksum(source.path / MANIFEST), "policy": held.decisive, "seed": seed}
    )
    with working_in(out):
        _claim(out, plan, held)
        with SampleJournal(out / SAMPLES) as journal:
            prompts = ((item.id, item.prompt) for item in items)
            done = ask(held, requests_for(prompts, k, seed), journal, advance=advance)
        if done.open:
            raise EvaluationError(f"{len(done.open)} tries got no answer; give the same command again. {done.open[0]}")
        yield plan


def _policy(given: PolicySource) -> Policy:
    if isinstance(given, Policy):
        return given
    return policy_from(given) if isinstance(given, Mapping) else policy_from(settings_in(Path(given)), str(given))


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

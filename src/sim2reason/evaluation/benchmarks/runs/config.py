"""Configuration of an evaluation: policies, benchmarks, numbers of samples, and seeds."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Any, cast

from annotated_types import Ge, Le, MinLen
from pydantic import BaseModel, ConfigDict

from sim2reason.base.settings import configuration
from sim2reason.errors import EvaluationError
from sim2reason.evaluation.benchmarks import MOST_SAMPLES, Benchmark, benchmark_from
from sim2reason.evaluation.policies import Policy, policy_from

__all__ = ["Evaluation", "evaluation_from"]

LARGEST = 2**63 - 1
Settings = dict[str, Any]


class _File(BaseModel):
    """The keys of a configuration file."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    out: Path
    seed: Annotated[int, Ge(0), Le(LARGEST)] = 0
    samples: Annotated[int, Ge(1), Le(MOST_SAMPLES)] = 1
    sampling: Settings = {}
    policies: Annotated[list[Settings], MinLen(1)]
    benchmarks: Annotated[list[Settings], MinLen(1)]
    judge: Settings | None = None


@dataclass(frozen=True)
class Evaluation:
    """An evaluation: policies, benchmarks, and numbers of samples for each problem.

    `out` is the folder of the run; the seeds of samples derive from `seed`; `judge` rules where a benchmark's scoring
    needs a judge.
    """

    out: Path
    policies: tuple[Policy, ...]
    benchmarks: tuple[Benchmark, ...]
    seed: int = 0
    samples: int = 1
    judge: Policy | None = None

    def __post_init__(self) -> None:
        """Raise EvaluationError if two policies or two benchmarks have the same name."""
        for what, names in (("policies", self.policies), ("benchmarks", self.benchmarks)):
            held = [each.name for each in names]
            if twice := sorted({name for name in held if held.count(name) > 1}):
                raise EvaluationError(f"{what}: the name {twice[0]!r} stands twice; give each its own")

    def check(self) -> None:
        """Check before a run that all policies are available; PolicyError if one is not."""
        for policy in (*self.policies, *(() if self.judge is None else (self.judge,))):
            policy.check()

    def samples_of(self, benchmark: Benchmark) -> int:
        """Return the number of samples for each problem of a benchmark."""
        return benchmark.samples or self.samples


def evaluation_from(config: "Path | str | Mapping[str, object] | Evaluation", out: Path | None = None) -> Evaluation:
    """Return the evaluation in a YAML file or in settings; `out` overrides the output folder.

    Relative paths refer to the current working directory.

    Raises:
        EvaluationError: what is missing, unknown or makes no sense; the line names its place.
        PolicyError, UnknownNameError: the same of a policy, and of a kind.
    """
    if isinstance(config, Evaluation):
        return config if out is None else replace(config, out=out)
    return configuration(config, out, lambda settings: _evaluation(_File.model_validate(settings)), EvaluationError)


def _evaluation(file: _File) -> Evaluation:
    return Evaluation(
        out=file.out,
        policies=tuple(_policy(each, f"policies[{n}]", file.sampling) for n, each in enumerate(file.policies)),
        benchmarks=tuple(benchmark_from(each, f"benchmarks[{n}]") for n, each in enumerate(file.benchmarks)),
        seed=file.seed,
        samples=file.samples,
        judge=None if file.judge is None else _policy(file.judge, "judge", {}),
    )


def _policy(settings: Settings, place: str, sampling: Settings) -> Policy:
    """Return a policy, whose own sampling settings override the common ones."""
    own = settings.get("sampling", {})
    if not isinstance(own, dict):
        raise EvaluationError(f"{place}.sampling: give settings, such as temperature: 1.0")
    return policy_from({**settings, "sampling": {**sampling, **cast("Settings", own)}}, place)

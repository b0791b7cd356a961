"""Configuration and folder of an evaluation: policies, benchmarks, seeds, and the plan, problems and answers."""

import json
import shutil
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Any, cast

from annotated_types import Ge, Le, MinLen
from pydantic import BaseModel, ConfigDict, JsonValue, ValidationError

from sim2reason.base.atomic_files import canonical, put_text
from sim2reason.base.settings import configuration
from sim2reason.errors import EvaluationError
from sim2reason.evaluation.benchmarks import (
    BENCHMARKS,
    MOST_SAMPLES,
    Benchmark,
    BenchmarkItem,
    build_benchmark,
    data_hash,
    load_items,
)
from sim2reason.evaluation.benchmarks.scoring import SCORINGS
from sim2reason.evaluation.policies import POLICIES, Policy, build_policy
from sim2reason.generation.request import shaping_versions

__all__ = ["BenchmarkPlan", "Evaluation", "PolicyPlan", "RunFolder", "RunRecord", "build_evaluation", "copy_answers"]

MAX_SEED = 2**63 - 1
Settings = dict[str, Any]


class _File(BaseModel):
    """The keys of a configuration file."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    out: Path
    seed: Annotated[int, Ge(0), Le(MAX_SEED)] = 0
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
            used_names = [each.name for each in names]
            if twice := sorted({name for name in used_names if used_names.count(name) > 1}):
                raise EvaluationError(f"{what}: the name {twice[0]!r} stands twice; give each its own")

    def check(self) -> None:
        """Check before a run that all policies are available; PolicyError if one is not."""
        for policy in (*self.policies, *(() if self.judge is None else (self.judge,))):
            policy.check()

    def samples_of(self, benchmark: Benchmark) -> int:
        """Return the number of samples for each problem of a benchmark."""
        return benchmark.samples or self.samples


def build_evaluation(config: "Path | str | Mapping[str, object] | Evaluation", out: Path | None = None) -> Evaluation:
    """Return the evaluation in a YAML file or in settings; `out` overrides the output folder.

    Relative paths refer to the current working directory.

    Raises:
        EvaluationError: what is missing, unknown or makes no sense; the line names its place.
        PolicyError, UnknownNameError: the same of a policy, and of a kind.
    """
    if isinstance(config, Evaluation):
        return config if out is None else replace(config, out=out)
    return configuration(
        config, out, lambda settings: _evaluation(_File.model_validate(settings)), EvaluationError, _File
    )


def _evaluation(file: _File) -> Evaluation:
    return Evaluation(
        out=file.out,
        policies=tuple(_policy(each, f"policies[{n}]", file.sampling) for n, each in enumerate(file.policies)),
        benchmarks=tuple(build_benchmark(each, f"benchmarks[{n}]") for n, each in enumerate(file.benchmarks)),
        seed=file.seed,
        samples=file.samples,
        judge=None if file.judge is None else _policy(file.judge, "judge", {}),
    )


def _policy(settings: Settings, location: str, sampling: Settings) -> Policy:
    """Return a policy, whose own sampling settings override the common ones."""
    own = settings.get("sampling", {})
    if not isinstance(own, dict):
        raise EvaluationError(f"{location}.sampling: give settings, such as temperature: 1.0")
    return build_policy({**settings, "sampling": {**sampling, **cast("Settings", own)}}, location)


RUN, PROBLEMS, SAMPLES, JUDGED, REPORT = "run.json", "problems", "samples", "judged", "report"


class _Record(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid")


class PolicyPlan(_Record):
    """The record of a policy in a run: all its settings, and the subset that affects its answers."""

    kind: str
    settings: dict[str, JsonValue]
    decisive: dict[str, JsonValue]

    @property
    def step(self) -> int | None:
        """Return the number of training steps of the evaluated checkpoint; None if its settings state none."""
        value = self.settings.get("step")
        return value if isinstance(value, int) else None


class BenchmarkPlan(_Record):
    """The record of a benchmark in a run."""

    kind: str
    settings: dict[str, JsonValue]
    samples: int
    """Of each problem and policy."""
    items: int
    data: str
    """The hash of all that is asked and of all answers."""


class RunRecord(_Record):
    """The contents of ``run.json``: the settings that determine the answers, and the library's version."""

    seed: int
    policies: dict[str, PolicyPlan]
    benchmarks: dict[str, BenchmarkPlan]
    judge: PolicyPlan | None = None
    versions: dict[str, str]

    def difference(self, other: "RunRecord") -> str:
        """Return the first setting, such as the seed, that keeps `other` from continuing this run; empty if none does.

        More samples, policies and benchmarks are allowed.
        """
        if self.seed != other.seed:
            return f"seed {self.seed} ≠ {other.seed}"
        for name, plan in self.policies.items():
            if name in other.policies and (where := _first(plan.decisive, other.policies[name].decisive)):
                return f"policy {name}: {where}"
        for name, benchmark in self.benchmarks.items():
            if name in other.benchmarks and benchmark.data != other.benchmarks[name].data:
                return f"benchmark {name}: other problems"
        if self.judge and other.judge and (where := _first(self.judge.decisive, other.judge.decisive)):
            return f"judge: {where}"
        return ""

    def joined(self, other: "RunRecord") -> "RunRecord":
        """Return this record extended and updated by `other`, with the larger numbers of samples of both."""
        more = {
            name: plan.model_copy(update={"samples": max(plan.samples, self.benchmarks[name].samples)})
            if name in self.benchmarks
            else plan
            for name, plan in other.benchmarks.items()
        }
        return other.model_copy(
            update={
                "policies": {**self.policies, **other.policies},
                "benchmarks": {**self.benchmarks, **more},
                "judge": other.judge or self.judge,
            }
        )


def _first(mine: Mapping[str, object], theirs: Mapping[str, object]) -> str:
    return next((name for name in sorted(mine.keys() | theirs.keys()) if mine.get(name) != theirs.get(name)), "")


class RunFolder:
    """The folder of a run, finished or not."""

    def __init__(self, path: Path) -> None:
        """Open a run; EvaluationError if the folder contains none."""
        self.path = path
        file = path / RUN
        try:
            self.record = RunRecord.model_validate_json(file.read_bytes())
        except FileNotFoundError:
            raise EvaluationError(f"{path}: no {RUN} here; give the folder of a run of sim2reason eval") from None
        except ValidationError:
            raise EvaluationError(
                f"{file}: damaged, or of another version; begin a new run in another folder"
            ) from None

    @classmethod
    def begin(cls, evaluation: Evaluation) -> "RunFolder":
        """Return the folder of an evaluation, new or continued; the caller holds its lock.

        A run without any answer is replaced.

        Raises:
            EvaluationError: the folder holds something else, or a run with which this one can't go on.
            PolicyError, MissingExtraError: the run would begin, and a policy can't be asked, or a rule not be applied.
        """
        out = evaluation.out
        if not (out / RUN).is_file() and (strangers := sorted(path.name for path in out.iterdir())):
            raise EvaluationError(f"{out}: holds {strangers[0]} and is no run; choose a new folder")
        before = cls(out).record if (out / RUN).is_file() else None
        if before is None:
            evaluation.check()  # before problems are drawn, which may take minutes
        items = {each.name: _drawn_before(out, each) or load_items(each) for each in evaluation.benchmarks}
        for rule in sorted({item.scoring for problems in items.values() for item in problems}):
            SCORINGS[rule].check()
        record = _record(evaluation, items)
        why = "" if before is None else before.difference(record)
        if why and any(path.stat().st_size for path in (out / SAMPLES).rglob("*.jsonl")):
            raise EvaluationError(f"{out}: holds a run of another configuration ({why}); choose a new folder")
        if why:
            evaluation.check()
        elif before is not None:
            record = before.joined(record)
        for name, problems in items.items():
            (out / PROBLEMS).mkdir(exist_ok=True)
            lines = "".join(f"{item.model_dump_json()}\n" for item in problems)
            put_text(out / PROBLEMS / f"{name}.jsonl", lines, out)
        put_text(out / RUN, canonical(record.model_dump(mode="json")), out)
        return cls(out)

    def items(self, benchmark: str) -> list[BenchmarkItem]:
        """Return the problems of a benchmark; EvaluationError if they differ from those at the start."""
        path = self.path / PROBLEMS / f"{benchmark}.jsonl"
        try:
            with path.open("rb") as lines:
                problems = [BenchmarkItem.model_validate_json(line) for line in lines]
        except (FileNotFoundError, ValidationError):
            raise EvaluationError(f"{path}: missing or damaged; give the same sim2reason eval again") from None
        if data_hash(problems) != self.record.benchmarks[benchmark].data:
            raise EvaluationError(f"{path}: changed since the run was begun; give the same sim2reason eval again")
        return problems

    def samples(self, policy: str, benchmark: str) -> Path:
        """Return the path of the journal of a policy's answers to a benchmark."""
        return self.path / SAMPLES / policy / f"{benchmark}.jsonl"

    def judged(self, policy: str, benchmark: str) -> Path:
        """Return the path of the journal of the judge's rulings."""
        return self.path / JUDGED / policy / f"{benchmark}.jsonl"

    @property
    def report(self) -> Path:
        """Return the folder of the report."""
        return self.path / REPORT


def _drawn_before(out: Path, benchmark: Benchmark) -> list[BenchmarkItem]:
    """Return the stored problems of a run that continues with the same settings; an empty list otherwise."""
    if not benchmark.pure or not (out / RUN).is_file():
        return []
    before = RunFolder(out)
    plan = before.record.benchmarks.get(benchmark.name)
    same = plan is not None and plan.settings == _settings(benchmark) and before.record.versions == shaping_versions()
    return before.items(benchmark.name) if same else []


def _settings(benchmark: Benchmark) -> dict[str, JsonValue]:
    return json.loads(benchmark.model_dump_json())


def _record(evaluation: Evaluation, items: Mapping[str, Iterable[BenchmarkItem]]) -> RunRecord:
    return RunRecord(
        seed=evaluation.seed,
        policies={policy.name: _plan(policy) for policy in evaluation.policies},
        benchmarks={each.name: _benchmark(evaluation, each, [*items[each.name]]) for each in evaluation.benchmarks},
        judge=None if evaluation.judge is None else _plan(evaluation.judge),
        versions=shaping_versions(),
    )


def _kind(registry: Mapping[str, type], value: object) -> str:
    """Return the registered name of the class of `value`, or its class name if it is not registered."""
    return next((name for name, kind in registry.items() if kind is type(value)), type(value).__name__)


def _plan(policy: Policy) -> PolicyPlan:
    return PolicyPlan.model_validate(
        {"kind": _kind(POLICIES, policy), "settings": policy.settings, "decisive": policy.decisive}
    )


def _benchmark(evaluation: Evaluation, benchmark: Benchmark, items: list[BenchmarkItem]) -> BenchmarkPlan:
    return BenchmarkPlan(
        kind=_kind(BENCHMARKS, benchmark),
        settings=_settings(benchmark),
        samples=evaluation.samples_of(benchmark),
        items=len(items),
        data=data_hash(items),
    )


PARTIAL = ".part"


def copy_answers(run: Path, out: Path, model: str, copied: str) -> None:
    """Start a run in `out` with the answers of `model` in `run`, assigned to its copy at `copied`.

    Without such answers no run is started. EvaluationError if `run` contains none.
    """
    source_run = RunFolder(run)
    policies = {name: plan for name, plan in source_run.record.policies.items() if plan.decisive.get("model") == model}
    if not policies:
        return
    partial = out.with_name(out.name + PARTIAL)
    shutil.rmtree(partial, ignore_errors=True)
    shutil.copytree(run / PROBLEMS, partial / PROBLEMS)
    for name in policies:
        if (run / SAMPLES / name).is_dir():
            shutil.copytree(run / SAMPLES / name, partial / SAMPLES / name)
    plans = {name: _of(plan, copied) for name, plan in policies.items()}
    record = source_run.record.model_copy(update={"policies": plans, "judge": None})
    put_text(partial / RUN, canonical(record.model_dump(mode="json")), partial)
    partial.rename(out)


def _of(plan: PolicyPlan, model: str) -> PolicyPlan:
    """Return the policy with the path of its model replaced."""
    settings, decisive = ({**fields, "model": model} for fields in (plan.settings, plan.decisive))
    return plan.model_copy(update={"settings": settings, "decisive": decisive})

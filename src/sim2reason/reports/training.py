"""What training has done: held-out accuracy before and after, beside the best constant and the run's own measures.

RUN/evaluation/greedy, RUN/evaluation/sampled   evaluations of the model before and after
RUN/report/report.md, report.json, steps.png    all of it on a page
"""

import json
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from pydantic import JsonValue, ValidationError

from sim2reason.benchmarks import BenchmarkItem, items_of
from sim2reason.benchmarks.runs.config import Evaluation
from sim2reason.benchmarks.saved import Saved
from sim2reason.benchmarks.scoring import SCORINGS
from sim2reason.datasets.atomic_files import canonical, put_text
from sim2reason.errors import TrainingError
from sim2reason.figures.training_plots import curves
from sim2reason.policies import Policy, policy_from
from sim2reason.reports.comparison import PairedDifference, compare
from sim2reason.reports.evaluation import evaluate
from sim2reason.reports.markdown import table
from sim2reason.reports.scores import scores_of
from sim2reason.reports.statistics import Estimate, wilson
from sim2reason.training.gspo.step_log import StepLog, StepRecord
from sim2reason.training.rl.config import ReinforcementLearning
from sim2reason.training.rl.folder import TrainingFolder

__all__ = ["TrainingReport", "report_training"]

HELD_OUT, BEFORE, AFTER = "held-out", "before", "after"
TEMPERATURES = {"greedy": 0.0, "sampled": 1.0}
CELL = "quantity"
INSIDE = 0.98  # of a tolerance: what is surely inside it when written with six digits
PANELS = {
    "reward": "mean reward",
    "pass_rate": "pass rate",
    "zero_variance": "share of groups without variance",
    "rounds": "rounds of sampling",
    "completion_tokens": "tokens of a completion",
    "kl": "KL to the first model",
    "clip_high": "share clipped above",
    "entropy": "entropy (nats)",
}


class TrainingReport(NamedTuple):
    """What stands on the page."""

    differences: dict[str, PairedDifference]
    """After less before, by how responses were chosen: ``greedy`` and ``sampled``."""
    cells: list[list[object]]
    """The rows of the table: cell, problems, accuracies before and after with intervals, best constant."""
    constant: Estimate
    """The accuracy of the constant that suits these very problems best."""
    overhead: float
    """The share of the steps' time that problems and rewards took."""
    seconds: float
    """Of a step."""
    folder: Path


def report_training(
    config: ReinforcementLearning,
    *,
    begun: Callable[[str, int], object] = lambda phase, steps: None,  # noqa: ARG005 - names say what is told
    advance: Callable[[int], object] = lambda _: None,
) -> TrainingReport:
    """Evaluate a finished run on its held-out problems, before and after, and write the report.

    Raises:
        TrainingError: the run is not finished, or holds no problems out.
        PolicyError: a model cannot be loaded.
    """
    held, folder = config.held_out, TrainingFolder(config.out)
    result = folder.result()
    if held is None or result is None:
        raise TrainingError(f"{config.out}: no finished run with held_out problems; train it first")
    benchmark = Saved(name=HELD_OUT, file=folder.held_out)
    runs: dict[str, Path] = {}
    for name, temperature in TEMPERATURES.items():
        runs[name] = config.out / "evaluation" / name
        sampling: dict[str, object] = {
            "temperature": temperature,
            "max_tokens": config.gspo.max_completion_tokens,
        }
        models = {BEFORE: result.initial, AFTER: str(folder.model)}
        policies = tuple(_policy(each, path, sampling, config.gspo.generations) for each, path in models.items())
        samples = 1 if temperature == 0.0 else held.samples
        asked = Evaluation(out=runs[name], policies=policies, benchmarks=(benchmark,), samples=samples)
        evaluate(asked, begun=lambda total, name=name: begun(f"answers, {name}", total), advance=advance)
    return _written(config, folder, items_of(benchmark), runs)


def _policy(name: str, model: str, sampling: dict[str, object], generations: int) -> Policy:
    settings = {"kind": "transformers", "name": name, "model": model, "sampling": sampling}
    return policy_from({**settings, "batch_size": max(64, generations)}, name)


def _written(
    config: ReinforcementLearning, folder: TrainingFolder, items: Sequence[BenchmarkItem], runs: Mapping[str, Path]
) -> TrainingReport:
    out = config.out / "report"
    out.mkdir(exist_ok=True)
    steps = StepLog(folder.train).read()
    differences = {name: compare(f"{run}:{BEFORE}", f"{run}:{AFTER}")[0] for name, run in runs.items()}
    total = sum(step.seconds.step for step in steps)
    found = TrainingReport(
        differences=differences,
        cells=_cells(items, runs),
        constant=_constant(items),
        overhead=sum(step.seconds.reward + step.seconds.drawing for step in steps) / total if total else 0.0,
        seconds=total / max(len(steps), 1),
        folder=out,
    )
    series = {title: {config.out.name: [getattr(step, name) for step in steps]} for name, title in PANELS.items()}
    curves(out / "steps.png", series)
    put_text(out / "report.json", canonical(_as_json(found)), out)
    put_text(out / "report.md", "\n".join(_page(config, folder, found, steps)) + "\n", out)
    return found


def _cells(items: Sequence[BenchmarkItem], runs: Mapping[str, Path]) -> list[list[object]]:
    """A row for each quantity, and one for all."""
    groups: dict[str, list[BenchmarkItem]] = defaultdict(list)
    for item in items:
        groups[", ".join(item.tags.get(CELL, ("",)))].append(item)
    means = {
        (name, who): scores_of(f"{run}:{who}").means(HELD_OUT) for name, run in runs.items() for who in (BEFORE, AFTER)
    }
    rows = list[list[object]]()
    for name, group in [*sorted(groups.items()), ("all", list(items))]:
        ids = [item.id for item in group]
        shown = [_share([means[key][each] for each in ids if each in means[key]]) for key in means]
        rows.append([name, len(group), *shown, _constant(group).shown])
    return rows


def _share(points: Sequence[float]) -> str:
    """The mean with Wilson's interval, in per cent; of several samples the interval is that of as many problems."""
    return wilson(round(sum(points)), len(points)).shown if points else "—"


def _constant(items: Sequence[BenchmarkItem]) -> Estimate:
    """What the constant that fits the answers best earns: each answer, and both ends of its tolerance, is tried."""
    numbers = list[float]()
    for item in items:
        answer = item.reference.get("answer")
        value, tolerance = (answer.get("value"), answer.get("tolerance")) if isinstance(answer, dict) else (None, None)
        if isinstance(value, float) and isinstance(tolerance, float):
            numbers += [value, (1.0 - INSIDE * tolerance) * value, (1.0 + INSIDE * tolerance) * value]
    best = 0
    for number in sorted(set(numbers)):
        said = f"\\boxed{{{number:.6g}}}"
        best = max(best, sum(SCORINGS[item.scoring].award(said, item.reference).points == 1.0 for item in items))
    return wilson(best, len(items))


def _as_json(found: TrainingReport) -> dict[str, JsonValue]:
    differences = {
        name: {**each._asdict(), "difference": each.difference._asdict()} for name, each in found.differences.items()
    }
    told = {"differences": differences, "cells": found.cells, "constant": found.constant._asdict()}
    return json.loads(json.dumps({**told, "overhead": found.overhead, "seconds": found.seconds}))


def _page(
    config: ReinforcementLearning, folder: TrainingFolder, found: TrainingReport, steps: Sequence[StepRecord]
) -> list[str]:
    lines = [f"# {config.out.name}", "", "Held-out accuracy in per cent, with 95 % intervals.", ""]
    head = [CELL, "problems", *(f"{name}, {who}" for name in TEMPERATURES for who in (BEFORE, AFTER)), "best constant"]
    lines += [*table(head, found.cells), ""]
    rows = [
        [name, f"{100 * each.first:.1f}", f"{100 * each.second:.1f}", each.difference.shown]
        for name, each in found.differences.items()
    ]
    lines += [*table(["responses", "before", "after", "paired difference"], rows), ""]
    cost = (
        f"{len(steps)} steps of {found.seconds:.1f} s; problems and rewards took {100 * found.overhead:.1f} % of that. "
        "The best constant is the one that suits these very problems best."
    )
    return [*lines, cost, "", *_corpora(folder), "![What each step measured](steps.png)"]


def _corpora(folder: TrainingFolder) -> list[str]:
    """Of what the warm start learned, and how much of it is wrong."""
    file = folder.warm_start / "corpora.json"
    if not file.is_file():
        return []
    try:
        held = json.loads(file.read_text("utf-8"))
        rows = [[each["kind"], each["rows"], f"{100 * each['wrong'] / each['rows']:.1f}"] for each in held]
    except (ValueError, KeyError, TypeError, ValidationError):
        raise TrainingError(f"{file}: damaged") from None
    return ["What the warm start learned from:", "", *table(["corpus", "rows", "wrong (%)"], rows), ""]

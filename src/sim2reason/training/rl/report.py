"""Report of a training run: accuracy on held-out problems before and after."""

import json
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from pydantic import JsonValue, ValidationError

from sim2reason.base.atomic_files import canonical, put_text
from sim2reason.errors import TrainingError
from sim2reason.evaluation.benchmarks import BenchmarkItem, load_items
from sim2reason.evaluation.benchmarks.own import Saved
from sim2reason.evaluation.benchmarks.runs.config import Evaluation
from sim2reason.evaluation.benchmarks.scoring import SCORINGS
from sim2reason.evaluation.policies import Policy, build_policy
from sim2reason.evaluation.reports.comparison import PairedDifference, compare, read_scores
from sim2reason.evaluation.reports.evaluation import evaluate
from sim2reason.evaluation.reports.pages import table
from sim2reason.evaluation.reports.results import Estimate, wilson_interval
from sim2reason.figures.run_plots import curves
from sim2reason.training.processes import AdvanceCallback, BeginCallback
from sim2reason.training.rl.config import ReinforcementLearning, TrainingFolder
from sim2reason.training.run_files import StepLog, StepRecord

__all__ = [
    "AFTER",
    "BEFORE",
    "CELL",
    "PANELS",
    "RESPONSES",
    "TrainingReport",
    "answer_before",
    "best_constant",
    "cells",
    "corpora_table",
    "evaluated",
    "evaluation_folders",
    "report_training",
]

BEFORE, AFTER = "before", "after"
RESPONSES = {"greedy": 0.0, "sampled": 1.0}
"""How responses are chosen, and at what temperature."""
CELL = "quantity"
TOLERANCE_FRACTION = 0.98  # fraction of a tolerance that is surely inside after rounding to six digits
MAX_CANDIDATES = 16  # candidate constants that are scored


def evaluation_folders(config: ReinforcementLearning) -> dict[str, Path]:
    """Return the evaluation folder for each method of choosing response tokens: greedy or sampled."""
    return {name: TrainingFolder(config.out).evaluation / name for name in RESPONSES}


def answer_before(config: ReinforcementLearning, begun: BeginCallback, advance: AdvanceCallback) -> None:
    """Evaluate the warm-started model, so that other runs of a study need not repeat it.

    Raises:
        PolicyError: it cannot be loaded.
    """
    if config.warm_start is not None and config.held_out:
        _asked(config, {BEFORE: (str(TrainingFolder(config.out).warm_start / "model"), None)}, begun, advance)


def evaluated(
    config: ReinforcementLearning, begun: BeginCallback, advance: AdvanceCallback
) -> dict[str, Sequence[BenchmarkItem]]:
    """Evaluate both models of a finished run; return the problems of each set by its name.

    Raises:
        TrainingError: the run is not finished, or holds no problems out.
        PolicyError: a model cannot be loaded.
    """
    folder = TrainingFolder(config.out)
    result = folder.result()
    if not config.held_out or result is None:
        raise TrainingError(f"{config.out}: no finished run with held_out problems; train it first")
    models = {BEFORE: (result.initial, result.revision), AFTER: (str(folder.model), None)}
    return {each.name: load_items(each) for each in _asked(config, models, begun, advance)}


def _asked(
    config: ReinforcementLearning,
    models: Mapping[str, tuple[str, str | None]],
    begun: BeginCallback,
    advance: AdvanceCallback,
) -> tuple[Saved, ...]:
    """Evaluate models on the held-out problems unless done before; return the held-out sets as benchmarks."""
    folder = TrainingFolder(config.out)
    sets = [(each.problems.name, each.samples) for each in config.held_out]
    benchmarks = tuple(Saved(name=name, file=folder.problems(name), samples=samples) for name, samples in sets)
    for name, out in evaluation_folders(config).items():
        temperature = RESPONSES[name]
        policies = tuple(_policy(config, each, *model, temperature) for each, model in models.items())
        once = tuple(each.model_copy(update={"samples": 1}) for each in benchmarks)
        evaluation = Evaluation(out=out, policies=policies, benchmarks=benchmarks if temperature else once)
        evaluate(evaluation, begun=lambda total, name=name: begun(f"answers, {name}", total), advance=advance)
    return benchmarks


def _policy(config: ReinforcementLearning, name: str, model: str, revision: str | None, temperature: float) -> Policy:
    settings = config.evaluation_policy
    sampling = {**settings["sampling"], "temperature": temperature}
    return build_policy({**settings, "name": name, "model": model, "revision": revision, "sampling": sampling}, name)


def cells(name: str, items: Sequence[BenchmarkItem], runs: Mapping[str, Path]) -> list[list[object]]:
    """Return table rows per quantity and in total: problems, accuracies before and after, best constant."""
    groups: dict[str, list[BenchmarkItem]] = defaultdict(list)
    for item in items:
        groups[", ".join(item.tags.get(CELL, ("",)))].append(item)
    means = [read_scores(f"{run}:{who}").means(name) for run in runs.values() for who in (BEFORE, AFTER)]
    rows = list[list[object]]()
    for cell, group in [*sorted(groups.items()), ("all", list(items))]:
        shown = [_share([run_means[item.id] for item in group if item.id in run_means]) for run_means in means]
        rows.append([cell, len(group), *shown, best_constant(group).shown])
    return rows


def _share(points: Sequence[float]) -> str:
    """Return a mean with Wilson's interval for as many trials as problems, in per cent."""
    return wilson_interval(round(sum(points)), len(points)).shown if points else "—"


def best_constant(items: Sequence[BenchmarkItem]) -> Estimate:
    """Return the accuracy of the best constant answer: the one number that answers most problems correctly.

    Candidates are the answers and both ends of their tolerances; those within the most tolerances are scored.
    """
    best = 0
    for number in _promising(items):
        response = f"\\boxed{{{number:.6g}}}"
        best = max(best, sum(SCORINGS[item.scoring].award(response, item.reference).points == 1.0 for item in items))
    return wilson_interval(best, len(items))


def _promising(items: Sequence[BenchmarkItem]) -> list[float]:
    """Return a few numbers that lie within the tolerances of the most answers, as candidates for a constant answer."""
    known = [(value, tolerance) for value, tolerance in map(_answer, items) if value is not None]
    values, tolerances = np.array(known, dtype=float).reshape(-1, 2).T
    widths = tolerances * np.abs(values)
    numbers = np.unique(
        np.concatenate([values, values - TOLERANCE_FRACTION * widths, values + TOLERANCE_FRACTION * widths])
    )
    begun = np.searchsorted(np.sort(values - widths), numbers, side="right")
    ended = np.searchsorted(np.sort(values + widths), numbers, side="left")
    return numbers[np.argsort(ended - begun, kind="stable")][:MAX_CANDIDATES].tolist()


def _answer(item: BenchmarkItem) -> tuple[float | None, float]:
    """Return the value and tolerance of a numeric answer; None for a formula."""
    answer = item.reference.get("answer")
    if not isinstance(answer, dict) or answer.get("formula") is not None or answer.get("parts"):
        return None, 0.0
    value, tolerance = answer.get("value"), answer.get("tolerance")
    return (value, tolerance) if isinstance(value, float) and isinstance(tolerance, float) else (None, 0.0)


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
PLOT = "![What each step measured](steps.png)"


class TrainingReport(NamedTuple):
    """The contents of the report page."""

    differences: dict[str, list[PairedDifference]]
    """After less before, of each set, by how responses were chosen: ``greedy`` and ``sampled``."""
    cells: dict[str, list[list[object]]]
    """Of each set the rows of its table: cell, problems, accuracies before and after with intervals, best constant."""
    constants: dict[str, Estimate]
    """Of each set the accuracy of the constant that suits these very problems best."""
    overhead: float
    """The share of the steps' time for which they waited for problems and rewards."""
    problems: float
    """CPU time for each step that other processes spent on making problems, s; nobody waited for it."""
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

    Without held-out problems the report contains only the metrics of the steps.

    Raises:
        TrainingError: the run is not finished.
        PolicyError: a model cannot be loaded.
    """
    folder = TrainingFolder(config.out)
    if folder.result() is None:
        raise TrainingError(f"{config.out}: no finished run; train it first")
    sets = evaluated(config, begun, advance) if config.held_out else {}
    out = folder.report.parent
    out.mkdir(exist_ok=True)
    steps = StepLog(folder.train).read()
    report = _found(config, sets, steps, out)
    series = {title: {config.out.name: [getattr(step, name) for step in steps]} for name, title in PANELS.items()}
    curves(out / "steps.png", series)
    put_text(out / "report.md", "\n".join(_page(config, folder, report, steps)) + "\n", out)
    put_text(folder.report, canonical(_as_json(report)), out)  # the last: with it the run is whole
    return report


def _found(
    config: ReinforcementLearning,
    sets: Mapping[str, Sequence[BenchmarkItem]],
    steps: Sequence[StepRecord],
    out: Path,
) -> TrainingReport:
    runs, total = evaluation_folders(config) if sets else {}, sum(step.seconds.step for step in steps)
    return TrainingReport(
        differences={name: compare(f"{run}:{BEFORE}", f"{run}:{AFTER}") for name, run in runs.items()},
        cells={name: cells(name, items, runs) for name, items in sets.items()},
        constants={name: best_constant(items) for name, items in sets.items()},
        overhead=sum(step.seconds.reward + step.seconds.drawing for step in steps) / total if total else 0.0,
        problems=sum(step.seconds.problems for step in steps) / max(len(steps), 1),
        seconds=total / max(len(steps), 1),
        folder=out,
    )


def _as_json(report: TrainingReport) -> dict[str, JsonValue]:
    differences = {
        name: [{**each._asdict(), "difference": each.difference._asdict()} for each in paired]
        for name, paired in report.differences.items()
    }
    constants = {name: each._asdict() for name, each in report.constants.items()}
    results = {"differences": differences, "cells": report.cells, "constants": constants}
    cost = {"overhead": report.overhead, "problems": report.problems, "seconds": report.seconds}
    return json.loads(json.dumps({**results, **cost}))


def _page(
    config: ReinforcementLearning, folder: TrainingFolder, report: TrainingReport, steps: Sequence[StepRecord]
) -> list[str]:
    cost = (
        f"{len(steps)} steps of {report.seconds:.1f} s; for {100 * report.overhead:.1f} % of that they waited for "
        f"problems and rewards. Making problems took other processes {report.problems:.1f} s of CPU time a step."
    )
    learned = ["What the warm start learned from:", "", *corpora_table(folder), ""] if folder.learned.is_file() else []
    return [f"# {config.out.name}", "", *(_accuracies(report) if report.cells else []), cost, "", *learned, PLOT]


def _accuracies(report: TrainingReport) -> list[str]:
    """Return the lines on accuracy on held-out problems."""
    lines = ["Held-out accuracy in per cent, with 95 % intervals."]
    head = [CELL, "problems", *(f"{name}, {who}" for name in RESPONSES for who in (BEFORE, AFTER)), "best constant"]
    for name, rows in report.cells.items():
        lines += ["", f"Problems *{name}*:", "", *table(head, rows)]
    rows = [
        [name, each.benchmark, f"{100 * each.first:.1f}", f"{100 * each.second:.1f}", each.difference.shown]
        for name, paired in report.differences.items()
        for each in paired
    ]
    lines += ["", *table(["responses", "problems", "before", "after", "paired difference"], rows), ""]
    return [*lines, "The best constant is the one that suits these very problems best.", ""]


def corpora_table(folder: TrainingFolder) -> list[str]:
    """Return a table of the warm start's corpora with their fractions of wrong solutions."""
    try:
        records = json.loads(folder.learned.read_text("utf-8"))
        rows = [[each["kind"], each["rows"], f"{100 * each['wrong'] / each['rows']:.1f}"] for each in records]
    except (ValueError, KeyError, TypeError, ValidationError):
        raise TrainingError(f"{folder.learned}: damaged") from None
    return list(table(["corpus", "rows", "wrong (%)"], rows))

"""What training has done: held-out accuracy before and after, beside the best constant and the run's own measures.

RUN/report/report.md, report.json, steps.png    all of it on a page
"""

import json
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from pydantic import JsonValue, ValidationError

from sim2reason.benchmarks import BenchmarkItem
from sim2reason.datasets.atomic_files import canonical, put_text
from sim2reason.errors import TrainingError
from sim2reason.figures.training_plots import curves
from sim2reason.reports.comparison import PairedDifference, compare
from sim2reason.reports.held_out import AFTER, BEFORE, CELL, RESPONSES, answered, best_constant, cells, evaluated
from sim2reason.reports.markdown import table
from sim2reason.reports.statistics import Estimate
from sim2reason.training.gspo.step_log import StepLog, StepRecord
from sim2reason.training.rl.config import ReinforcementLearning
from sim2reason.training.rl.folder import TrainingFolder

__all__ = ["PANELS", "TrainingReport", "corpora_of", "report_training"]

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
    """What stands on the page."""

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

    Where none are held out it has what the steps measured alone.

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
    found = _found(config, sets, steps, out)
    series = {title: {config.out.name: [getattr(step, name) for step in steps]} for name, title in PANELS.items()}
    curves(out / "steps.png", series)
    put_text(out / "report.md", "\n".join(_page(config, folder, found, steps)) + "\n", out)
    put_text(folder.report, canonical(_as_json(found)), out)  # the last: with it the run is whole
    return found


def _found(
    config: ReinforcementLearning,
    sets: Mapping[str, Sequence[BenchmarkItem]],
    steps: Sequence[StepRecord],
    out: Path,
) -> TrainingReport:
    runs, total = answered(config) if sets else {}, sum(step.seconds.step for step in steps)
    return TrainingReport(
        differences={name: compare(f"{run}:{BEFORE}", f"{run}:{AFTER}") for name, run in runs.items()},
        cells={name: cells(name, items, runs) for name, items in sets.items()},
        constants={name: best_constant(items) for name, items in sets.items()},
        overhead=sum(step.seconds.reward + step.seconds.drawing for step in steps) / total if total else 0.0,
        problems=sum(step.seconds.problems for step in steps) / max(len(steps), 1),
        seconds=total / max(len(steps), 1),
        folder=out,
    )


def _as_json(found: TrainingReport) -> dict[str, JsonValue]:
    differences = {
        name: [{**each._asdict(), "difference": each.difference._asdict()} for each in held]
        for name, held in found.differences.items()
    }
    constants = {name: each._asdict() for name, each in found.constants.items()}
    told = {"differences": differences, "cells": found.cells, "constants": constants}
    cost = {"overhead": found.overhead, "problems": found.problems, "seconds": found.seconds}
    return json.loads(json.dumps({**told, **cost}))


def _page(
    config: ReinforcementLearning, folder: TrainingFolder, found: TrainingReport, steps: Sequence[StepRecord]
) -> list[str]:
    cost = (
        f"{len(steps)} steps of {found.seconds:.1f} s; for {100 * found.overhead:.1f} % of that they waited for "
        f"problems and rewards. Making problems took other processes {found.problems:.1f} s of CPU time a step."
    )
    learned = ["What the warm start learned from:", "", *corpora_of(folder), ""] if folder.learned.is_file() else []
    return [f"# {config.out.name}", "", *(_accuracies(found) if found.cells else []), cost, "", *learned, PLOT]


def _accuracies(found: TrainingReport) -> list[str]:
    """On held-out problems."""
    lines = ["Held-out accuracy in per cent, with 95 % intervals."]
    head = [CELL, "problems", *(f"{name}, {who}" for name in RESPONSES for who in (BEFORE, AFTER)), "best constant"]
    for name, rows in found.cells.items():
        lines += ["", f"Problems *{name}*:", "", *table(head, rows)]
    rows = [
        [name, each.benchmark, f"{100 * each.first:.1f}", f"{100 * each.second:.1f}", each.difference.shown]
        for name, held in found.differences.items()
        for each in held
    ]
    lines += ["", *table(["responses", "problems", "before", "after", "paired difference"], rows), ""]
    return [*lines, "The best constant is the one that suits these very problems best.", ""]


def corpora_of(folder: TrainingFolder) -> list[str]:
    """A table of what the warm start learned from, and how much of it is wrong; TrainingError if it is damaged."""
    try:
        held = json.loads(folder.learned.read_text("utf-8"))
        rows = [[each["kind"], each["rows"], f"{100 * each['wrong'] / each['rows']:.1f}"] for each in held]
    except (ValueError, KeyError, TypeError, ValidationError):
        raise TrainingError(f"{folder.learned}: damaged") from None
    return list(table(["corpus", "rows", "wrong (%)"], rows))

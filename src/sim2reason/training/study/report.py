"""Report of a study: held-out accuracy of each run before and after, and of each arm over its seeds.

OUT/report/report.md, report.json, steps.png    all of it on a page
"""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from pydantic import JsonValue

from sim2reason.base.atomic_files import canonical, put_text
from sim2reason.errors import TrainingError
from sim2reason.evaluation.benchmarks import BenchmarkItem, load_items
from sim2reason.evaluation.benchmarks.own import Saved
from sim2reason.evaluation.reports.comparison import read_scores
from sim2reason.evaluation.reports.pages import table
from sim2reason.evaluation.reports.results import Estimate, difference, item_mean
from sim2reason.figures.run_plots import curves
from sim2reason.training.rl.config import TrainingFolder
from sim2reason.training.rl.report import (
    AFTER,
    BEFORE,
    PANELS,
    PLOT,
    RESPONSES,
    best_constant,
    corpora_table,
    evaluation_folders,
)
from sim2reason.training.run_files import StepLog
from sim2reason.training.study.config import Arm, TrainingStudy

__all__ = ["ArmGain", "RunAccuracy", "StudyReport", "report_study"]

Means = Mapping[str, float]
"""The mean points of each problem."""


class RunAccuracy(NamedTuple):
    """The accuracy of one run on one held-out set before and after training, for greedy or sampled responses."""

    problems: str
    responses: str
    arm: str
    seed: int
    before: Estimate
    after: Estimate
    gain: Estimate
    """After less before, problem by problem."""


class ArmGain(NamedTuple):
    """The gain in accuracy of an arm by training; a problem's points are means over the arm's seeds."""

    problems: str
    responses: str
    arm: str
    before: float
    after: float
    gain: Estimate
    lowest: float
    highest: float
    """The gains of single seeds reach from the one to the other."""
    against: Estimate | None
    """By how much its accuracy after training exceeds that of the first arm; None for that itself."""


class StudyReport(NamedTuple):
    """The contents of the report page."""

    runs: list[RunAccuracy]
    arms: list[ArmGain]
    constants: dict[str, Estimate]
    """Of each set the accuracy of the constant that suits these very problems best."""
    folder: Path


def report_study(study: TrainingStudy) -> StudyReport:
    """Combine the reports of all runs; TrainingError if one is unfinished or has no held-out problems."""
    first = study.first(study.runs[0].name)
    if not first.held_out or any(TrainingFolder(each.out).result() is None for each in study.configs.values()):
        raise TrainingError(f"{study.out}: runs without held_out problems, or not finished; train them first")
    runs, arms, constants = list[RunAccuracy](), list[ArmGain](), dict[str, Estimate]()
    for name in (each.problems.name for each in first.held_out):
        constants[name] = best_constant(_problems(name, TrainingFolder(first.out)))
        for responses in RESPONSES:
            means_by_arm = {arm: _points(study, arm, responses, name) for arm in study.runs}
            runs += [_run(name, responses, arm, *points) for arm, points in means_by_arm.items()]
            arms += _arms(study, name, responses, means_by_arm)
    report = StudyReport(runs, arms, constants, study.out / "report")
    _write(study, report)
    return report


def _problems(name: str, folder: TrainingFolder) -> Sequence[BenchmarkItem]:
    return load_items(Saved(name=name, file=folder.problems(name)))


def _points(study: TrainingStudy, arm: Arm, responses: str, name: str) -> tuple[Means, Means]:
    """Return the mean points of each held-out problem before and after training, for one run of a study."""
    run = evaluation_folders(study.configs[arm])[responses]
    before, after = (read_scores(f"{run}:{who}").means(name) for who in (BEFORE, AFTER))
    return before, after


def _run(name: str, responses: str, arm: Arm, before: Means, after: Means) -> RunAccuracy:
    first, last = ([points[item] for item in sorted(points)] for points in (before, after))
    shares = [item_mean([[each] for each in points]) for points in (first, last)]
    return RunAccuracy(name, responses, arm.name, arm.seed, shares[0], shares[1], difference(first, last))


def _arms(
    study: TrainingStudy, name: str, responses: str, means_by_arm: Mapping[Arm, tuple[Means, Means]]
) -> list[ArmGain]:
    arm_gains, reference = list[ArmGain](), None
    for arm in study.arms:
        runs = [means_by_arm[Arm(arm, seed)] for seed in study.seeds_of(arm)]
        before, after = (_over_seeds([run[which] for run in runs]) for which in (0, 1))
        gains = [float(np.mean(_values(run[1])) - np.mean(_values(run[0]))) for run in runs]
        against = None if reference is None else difference(reference, after)
        reference = after if reference is None else reference
        means = float(np.mean(before)), float(np.mean(after))
        arm_gains.append(
            ArmGain(name, responses, arm, *means, difference(before, after), min(gains), max(gains), against)
        )
    return arm_gains


def _values(means: Means) -> list[float]:
    """Return the points of all problems, ordered by the problems' names."""
    return [means[item] for item in sorted(means)]


def _over_seeds(runs: Sequence[Means]) -> list[float]:
    """Return the mean points of each problem over the runs of an arm with different seeds."""
    return [float(mean) for mean in np.mean([_values(run) for run in runs], axis=0)]


def _write(study: TrainingStudy, report: StudyReport) -> None:
    out = report.folder
    out.mkdir(exist_ok=True)
    curves(out / "steps.png", {title: _series(study, name) for name, title in PANELS.items()})
    put_text(out / "report.json", canonical(_as_json(report)), out)
    put_text(out / "report.md", "\n".join(_page(study, report)) + "\n", out)


def _series(study: TrainingStudy, name: str) -> dict[str, list[float | None]]:
    """Return, by arm of a study, the values of a logged quantity at each step: means over the arm's seeds."""
    series: dict[str, list[float | None]] = {}
    for arm in study.arms:
        logs = [StepLog(TrainingFolder(study.configs[Arm(arm, seed)].out).train).read() for seed in study.seeds_of(arm)]
        columns = [[getattr(step, name) for step in log] for log in logs]
        series[arm] = [_mean([each for each in row if each is not None]) for row in zip(*columns, strict=False)]
    return series


def _mean(values: Sequence[float]) -> float | None:
    return sum(values) / len(values) if values else None


def _as_json(report: StudyReport) -> dict[str, JsonValue]:
    def told(row: NamedTuple) -> dict[str, object]:
        entries = row._asdict()
        return {name: value._asdict() if isinstance(value, Estimate) else value for name, value in entries.items()}

    constants = {name: each._asdict() for name, each in report.constants.items()}
    rows = {"runs": [told(row) for row in report.runs], "arms": [told(row) for row in report.arms]}
    return json.loads(json.dumps({**rows, "constants": constants}))


def _page(study: TrainingStudy, report: StudyReport) -> list[str]:
    lines = [f"# {study.out.name}", "", "Held-out accuracy in per cent, with 95 % intervals over the problems."]
    head = ["arm", "responses", "before", "after", "gain", "gains of single seeds", "more than the first arm"]
    seeds = ["arm", "seed", "responses", "before", "after", "gain"]
    for name, constant in report.constants.items():
        rows = [
            [
                each.arm,
                each.responses,
                f"{100 * each.before:.1f}",
                f"{100 * each.after:.1f}",
                each.gain.shown,
                f"{100 * each.lowest:.1f} to {100 * each.highest:.1f}",
                "" if each.against is None else each.against.shown,
            ]
            for each in report.arms
            if each.problems == name
        ]
        caption = f"Problems *{name}*; the constant that suits them best has {constant.shown}. Means over the seeds:"
        lines += ["", caption, "", *table(head, rows), "", "Each run:", ""]
        single = [
            [each.arm, each.seed, each.responses, each.before.shown, each.after.shown, each.gain.shown]
            for each in report.runs
            if each.problems == name
        ]
        lines += table(seeds, single)
    return [*lines, "", *_corpora(study), PLOT]


def _corpora(study: TrainingStudy) -> list[str]:
    """Return the lines on the corpora of each arm's warm start; arms with equal ones are merged."""
    arms: dict[str, list[str]] = {}
    for arm in study.arms:
        folder = TrainingFolder(study.first(arm).out)
        if folder.learned.is_file():
            arms.setdefault("\n".join(corpora_table(folder)), []).append(arm)
    return [
        line
        for corpora_text, names in arms.items()
        for line in (f"Warm start of {', '.join(names)}:", "", corpora_text, "")
    ]

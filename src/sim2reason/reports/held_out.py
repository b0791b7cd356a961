"""Held-out problems of a run of training, answered by the model before and after.

RUN/evaluation/greedy, RUN/evaluation/sampled   evaluations, each of both models on all sets
"""

from collections import defaultdict
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from sim2reason.benchmarks import BenchmarkItem, items_of
from sim2reason.benchmarks.runs.config import Evaluation
from sim2reason.benchmarks.saved import Saved
from sim2reason.benchmarks.scoring import SCORINGS
from sim2reason.errors import TrainingError
from sim2reason.policies import Policy, policy_from
from sim2reason.reports.evaluation import evaluate
from sim2reason.reports.scores import scores_of
from sim2reason.reports.statistics import Estimate, wilson
from sim2reason.training.processes import Advance, Begun
from sim2reason.training.rl.config import ReinforcementLearning
from sim2reason.training.rl.folder import TrainingFolder

__all__ = ["AFTER", "BEFORE", "CELL", "RESPONSES", "answer_before", "answered", "best_constant", "cells", "evaluated"]

BEFORE, AFTER = "before", "after"
RESPONSES = {"greedy": 0.0, "sampled": 1.0}
"""How responses are chosen, and at what temperature."""
CELL = "quantity"
INSIDE = 0.98  # of a tolerance: what is surely inside it when written with six digits
PROMISING = 16  # constants that are scored: more than enough for what rounding decides


def answered(config: ReinforcementLearning) -> dict[str, Path]:
    """The folder of the evaluation for each way to choose responses."""
    return {name: TrainingFolder(config.out).evaluation / name for name in RESPONSES}


def answer_before(config: ReinforcementLearning, begun: Begun, advance: Advance) -> None:
    """Let the result of a warm start answer, which `evaluated` and other runs of a study need not ask again then.

    Raises:
        PolicyError: it cannot be loaded.
    """
    if config.warm_start is not None and config.held_out:
        _asked(config, {BEFORE: (str(TrainingFolder(config.out).warm_start / "model"), None)}, begun, advance)


def evaluated(config: ReinforcementLearning, begun: Begun, advance: Advance) -> dict[str, Sequence[BenchmarkItem]]:
    """Let both models of a finished run answer; the problems of each set, by its name.

    Raises:
        TrainingError: the run is not finished, or holds no problems out.
        PolicyError: a model cannot be loaded.
    """
    folder = TrainingFolder(config.out)
    result = folder.result()
    if not config.held_out or result is None:
        raise TrainingError(f"{config.out}: no finished run with held_out problems; train it first")
    models = {BEFORE: (result.initial, result.revision), AFTER: (str(folder.model), None)}
    return {each.name: items_of(each) for each in _asked(config, models, begun, advance)}


def _asked(
    config: ReinforcementLearning, models: Mapping[str, tuple[str, str | None]], begun: Begun, advance: Advance
) -> tuple[Saved, ...]:
    """Let models, each with its revision, answer as far as they have not; what was asked."""
    folder = TrainingFolder(config.out)
    sets = [(each.problems.name, each.samples) for each in config.held_out]
    benchmarks = tuple(Saved(name=name, file=folder.problems(name), samples=samples) for name, samples in sets)
    for name, out in answered(config).items():
        temperature = RESPONSES[name]
        policies = tuple(_policy(config, each, *model, temperature) for each, model in models.items())
        once = tuple(each.model_copy(update={"samples": 1}) for each in benchmarks)
        asked = Evaluation(out=out, policies=policies, benchmarks=benchmarks if temperature else once)
        evaluate(asked, begun=lambda total, name=name: begun(f"answers, {name}", total), advance=advance)
    return benchmarks


def _policy(config: ReinforcementLearning, name: str, model: str, revision: str | None, temperature: float) -> Policy:
    settings = config.evaluation_policy
    sampling = {**settings["sampling"], "temperature": temperature}
    return policy_from({**settings, "name": name, "model": model, "revision": revision, "sampling": sampling}, name)


def cells(name: str, items: Sequence[BenchmarkItem], runs: Mapping[str, Path]) -> list[list[object]]:
    """A row for each quantity of a set, and one for all: problems, accuracies before and after, best constant."""
    groups: dict[str, list[BenchmarkItem]] = defaultdict(list)
    for item in items:
        groups[", ".join(item.tags.get(CELL, ("",)))].append(item)
    means = [scores_of(f"{run}:{who}").means(name) for run in runs.values() for who in (BEFORE, AFTER)]
    rows = list[list[object]]()
    for cell, group in [*sorted(groups.items()), ("all", list(items))]:
        shown = [_share([held[item.id] for item in group if item.id in held]) for held in means]
        rows.append([cell, len(group), *shown, best_constant(group).shown])
    return rows


def _share(points: Sequence[float]) -> str:
    """The mean with Wilson's interval, in per cent; of several samples the interval is that of as many problems."""
    return wilson(round(sum(points)), len(points)).shown if points else "—"


def best_constant(items: Sequence[BenchmarkItem]) -> Estimate:
    """What the constant that fits the answers best earns, by their own scoring.

    Each answer, and both ends of its tolerance, may be it; those are scored that lie within most tolerances.
    """
    best = 0
    for number in _promising(items):
        said = f"\\boxed{{{number:.6g}}}"
        best = max(best, sum(SCORINGS[item.scoring].award(said, item.reference).points == 1.0 for item in items))
    return wilson(best, len(items))


def _promising(items: Sequence[BenchmarkItem]) -> list[float]:
    """Numbers that lie within the tolerances of as many answers as any; few, for scoring all would take minutes."""
    known = [(value, tolerance) for value, tolerance in map(_answer, items) if value is not None]
    values, tolerances = np.array(known, dtype=float).reshape(-1, 2).T
    widths = tolerances * np.abs(values)
    numbers = np.unique(np.concatenate([values, values - INSIDE * widths, values + INSIDE * widths]))
    begun = np.searchsorted(np.sort(values - widths), numbers, side="right")
    ended = np.searchsorted(np.sort(values + widths), numbers, side="left")
    return numbers[np.argsort(ended - begun, kind="stable")][:PROMISING].tolist()


def _answer(item: BenchmarkItem) -> tuple[float | None, float]:
    """Value and tolerance of an answer, if it is a number and no formula."""
    answer = item.reference.get("answer")
    if not isinstance(answer, dict) or answer.get("formula") is not None or answer.get("parts"):
        return None, 0.0
    value, tolerance = answer.get("value"), answer.get("tolerance")
    return (value, tolerance) if isinstance(value, float) and isinstance(tolerance, float) else (None, 0.0)

"""Comparisons of policies, correlations between benchmarks, and folders for these results."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from pydantic import ValidationError

from sim2reason.base.atomic_files import canonical, put_text
from sim2reason.errors import EvaluationError, MissingExtraError
from sim2reason.evaluation.benchmarks.own import SYNTHETIC
from sim2reason.evaluation.benchmarks.runs.config import RunFolder
from sim2reason.evaluation.benchmarks.runs.run import SampleOutcome
from sim2reason.evaluation.reports.evaluation import SCORES
from sim2reason.evaluation.reports.pages import table
from sim2reason.evaluation.reports.results import Estimate, difference, item_mean, rank_correlation
from sim2reason.figures.run_plots import Bar, Point, scatter

__all__ = [
    "PairedDifference",
    "PolicyScores",
    "RankCorrelation",
    "all_scores",
    "compare",
    "correlate",
    "own_folder",
    "read_scores",
]


@dataclass(frozen=True)
class PolicyScores:
    """The points of one policy by benchmark and problem: a list with one number per sample of a problem."""

    name: str
    run: RunFolder
    points: dict[str, dict[str, list[float]]]

    def means(self, benchmark: str) -> dict[str, float]:
        """Return the mean points of each problem of a benchmark."""
        return {
            item: sum(item_points) / len(item_points) for item, item_points in self.points.get(benchmark, {}).items()
        }


def _outcomes(folder: RunFolder) -> Iterator[SampleOutcome]:
    path = folder.report / SCORES
    if not path.is_file():
        raise EvaluationError(f"{folder.path}: has no report; give its sim2reason eval again")
    with path.open("rb") as lines:
        for count, line in enumerate(lines, start=1):
            try:
                yield SampleOutcome.model_validate_json(line)
            except ValidationError:
                raise EvaluationError(f"{path}:{count}: damaged; give its sim2reason eval again") from None


def all_scores(run: Path | str) -> list[PolicyScores]:
    """Return the scores of every policy of a run; EvaluationError if it has no report."""
    folder = RunFolder(Path(run))
    points: dict[str, dict[str, dict[str, list[float]]]] = {name: {} for name in folder.record.policies}
    for outcome in _outcomes(folder):
        points[outcome.policy].setdefault(outcome.benchmark, {}).setdefault(outcome.id, []).append(outcome.points)
    return [PolicyScores(name, folder, policy_points) for name, policy_points in points.items()]


def read_scores(address: str) -> PolicyScores:
    """Return the scores of one policy, given as RUN if that has only one, or RUN:POLICY.

    EvaluationError if there is no such run or policy, or if there are several and none is named.
    """
    run, name = address, ""
    if not Path(address).exists() and ":" in address:
        run, _, name = address.rpartition(":")
    candidates = all_scores(run)
    chosen = [scores for scores in candidates if name in {"", scores.name}]
    if len(chosen) != 1:
        there = ", ".join(scores.name for scores in candidates)
        raise EvaluationError(f"{address}: which policy? give {run}:NAME, with one of {there}")
    return chosen[0]


def own_folder(out: Path, result: str) -> None:
    """Create the folder; EvaluationError if it contains files but none named `result`."""
    out.mkdir(parents=True, exist_ok=True)
    if not (out / result).is_file() and (strangers := sorted(path.name for path in out.iterdir())):
        raise EvaluationError(f"{out}: holds {strangers[0]} and no {result}; choose a new folder")


COMPARISON_FILE = "compare.json"


class PairedDifference(NamedTuple):
    """The difference of two policies' mean points (second minus first) over the problems that both answered."""

    benchmark: str
    items: int
    first: float
    second: float
    difference: Estimate
    better: int
    """Problems with more points for the second."""
    worse: int


def compare(first: str | Path, second: str | Path, out: Path | None = None) -> list[PairedDifference]:
    """Compare two policies on every benchmark that both answered; each is RUN or RUN:POLICY.

    With `out`, a folder, the result is written there as ``compare.json`` and ``compare.md``.

    Raises:
        EvaluationError: no such run or policy, no benchmark in common, other problems under the same name, or a folder
            that holds something else.
    """
    mine, theirs = read_scores(str(first)), read_scores(str(second))
    common = [name for name in mine.points if name in theirs.points]
    if not common:
        raise EvaluationError(f"{first} and {second} have answered no benchmark of the same name")
    pairs = [_pair(mine, theirs, name) for name in common]
    if out is not None:
        _write_comparison(out, str(first), str(second), pairs)
    return pairs


def _pair(mine: PolicyScores, theirs: PolicyScores, benchmark: str) -> PairedDifference:
    plans = [scores.run.record.benchmarks[benchmark].data for scores in (mine, theirs)]
    if plans[0] != plans[1]:
        raise EvaluationError(f"benchmark {benchmark}: the two runs have other problems; compare the same ones")
    one, other = mine.means(benchmark), theirs.means(benchmark)
    items = sorted(one.keys() & other.keys())
    if not items:
        raise EvaluationError(f"benchmark {benchmark}: no problem that both have answered")
    a, b = [one[item] for item in items], [other[item] for item in items]
    return PairedDifference(
        benchmark,
        len(items),
        sum(a) / len(a),
        sum(b) / len(b),
        difference(a, b),
        sum(y > x for x, y in zip(a, b, strict=True)),
        sum(y < x for x, y in zip(a, b, strict=True)),
    )


def rows(pairs: list[PairedDifference]) -> list[list[object]]:
    """Return table rows of the differences, in per cent."""
    return [
        [o.benchmark, o.items, f"{100 * o.first:.1f}", f"{100 * o.second:.1f}", o.difference.shown, o.better, o.worse]
        for o in pairs
    ]


HEAD = "benchmark", "problems", "first", "second", "difference", "better", "worse"


def _write_comparison(out: Path, first: str, second: str, pairs: list[PairedDifference]) -> None:
    own_folder(out, COMPARISON_FILE)
    records = [{**one._asdict(), "difference": one.difference._asdict()} for one in pairs]
    put_text(out / COMPARISON_FILE, canonical({"first": first, "second": second, "benchmarks": records}), out)
    lines = [
        "# Paired comparison",
        "",
        f"First: `{first}`. Second: `{second}`. Accuracies and differences in per cent;",
    ]
    lines += ["95 % interval by a bootstrap over the problems that both answered.", ""]
    put_text(out / "compare.md", "\n".join([*lines, *table(HEAD, rows(pairs)), ""]), out)


MIN_MODELS = 3  # models
CORRELATION_FILE = "correlate.json"


class RankCorrelation(NamedTuple):
    """Spearman's ρ of two benchmarks over models."""

    across: str
    up: str
    models: tuple[str, ...]
    rho: Estimate | None
    """None where all models are alike on one of them."""
    x: tuple[Estimate, ...]
    y: tuple[Estimate, ...]


def correlate(
    runs: Sequence[Path | str], across: str | None = None, up: Sequence[str] = (), out: Path | None = None
) -> list[RankCorrelation]:
    """Correlate accuracy on the benchmark `across`, by default the synthetic one, with that on each of `up`.

    A model is a policy of one of the runs; those with both benchmarks count. With `out`, a folder, the result is
    written there as ``correlate.json``, ``correlate.md`` and a scatter plot each.

    Raises:
        EvaluationError: a run that stands twice, no such benchmark, one with itself, fewer than three models, other
            problems under the same name, or a folder that holds something else.
    """
    places = [Path(run).resolve() for run in runs]
    if twice := [run for run, path in zip(runs, places, strict=True) if places.count(path) > 1]:
        raise EvaluationError(f"{twice[0]}: this run stands twice; give each once, its models count once")
    models = [scores for run in runs for scores in all_scores(run)]
    across = across or _synthetic(models)
    there = sorted({name for scores in models for name in scores.points})
    others = list(dict.fromkeys(up)) or [name for name in there if name != across]
    if unknown := [name for name in (across, *others) if name not in there]:
        raise EvaluationError(f"no benchmark {unknown[0]!r} in these runs; there are: {', '.join(there)}")
    if across in others:
        raise EvaluationError(f"{across} lies across; correlate it with others: {', '.join(there)}")
    if not others:
        raise EvaluationError(f"these runs have answered no benchmark but {across}")
    correlations = [_correlation(models, across, other) for other in others]
    if out is not None:
        _write_correlation(out, correlations)
    return correlations


def _synthetic(models: Sequence[PolicyScores]) -> str:
    names = {name for scores in models for name, plan in scores.run.record.benchmarks.items() if plan.kind == SYNTHETIC}
    if len(names) != 1:
        raise EvaluationError("which benchmark shall lie across? these runs have not just one synthetic one; name it")
    return names.pop()


def _correlation(models: Sequence[PolicyScores], across: str, up: str) -> RankCorrelation:
    both = [scores for scores in models if scores.points.get(across) and scores.points.get(up)]
    if len(both) < MIN_MODELS:
        raise EvaluationError(f"{across} and {up}: {len(both)} models have answered both; it takes {MIN_MODELS}")
    for name in (across, up):
        if len({scores.run.record.benchmarks[name].data for scores in both}) > 1:
            raise EvaluationError(f"benchmark {name}: the runs have other problems; correlate the same ones")
    x, y = (tuple(item_mean(list(s.points[name].values())) for s in both) for name in (across, up))
    rho = rank_correlation([each.value for each in x], [each.value for each in y])
    return RankCorrelation(across, up, tuple(s.name for s in both), rho, x, y)


def correlation_text(correlation: RankCorrelation) -> str:
    """Return ρ as readable text."""
    rho = correlation.rho
    return "none" if rho is None else f"{rho.value:.2f} [{rho.low:.2f}, {rho.high:.2f}]"


def _write_correlation(out: Path, correlations: Sequence[RankCorrelation]) -> None:
    own_folder(out, CORRELATION_FILE)
    listed = [
        {**each._asdict(), "rho": each.rho and each.rho._asdict()}
        | {side: [one._asdict() for one in getattr(each, side)] for side in ("x", "y")}
        for each in correlations
    ]
    put_text(out / CORRELATION_FILE, canonical(listed), out)
    lines = [
        "# Rank correlation across models",
        "",
        "Spearman's ρ with its 95 % interval (Bonett and Wright, 2000).",
        "",
    ]
    lines += table(
        ["across", "up", "models", "ρ"], [[f.across, f.up, len(f.models), correlation_text(f)] for f in correlations]
    )
    for each in correlations:
        rows = zip(each.models, (one.shown for one in each.x), (one.shown for one in each.y), strict=True)
        lines += ["", *table(["model", each.across, each.up], rows)]
        if (name := _picture(out, each)) is not None:
            lines += ["", f"![{each.across} and {each.up}]({name})"]
    put_text(out / "correlate.md", "\n".join([*lines, ""]), out)


def _picture(out: Path, correlation: RankCorrelation) -> str | None:
    name = f"{correlation.across}-{correlation.up}.png"
    points = [
        Point(model, Bar(*x[:3]), Bar(*y[:3]))
        for model, x, y in zip(correlation.models, correlation.x, correlation.y, strict=True)
    ]
    try:
        scatter(
            out / name,
            points,
            correlation.across,
            correlation.up,
            f"Spearman's ρ {correlation_text(correlation)}, {len(points)} models",
        )
    except MissingExtraError:
        return None
    return name

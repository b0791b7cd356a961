"""Two policies on the same problems: paired differences with intervals."""

from pathlib import Path
from typing import NamedTuple

from sim2reason.base.atomic_files import canonical, put_text
from sim2reason.errors import EvaluationError
from sim2reason.evaluation.reports.markdown import table
from sim2reason.evaluation.reports.own_folder import own_folder
from sim2reason.evaluation.reports.results import Estimate, difference
from sim2reason.evaluation.reports.scores import PolicyScores, scores_of

__all__ = ["PairedDifference", "compare"]

RESULT = "compare.json"


class PairedDifference(NamedTuple):
    """The second policy less the first, on the problems of a benchmark that both answered."""

    benchmark: str
    items: int
    first: float
    second: float
    difference: Estimate
    better: int
    """Problems with more points for the second."""
    worse: int


def compare(first: str | Path, second: str | Path, out: Path | None = None) -> list[PairedDifference]:
    """Compare two policies on every benchmark that both answered; each is RUN, or RUN:POLICY where a run has several.

    With `out`, a folder, the result is written there as ``compare.json`` and ``compare.md``.

    Raises:
        EvaluationError: no such run or policy, no benchmark in common, other problems under the same name, or a folder
            that holds something else.
    """
    mine, theirs = scores_of(str(first)), scores_of(str(second))
    common = [name for name in mine.points if name in theirs.points]
    if not common:
        raise EvaluationError(f"{first} and {second} have answered no benchmark of the same name")
    found = [_pair(mine, theirs, name) for name in common]
    if out is not None:
        _write(out, str(first), str(second), found)
    return found


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


def rows(found: list[PairedDifference]) -> list[list[object]]:
    """For people, in per cent."""
    return [
        [o.benchmark, o.items, f"{100 * o.first:.1f}", f"{100 * o.second:.1f}", o.difference.shown, o.better, o.worse]
        for o in found
    ]


HEAD = "benchmark", "problems", "first", "second", "difference", "better", "worse"


def _write(out: Path, first: str, second: str, found: list[PairedDifference]) -> None:
    own_folder(out, RESULT)
    told = [{**one._asdict(), "difference": one.difference._asdict()} for one in found]
    put_text(out / RESULT, canonical({"first": first, "second": second, "benchmarks": told}), out)
    lines = [
        "# Paired comparison",
        "",
        f"First: `{first}`. Second: `{second}`. Accuracies and differences in per cent;",
    ]
    lines += ["95 % interval by a bootstrap over the problems that both answered.", ""]
    put_text(out / "compare.md", "\n".join([*lines, *table(HEAD, rows(found)), ""]), out)

"""Report of a run: a folder with numbers, a page, plots, and the answers side by side."""

from collections.abc import Iterator, Sequence
from pathlib import Path

from sim2reason.base.atomic_files import canonical, put, put_text
from sim2reason.errors import MissingExtraError
from sim2reason.evaluation.benchmarks.runs.folder import RunFolder
from sim2reason.evaluation.benchmarks.runs.outcomes import SampleOutcome, outcomes
from sim2reason.evaluation.reports.answers_page import answers_page
from sim2reason.evaluation.reports.markdown import page
from sim2reason.evaluation.reports.results import Result, RunReport, result
from sim2reason.figures.run_plots import Bar, bars, over_steps

__all__ = ["write_report"]

JSON, PAGE, SCORES, ANSWERS = "report.json", "report.md", "scores.jsonl", "answers.html"
NO_PICTURES = "There are no pictures, since matplotlib is not installed: pip install matplotlib"


def write_report(folder: RunFolder) -> RunReport:
    """Score all samples of a run again, and write its report, which counts missing samples.

    Raises:
        MissingExtraError: a rule of scoring needs a package that is not installed.
        EvaluationError: a damaged run.
    """
    out, record = folder.report, folder.record
    out.mkdir(exist_ok=True)
    by_benchmark: dict[str, list[SampleOutcome]] = {}
    found: list[Result] = []
    for benchmark in record.benchmarks:
        for policy in record.policies:
            held = sorted(outcomes(folder, policy, benchmark), key=lambda each: (each.id, each.sample))
            by_benchmark.setdefault(benchmark, []).extend(held)
            if (each := result(folder, policy, benchmark, held)) is not None:
                found.append(each)
    _lines(out / SCORES, (f"{one.model_dump_json()}\n" for held in by_benchmark.values() for one in held))
    _lines(out / ANSWERS, answers_page(folder, by_benchmark))
    notes: list[str] = []
    try:
        pictures = tuple(_pictures(folder, found))
    except MissingExtraError:
        pictures, notes = (), [NO_PICTURES]
    put_text(out / PAGE, page(record, found, pictures, notes), out)
    report = RunReport(run=record.model_dump(mode="json"), results=tuple(found), pictures=pictures)
    put_text(out / JSON, canonical(report.model_dump(mode="json")), out)
    return report


def _lines(path: Path, lines: Iterator[str]) -> None:
    def write(temporary: Path) -> None:
        with temporary.open("w", encoding="utf-8", newline="\n", errors="replace") as file:
            file.writelines(lines)

    put(path, write, path.parent)


def _bar(found: Result | None) -> Bar | None:
    return None if found is None else Bar(found.accuracy.value, found.accuracy.low, found.accuracy.high)


def _pictures(folder: RunFolder, results: Sequence[Result]) -> Iterator[str]:
    """Draw all possible plots, and yield the names of their files."""
    if not results:
        return
    out, held = folder.report, {(each.policy, each.benchmark): each for each in results}
    benchmarks = list(dict.fromkeys(each.benchmark for each in results))
    policies = list(dict.fromkeys(each.policy for each in results))
    rows = {policy: [_bar(held.get((policy, benchmark))) for benchmark in benchmarks] for policy in policies}
    bars(out / "accuracy.png", "Accuracy with 95 % intervals", benchmarks, rows)
    yield "accuracy.png"
    for benchmark in benchmarks:
        yield from _groups(out, benchmark, [each for each in results if each.benchmark == benchmark])
    yield from _steps(folder, out, results)


def _groups(out: Path, benchmark: str, results: Sequence[Result]) -> Iterator[str]:
    """Draw a bar plot for each tag that divides a benchmark's problems into a few groups; yield the file names."""
    for tag in sorted({tag for each in results for tag in each.groups}):
        values = sorted({value for each in results for value in each.groups.get(tag, {})})
        if not 2 <= len(values) <= 20:
            continue
        rows = {each.policy: [_group(each, tag, value) for value in values] for each in results}
        name = f"{benchmark}-{tag}.png"
        bars(out / name, f"{benchmark}, by {tag}", values, rows)
        yield name


def _group(found: Result, tag: str, value: str) -> Bar | None:
    group = found.groups.get(tag, {}).get(value)
    return None if group is None else Bar(group.accuracy.value, group.accuracy.low, group.accuracy.high)


def _steps(folder: RunFolder, out: Path, results: Sequence[Result]) -> Iterator[str]:
    """Draw the plot of accuracy and length over training steps and yield its file name, if policies state steps."""
    steps = {name: plan.step for name, plan in folder.record.policies.items()}
    staged = [(step, each) for each in results if (step := steps[each.policy]) is not None]
    moments = sorted({step for step, _ in staged})
    by_benchmark: dict[str, dict[int, Result]] = {}
    for step, each in staged:
        by_benchmark.setdefault(each.benchmark, {})[step] = each
    whole = {name: held for name, held in by_benchmark.items() if sorted(held) == moments}
    if len(moments) < 2 or not whole:
        return
    rows = {name: [bar for step in moments if (bar := _bar(held[step]))] for name, held in whole.items()}
    lengths = {name: [held[step].tokens or held[step].characters for step in moments] for name, held in whole.items()}
    over_steps(out / "steps.png", moments, rows, lengths)
    yield "steps.png"

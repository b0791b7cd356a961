"""Evaluation and its report: a folder with numbers, a page, plots, and the answers side by side.

`evaluate` is the function behind the command ``sim2reason eval``.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from sim2reason.base.atomic_files import canonical, put_text, write_atomically
from sim2reason.base.records import format_count
from sim2reason.errors import MissingExtraError, PolicyError, Sim2ReasonError
from sim2reason.evaluation.benchmarks.runs.config import Evaluation, RunFolder, build_evaluation
from sim2reason.evaluation.benchmarks.runs.run import SampleOutcome, outcomes, run
from sim2reason.evaluation.reports.pages import answers_page, page
from sim2reason.evaluation.reports.results import Result, RunReport, result
from sim2reason.figures.run_plots import Bar, bars, over_steps

__all__ = ["EvaluationResult", "evaluate", "write_report"]

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
    all_results: list[Result] = []
    for benchmark in record.benchmarks:
        for policy in record.policies:
            samples = sorted(outcomes(folder, policy, benchmark), key=lambda each: (each.id, each.sample))
            by_benchmark.setdefault(benchmark, []).extend(samples)
            if (each := result(folder, policy, benchmark, samples)) is not None:
                all_results.append(each)
    _lines(out / SCORES, (f"{one.model_dump_json()}\n" for samples in by_benchmark.values() for one in samples))
    _lines(out / ANSWERS, answers_page(folder, by_benchmark))
    notes: list[str] = []
    try:
        pictures = tuple(_pictures(folder, all_results))
    except MissingExtraError:
        pictures, notes = (), [NO_PICTURES]
    put_text(out / PAGE, page(record, all_results, pictures, notes), out)
    report = RunReport(run=record.model_dump(mode="json"), results=tuple(all_results), pictures=pictures)
    put_text(out / JSON, canonical(report.model_dump(mode="json")), out)
    return report


def _lines(path: Path, lines: Iterator[str]) -> None:
    def write(temporary: Path) -> None:
        with temporary.open("w", encoding="utf-8", newline="\n", errors="replace") as file:
            file.writelines(lines)

    write_atomically(path, write, path.parent)


def _bar(policy_result: Result | None) -> Bar | None:
    return (
        None
        if policy_result is None
        else Bar(policy_result.accuracy.value, policy_result.accuracy.low, policy_result.accuracy.high)
    )


def _pictures(folder: RunFolder, results: Sequence[Result]) -> Iterator[str]:
    """Draw all possible plots, and yield the names of their files."""
    if not results:
        return
    out, result_by_pair = folder.report, {(each.policy, each.benchmark): each for each in results}
    benchmarks = list(dict.fromkeys(each.benchmark for each in results))
    policies = list(dict.fromkeys(each.policy for each in results))
    rows = {policy: [_bar(result_by_pair.get((policy, benchmark))) for benchmark in benchmarks] for policy in policies}
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


def _group(policy_result: Result, tag: str, value: str) -> Bar | None:
    group = policy_result.groups.get(tag, {}).get(value)
    return None if group is None else Bar(group.accuracy.value, group.accuracy.low, group.accuracy.high)


def _steps(folder: RunFolder, out: Path, results: Sequence[Result]) -> Iterator[str]:
    """Draw the plot of accuracy and length over training steps and yield its file name, if policies state steps."""
    steps = {name: plan.step for name, plan in folder.record.policies.items()}
    staged = [(step, each) for each in results if (step := steps[each.policy]) is not None]
    moments = sorted({step for step, _ in staged})
    by_benchmark: dict[str, dict[int, Result]] = {}
    for step, each in staged:
        by_benchmark.setdefault(each.benchmark, {})[step] = each
    complete = {name: by_step for name, by_step in by_benchmark.items() if sorted(by_step) == moments}
    if len(moments) < 2 or not complete:
        return
    rows = {name: [bar for step in moments if (bar := _bar(by_step[step]))] for name, by_step in complete.items()}
    lengths = {
        name: [by_step[step].tokens or by_step[step].characters for step in moments]
        for name, by_step in complete.items()
    }
    over_steps(out / "steps.png", moments, rows, lengths)
    yield "steps.png"


@dataclass(frozen=True)
class EvaluationResult:
    """An evaluation with its report.

    Attributes:
        folder: The folder of the run.
        report: Accuracies of each policy on each benchmark, as a whole and by tags of problems.
        open: Reasons for the samples without an answer, a line for each.
    """

    folder: RunFolder
    report: RunReport
    open: tuple[str, ...] = ()

    def __repr__(self) -> str:
        """Return the folder and the number of results."""
        return f"<EvaluationResult {str(self.folder.path)!r}: {format_count(len(self.report.results), 'result')}>"

    def __str__(self) -> str:
        """Return a line with the accuracy for each policy on each benchmark."""
        lines = (f"  {each.policy} on {each.benchmark}: {each.accuracy.shown} %" for each in self.report.results)
        return "\n".join([repr(self)[1:-1], *lines])


def evaluate(
    config: Path | str | Mapping[str, object] | Evaluation,
    out: Path | None = None,
    *,
    begun: Callable[[int], object] = lambda _: None,
    advance: Callable[[int], object] = lambda _: None,
) -> EvaluationResult:
    r"""Evaluate policies on benchmarks, and write a report.

    ``sim2reason.eval`` is this function. Answers of an earlier run in the same folder are reused. If a run ends early,
    its finished answers are stored and reported.

    Args:
        config: A YAML file, a mapping with its contents, or an `Evaluation`.
        out: Folder of the run; by default the folder in the configuration.
        begun: Callback that takes the number of answers to come.
        advance: Callback that takes the number of further answers that are finished.

    Returns:
        The folder and the report.

    Raises:
        EvaluationError, UnknownNameError: A configuration, benchmark or folder is invalid.
        PolicyError: A policy cannot be asked, or its limit is reached.
        MissingExtraError: A policy or a scoring rule needs a package that is not installed.

    Examples:
        >>> import sim2reason
        >>> data = sim2reason.generate("problems", items=2, recipe="pulley", difficulty="easy", workers=1)
        >>> run = sim2reason.eval({
        ...     "out": "run",
        ...     "policies": [{"kind": "constant", "name": "one", "text": r"\boxed{1}"}],
        ...     "benchmarks": [{"kind": "synthetic", "name": "ours", "dataset": "problems"}],
        ... })
        >>> [(each.policy, each.benchmark, each.accuracy.value) for each in run.report.results]
        [('one', 'ours', 0.0)]
    """
    evaluation = build_evaluation(config, out)
    try:
        folder, left = run(evaluation, begun=begun, advance=advance)
    except PolicyError as error:
        if _reported(evaluation.out):
            error.add_note(f"what was finished is kept in {evaluation.out}; the same command goes on")
        raise
    return EvaluationResult(folder, write_report(folder), tuple(left))


def _reported(out: Path) -> bool:
    """Write a report on the present answers; return whether there are any."""
    try:
        return bool(write_report(RunFolder(out)).results)
    except (Sim2ReasonError, OSError):
        return False

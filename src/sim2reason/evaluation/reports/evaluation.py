"""Evaluation: the function behind the command ``sim2reason eval``."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from sim2reason.base.records import counted
from sim2reason.errors import PolicyError, Sim2ReasonError
from sim2reason.evaluation.benchmarks.runs.config import Evaluation, evaluation_from
from sim2reason.evaluation.benchmarks.runs.folder import RunFolder
from sim2reason.evaluation.benchmarks.runs.run import run
from sim2reason.evaluation.reports.report import write_report
from sim2reason.evaluation.reports.results import RunReport

__all__ = ["Evaluated", "evaluate"]


@dataclass(frozen=True)
class Evaluated:
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
        return f"<Evaluated {str(self.folder.path)!r}: {counted(len(self.report.results), 'result')}>"

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
) -> Evaluated:
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
    evaluation = evaluation_from(config, out)
    try:
        folder, left = run(evaluation, begun=begun, advance=advance)
    except PolicyError as error:
        if _reported(evaluation.out):
            error.add_note(f"what was finished is kept in {evaluation.out}; the same command goes on")
        raise
    return Evaluated(folder, write_report(folder), tuple(left))


def _reported(out: Path) -> bool:
    """Write a report on the present answers; return whether there are any."""
    try:
        return bool(write_report(RunFolder(out)).results)
    except (Sim2ReasonError, OSError):
        return False

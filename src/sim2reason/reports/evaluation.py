"""Evaluate from Python, as ``sim2reason eval`` does."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from sim2reason.benchmarks.runs.config import Evaluation, evaluation_from
from sim2reason.benchmarks.runs.folder import RunFolder
from sim2reason.benchmarks.runs.run import run
from sim2reason.errors import PolicyError, Sim2ReasonError
from sim2reason.record import counted
from sim2reason.reports.report import write_report
from sim2reason.reports.results import RunReport

__all__ = ["Evaluated", "evaluate"]


@dataclass(frozen=True)
class Evaluated:
    """A run with its report; `open` says of each sample without an answer why there is none."""

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
    """Have policies answer benchmarks, and report: into the folder `out`, or the one that the configuration names.

    What was answered before is not asked again. Whatever ends the run, what was finished is kept, and reported on.

    Raises:
        EvaluationError, UnknownNameError: a configuration, benchmark or folder that can't be used.
        PolicyError: a policy that can't be asked, or whose limit is reached.
        MissingExtraError: a package that a policy or a rule of scoring needs.
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
    """Report on what is there, if that is a run with an answer."""
    try:
        return bool(write_report(RunFolder(out)).results)
    except (Sim2ReasonError, OSError):
        return False

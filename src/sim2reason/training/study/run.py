"""Execution of all runs of a study, each in its own processes, with resumption."""

# torch is an extra:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

import os
import shutil
import signal
import sys
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path
from subprocess import STDOUT, Popen

from sim2reason.base.atomic_files import canonical, lock_work_folder, put_text
from sim2reason.errors import Sim2ReasonError, TrainingError
from sim2reason.evaluation.benchmarks.runs.config import RUN, copy_answers
from sim2reason.training.extras import require
from sim2reason.training.rl.config import TrainingFolder, TrainingResult
from sim2reason.training.rl.run import NEEDED, Stage
from sim2reason.training.study.config import Arm, TrainingStudy, build_study

__all__ = ["prepare_study", "train_study"]

MAX_OUTPUT = 300  # characters of a failed run's last output
PARTIAL = ".part"


def train_study(
    config: Path | str | Mapping[str, object] | TrainingStudy,
    out: Path | None = None,
    *,
    begun: Callable[[str, int], object] = lambda phase, steps: None,  # noqa: ARG005 - names say what is told
    advance: Callable[[int], object] = lambda _: None,
) -> dict[str, TrainingResult]:
    """Run all runs of a study; return the results by name.

    `out` overrides the output folder. Finished runs are kept, and interrupted ones continue. A warm start common to
    several runs is trained once. `begun` receives the number of runs, `advance` the numbers of newly finished ones.

    Raises:
        TrainingError: a configuration or folder that cannot be used, or runs that failed: the others are made before.
        MissingExtraError: a library of the extra [train] is missing.
        DatasetError: another study is writing in the folder.
    """
    study = _checked(config, out)
    with lock_work_folder(study.out):
        begun("runs", len(study.runs))
        for arm in study.runs:
            _claim(study, arm)
        failed = _warm_starts(study, "warm-start")
        todo = [arm for arm in study.runs if not _finished(study, arm) and arm.run not in failed]
        advance(len(study.runs) - len(todo) - len(failed))
        failed |= _made(study, todo, advance=advance)
    _all_made(failed, len(study.runs))
    return {arm.run: result for arm in study.runs if (result := _folder(study, arm).result())}


def prepare_study(
    config: Path | str | Mapping[str, object] | TrainingStudy,
    out: Path | None = None,
    *,
    until: Stage = "warm-start",
    begun: Callable[[str, int], object] = lambda phase, steps: None,  # noqa: ARG005 - names say what is told
    advance: Callable[[int], object] = lambda _: None,
) -> Path:
    """Run the steps before reinforcement learning once for each warm start of a study.

    `begun` receives the number of different warm starts, `advance` the numbers of newly prepared ones. `train_study`,
    with the same arguments, continues in the returned folder.

    Raises:
        TrainingError, MissingExtraError, DatasetError: as `train_study` does.
    """
    study = _checked(config, out)
    with lock_work_folder(study.out):
        for arm in study.runs:
            _claim(study, arm)
        begun("preparations", len(_firsts(study)))
        failed = _warm_starts(study, until, advance)
    _all_made(failed, len(study.runs))
    return study.out


def _checked(config: Path | str | Mapping[str, object] | TrainingStudy, out: Path | None) -> TrainingStudy:
    study = build_study(config, out)
    require(*NEEDED, *(name for each in study.configs.values() for name in each.libraries))
    return study


def _all_made(failed: Mapping[str, str], runs: int) -> None:
    """Raise TrainingError if some runs failed."""
    if failed:
        reasons = "; ".join(f"{run}: {why}" for run, why in failed.items())
        raise TrainingError(f"{len(failed)} of {runs} runs failed, the others are finished; {reasons}")


def _folder(study: TrainingStudy, arm: Arm) -> TrainingFolder:
    return TrainingFolder(study.configs[arm].out)


def _claim(study: TrainingStudy, arm: Arm) -> None:
    """Create the folder of a run; TrainingError if the run could not start, or the folder is another's."""
    folder = _folder(study, arm)
    try:
        with lock_work_folder(folder.path):
            folder.claim(study.configs[arm])
    except Sim2ReasonError as error:
        error.args = (f"arms.{arm.name}: {error}", *error.args[1:])
        raise
    put_text(folder.path.with_name(f"{arm.run}.yaml"), canonical(study.settings[arm]), folder.path.parent)


def _finished(study: TrainingStudy, arm: Arm) -> bool:
    """Return whether a run is trained and reported."""
    folder = _folder(study, arm)
    return folder.result() is not None and folder.report.is_file()


def _warm_starts(
    study: TrainingStudy, until: Stage, advance: Callable[[int], object] = lambda _: None
) -> dict[str, str]:
    """Prepare the first run of each different warm start, and share its files with runs that have the same one.

    Returns the last output of failed preparations, by run.
    """
    firsts = _firsts(study)
    open_ones = [first for first, arms in firsts.items() if not all(_finished(study, arm) for arm in arms)]
    todo = [first for first in open_ones if not _folder(study, first).is_prepared(study.configs[first])]
    failed = _made(study, todo, until, advance)
    for first, arms in firsts.items():
        for arm in arms:
            if first.run in failed:
                failed[arm.run] = failed[first.run]
            elif until == "warm-start":
                _share(study, first, arm)
    return failed


def _firsts(study: TrainingStudy) -> dict[Arm, list[Arm]]:
    """Return the groups of runs with equal warm start and held-out problems, by the first run of each group."""
    known = dict[str, list[Arm]]()
    for arm in study.runs:
        config = study.configs[arm].decisive
        known.setdefault(canonical([config["warm_start"], config["held_out"]]), []).append(arm)
    return {arms[0]: arms for arms in known.values()}


def _made(
    study: TrainingStudy,
    arms: Sequence[Arm],
    until: Stage | None = None,
    advance: Callable[[int], object] = lambda _: None,
) -> dict[str, str]:
    """Execute the runs, or only prepare them; return the last output of each failed run, by its name."""
    running, failed = dict[Arm, Popen[bytes]](), dict[str, str]()
    with ThreadPoolExecutor(study.workers) as pool:
        try:
            made = {pool.submit(_make, study, arm, until, running): arm for arm in arms}
            for future in as_completed(made):
                advance(1)
                if output := future.result():
                    failed[made[future].run] = output
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            for process in list(running.values()):
                process.send_signal(signal.SIGINT)  # a second one, if the terminal has sent one, does no harm
            raise
    return failed


def _share(study: TrainingStudy, first: Arm, arm: Arm) -> None:
    """Link the warm start, held-out problems and answers of the first run into another run's folder."""
    earlier, folder = _folder(study, first), _folder(study, arm)
    if first == arm:
        return
    for theirs, mine in ((earlier.held_out, folder.held_out), (earlier.warm_start, folder.warm_start)):
        if theirs.is_dir() and not mine.exists():
            _linked(theirs, mine)
    if study.configs[first].evaluation_policy == study.configs[arm].evaluation_policy:
        models = [str(each.warm_start / "model") for each in (earlier, folder)]
        for run in (record.parent for record in earlier.evaluation.glob(f"*/{RUN}")):
            if not (folder.evaluation / run.name).exists():
                folder.evaluation.mkdir(exist_ok=True)
                copy_answers(run, folder.evaluation / run.name, *models)


def _linked(source: Path, target: Path) -> None:
    """Link a folder atomically under another name, without the files of training itself."""
    partial = target.with_name(target.name + PARTIAL)
    shutil.rmtree(partial, ignore_errors=True)
    try:
        shutil.copytree(source, partial, ignore=shutil.ignore_patterns("checkpoints"), copy_function=os.link)
    except shutil.Error:  # a file system without links
        shutil.rmtree(partial, ignore_errors=True)
        shutil.copytree(source, partial, ignore=shutil.ignore_patterns("checkpoints"))
    partial.rename(target)


def _make(study: TrainingStudy, arm: Arm, until: Stage | None, running: dict[Arm, Popen[bytes]]) -> str:
    """Execute or prepare one run; return its last output if it failed, else an empty text."""
    folder = _folder(study, arm).path
    log = folder.with_name(f"{arm.run}.log")
    with log.open("ab") as output:
        command = [sys.executable, "-m", "sim2reason", "train", "rl", str(folder.with_name(f"{arm.run}.yaml"))]
        command += [] if until is None else ["--until", until]
        running[arm] = Popen(command, stdout=output, stderr=STDOUT)  # noqa: S603 - our own command, in a list
        code = running[arm].wait()
        del running[arm]
    if code == 0:
        return ""
    lines = [line for line in log.read_text("utf-8", errors="replace").splitlines() if line.strip()]
    last = lines[-1][-MAX_OUTPUT:] if lines else f"ended with code {code}"
    return f"{last} (see {log})"

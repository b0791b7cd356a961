"""Files of a training run: its plan, the log of its steps, its checkpoints and its result.

The plan is written first, and the result last. A checkpoint is complete when it has the cursor of the prompt stream.
"""

import json
import os
import shutil
from collections.abc import Callable, Mapping, Sequence
from collections.abc import Set as AbstractSet
from pathlib import Path
from typing import TypeVar

from pydantic import BaseModel, ConfigDict, FiniteFloat, JsonValue, NonNegativeInt, ValidationError

from sim2reason.base.atomic_files import TEMPORARY, canonical, put_text
from sim2reason.errors import TrainingError
from sim2reason.generation.item import Record
from sim2reason.training.extras import versions

__all__ = [
    "RESULT",
    "RL_PLAN",
    "SFT_PLAN",
    "Cursor",
    "StepLines",
    "StepLog",
    "StepRecord",
    "StepSeconds",
    "checkpoint_folder",
    "claim",
    "finish",
    "last_checkpoint",
    "mark",
    "read_cursor",
    "read_result",
    "remove_later",
    "unmark",
]

RL_PLAN, SFT_PLAN, RESULT = "rl.json", "sft.json", "result.json"
R = TypeVar("R", bound=Record)


class TrainingPlan(Record):
    """The plan of a run, its first file."""

    settings: dict[str, JsonValue]
    """Those that decide the weights."""
    versions: dict[str, str]
    """Of the libraries with which it was begun."""


def claim(
    file: Path, decisive: Mapping[str, object], check: Callable[[], object], prepared: Sequence[Path] = ()
) -> None:
    """Write the plan into an empty folder, or continue with an equal one; the caller holds the lock.

    `check` raises an error if the run could not start, before the folder is claimed. A plan without any training is
    replaced, together with `prepared`, the files and folders that come before training.

    Raises:
        TrainingError: the folder holds something else, or a run of another configuration.
    """
    settings: dict[str, JsonValue] = json.loads(json.dumps(decisive))
    folder = file.parent
    if not file.is_file():
        if strangers := sorted(path.name for path in folder.iterdir()):
            raise TrainingError(f"{folder}: holds {strangers[0]} and is no run; choose a new folder")
    else:
        differs = _difference(file, settings)
        if differs and not _only(folder, {file, *prepared}):
            raise TrainingError(f"{folder}: holds a run with another setting of {differs}; choose a new folder")
        if not differs:
            return
    check()
    for path in prepared:
        _remove(path)
    plan = TrainingPlan(settings=settings, versions=versions())
    put_text(file, canonical(plan.model_dump(mode="json")), folder)


def _difference(file: Path, settings: Mapping[str, JsonValue]) -> str:
    """Return the name of the first setting that differs from the plan of a run; empty if all are equal."""
    try:
        before = TrainingPlan.model_validate_json(file.read_bytes()).settings
    except ValidationError:
        raise TrainingError(f"{file}: damaged, or of another version; choose a new folder") from None
    return _first(before, settings)


def _first(one: Mapping[str, JsonValue], other: Mapping[str, JsonValue]) -> str:
    for name in sorted(one.keys() | other.keys()):
        mine, theirs = one.get(name), other.get(name)
        if mine != theirs:
            within = _first(mine, theirs) if isinstance(mine, dict) and isinstance(theirs, dict) else ""
            return f"{name}.{within}" if within else name
    return ""


def _only(folder: Path, known: AbstractSet[Path]) -> bool:
    """Return whether a folder contains only known paths and remains of interrupted writes."""
    paths = (path for path in folder.rglob("*") if not path.is_dir() and path.suffix != TEMPORARY)
    return all(known & {path, *path.parents} for path in paths)


def _remove(path: Path) -> None:
    if path.is_dir():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)


def read_result(folder: Path, kind: type[R]) -> R | None:
    """Return the result of a run; None if unfinished, TrainingError if the file is damaged."""
    file = folder / RESULT
    if not file.is_file():
        return None
    try:
        return kind.model_validate_json(file.read_bytes())
    except ValidationError:
        raise TrainingError(f"{file}: damaged; remove it, and give the same command again") from None


def finish(folder: Path, result: Record) -> None:
    """Write the result of a run, after all other files."""
    put_text(folder / RESULT, canonical(result.model_dump(mode="json")), folder)


class StepLines:
    """The lines of a log file."""

    def __init__(self, path: Path) -> None:
        """Store the path in the folder of the run, which need not exist."""
        self.path = path

    def rewind(self, step: int) -> None:
        """Remove from the log the lines after a step, and an incomplete line."""
        kept = [line for line in self.read() if json.loads(line)["step"] <= step]
        self.path.parent.mkdir(parents=True, exist_ok=True)
        put_text(self.path, "".join(f"{line}\n" for line in kept), self.path.parent)

    def add(self, line: str) -> None:
        """Write a line and sync it to disk."""
        with self.path.open("a", encoding="utf-8", newline="\n") as file:
            file.write(f"{line}\n")
            file.flush()
            os.fsync(file.fileno())

    def read(self) -> list[str]:
        """Return the complete lines so far."""
        complete = self.path.read_bytes().split(b"\n")[:-1] if self.path.is_file() else []
        return [line.decode() for line in complete]


STEP_LOG = "log.jsonl"


class _Record(BaseModel):
    """The base of records on disk: frozen, without unknown fields."""

    model_config = ConfigDict(frozen=True, extra="forbid")


class StepSeconds(_Record):
    """The wall time of one step in the first process; `problems` is CPU time of other processes.

    The remainder of `step` is spent on the selection of groups and communication.
    """

    step: FiniteFloat
    generation: FiniteFloat
    reward: FiniteFloat
    drawing: FiniteFloat
    """Of prompts: the stream, and their way to all processes."""
    logprobs: FiniteFloat
    """Log-probabilities under the policy and the reference, before the updates."""
    update: FiniteFloat
    """Forward, backward and optimizer, of all minibatches."""
    problems: FiniteFloat = 0.0
    """CPU time of the processes that made problems meanwhile; in the first step after a start, since that."""


class StepRecord(_Record):
    """The log record of one step; fractions are relative to 1 and include omitted groups."""

    step: int
    updates: int
    """Of the optimizer, since the beginning."""
    rounds: int
    prompts: int
    """Drawn and answered in this step."""
    prompts_consumed: int
    """Read from the stream since the beginning, with those that were too long."""
    groups: int
    """That were learned from: all of unequal rewards."""
    zero_variance: FiniteFloat
    """The share of groups drawn in this step whose rewards were all equal, or that had none."""
    reward: FiniteFloat | None
    pass_rate: FiniteFloat | None
    """The share of rewards of 1 or more."""
    completion_tokens: FiniteFloat | None
    """The mean."""
    truncated: FiniteFloat | None
    """The share of completions that were cut at the greatest length."""
    kl: FiniteFloat | None
    clip_low: FiniteFloat | None
    """The share of completions whose ratio fell below the lower bound while their advantage was negative."""
    clip_high: FiniteFloat | None
    entropy: FiniteFloat | None
    loss: FiniteFloat | None
    """The mean over the minibatches."""
    grad_norm: FiniteFloat | None
    """Before clipping; the mean over the minibatches."""
    learning_rate: FiniteFloat | None
    seconds: StepSeconds


class StepLog:
    """The log file of a run."""

    def __init__(self, folder: Path) -> None:
        """Locate the file in the folder of the run."""
        self._lines = StepLines(folder / STEP_LOG)

    def rewind(self, step: int) -> None:
        """Remove from the log all steps after a given one, from which the run continues."""
        self._lines.rewind(step)

    def add(self, record: StepRecord) -> None:
        """Write a step and sync it to disk."""
        self._lines.add(record.model_dump_json())

    def read(self) -> list[StepRecord]:
        """Return all steps so far."""
        return [StepRecord.model_validate_json(line) for line in self._lines.read()]


CURSOR = "cursor.json"


class Cursor(BaseModel):
    """The state of a run between two steps: counts, and the position in the stream of prompts."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    step: NonNegativeInt
    updates: NonNegativeInt
    prompts_consumed: NonNegativeInt
    stream: JsonValue
    """The state of the stream of prompts."""


def checkpoint_folder(out: Path, updates: int) -> Path:
    """Return the folder of a checkpoint, named as transformers does."""
    return out / f"checkpoint-{updates}"


def unmark(folder: Path) -> None:
    """Remove the file that marks a checkpoint as complete, before it is overwritten."""
    (folder / CURSOR).unlink(missing_ok=True)


def mark(folder: Path, cursor: Cursor) -> None:
    """Write the state of the run (the cursor) into a checkpoint, which marks it as complete."""
    put_text(folder / CURSOR, cursor.model_dump_json() + "\n", folder)


def read_cursor(folder: Path) -> Cursor:
    """Return the state of the run (the cursor) stored in a checkpoint.

    Raises:
        TrainingError: it has none, as one that was being written when the run was killed, or it is damaged.
    """
    path = folder / CURSOR
    try:
        return Cursor.model_validate_json(path.read_text("utf-8"))
    except FileNotFoundError:
        raise TrainingError(f"{folder} is no whole checkpoint: it has no {CURSOR}; take an earlier one") from None
    except (OSError, ValidationError, UnicodeDecodeError) as error:
        raise TrainingError(f"{path} cannot be read: {' '.join(str(error).split())[:200]}") from None


def last_checkpoint(out: Path) -> Path | None:
    """Return the newest complete checkpoint of a run, or None; incomplete ones are skipped."""
    return max((path for path in _folders(out) if (path / CURSOR).is_file()), key=_updates, default=None)


def remove_later(out: Path, cursor: Cursor | None) -> None:
    """Remove incomplete checkpoints of later steps than the cursor; complete ones raise an error.

    Transformers would keep them, since it keeps the checkpoints of the highest numbers.

    Raises:
        TrainingError: there are whole checkpoints of a run that got further.
    """
    done = 0 if cursor is None else cursor.updates
    later = [path for path in _folders(out) if _updates(path) > done]
    complete = sorted((path for path in later if (path / CURSOR).is_file()), key=_updates)
    if complete:
        raise TrainingError(
            f"{out} holds a run up to {complete[-1].name}; go on from there with resume_from_checkpoint=True, "
            "remove what comes later, or choose another folder"
        )
    for path in later:
        shutil.rmtree(path)


def _folders(out: Path) -> list[Path]:
    return [path for path in out.glob("checkpoint-*") if path.is_dir() and path.name[len("checkpoint-") :].isdecimal()]


def _updates(folder: Path) -> int:
    return int(folder.name.rpartition("-")[2])

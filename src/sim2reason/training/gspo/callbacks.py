"""Callbacks of the trainer: checkpoints, and batches that could not be filled."""

import shutil
from pathlib import Path
from typing import Any

from pydantic import BaseModel, ConfigDict, JsonValue, NonNegativeInt, ValidationError

from sim2reason.base.atomic_files import put_text
from sim2reason.errors import TrainingError
from sim2reason.training.extras import library

__all__ = ["BetweenUpdates", "Cursor", "clear_behind", "folder_of", "last_checkpoint", "mark", "read_cursor", "unmark"]

NAME = "cursor.json"


class Cursor(BaseModel):
    """Where a run stands between two steps."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    step: NonNegativeInt
    updates: NonNegativeInt
    prompts_consumed: NonNegativeInt
    stream: JsonValue
    """The state of the stream of prompts."""


def folder_of(out: Path, updates: int) -> Path:
    """As transformers names it."""
    return out / f"checkpoint-{updates}"


def unmark(folder: Path) -> None:
    """Before anything is written to a checkpoint of this name."""
    (folder / NAME).unlink(missing_ok=True)


def mark(folder: Path, cursor: Cursor) -> None:
    """After all else was written."""
    put_text(folder / NAME, cursor.model_dump_json() + "\n", folder)


def read_cursor(folder: Path) -> Cursor:
    """Return the cursor of a checkpoint.

    Raises:
        TrainingError: it has none, as one that was being written when the run was killed, or it is damaged.
    """
    path = folder / NAME
    try:
        return Cursor.model_validate_json(path.read_text("utf-8"))
    except FileNotFoundError:
        raise TrainingError(f"{folder} is no whole checkpoint: it has no {NAME}; take an earlier one") from None
    except (OSError, ValidationError, UnicodeDecodeError) as error:
        raise TrainingError(f"{path} cannot be read: {' '.join(str(error).split())[:200]}") from None


def last_checkpoint(out: Path) -> Path | None:
    """Return the newest whole checkpoint of a run, or None. One that a kill left half written is passed over."""
    return max((path for path in _folders(out) if (path / NAME).is_file()), key=_updates, default=None)


def clear_behind(out: Path, cursor: Cursor | None) -> None:
    """Make room for what a run will save that goes on from a cursor, or begins.

    Folders that a kill left half written are removed, since transformers keeps those of the highest numbers.

    Raises:
        TrainingError: there are whole checkpoints of a run that got further.
    """
    done = 0 if cursor is None else cursor.updates
    later = [path for path in _folders(out) if _updates(path) > done]
    whole = sorted((path for path in later if (path / NAME).is_file()), key=_updates)
    if whole:
        raise TrainingError(
            f"{out} holds a run up to {whole[-1].name}; go on from there with resume_from_checkpoint=True, "
            "remove what comes later, or choose another folder"
        )
    for path in later:
        shutil.rmtree(path)


def _folders(out: Path) -> list[Path]:
    return [path for path in out.glob("checkpoint-*") if path.is_dir() and path.name[len("checkpoint-") :].isdecimal()]


def _updates(folder: Path) -> int:
    return int(folder.name.rpartition("-")[2])


# transformers is an extra and ships no types to an environment without it:
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUntypedBaseClass=false


class BetweenUpdates(library("transformers").TrainerCallback):
    """Called by transformers' loop for a `GSPOTrainer`."""

    def __init__(self, trainer: Any) -> None:  # noqa: ANN401 - ours, which imports this module
        """The trainer says whether its step is short, and whether its stream is exhausted."""
        self.trainer = trainer

    def on_pre_optimizer_step(self, *_: object, **__: object) -> None:
        """Leave weights alone that have no gradient: momentum and decay would move them still."""
        if self.trainer.short:
            for weights in self.trainer.model.parameters():
                if weights.grad is not None and not weights.grad.any():
                    weights.grad = None

    def on_step_end(self, _: object, state: Any, control: Any, **__: object) -> None:  # noqa: ANN401 - transformers' own
        """End the run with the step in which the stream ended."""
        if self.trainer.exhausted and state.global_step % self.trainer.settings.minibatches == 0:
            control.should_training_stop = control.should_save = True

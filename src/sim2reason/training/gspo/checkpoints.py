"""Checkpoints of a run: the cursor of the prompt stream, whose file marks a checkpoint as complete."""

import shutil
from pathlib import Path

from pydantic import BaseModel, ConfigDict, JsonValue, NonNegativeInt, ValidationError

from sim2reason.base.atomic_files import put_text
from sim2reason.errors import TrainingError

__all__ = ["Cursor", "clear_behind", "folder_of", "last_checkpoint", "mark", "read_cursor", "unmark"]

NAME = "cursor.json"


class Cursor(BaseModel):
    """The state of a run between two steps: counts, and the position in the stream of prompts."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    step: NonNegativeInt
    updates: NonNegativeInt
    prompts_consumed: NonNegativeInt
    stream: JsonValue
    """The state of the stream of prompts."""


def folder_of(out: Path, updates: int) -> Path:
    """Return the folder of a checkpoint, named as transformers does."""
    return out / f"checkpoint-{updates}"


def unmark(folder: Path) -> None:
    """Remove the file that marks a checkpoint as complete, before it is overwritten."""
    (folder / NAME).unlink(missing_ok=True)


def mark(folder: Path, cursor: Cursor) -> None:
    """Write the state of the run (the cursor) into a checkpoint, which marks it as complete."""
    put_text(folder / NAME, cursor.model_dump_json() + "\n", folder)


def read_cursor(folder: Path) -> Cursor:
    """Return the state of the run (the cursor) stored in a checkpoint.

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
    """Return the newest complete checkpoint of a run, or None; incomplete ones are skipped."""
    return max((path for path in _folders(out) if (path / NAME).is_file()), key=_updates, default=None)


def clear_behind(out: Path, cursor: Cursor | None) -> None:
    """Remove incomplete checkpoints of later steps than the cursor; complete ones raise an error.

    Transformers would keep them, since it keeps the checkpoints of the highest numbers.

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

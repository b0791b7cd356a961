"""Records of a training run: its plan, written first, and its result, written last."""

import json
import shutil
from collections.abc import Callable, Mapping, Sequence
from collections.abc import Set as AbstractSet
from pathlib import Path
from typing import TypeVar

from pydantic import JsonValue, ValidationError

from sim2reason.base.atomic_files import TEMPORARY, canonical, put_text
from sim2reason.errors import TrainingError
from sim2reason.generation.item import Record
from sim2reason.training.extras import versions

__all__ = ["RESULT", "RL_PLAN", "SFT_PLAN", "claim", "finish", "result_in"]

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
    held = (path for path in folder.rglob("*") if not path.is_dir() and path.suffix != TEMPORARY)
    return all(known & {path, *path.parents} for path in held)


def _remove(path: Path) -> None:
    if path.is_dir():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)


def result_in(folder: Path, kind: type[R]) -> R | None:
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

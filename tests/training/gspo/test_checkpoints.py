"""Tests of complete checkpoints, and of the log that is truncated to one."""

from pathlib import Path

import pytest

from sim2reason.errors import TrainingError
from sim2reason.training.run_files import (
    Cursor,
    StepLog,
    StepRecord,
    last_checkpoint,
    mark,
    read_cursor,
    remove_later,
    unmark,
)


def saved(out: Path, updates: int) -> Path:
    folder = out / f"checkpoint-{updates}"
    folder.mkdir()
    mark(folder, Cursor(step=updates // 2, updates=updates, prompts_consumed=7, stream={"next": 7}))
    return folder


def record(step: int) -> StepRecord:
    names = ("reward", "pass_rate", "completion_tokens", "truncated", "kl", "clip_low", "clip_high", "entropy", "loss")
    counts = dict.fromkeys(("updates", "rounds", "prompts", "prompts_consumed", "groups"), 1)
    times = dict.fromkeys(("step", "generation", "reward", "drawing", "logprobs", "update"), 0.5)
    rest = dict.fromkeys((*names, "grad_norm", "learning_rate"), None)
    return StepRecord.model_validate({"step": step, **counts, "zero_variance": 0.25, **rest, "seconds": times})


def test_the_last_whole_checkpoint_is_found(tmp_path: Path) -> None:
    assert last_checkpoint(tmp_path) is None
    saved(tmp_path, 8)
    newest = saved(tmp_path, 10)
    (tmp_path / "checkpoint-12").mkdir()
    assert last_checkpoint(tmp_path) == newest
    assert read_cursor(newest).stream == {"next": 7}
    unmark(newest)
    assert last_checkpoint(tmp_path) == tmp_path / "checkpoint-8"


def test_a_checkpoint_without_a_cursor_or_with_a_damaged_one_is_named(tmp_path: Path) -> None:
    (tmp_path / "checkpoint-12").mkdir()
    with pytest.raises(TrainingError, match="checkpoint-12 is no whole checkpoint"):
        read_cursor(tmp_path / "checkpoint-12")
    (tmp_path / "checkpoint-12/cursor.json").write_text('{"step": -1}')
    with pytest.raises(TrainingError, match=r"cursor\.json cannot be read"):
        read_cursor(tmp_path / "checkpoint-12")


def test_a_log_goes_back_to_a_step(tmp_path: Path) -> None:
    log = StepLog(tmp_path)
    for step in (1, 2, 3):
        log.add(record(step))
    log.rewind(2)
    assert log.read() == [record(1), record(2)]


def test_half_written_checkpoints_are_removed_and_whole_ones_never(tmp_path: Path) -> None:
    first, half = saved(tmp_path, 2), tmp_path / "checkpoint-4"
    half.mkdir()
    (tmp_path / "checkpoint-best").mkdir()
    remove_later(tmp_path, read_cursor(first))
    assert first.is_dir()
    assert not half.exists()
    assert (tmp_path / "checkpoint-best").is_dir()
    with pytest.raises(TrainingError, match="holds a run up to checkpoint-2"):
        remove_later(tmp_path, None)
    assert last_checkpoint(tmp_path) == first

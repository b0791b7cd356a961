"""Which run a folder belongs to: one that could begin, and no other once something has come of it."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import short_run
from sim2reason.errors import Sim2ReasonError, TrainingError
from sim2reason.training.rl.config import reinforcement_learning_from
from sim2reason.training.rl.folder import TrainingFolder
from sim2reason.training.run_plan import RL_PLAN, SFT_PLAN, claim
from sim2reason.training.sft.config import fine_tuning_from
from sim2reason.training.sft.folder import SftFolder

Settings = dict[str, Any]
MODEL = {"kind": "pretrained"}


def nothing() -> None:
    pass


def tuned(out: Path, **changed: object) -> SftFolder:
    settings = {"out": out, "model": {"kind": "scratch"}, "corpora": [{"kind": "drills"}], "steps": 1, **changed}
    folder = SftFolder(out)
    out.mkdir(exist_ok=True)
    folder.claim(fine_tuning_from(settings))
    return folder


def reinforced(out: Path, **changed: object) -> TrainingFolder:
    settings = short_run.settings(out) | changed
    if "model" in changed:
        del settings["warm_start"]
    folder = TrainingFolder(out)
    out.mkdir(exist_ok=True)
    folder.claim(reinforcement_learning_from(settings))
    return folder


def asked(**benchmark: object) -> Settings:
    return {"problems": [{"kind": "benchmark", "name": "asked", "benchmark": benchmark}]}


@pytest.mark.parametrize(
    ("claimed", "missing"),
    [
        (tuned, {"corpora": [{"kind": "jsonl", "file": "none.jsonl"}]}),
        (tuned, {"corpora": [{"kind": "worked", "dataset": "none"}]}),
        (tuned, {"corpora": [{"kind": "sampled", "folder": "none"}]}),
        (reinforced, asked(kind="jsonl", file="none.jsonl")),
        (reinforced, asked(kind="synthetic", dataset="none")),
        (
            reinforced,
            {
                "warm_start": {
                    **short_run.settings(Path())["warm_start"],
                    "corpora": [{"kind": "jsonl", "file": "none.jsonl"}],
                }
            },
        ),
    ],
)
def test_a_run_that_cannot_begin_claims_no_folder(
    claimed: Callable[..., object], missing: Settings, tmp_path: Path
) -> None:
    with pytest.raises(Sim2ReasonError, match="none"):
        claimed(tmp_path, **missing)
    assert not list(tmp_path.iterdir())
    claimed(tmp_path)


def test_a_model_that_is_missing_claims_no_folder(tmp_path: Path) -> None:
    pytest.importorskip("transformers")
    for claimed in (tuned, reinforced):
        with pytest.raises(TrainingError, match="no model could be loaded"):
            claimed(tmp_path, model={"kind": "pretrained", "model": str(tmp_path / "none")})
    assert not list(tmp_path.iterdir())


def test_a_plan_of_which_nothing_came_is_replaced(tmp_path: Path) -> None:
    tuned(tmp_path / "sft")
    tuned(tmp_path / "sft", steps=2)
    assert json.loads((tmp_path / "sft" / SFT_PLAN).read_text())["settings"]["steps"] == 2
    reinforced(tmp_path / "rl").warm_start.mkdir()
    (tmp_path / "rl/warm-start" / SFT_PLAN).touch()
    reinforced(tmp_path / "rl", reward="format")
    assert json.loads((tmp_path / "rl" / RL_PLAN).read_text())["settings"]["reward"]["kind"] == "format"


def test_a_run_from_which_something_came_is_not(tmp_path: Path) -> None:
    (tuned(tmp_path).path / "rows.jsonl").touch()
    with pytest.raises(TrainingError, match="holds a run with another setting of steps; choose a new folder"):
        tuned(tmp_path, steps=2)
    tuned(tmp_path)


def test_a_folder_of_something_else_is_not_claimed(tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").touch()
    with pytest.raises(TrainingError, match=r"holds thesis\.tex and is no run"):
        claim(tmp_path / RL_PLAN, {}, nothing)

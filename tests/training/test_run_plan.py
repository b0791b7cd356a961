"""Tests of the run that owns a folder: any valid one at first, no other one once there are results."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import short_run
from sim2reason.errors import Sim2ReasonError, TrainingError
from sim2reason.training.rl.config import TrainingFolder, build_reinforcement_learning
from sim2reason.training.run_files import RL_PLAN, SFT_PLAN, claim
from sim2reason.training.sft.config import SftFolder, build_fine_tuning

Settings = dict[str, Any]
MODEL = {"kind": "pretrained"}


def nothing() -> None:
    pass


def tuned(out: Path, **changed: object) -> SftFolder:
    settings = {"out": out, "model": {"kind": "scratch"}, "corpora": [{"kind": "drills"}], "steps": 1, **changed}
    folder = SftFolder(out)
    out.mkdir(exist_ok=True)
    folder.claim(build_fine_tuning(settings))
    return folder


def reinforced(out: Path, **changed: object) -> TrainingFolder:
    settings = short_run.settings(out) | changed
    if "model" in changed:
        del settings["warm_start"]
    folder = TrainingFolder(out)
    out.mkdir(exist_ok=True)
    folder.claim(build_reinforcement_learning(settings))
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
    (tuned(tmp_path).path / "log.jsonl").touch()
    with pytest.raises(TrainingError, match="holds a run with another setting of steps; choose a new folder"):
        tuned(tmp_path, steps=2)
    with pytest.raises(TrainingError, match=r"another setting of model\.layers"):
        tuned(tmp_path, model={"kind": "scratch", "layers": 2})
    tuned(tmp_path)


def test_what_was_prepared_alone_claims_no_folder(tmp_path: Path) -> None:
    """After a failure that leaves only held-out problems and rows, other settings may use the folder."""
    folder = reinforced(tmp_path)
    made = [folder.problems("rolling"), folder.warm_start / "rows.jsonl", folder.warm_start / "initial/config.json"]
    for path in made:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.touch()
    reinforced(tmp_path)
    assert all(path.is_file() for path in made), "the same run goes on with them"
    reinforced(tmp_path, reward="format")
    assert not any(path.is_file() for path in made)
    folder.held_out.mkdir(exist_ok=True)
    folder.problems("rolling").touch()
    folder.train.mkdir()
    (folder.train / "log.jsonl").touch()
    with pytest.raises(TrainingError, match="holds a run with another setting of reward"):
        reinforced(tmp_path)
    assert folder.problems("rolling").is_file()


@pytest.mark.parametrize(("text", "message"), [('{"prompt": "a", "completion": "b"}\n{}\n', ":2: "), ("\n", "no row")])
def test_a_corpus_is_read_to_its_end_before_a_folder_is_claimed(text: str, message: str, tmp_path: Path) -> None:
    (tmp_path / "rows.jsonl").write_text(text)
    corpora = [{"kind": "jsonl", "file": str(tmp_path / "rows.jsonl")}]
    with pytest.raises(TrainingError, match=message):
        tuned(tmp_path / "sft", corpora=corpora)
    with pytest.raises(TrainingError, match=message):
        reinforced(tmp_path / "rl", warm_start={**short_run.settings(Path())["warm_start"], "corpora": corpora})
    assert not [*(tmp_path / "sft").iterdir(), *(tmp_path / "rl").iterdir()]


def test_a_folder_of_something_else_is_not_claimed(tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").touch()
    with pytest.raises(TrainingError, match=r"holds thesis\.tex and is no run"):
        claim(tmp_path / RL_PLAN, {}, nothing)

"""Tests of whole studies on a tiny model."""

import json
import os
from pathlib import Path
from typing import Any

import pytest

from short_run import settings
from sim2reason.errors import TrainingError
from sim2reason.evaluation.benchmarks.runs.config import RunFolder
from sim2reason.training.study.config import build_study
from sim2reason.training.study.report import report_study
from sim2reason.training.study.run import prepare_study, train_study

pytest.importorskip("trl")
pytestmark = pytest.mark.filterwarnings("ignore")


@pytest.fixture(autouse=True)
def _one_thread(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("OMP_NUM_THREADS", "1")


def study(out: Path, **changed: object) -> dict[str, Any]:
    base = {name: value for name, value in settings(Path("run")).items() if name != "out"}
    base["gspo"] |= {"steps": 1, "rounds": 1}
    arms = {"ours": {}, "drawn": {"gspo": {"temperature": 0.9}}}
    return {"out": str(out), "base": base, "arms": arms, "seeds": [0, 1], "workers": 2, **changed}


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("studies") / "whole"
    os.environ["OMP_NUM_THREADS"] = "1"
    found = train_study(study(out))
    assert [(name, each.steps) for name, each in found.items()] == [
        ("ours-0", 1),
        ("drawn-0", 1),
        ("ours-1", 1),
        ("drawn-1", 1),
    ]
    return out


def test_a_warm_start_that_runs_share_is_made_once(whole: Path) -> None:
    files = {
        (whole / "runs" / f"{name}/warm-start/model/model.safetensors") for name in ("ours-0", "ours-1", "drawn-0")
    }
    assert len({file.stat().st_ino for file in files}) == 1
    rows = [(whole / "runs" / name / "held-out" / "rolling.jsonl").read_bytes() for name in ("ours-0", "drawn-1")]
    assert rows[0] == rows[1]


def test_what_a_warm_start_answers_is_asked_once_for_all_runs_that_ask_alike(whole: Path) -> None:
    for responses in ("greedy", "sampled"):
        held = [*whole.glob(f"runs/*/evaluation/{responses}/samples/before/rolling.jsonl")]
        assert (len(held), len({path.stat().st_mtime_ns for path in held})) == (4, 1)  # copies are as old
        assert len(held[0].read_text().splitlines()) == 4


def test_seeds_draw_other_prompts_and_arms_the_same(whole: Path) -> None:
    names = "ours-0", "drawn-0", "ours-1"
    plans = [json.loads((whole / "runs" / name / "rl.json").read_text())["settings"] for name in names]
    assert plans[0]["problems"] == plans[1]["problems"] != plans[2]["problems"]
    models = {(whole / "runs" / name / "model" / "model.safetensors").read_bytes() for name in names}
    assert len(models) == 3


def test_all_runs_stand_on_one_page(whole: Path) -> None:
    found = report_study(build_study(study(whole)))
    page = (whole / "report" / "report.md").read_text()
    assert len(found.runs) == 8
    assert [(each.responses, each.arm) for each in found.arms] == [
        ("greedy", "ours"),
        ("greedy", "drawn"),
        ("sampled", "ours"),
        ("sampled", "drawn"),
    ]
    assert found.arms[0].against is None
    assert found.arms[1].against is not None
    assert "Warm start of ours, drawn:" in page
    assert (whole / "report" / "steps.png").read_bytes()[:4] == b"\x89PNG"


def test_a_finished_study_is_not_run_again(whole: Path) -> None:
    logs = {file: file.stat().st_mtime_ns for file in (whole / "runs").glob("*.log")}
    train_study(study(whole))
    assert {file: file.stat().st_mtime_ns for file in (whole / "runs").glob("*.log")} == logs


def test_an_arm_that_means_something_else_now_is_refused(whole: Path) -> None:
    with pytest.raises(TrainingError, match="ours-0: holds a run with another setting of reward"):
        train_study(study(whole, arms={"ours": {"reward": "format"}}, seeds=[0]))


def test_a_study_may_shrink_and_grow(whole: Path) -> None:
    assert [*train_study(study(whole, seeds=[1]))] == ["ours-1", "drawn-1"]


def test_a_prepared_study_has_one_warm_start_for_all(tmp_path: Path) -> None:
    out = tmp_path / "study"
    arms = {"ours": {}, "drawn": {"gspo": {"temperature": 0.9}}, "short": {"gspo": {"max_completion_tokens": 6}}}
    assert prepare_study(study(out, arms=arms), until="data") == out
    assert [path.parent.name for path in out.glob("runs/*/warm-start")] == ["ours-0"]
    prepare_study(study(out, arms=arms))
    assert len({file.stat().st_ino for file in out.glob("runs/*/warm-start/model/model.safetensors")}) == 1
    assert not [*out.glob("runs/*/train")]
    asked = {
        path.parts[-3]: RunFolder(path).record.policies["before"] for path in out.glob("runs/*/evaluation/sampled")
    }
    assert asked.keys() == {"ours-0", "ours-1", "drawn-0", "drawn-1"}  # others would be cut off elsewhere
    assert len({str(policy.decisive["model"]) for policy in asked.values()}) == 4
    broken = study(tmp_path / "broken")
    broken["base"]["warm_start"]["max_completion_tokens"] = 1
    with pytest.raises(TrainingError, match=r"4 of 4 runs failed.*ours-1: .*no row is within the limits"):
        train_study(broken)


def test_a_run_that_fails_is_named_and_the_others_are_made(tmp_path: Path) -> None:
    arms = {"ours": {}, "broken": {"warm_start": {"model": {"kind": "scratch", "layers": 1, "width": 32, "heads": 2}}}}
    arms["broken"]["warm_start"]["corpora"] = [{"kind": "jsonl", "file": str(tmp_path / "rows.jsonl")}]
    with pytest.raises(TrainingError, match=r"arms\.broken: .*rows\.jsonl: no such file"):
        train_study(study(tmp_path / "study", arms=arms, seeds=[0]))
    assert not (tmp_path / "study" / "runs" / "broken-0").exists()
    arms["broken"] = {"gspo": {"steps": 2, "learning_rate": 1e30, "warmup_steps": 0}}
    with pytest.raises(TrainingError, match=r"1 of 2 runs failed.*broken-0: .*training has diverged"):
        train_study(study(tmp_path / "study", arms=arms, seeds=[0]))
    assert (tmp_path / "study" / "runs" / "ours-0" / "result.json").is_file()

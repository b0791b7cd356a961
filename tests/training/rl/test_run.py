"""Tests of whole runs on a tiny model: warm start, training, report, resumption, controls, another corpus."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest
import yaml

from short_run import PROBLEMS, settings
from sim2reason.errors import TrainingError
from sim2reason.evaluation.policies.local_model import LocalModel
from sim2reason.training.models import Checkpoint
from sim2reason.training.problem_stream import ProblemStream
from sim2reason.training.rl import report
from sim2reason.training.rl.config import build_reinforcement_learning
from sim2reason.training.rl.report import report_training
from sim2reason.training.rl.run import prepare_rl, train_rl
from sim2reason.training.sources.problems import Fresh

pytest.importorskip("trl")

pytestmark = pytest.mark.filterwarnings("ignore")
TIMES = "seconds"


def log(out: Path) -> list[dict[str, Any]]:
    """Return the log without the times, which differ between runs."""
    lines = [json.loads(line) for line in (out / "train" / "log.jsonl").read_text().splitlines()]
    return [{name: value for name, value in line.items() if name != TIMES} for line in lines]


def cursor(out: Path, updates: int) -> dict[str, Any]:
    return json.loads((out / "train" / f"checkpoint-{updates}" / "cursor.json").read_text())


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("runs") / "whole"
    train_rl(settings(out))
    return out


def test_a_run_leaves_a_model_a_log_and_a_report(whole: Path) -> None:
    found = report_training(build_reinforcement_learning(settings(whole)))
    assert [line["step"] for line in log(whole)] == [1, 2, 3]
    assert (whole / "model" / "model.safetensors").is_file()
    page = (whole / "report" / "report.md").read_text()
    assert "| all | 4 |" in page
    assert "best constant" in page
    assert (whole / "report" / "steps.png").read_bytes()[:4] == b"\x89PNG"
    assert set(found.differences) == {"greedy", "sampled"}
    assert 0.0 < found.overhead < 1.0


def test_a_prepared_run_ends_as_one_that_was_not(whole: Path, tmp_path: Path) -> None:
    out = tmp_path / "run"
    prepare_rl(settings(out), until="data")
    assert {file.name for file in out.iterdir()} == {"rl.json", "held-out", "warm-start"}
    assert (out / "warm-start" / "initial" / "model.safetensors").is_file()
    assert not (out / "warm-start" / "checkpoints").exists()
    prepare_rl(settings(out), until="warm-start")
    assert (out / "warm-start" / "model" / "model.safetensors").is_file()
    assert not (out / "train").exists()
    train_rl(settings(out))
    assert log(out) == log(whole)


def test_two_processes_prepare_what_one_does(whole: Path, tmp_path: Path) -> None:
    out = tmp_path / "run"
    prepare_rl(settings(out, processes=2), until="data")
    for file in ("held-out/keys.json", "warm-start/rows.jsonl", "warm-start/initial/model.safetensors"):
        assert (out / file).read_bytes() == (whole / file).read_bytes()


def test_no_held_out_problem_is_given_again_even_by_its_own_seed(whole: Path) -> None:
    held = {json.loads(line)["prompt"] for line in (whole / "held-out" / "rolling.jsonl").read_text().splitlines()}
    avoid = frozenset(json.loads((whole / "held-out" / "keys.json").read_text()))
    source = Fresh.model_validate({**PROBLEMS, "seed": 3})
    first = {problem.item.prompt for problem in ProblemStream([source]).problems(4)}
    assert len(held) == 4
    assert first == held
    assert not {problem.item.prompt for problem in ProblemStream([source], avoid=avoid).problems(4)} & held


def test_no_held_out_problem_is_in_the_warm_start(whole: Path, tmp_path: Path) -> None:
    """The corpus has the seed of the held-out problems, and those problems are removed from it."""
    given = settings(tmp_path / "run")
    (corpus, _) = given["warm_start"]["corpora"]
    corpus["problems"] = {**PROBLEMS, "seed": 3}
    given["gspo"] |= {"steps": 1, "rounds": 1}
    train_rl(given)
    counted = json.loads((tmp_path / "run" / "warm-start" / "corpora.json").read_text())[0]
    assert counted["left_out"] == {"held out": 4}
    held = {json.loads(line)["prompt"] for line in (whole / "held-out" / "rolling.jsonl").read_text().splitlines()}
    rows = [json.loads(line)["prompt"] for line in (tmp_path / "run/warm-start/rows.jsonl").read_text().splitlines()]
    assert not held & {*rows}


def test_a_finished_run_is_not_run_again(whole: Path) -> None:
    before = (whole / "train" / "log.jsonl").stat().st_mtime_ns
    assert train_rl(settings(whole)).steps == 3
    assert (whole / "train" / "log.jsonl").stat().st_mtime_ns == before


def test_another_configuration_is_refused(whole: Path) -> None:
    with pytest.raises(TrainingError, match="holds a run with another setting of reward"):
        train_rl(settings(whole, reward="format"))
    with pytest.raises(TrainingError, match="holds a run with another setting of held_out"):
        train_rl(settings(whole, held_out={"problems": {**PROBLEMS, "seed": 3}, "items": 5}))


def test_a_killed_run_goes_on_with_the_same_prompts(whole: Path, tmp_path: Path) -> None:
    out, file = tmp_path / "killed", tmp_path / "config.yaml"
    file.write_text(yaml.safe_dump(settings(out)))
    command = [sys.executable, "-m", "sim2reason", "train", "rl", str(file)]
    environment = {**os.environ, "OMP_NUM_THREADS": "1"}
    with subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
        while not (out / "train" / "checkpoint-2" / "cursor.json").is_file() and process.poll() is None:
            time.sleep(0.02)
        process.send_signal(signal.SIGKILL)
    train_rl(settings(out))
    assert log(out) == log(whole)
    assert cursor(out, 6) == cursor(whole, 6)


@pytest.mark.parametrize(
    "changed",
    [
        {"reward": "accuracy", "curriculum": {}},
        {"reward": "format"},
        {
            "problems": [{"kind": "fresh", **PROBLEMS, "seed": 2, "unfiltered": True}],
            "prefetch": {"workers": 1, "depth": 4},
        },
    ],
    ids=["curriculum", "format", "unfiltered"],
)
def test_controls_are_one_key_each(changed: dict[str, object], whole: Path, tmp_path: Path) -> None:
    model = {"kind": "pretrained", "model": str(whole / "warm-start" / "model")}
    gspo = {**settings(tmp_path)["gspo"], "steps": 1, "rounds": 1}
    given = settings(tmp_path / "run", model=model, gspo=gspo, **changed)
    del given["warm_start"], given["held_out"]
    assert train_rl(given).steps == 1
    found = report_training(build_reinforcement_learning(given))
    assert (found.folder / "steps.png").is_file()
    assert found.differences == {}
    assert (found.problems > 0.0) == bool(given["prefetch"]["workers"])


def test_settings_of_a_model_reach_the_trainer_and_the_evaluation(
    whole: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    told: list[Checkpoint] = []

    def instead(model: Checkpoint, *_: object) -> None:
        told.append(model)
        raise TrainingError("far enough")

    monkeypatch.setattr("sim2reason.training.rl.run.make_trainer", instead)
    path = str(whole / "warm-start" / "model")
    chosen = {"revision": "v1", "precision": "bfloat16", "attention": "eager"}
    given = settings(tmp_path / "run", model={"kind": "pretrained", "model": path, **chosen}, chat=False)
    del given["warm_start"]
    with pytest.raises(TrainingError, match="far enough"):
        train_rl(given)
    assert told == [Checkpoint(path, "v1", "bfloat16", "eager")]
    policy = report._policy(build_reinforcement_learning(given), "before", path, "v1", 0.0)
    assert isinstance(policy, LocalModel)
    assert (policy.revision, policy.chat, policy.batch_size, policy.precision) == ("v1", False, 64, "auto")
    quick = {**given, "gspo": {**given["gspo"], "precision": "bfloat16"}, "answers_together": 512}
    policy = report._policy(build_reinforcement_learning(quick), "before", path, "v1", 0.0)
    assert isinstance(policy, LocalModel)
    assert (policy.batch_size, policy.precision) == (512, "bfloat16")


def test_messages_need_a_chat_template(whole: Path, tmp_path: Path) -> None:
    model = {"kind": "pretrained", "model": str(whole / "warm-start" / "model")}
    given = settings(tmp_path / "run", model=model, chat=True)
    del given["warm_start"], given["held_out"]
    with pytest.raises(TrainingError, match="has no chat template; set chat to false"):
        train_rl(given)


def test_a_mixture_with_another_corpus(whole: Path, tmp_path: Path) -> None:
    file = tmp_path / "sums.jsonl"
    file.write_text("".join(json.dumps({"question": f"{n} + 2?", "answer": str(n + 2)}) + "\n" for n in range(8)))
    other = {"kind": "benchmark", "name": "sums", "benchmark": {"kind": "jsonl", "file": str(file)}}
    model = {"kind": "pretrained", "model": str(whole / "warm-start" / "model")}
    given = settings(tmp_path / "run", model=model, problems=[{"kind": "fresh", **PROBLEMS, "seed": 2}, other])
    del given["warm_start"], given["held_out"]
    train_rl(given)
    drawn = cursor(tmp_path / "run", 6)["stream"]["next"]
    assert abs(drawn["sums/sums"] - drawn["rolling/easy"]) <= 4

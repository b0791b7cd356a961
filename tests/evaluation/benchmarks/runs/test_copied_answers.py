"""Tests of answers copied from a run of the same model at another place."""

import json
from pathlib import Path

import pytest

from sim2reason.evaluation.benchmarks.runs.config import RunFolder, build_evaluation, copy_answers
from sim2reason.evaluation.benchmarks.runs.run import run
from sim2reason.evaluation.policies.journal import read_finished


@pytest.fixture
def made(tmp_path: Path) -> Path:
    """Build a run of two policies, the first of which uses the model `here`."""
    rows = [{"question": f"How much is {n}?", "answer": n, "id": f"n{n}"} for n in range(1, 4)]
    (tmp_path / "numbers.json").write_text(json.dumps(rows))
    policies = [{"kind": "constant", "name": name, "text": name} for name in ("1", "2")]
    benchmarks = [{"kind": "jsonl", "name": "numbers", "file": str(tmp_path / "numbers.json")}]
    out = tmp_path / "run"
    run(build_evaluation({"policies": policies, "benchmarks": benchmarks}, out))
    record = json.loads((out / "run.json").read_text())
    for held in ("settings", "decisive"):
        record["policies"]["1"][held]["model"] = "here"
    (out / "run.json").write_text(json.dumps(record))
    return out


def test_answers_of_the_model_come_along_and_no_others(made: Path, tmp_path: Path) -> None:
    out = tmp_path / "other"
    copy_answers(made, out, "here", "there")
    found = RunFolder(out)
    assert [(name, plan.decisive["model"]) for name, plan in found.record.policies.items()] == [("1", "there")]
    assert found.record.policies["1"].settings["model"] == "there"
    assert [each.id for each in read_finished(found.samples("1", "numbers"))] == ["n1", "n2", "n3"]
    assert not found.samples("2", "numbers").exists()
    assert len(found.items("numbers")) == 3


def test_nothing_is_begun_where_the_model_has_answered_nothing(made: Path, tmp_path: Path) -> None:
    copy_answers(made, tmp_path / "other", "elsewhere", "there")
    assert not (tmp_path / "other").exists()

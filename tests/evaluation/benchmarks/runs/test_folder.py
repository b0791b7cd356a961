"""Tests of the checks that a run makes before its first request."""

from pathlib import Path

import pytest

from sim2reason.errors import MissingExtraError, PolicyError
from sim2reason.evaluation.benchmarks.runs.config import build_evaluation
from sim2reason.evaluation.benchmarks.runs.run import run

POLICY = {"kind": "constant", "name": "p", "text": "1"}


def test_policies_come_before_problems_are_drawn(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sim2reason.evaluation.benchmarks.own.stream", None)
    monkeypatch.delenv("NO_KEY", raising=False)
    policy = {"kind": "endpoint", "name": "e", "url": "http://127.0.0.1:9/v1", "model": "m", "key_from": "NO_KEY"}
    settings = {"policies": [policy], "benchmarks": [{"kind": "synthetic", "name": "b", "seed": 1}]}
    with pytest.raises(PolicyError, match="NO_KEY holds no key"):
        run(build_evaluation(settings, tmp_path / "run"))
    assert not (tmp_path / "run").exists()


def test_a_rule_without_its_library_comes_before_anyone_is_asked(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sim2reason.evaluation.benchmarks.scoring.find_spec", lambda _: None)
    (tmp_path / "m.jsonl").write_text('{"problem": "1 + 1?", "answer": "2"}')
    settings = {"policies": [POLICY], "benchmarks": [{"kind": "math", "name": "m", "file": str(tmp_path / "m.jsonl")}]}
    with pytest.raises(MissingExtraError, match=r"pip install .*'math-verify"):
        run(build_evaluation(settings, tmp_path / "run"))
    assert not (tmp_path / "run").exists()

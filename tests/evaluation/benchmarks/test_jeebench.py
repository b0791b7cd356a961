"""Tests of JEEBench: its published rule on handwritten responses, and its loader on a small file.

The points of a case follow from the rule; None means a response without a readable answer.
"""

import json
from pathlib import Path
from typing import Any

import pytest

from sim2reason.errors import EvaluationError
from sim2reason.evaluation.benchmarks import build_benchmark, load_items
from sim2reason.evaluation.benchmarks.scoring import SCORINGS

CASES: list[dict[str, Any]] = [
    json.loads(line) for line in (Path(__file__).parent / "cases/jeebench.jsonl").read_text("utf-8").splitlines()
]


def test_there_are_enough_cases_of_every_type() -> None:
    assert len(CASES) >= 200
    for kind in ("MCQ", "MCQ(multiple)", "Integer", "Numeric"):
        points = [case["points"] for case in CASES if case["type"] == kind]
        assert len(points) >= 40
        assert {0, 1, None} <= set(points)


@pytest.mark.parametrize("case", CASES, ids=lambda case: f"{case['type']}-{case['answer']}-{case['response'][-25:]}")
def test_the_published_rule(case: dict[str, Any]) -> None:
    found = SCORINGS["jeebench"].award(case["response"], {"type": case["type"], "answer": case["answer"]})
    assert (found.points if found.readable else None) == case["points"], found
    assert found.readable or found.points == 0.0


def row(**fields: object) -> dict[str, object]:
    held = {"description": "A paper", "index": 1, "subject": "phy", "type": "Integer", "question": "One?", "gold": "1"}
    return {**held, **fields}


def test_the_loader_filters_by_subject_and_asks_by_type(tmp_path: Path) -> None:
    path = tmp_path / "dataset.json"
    rows = [row(), row(subject="math"), row(type="MCQ(multiple)", gold="AC"), row(type="MCQ", gold="B")]
    path.write_text(json.dumps(rows))
    found = load_items(build_benchmark({"kind": "jeebench", "name": "jee", "file": str(path), "subjects": ["phy"]}))
    assert [item.id for item in found] == ["jeebench-0", "jeebench-2", "jeebench-3"]
    assert "integer" in found[0].prompt
    assert "One or more options" in found[1].prompt
    assert found[1].reference == {"type": "MCQ(multiple)", "answer": "AC"}
    assert found[0].tags["subject"] == ("phy",)


@pytest.mark.parametrize(
    ("fields", "message"),
    [({"type": "Essay"}, "no such type"), ({"gold": "one"}, "row 0"), ({"type": "MCQ", "gold": "E"}, "no options")],
)
def test_a_row_that_is_none_is_named(tmp_path: Path, fields: dict[str, object], message: str) -> None:
    path = tmp_path / "dataset.json"
    path.write_text(json.dumps([row(**fields)]))
    with pytest.raises(EvaluationError, match=message):
        load_items(build_benchmark({"kind": "jeebench", "name": "jee", "file": str(path)}))

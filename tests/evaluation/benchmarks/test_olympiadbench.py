"""Tests of OlympiadBench: its published rule on handwritten responses, and its loader on a small file.

The verdict of a case follows from the rule, or from a difference that docs/evaluation.md lists; None means a response
without a readable answer.
"""

import json
from pathlib import Path
from typing import Any

import pytest

from sim2reason.errors import EvaluationError
from sim2reason.evaluation.benchmarks import build_benchmark, load_items
from sim2reason.evaluation.benchmarks.scoring import SCORINGS

CASES: list[dict[str, Any]] = [
    json.loads(line) for line in (Path(__file__).parent / "cases/olympiadbench.jsonl").read_text("utf-8").splitlines()
]


def test_there_are_enough_cases() -> None:
    assert len(CASES) >= 200
    assert sum(case["right"] == 1 for case in CASES) >= 80
    assert sum(case["right"] == 0 for case in CASES) >= 80


@pytest.mark.parametrize(
    "case", CASES, ids=lambda case: f"{case['reference']['answer'][:20]}-{case['response'][22:60]}"
)
def test_the_published_rule(case: dict[str, Any]) -> None:
    found = SCORINGS["olympiadbench"].award(case["response"], case["reference"])
    assert (found.points if found.readable else None) == case["right"], found


def row(**fields: object) -> dict[str, object]:
    held = {"id": 7, "subfield": "Mechanics", "question": "How far?", "final_answer": ["$2.5$"], "unit": "m"}
    held |= {"is_multiple_answer": False, "answer_type": "Numerical", "error": "1e-1", "source": "ours"}
    return {**held, **fields}


def loaded(tmp_path: Path, *rows: dict[str, object], **settings: object) -> list[str]:
    path = tmp_path / "file.json"
    path.write_text(json.dumps(rows))
    found = load_items(build_benchmark({"kind": "olympiadbench", "name": "o", "file": str(path), **settings}))
    return [item.id.removeprefix("olympiadbench-") for item in found]


def test_the_loader_leaves_out_figures_people_and_other_subjects(tmp_path: Path) -> None:
    pictured = row(id=2, question="See ![](a.png)")
    rows = [row(id=1), pictured, row(id=3, answer_type="Need_human_evaluate"), row(id=4, subfield="Optics")]
    assert loaded(tmp_path, *rows, subjects=["Mechanics"]) == ["1"]
    assert loaded(tmp_path, *rows) == ["1", "4"]
    assert loaded(tmp_path, *rows, text_only=False) == ["1", "2", "4"]
    assert loaded(tmp_path, *rows, limit=1) == ["1"]
    with pytest.raises(EvaluationError, match="no subject 'Botany'"):
        loaded(tmp_path, *rows, subjects=["Botany"])
    with pytest.raises(EvaluationError, match="row 0"):
        loaded(tmp_path, row(error="much"))
    with pytest.raises(EvaluationError, match="row 0 has no 'final_answer'"):
        loaded(tmp_path, {key: value for key, value in row().items() if key != "final_answer"})


def test_a_caption_stands_for_the_figure(tmp_path: Path) -> None:
    path = tmp_path / "file.json"
    path.write_text(json.dumps([row(question="See ![](a.png)", caption="A cart on a slope.")]))
    settings = {"kind": "olympiadbench", "name": "o", "file": str(path), "captions": "caption"}
    (found,) = load_items(build_benchmark(settings))
    assert found.prompt.startswith("The figure shows: A cart on a slope.\n\nSee")
    assert "in m, without the unit" in found.prompt

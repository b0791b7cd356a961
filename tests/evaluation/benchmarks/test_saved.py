"""Tests that problems saved by a run are asked again unchanged."""

from pathlib import Path

import pytest

from sim2reason.datasets.items import item
from sim2reason.errors import EvaluationError
from sim2reason.evaluation.benchmarks import build_benchmark, load_items
from sim2reason.evaluation.benchmarks.own import benchmark_item


def test_what_was_saved_comes_back(tmp_path: Path) -> None:
    file = tmp_path / "held.jsonl"
    saved = [benchmark_item(item("pulley", "easy", seed=3, index=n)) for n in range(2)]
    file.write_text("".join(f"{each.model_dump_json()}\n" for each in saved))
    assert load_items(build_benchmark({"kind": "saved", "name": "held", "file": file})) == saved


def test_a_row_that_is_no_problem_is_named(tmp_path: Path) -> None:
    file = tmp_path / "held.jsonl"
    file.write_text('{"id": "a"}\n')
    with pytest.raises(EvaluationError, match=r"row 0: prompt"):
        load_items(build_benchmark({"kind": "saved", "name": "held", "file": file}))

"""Fixtures for reports on small runs."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from sim2reason.evaluation.benchmarks import build_benchmark
from sim2reason.evaluation.benchmarks.runs.config import Evaluation
from told_policy import Told

Made = Callable[..., Evaluation]


@pytest.fixture
def made(tmp_path: Path) -> Made:
    """Return a function that evaluates policies of given answers on twenty numbers, of subjects even and odd."""

    def make(*policies: Told, out: str = "run", names: tuple[str, ...] = ("numbers",), **settings: int) -> Evaluation:
        rows = [
            {"question": f"How much is {n}?", "answer": n, "id": f"n{n}", "subject": "odd" if n % 2 else "even"}
            for n in range(20)
        ]
        path = tmp_path / "numbers.json"
        path.write_text(json.dumps(rows))
        benchmarks = tuple(build_benchmark({"kind": "jsonl", "name": name, "file": str(path)}) for name in names)
        return Evaluation(tmp_path / out, policies or (Told(name="told"),), benchmarks, **settings)

    return make

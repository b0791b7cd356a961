"""Small runs to report on."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from sim2reason.evaluation.benchmarks import benchmark_from
from sim2reason.evaluation.benchmarks.runs.config import Evaluation
from told_policy import Told

Made = Callable[..., Evaluation]


@pytest.fixture
def made(tmp_path: Path) -> Made:
    """An evaluation of told policies on twenty numbers, whose subjects are even and odd."""

    def make(*policies: Told, out: str = "run", names: tuple[str, ...] = ("numbers",), **settings: int) -> Evaluation:
        rows = [
            {"question": f"How much is {n}?", "answer": n, "id": f"n{n}", "subject": "odd" if n % 2 else "even"}
            for n in range(20)
        ]
        path = tmp_path / "numbers.json"
        path.write_text(json.dumps(rows))
        benchmarks = tuple(benchmark_from({"kind": "jsonl", "name": name, "file": str(path)}) for name in names)
        return Evaluation(tmp_path / out, policies or (Told(name="told"),), benchmarks, **settings)

    return make

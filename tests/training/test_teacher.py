"""Tests of the way from a teacher behind an address to a trained model, by the commands that a user gives."""

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import yaml

from faulty_endpoint import FAULTS, KEY, Said, answer, serving
from sim2reason import generate
from sim2reason.training.corpora.rows import read_rows

pytest.importorskip("trl")
MODEL = {"kind": "scratch", "layers": 1, "width": 32, "heads": 2, "vocabulary": 600, "context": 1024}


def command(*arguments: object) -> None:
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "TEACHER_KEY": KEY}
    line = [sys.executable, "-m", "sim2reason", *map(str, arguments)]
    subprocess.run(line, env=environment, check=True, stdout=subprocess.DEVNULL)


def test_right_responses_of_an_endpoint_become_a_model(tmp_path: Path) -> None:
    drawn = {"recipe": "collision", "difficulty": "easy", "solutions": True}
    problems = generate(tmp_path / "problems", items=6, workers=1, **drawn)
    solved = {item.prompt: item.solution.text for item in problems if item.solution is not None}

    def teach(number: int, fields: dict[str, Any], key: str) -> Said:
        """Return a fault for every fourth request, and a wrong response for every other seed."""
        if number % 4 == 0:
            return FAULTS["broken"](key)
        told = solved[fields["messages"][-1]["content"]]
        return Said(answer(told if fields["seed"] % 2 else r"\boxed{-1}"))

    with serving(teach) as endpoint:
        policy = {"kind": "endpoint", "name": "teacher", "url": endpoint.url, "model": "m", "key_from": "TEACHER_KEY"}
        (tmp_path / "policy.yaml").write_text(yaml.safe_dump(policy))
        out = tmp_path / "solutions"
        command("sample-solutions", problems.path, "--policy", tmp_path / "policy.yaml", "--k", 6, "-o", out)
    kept = list(read_rows(out / "solutions.jsonl"))
    assert kept
    assert {row.prompt: row.completion for row in kept}.items() <= solved.items()
    (tmp_path / "sft.yaml").write_text(
        yaml.safe_dump(
            {
                "out": str(tmp_path / "tuned"),
                "model": MODEL,
                "corpora": [{"kind": "sampled", "folder": str(out)}],
                "steps": 2,
                "batch": 2,
                "learning_rate": 1e-3,
                "device": "cpu",
            }
        )
    )
    command("train", "sft", tmp_path / "sft.yaml")
    result = json.loads((tmp_path / "tuned" / "result.json").read_text())
    assert result["rows"] == len(kept)
    assert (tmp_path / "tuned" / "model" / "model.safetensors").is_file()
    assert all(KEY.encode() not in file.read_bytes() for file in out.rglob("*") if file.is_file())

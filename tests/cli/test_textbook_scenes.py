"""Tests of forty textbook scenes: one command answers each, from words and from parts."""

import json
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from sim2reason.cli.questions import solve_command
from sim2reason.scenes.dsl.units import parse_unit

DATA = Path(__file__).parents[1] / "data"
ROWS: list[dict[str, Any]] = [
    json.loads(row) for row in (DATA / "textbook_scenes.jsonl").read_text("utf-8").splitlines()
]
EXACT = 1e-6  # relative


def answered(*options: str) -> dict[str, Any]:
    """Run the command with --json and return its output."""
    found = CliRunner().invoke(solve_command, [*options, "--json"])
    assert found.exit_code == 0, found.output
    read: dict[str, Any] = json.loads(found.stdout)
    return read


@pytest.mark.parametrize("row", ROWS, ids=[row["scene"] for row in ROWS])
def test_each_scene_is_answered_in_words_and_in_parts(row: dict[str, Any]) -> None:
    """Both answers agree with the closed form."""
    path = str(DATA / "textbook_scenes" / f"{row['scene']}.yaml")
    parts = [option for name, part in row["parts"].items() for option in (f"--{name}", part)]
    for options in ([], ["--question", row["question"]], parts):
        read = answered(path, *options)
        factor = parse_unit(read["unit"]).factor_to(parse_unit(row["unit"]))
        assert factor is not None
        assert read["from_motion"] * factor == pytest.approx(row["value"], rel=EXACT), read


def test_there_are_forty() -> None:
    assert len(ROWS) >= 40
    assert {row["scene"] for row in ROWS} == {path.stem for path in (DATA / "textbook_scenes").glob("*.yaml")}

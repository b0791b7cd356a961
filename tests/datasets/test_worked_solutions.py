"""Tests of datasets with worked solutions: the same problems, with solutions that the grader finds right."""

from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import CliRunner

from fake_makers import steady
from sim2reason.cli import main
from sim2reason.datasets.build import build
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.grade import grade
from sim2reason.datasets.plan import Config
from sim2reason.datasets.store import read, write
from sim2reason.generation.certified import solution_record
from sim2reason.generation.item import Item
from sim2reason.generation.request import Request
from sim2reason.solutions import Solution

CONFIG = Config(items=6, recipes=("hybrid", "projectile"), difficulties=("easy",), shard=2, solutions=True)


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build six problems with solutions, without pictures."""
    out = tmp_path_factory.mktemp("solved")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("sim2reason.datasets.build.put_pictures", lambda *_: ())
        build(out, CONFIG, workers=1)
    return out


def test_problems_are_those_without_solutions_and_each_solution_is_graded_right(data: Path, tmp_path: Path) -> None:
    build(tmp_path, CONFIG.model_copy(update={"solutions": False}), workers=1)
    bare, solved = list(Dataset(tmp_path)), list(Dataset(data))
    assert [item.model_copy(update={"solution": None, "unsolved": ""}) for item in solved] == bare
    assert all(item.solution is None and not item.unsolved for item in bare)
    for item in solved:
        assert (item.solution is None) == bool(item.unsolved)
        if item.solution is not None:
            assert grade(item, item.solution.text).reward == 1.0
            assert all(step.text in item.solution.text for step in item.solution.steps)
            assert all(needed < n for n, step in enumerate(item.solution.steps) for needed in step.needs)
    assert any(item.solution is not None and item.solution.derived for item in solved)


def test_two_workers_and_a_second_run_end_in_the_same_bytes(
    data: Path, tmp_path: Path, contents: Callable[[Path], dict[str, bytes]]
) -> None:
    build(tmp_path, CONFIG, workers=2)
    (tmp_path / "data/train-00001-of-00003.parquet").unlink()
    build(tmp_path, CONFIG, workers=2)
    assert contents(tmp_path) == contents(data)


def test_a_problem_without_a_solution_says_why(tmp_path: Path) -> None:
    made = steady(Request("pulley", "easy", "numeric", 0, 0)).item
    assert made is not None
    solution, unsolved = solution_record(Solution("", reason="no strategy applies"))
    item: Item = made.model_copy(update={"solution": solution, "unsolved": unsolved})
    write(tmp_path / "shard.parquet", [item])
    assert read(tmp_path / "shard.parquet") == [item]
    assert (item.solution, item.unsolved) == (None, "no strategy applies")


def test_the_command_makes_and_shows_them(data: Path, tmp_path: Path) -> None:
    run = CliRunner().invoke
    made = run(main, ["generate", str(tmp_path), "--items", "1", "--recipe", "hybrid", "--solutions"])
    assert made.exit_code == 0, made.output
    assert " --solutions\n" in (tmp_path / "README.md").read_text()
    solved = next(item for item in Dataset(data) if item.solution is not None)
    assert solved.solution is not None
    assert solved.solution.text in run(main, ["show", str(data), "--id", solved.id, "--solutions"]).output
    told = run(main, ["explain", str(data), "--id", solved.id])
    assert told.exit_code == 0, told.output
    assert solved.solution.strategy in told.output

"""Tests of ``sim2reason explain``, which tells how a problem was made and trusts nothing in the file."""

from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from sim2reason.cli import main
from sim2reason.datasets.build import build
from sim2reason.datasets.plan import Config
from sim2reason.generation.filters import FILTERS


def call(*args: object) -> Result:
    return CliRunner().invoke(main, [str(arg) for arg in args])


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build a dataset of two problems."""
    out = tmp_path_factory.mktemp("explained")
    build(out, Config(items=2, recipes=("incline",), difficulties=("easy", "medium")), workers=1)
    return out


def test_every_filter_has_its_say(data: Path) -> None:
    told = call("explain", data, "--id", "incline-medium-numeric-0-0")
    assert told.exit_code == 0, told.output
    for title in ("Problem", "Scene", "Certificate", "Refused before it", "Filters", "Wrong answers"):
        assert f"{title}\n" in told.output
    for name in FILTERS:
        assert f"  {name}: keeps it\n" in told.output
    assert "the condition number is" in told.output
    assert "|d ln answer / d ln number|" in told.output
    assert "    the nearest number of scene and question is " in told.output
    assert "    the worst difference of the engines is " in told.output


def test_figure_and_trace_are_written(data: Path, tmp_path: Path) -> None:
    figure, trace = tmp_path / "scene.svg", tmp_path / "trace.parquet"
    told = call("explain", data, "--id", "incline-easy-numeric-0-0", "--figure", figure, "--trace", trace)
    assert told.exit_code == 0, told.output
    assert figure.stat().st_size > 1000
    assert trace.stat().st_size > 1000


def test_numbers_without_bearing_are_named(tmp_path: Path) -> None:
    """The acceleration of a lone block on an incline does not depend on its mass."""
    build(tmp_path, Config(items=1, recipes=("incline",), difficulties=("easy",), seed=771), workers=1)
    told = call("explain", tmp_path, "--id", "incline-easy-numeric-771-0")
    assert told.exit_code == 0, told.output
    assert "Without bearing\n  the number two_side_mass_plane.blocks.0.mass\n" in told.output


@pytest.mark.parametrize(("option", "name"), [("--figure", "z.bmp"), ("--trace", "z.csv")])
def test_another_format_is_refused_by_name(data: Path, tmp_path: Path, option: str, name: str) -> None:
    told = call("explain", data, "--id", "incline-easy-numeric-0-0", option, tmp_path / name)
    assert told.exit_code == 2
    assert told.output.startswith(f"sim2reason: {tmp_path / name}: ")
    assert told.output.count("\n") == 1
    assert not list(tmp_path.iterdir())


def test_an_unknown_problem_is_one_line(data: Path) -> None:
    told = call("explain", data, "--id", "nobody")
    assert told.exit_code == 2
    assert told.output.count("\n") == 1
    assert "sim2reason show" in told.output


def test_a_problem_of_another_version_is_said_to_be_one(data: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sim2reason.generation.item_search.ItemSearch.find", lambda _: None)
    told = call("explain", data, "--id", "incline-easy-numeric-0-0")
    assert told.exit_code == 2
    assert "another problem" in told.output


def test_a_problem_of_a_dataset_without_filters(tmp_path: Path) -> None:
    build(tmp_path, Config(items=1, recipes=("incline",), difficulties=("easy",), unfiltered=True), workers=1)
    told = call("explain", tmp_path, "--id", "incline-easy-numeric-0-0-unfiltered")
    assert told.exit_code == 0, told.output


def test_refused_questions_are_shown_with_the_numbers_of_their_filters() -> None:
    told = call("explain", "--id", "springs-hard-numeric-3-0", "--refused")
    assert told.exit_code == 0, told.output
    counts, shown = told.output.split("Refused before it\n")[1].split("\nSolution\n")[0].split("\nRefused questions\n")
    reasons = [line.strip().removeprefix("refused by ") for line in shown.splitlines() if "refused by " in line]
    assert reasons
    assert {reason.split(": ")[0] for reason in reasons} <= {*FILTERS}
    assert all(reason.split(": ")[0] in counts for reason in reasons)
    assert "condition number is 53.67; up to 20 is allowed" in shown


def test_without_a_dataset_the_coordinates_are_enough(data: Path) -> None:
    name = "incline-easy-numeric-0-0"
    assert call("explain", "--id", name).output == call("explain", data, "--id", name).output
    told = call("explain", "--id", "nonsense")
    assert (told.exit_code, told.output.count("\n")) == (2, 1)

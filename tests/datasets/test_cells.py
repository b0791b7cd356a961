"""Tests of the table of requested and kept items, and of empty cells that are not due to chance."""

from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import CliRunner

from sim2reason.cli import main
from sim2reason.datasets.dataset import verify
from sim2reason.datasets.manifest import (
    FALSE_ALARM_PROBABILITY,
    MIN_KEPT_SHARE,
    Cell,
    Manifest,
    empty,
    failure_limit,
    load,
    table,
)
from sim2reason.generation.item_search import MAX_EMPTY_SCENES
from sim2reason.generation.make import make as make_item
from sim2reason.generation.question_search import NOTHING
from sim2reason.generation.request import Request
from sim2reason.questions import KINDS

Make = Callable[..., Manifest]


def test_the_table_counts_what_was_asked_for_and_what_was_kept() -> None:
    state, event = ("numeric", "state", "box"), ("numeric", "event", "box")
    assert table([(state, 2), (event, 1), (state, 1)], [event, event]) == (
        Cell(mode="numeric", kind="event", recipe="box", asked=1, kept=2),
        Cell(mode="numeric", kind="state", recipe="box", asked=3, kept=0),
    )


@pytest.mark.parametrize("cells", [1, 30, 300])
def test_enough_is_where_the_binomial_tail_of_all_cells_falls_below_the_false_alarm(cells: int) -> None:
    """P(none of n) = (1 − p)^n; the sum over all cells bounds the probability of any empty one (Bonferroni)."""
    number = failure_limit(cells)
    assert (
        cells * (1.0 - MIN_KEPT_SHARE) ** number
        <= FALSE_ALARM_PROBABILITY
        < cells * (1.0 - MIN_KEPT_SHARE) ** (number - 1)
    )


def test_only_a_cell_that_was_asked_for_often_enough_is_an_error() -> None:
    often, seldom = failure_limit(3), failure_limit(3) - 1
    cells = [
        Cell(mode="numeric", kind="sum", recipe="box", asked=often, kept=0),
        Cell(mode="numeric", kind="state", recipe="box", asked=seldom, kept=0),
        Cell(mode="numeric", kind="event", recipe="box", asked=often, kept=1),
    ]
    (line,) = empty(cells)
    assert line.startswith(f"box.numeric.sum: asked for {often} times, and none was kept")
    assert "the weight box.numeric.sum=0" in line


def test_the_manifest_and_the_card_show_the_table(make: Make, tmp_path: Path) -> None:
    manifest = make(maker="fake_makers:wanting", items=20)
    assert manifest.cells == (
        Cell(mode="numeric", kind="period", recipe="incline", asked=11, kept=0),
        Cell(mode="numeric", kind="period", recipe="pulley", asked=10, kept=0),
        Cell(mode="numeric", kind="state", recipe="incline", asked=0, kept=10),
        Cell(mode="numeric", kind="state", recipe="pulley", asked=0, kept=10),
    )
    assert load(tmp_path / "data") == manifest
    assert "| numeric | period | pulley | 10 | 0 |" in (tmp_path / "data/README.md").read_text()


def test_shards_that_stand_keep_their_counts(make: Make, tmp_path: Path, contents: Callable[..., object]) -> None:
    """After a lost shard is made again, the counts of the others come from the records of the shards."""
    make(maker="fake_makers:wanting")
    before = contents(tmp_path / "data")
    (tmp_path / "data/data/train-00001-of-00005.parquet").unlink()
    make(maker="fake_makers:wanting")
    assert contents(tmp_path / "data") == before


def test_an_empty_cell_is_an_error_of_generate_and_verify(tmp_path: Path) -> None:
    out, items = tmp_path / "data", 4 * failure_limit(4)
    usual = "--recipe", "incline,pulley", "--difficulty", "easy", "--workers", "1", "--maker", "fake_makers:wanting"
    result = CliRunner().invoke(main, ["generate", str(out), "--items", str(items), *usual])
    assert result.exit_code == 1
    assert "an empty cell: incline.numeric.period: asked for" in result.stderr
    assert load(out).rows == items  # the data are kept
    assert [fault.partition(":")[0] for fault in verify(out).faults] == [
        "incline.numeric.period",
        "pulley.numeric.period",
    ]
    few = CliRunner().invoke(main, ["generate", str(tmp_path / "few"), "--items", "20", *usual])
    assert few.exit_code == 0


def test_a_cell_of_which_no_scene_offers_a_kind_was_not_asked_for() -> None:
    """Projectile problems never ask for a period."""
    weights = tuple((name, float(name == "period")) for name in KINDS)
    made = make_item(Request("projectile", "easy", "numeric", 0, 0, weights))
    assert (made.item, made.wanted) == (None, "")
    assert made.rejected.keys() == {NOTHING}
    assert made.rejected[NOTHING] >= MAX_EMPTY_SCENES


def test_a_dataset_of_which_nothing_could_be_made_is_an_error(tmp_path: Path) -> None:
    """Projectile problems never ask for a period, so no cell was asked for, although it was tried."""
    options = ["-n", "2", "--recipe", "projectile", "--difficulty", "easy", "--weights", _only("period")]
    told = CliRunner().invoke(main, ["generate", str(tmp_path / "data"), *options])
    assert told.exit_code == 2
    assert "0 problems of 2 asked for, and of 20 tries the last ones gave nothing new; ask" in told.output
    (line,) = verify(tmp_path / "data").faults
    assert line.startswith("no problem at all: none of 20 could be made")


def _only(kind: str) -> str:
    return ",".join(f"{name}={float(name == kind):g}" for name in KINDS)

"""Tests of fresh problems for a trainer: the same rows by position and in order, endless, in any process."""

import pickle
from itertools import islice
from pathlib import Path
from typing import Any

import pytest

import sim2reason
from sim2reason.datasets.exports import EXPORTS, RowPosition
from sim2reason.errors import DatasetError, DrawError, MissingExtraError, UnknownNameError
from sim2reason.generation.request import Request, load_maker

FAKE: dict[str, Any] = {"recipe": ("pulley", "springs"), "difficulty": "easy", "maker": "fake_makers:with_answers"}


@pytest.mark.parametrize("to", [name for name in EXPORTS if name != "multiple-choice"])
def test_rows_are_those_of_the_export_in_order_and_by_position(to: str) -> None:
    rows = sim2reason.iterable(to, **FAKE)
    first = list(islice(rows, 30))
    assert [rows[number] for number in range(30)] == first
    assert list(islice(rows, 30)) == first, "each iteration begins anew"
    assert list(islice(pickle.loads(pickle.dumps(rows)), 30)) == first
    made = load_maker(FAKE["maker"])(Request("pulley", "easy", "numeric", 0, 0)).item
    assert made is not None
    assert first[0] == EXPORTS[to].row(made, RowPosition("train", 0))


def test_an_item_that_the_export_cannot_hold_is_passed_over() -> None:
    rows = sim2reason.iterable("multiple-choice", **FAKE, items=60)
    assert 0 < len(list(rows)) < 60


def test_they_begin_and_end_where_is_said() -> None:
    ids = [row["id"] for row in islice(sim2reason.iterable(**FAKE), 20)]
    assert [row["id"] for row in sim2reason.iterable(**FAKE, start=5, items=7)] == ids[5:12]
    assert [row["id"] for row in sim2reason.iterable(**FAKE, items=0)] == []
    with pytest.raises(IndexError):
        sim2reason.iterable(**FAKE, items=3)[3]
    assert len(set(ids)) == 20
    assert not set(ids) & {row["id"] for row in islice(sim2reason.iterable(**FAKE, seed=1), 20)}


def test_shards_share_the_rows() -> None:
    whole = [row["id"] for row in sim2reason.iterable(**FAKE, items=10)]
    parts = [[row["id"] for row in part] for part in sim2reason.iterable(**FAKE, items=10).shards(3)]
    assert [len(part) for part in parts] == [4, 3, 3]
    assert sorted(name for part in parts for name in part) == sorted(whole)


def test_hugging_face_streams_them_with_their_columns() -> None:
    datasets = pytest.importorskip("datasets")
    rows = sim2reason.iterable(**FAKE)
    loaded = rows.to_hugging_face()
    assert isinstance(loaded, datasets.IterableDataset)
    assert list(loaded.take(25)) == list(islice(rows, 25))
    assert set(loaded.features) == set(EXPORTS["hf"].columns)
    two = sim2reason.iterable(**FAKE, items=9).to_hugging_face(shards=2)
    assert two.num_shards == 2
    assert sorted(row["id"] for row in two) == sorted(row["id"] for row in islice(rows, 9))


def test_nested_columns_are_streamed_too() -> None:
    pytest.importorskip("datasets")
    rows = sim2reason.iterable("verl", **FAKE)
    assert list(rows.to_hugging_face().take(3)) == list(islice(rows, 3))


def test_real_problems_have_worked_solutions_where_they_are_asked_for() -> None:
    order: dict[str, Any] = {"recipe": "pulley", "difficulty": "easy", "seed": 3}
    (row,) = sim2reason.iterable(**order, items=1, solutions=True)
    (bare,) = sim2reason.iterable(**order, items=1)
    assert row["solution"]
    assert bare == row | {"solution": None}


@pytest.mark.parametrize(
    ("order", "error", "told"),
    [
        ({"to": "trl"}, UnknownNameError, "did you mean: hf"),
        ({"recipe": "puly"}, UnknownNameError, "did you mean: pulley"),
        ({"items": -1}, DrawError, "items: -1 is no whole number"),
        ({"start": 2.5}, DrawError, r"start: 2\.5 is no whole number"),
        ({"start": 2**60}, DatasetError, "too many"),
        ({"weights": "x"}, DatasetError, "weights: 'x' is no mapping"),
        ({"decontaminate": "none.jsonl"}, DatasetError, "none.jsonl"),
    ],
)
def test_what_makes_no_sense_is_told_at_once(order: dict[str, Any], error: type[Exception], told: str) -> None:
    with pytest.raises(error, match=told):
        sim2reason.iterable(**order)


def test_a_number_of_shards_that_is_none_and_a_missing_library_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    import sys

    rows = sim2reason.iterable(**FAKE)
    with pytest.raises(DatasetError, match="shards: 0 of them"):
        rows.shards(0)
    monkeypatch.setitem(sys.modules, "datasets", None)
    with pytest.raises(MissingExtraError, match="datasets is not installed; install it with: pip install datasets"):
        rows.to_hugging_face()


def test_no_row_has_the_words_of_a_benchmark(tmp_path: Path) -> None:
    order: dict[str, Any] = {"recipe": "pulley", "difficulty": "easy"}
    first = sim2reason.iterable(**order)[0]
    (tmp_path / "bench.txt").write_text(first["prompt"][0]["content"], encoding="utf-8")
    assert sim2reason.iterable(**order, decontaminate=tmp_path / "bench.txt")[0]["id"] != first["id"]

"""Tests of rows that are made when a trainer asks for them, mixed with stored ones by weight."""

import pickle
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from sim2reason.datasets.exports import EXPORTS
from sim2reason.errors import DatasetError, UnknownNameError
from sim2reason.questions import MODES
from sim2reason.rewards import compute_score
from sim2reason.training.lazy_rows import LazyRows, LazySettings

DRAWN = "items: 120\nrecipe: [pulley, springs]\ndifficulty: easy\nseed: 3\nmaker: fake_makers:with_answers\n"


@pytest.fixture
def described(tmp_path: Path) -> Path:
    path = tmp_path / "problems.yaml"
    path.write_text(DRAWN)
    return path


def stored(count: int) -> list[dict[str, Any]]:
    columns = dict.fromkeys(EXPORTS["verl"].columns)
    return [{**columns, "data_source": "other", "extra_info": {"index": n}, "more": n} for n in range(count)]


def test_rows_are_those_of_the_export_with_the_number_of_the_row(described: Path) -> None:
    rows = LazyRows(described, "verl")
    assert len(rows) == 120
    for number in (0, 1, 119):
        row = rows[number]
        assert row.keys() == EXPORTS["verl"].columns.keys()
        assert row["extra_info"]["index"] == number
        assert row["extra_info"]["split"] == "train"
        assert row["extra_info"]["recipe"] == ("pulley", "springs")[number % 2]
        assert compute_score(row["data_source"], "nothing", row["reward_model"]["ground_truth"]) == 0.0
    assert rows[5] == pickle.loads(pickle.dumps(rows))[5] == LazyRows(described, "verl")[5]
    for number in (-1, 120):
        with pytest.raises(IndexError, match=f"row {number} of 120"):
            rows[number]


@pytest.mark.parametrize(("share", "drawn"), [("0.5", 60), ("0.25", 30), ("0.9", 108), ("0.333", 39)])
def test_of_any_stretch_the_share_is_drawn(described: Path, share: str, drawn: int) -> None:
    described.write_text(f"{DRAWN}share: {share}\n")
    rows = LazyRows(described, "verl", stored(7))
    ours = [row["data_source"] == "sim2reason" for row in rows]
    assert sum(ours) == drawn
    for start in range(0, 100, 7):
        assert abs(sum(ours[start : start + 20]) - 20 * float(share)) < 1.0
    seen = [row["extra_info"]["id"] for row, own in zip(rows, ours, strict=True) if own]
    assert len(set(seen)) == drawn
    assert all("more" not in row for row in rows)


def test_stored_rows_come_once_in_each_lap_and_in_another_order_each_time(described: Path) -> None:
    described.write_text(f"{DRAWN}share: 0.5\n")
    rows = LazyRows(described, "verl", stored(20))
    others = [row["extra_info"]["index"] for row in rows if row["data_source"] == "other"]
    laps = [others[start : start + 20] for start in (0, 20, 40)]
    assert all(Counter(lap) == Counter(range(20)) for lap in laps)
    assert len({tuple(lap) for lap in laps}) == 3
    again = LazyRows(described, "verl", stored(20))
    assert [again[number] for number in reversed(range(120))] == [rows[number] for number in reversed(range(120))]


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("itmes: 3\n", "items: is missing"),
        (f"{DRAWN}recipes: pulley\n", "recipes: no such setting"),
        ("items: 0\n", "items: must be at least 1"),
        (f"{DRAWN}share: 0\n", "share: must be greater than 0"),
        (f"{DRAWN}split: {{train: 0.5}}\n", "split: the shares add up to 0.5; give all of them"),
        (f"{DRAWN}take: test\n", "there is no split 'test'"),
        (f"{DRAWN}decontaminate: [missing.jsonl]\n", "missing.jsonl"),
        ("- 3\n", "holds no settings"),
        ("a: &a [1]\nb: *a\n", "an alias"),
        (f"{DRAWN}share: 0.5\n", "share is 0.5, but there are no stored rows; give both or neither"),
    ],
)
def test_what_a_file_may_not_say_is_told_in_one_line(described: Path, text: str, told: str) -> None:
    described.write_text(text)
    with pytest.raises(DatasetError) as error:
        LazyRows(described, "verl")
    assert told in str(error.value)
    assert str(error.value).startswith(f"{described}: ")
    assert "\n" not in str(error.value)


def test_stored_rows_must_fit(described: Path) -> None:
    with pytest.raises(DatasetError, match="so that stored rows would never be shown"):
        LazyRows(described, "verl", stored(1))
    described.write_text(f"{DRAWN}share: 0.5\n")
    with pytest.raises(DatasetError, match="a stored row has no column 'data_source'; it has prompt"):
        LazyRows(described, "verl", [{"prompt": "?"}])[0]


def test_unknown_names_are_told_with_the_right_ones(described: Path) -> None:
    described.write_text("items: 3\nrecipe: puley\n")
    with pytest.raises(UnknownNameError, match=rf"{described}: .*did you mean: pulley"):
        LazyRows(described, "verl")
    with pytest.raises(UnknownNameError, match="did you mean: verl"):
        LazyRows(described, "vrl")


def test_names_are_one_or_several(described: Path) -> None:
    described.write_text("items: 3\nrecipe: pulley\ndifficulty: [easy, hard]\nmode: all\n")
    config = LazySettings.read(described).problems().config
    assert config.recipes == ("pulley",)
    assert config.difficulties == ("easy", "hard")
    assert config.modes == tuple(sorted(MODES))

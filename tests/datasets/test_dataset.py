"""Tests of an opened dataset, with items of the fake maker."""

import sys
from collections.abc import Callable
from os import fspath
from pathlib import Path

import pytest

from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.manifest import Manifest
from sim2reason.datasets.plan import Config
from sim2reason.errors import DatasetError, MissingExtraError

Make = Callable[..., Manifest]


def test_it_knows_how_many_it_holds_and_gives_them_in_order(data: Path, config: Config) -> None:
    opened = Dataset(data)
    wanted = [config.request(k).id for k in range(96)]
    wanted.remove("incline-easy-numeric-0-3")
    assert len(opened) == 95
    assert repr(opened) == f"<Dataset {str(data)!r}: 95 train>"
    assert [item.id for item in opened] == wanted


def test_any_item_is_found_by_its_id(data: Path) -> None:
    opened = Dataset(data)
    assert all(opened.item(item.id) == item for item in opened)


@pytest.mark.parametrize(
    "name", ["nobody", "pulley-easy-numeric-0-48", "incline-easy-numeric-0-3", "pulley-easy-numeric-1-0", "x" * 10_000]
)
def test_an_id_of_no_item_is_told(data: Path, name: str) -> None:
    with pytest.raises(DatasetError, match="holds no problem"):
        Dataset(data).item(name)


@pytest.mark.parametrize("count", [1, 3, 40, 95, 1000])
def test_some_are_from_all_over(data: Path, count: int) -> None:
    opened = Dataset(data)
    found = [item.id for item in opened.some(count)]
    assert len(set(found)) == len(found) == min(count, 95)
    if count == 40:
        assert {opened.manifest.config.position(opened.manifest.config.named(name)) // 20 for name in found} == {
            *range(5)
        }


def test_a_damaged_file_is_named_before_an_item_is_believed(data: Path) -> None:
    file = data / "data/train-00002-of-00005.parquet"
    whole = file.read_bytes()
    opened = Dataset(data)
    for place in (4, len(whole) // 2, len(whole) - 5):
        file.write_bytes(whole[:place] + bytes([whole[place] ^ 1]) + whole[place + 1 :])
        with pytest.raises(DatasetError, match=r"train-00002-of-00005\.parquet: damaged; see: sim2reason verify"):
            list(opened)
    file.unlink()
    with pytest.raises(DatasetError, match="missing"):
        list(opened.some(95))


def test_there_must_be_a_dataset_and_a_split(data: Path, tmp_path: Path) -> None:
    with pytest.raises(DatasetError, match=r"no manifest\.json"):
        Dataset(tmp_path)
    with pytest.raises(DatasetError, match="has no split 'test'; there is train"):
        Dataset(data).items("test")


@pytest.fixture
def halves(make: Make, tmp_path: Path) -> Dataset:
    """Build a dataset of two splits, each in several shards."""
    make("halves", split={"train": 0.5, "test": 0.5})
    return Dataset(tmp_path / "halves")


def test_items_are_found_by_place_slice_and_split(halves: Dataset) -> None:
    """Indices and slices work as in a list, split names as in Hugging Face's datasets."""
    items = list(halves)
    assert [halves[number] for number in range(len(halves))] == items
    assert halves[-1] == items[-1]
    assert halves[3:40:7] == items[3:40:7]
    assert halves[:0] == []
    for split in ("train", "test"):
        part = halves[split]
        assert list(part) == [part[number] for number in range(len(part))] == list(halves.items(split))
        assert part[-2:] == list(part)[-2:]
        assert repr(part) == f"<{len(part)} items of {str(halves.path)!r}, split {split}>"
    assert len(halves["train"]) + len(halves["test"]) == len(halves)


def test_a_key_that_leads_nowhere_is_told(halves: Dataset) -> None:
    for number in (len(halves), -len(halves) - 1):
        with pytest.raises(IndexError, match=f"there is no place {number} among {len(halves)} items"):
            halves[number]
    with pytest.raises(DatasetError, match=r"has no split 'dev'; there is test, train; for an id: \.item\(ID\)"):
        halves["dev"]
    for key in (1.5, None, (1, 2)):
        with pytest.raises(TypeError, match="is no place, slice or split of a dataset"):
            halves[key]  # type: ignore[call-overload]


def test_pandas_gets_a_row_for_each_item(halves: Dataset, monkeypatch: pytest.MonkeyPatch) -> None:
    frame = halves.to_pandas()
    assert list(frame["id"]) == [item.id for item in halves]
    assert [row["value"] for row in frame["answer"]] == [item.answer.value for item in halves]
    assert list(halves["test"].to_pandas()["id"]) == [item.id for item in halves.items("test")]
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(MissingExtraError, match="pandas is not installed; install it with: pip install pandas"):
        halves.to_pandas()


def test_a_dataset_is_accepted_where_a_folder_is(data: Path) -> None:
    whole = Dataset(data)
    assert fspath(whole) == str(data)
    assert Dataset(whole).path == data

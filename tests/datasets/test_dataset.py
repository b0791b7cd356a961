"""A dataset that is opened, on the fake maker's items."""

from pathlib import Path

import pytest

from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.plan import Config
from sim2reason.errors import DatasetError


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

import json
import random
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from sim2reason.base.atomic_files import FOLDER, canonical, checksum
from sim2reason.datasets import store
from sim2reason.datasets.dataset import Dataset, verify
from sim2reason.datasets.inspection import stats
from sim2reason.datasets.manifest import MANIFEST, SHARDS, Manifest, load, shards
from sim2reason.errors import DatasetError

FIRST = "data/train-00000-of-00005.parquet"


def test_a_whole_dataset_has_no_problems(data: Path) -> None:
    found = verify(data)
    assert (found.rows, found.shards, found.faults) == (95, 5, ())


def test_any_flipped_byte_is_found(data: Path, contents: Callable[[Path], dict[str, bytes]]) -> None:
    rng = random.Random(1)
    for name, whole in contents(data).items():
        for _ in range(12):
            place, bit = rng.randrange(len(whole)), 1 << rng.randrange(8)
            (data / name).write_bytes(whole[:place] + bytes([whole[place] ^ bit]) + whole[place + 1 :])
            assert any(name in line for line in verify(data).faults), (name, place, bit)
        (data / name).write_bytes(whole)
    assert not verify(data).faults


def test_a_missing_shard_is_found(data: Path) -> None:
    (data / FIRST).unlink()
    assert verify(data).faults == (f"{FIRST}: missing",)


def test_an_extra_shard_is_found(data: Path) -> None:
    shutil.copy(data / FIRST, data / "data/train-00005-of-00005.parquet")
    assert verify(data).faults == ("data/train-00005-of-00005.parquet: an extra file that the dataset does not know",)


def test_a_truncated_shard_is_found(data: Path) -> None:
    whole = (data / FIRST).read_bytes()
    (data / FIRST).write_bytes(whole[: len(whole) // 2])
    damaged, unreadable = verify(data).faults
    assert damaged.startswith(f"{FIRST}: damaged")
    assert unreadable.startswith(f"{FIRST}: not readable as Parquet")


def test_a_wrong_count_of_rows_is_found_even_under_a_right_checksum(data: Path) -> None:
    first, *others = shards(data)
    file = first.files[0].model_copy(update={"rows": 20})
    lines = [shard.model_dump_json() for shard in (first.model_copy(update={"files": (file,)}), *others)]
    (data / SHARDS).write_text("".join(f"{line}\n" for line in lines))
    value = json.loads((data / MANIFEST).read_text())
    value["files"][SHARDS] = checksum(data / SHARDS)
    value["rows"] += 1
    (data / MANIFEST).write_text(Manifest.model_validate(value).sealed().text())
    assert verify(data).faults == (f"{FIRST}: 19 rows instead of 20",)


@pytest.mark.parametrize(
    ("change", "finding"),
    [
        (lambda value: value["config"].update(seed=3), "don't fit their hash"),
        (lambda value: value["versions"].update(numpy="0"), "don't fit their hash"),
        (lambda value: value.update(shards=4), "doesn't fit the configuration"),
        (lambda value: value.update(rows=7), "not the sum"),
        (lambda value: value["rejected"]["pulley"].update(shortcut=0), "damaged"),
        (lambda value: value.update(more=1), "not a manifest"),
    ],
)
def test_a_manifest_that_was_edited_is_found(
    data: Path, change: Callable[[dict[str, dict[str, object]]], object], finding: str
) -> None:
    value = json.loads((data / MANIFEST).read_text())
    change(value)
    (data / MANIFEST).write_text(canonical(value))
    assert any(finding in line for line in verify(data).faults)


def test_a_manifest_that_was_edited_opens_no_dataset(data: Path) -> None:
    """The counts of an edited manifest would be reported as they are."""
    Dataset(data)
    value = json.loads((data / MANIFEST).read_text())
    value["counts"]["split"]["train"] += 1
    (data / MANIFEST).write_text(canonical(value))
    for read in (Dataset, stats):
        with pytest.raises(DatasetError, match=r"manifest\.json: changed since it was written; see: sim2reason verify"):
            read(data)


def test_what_is_no_finished_dataset_is_refused(tmp_path: Path, data: Path) -> None:
    with pytest.raises(DatasetError, match="no such folder"):
        verify(tmp_path / "nowhere")
    (tmp_path / "empty").mkdir()
    with pytest.raises(DatasetError, match=r"no manifest\.json here"):
        verify(tmp_path / "empty")
    (data / MANIFEST).unlink()
    (data / FOLDER).mkdir()
    with pytest.raises(DatasetError, match="not finished; run the same"):
        verify(data)


def test_items_come_back_as_they_were_made(data: Path) -> None:
    from fake_makers import steady

    config = load(data).config
    made = [steady(config.request(k)).item for k in range(20)]
    assert store.read(data / FIRST) == [item for item in made if item is not None]

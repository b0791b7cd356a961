import re
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from sim2reason.base.atomic_files import FOLDER, lock_folder
from sim2reason.datasets.build import build, build_part
from sim2reason.datasets.dataset import Dataset, verify
from sim2reason.datasets.manifest import MANIFEST, SHARDS, Manifest, load, read_refusals
from sim2reason.datasets.places.here import cores
from sim2reason.datasets.plan import Config
from sim2reason.datasets.store import count
from sim2reason.errors import DatasetError
from sim2reason.generation.request import MAX_SEED

Make = Callable[..., Manifest]
Contents = Callable[[Path], dict[str, bytes]]


def test_a_dataset_is_its_shards_a_card_and_a_manifest(make: Make, tmp_path: Path, contents: Contents) -> None:
    manifest = make()
    files = [f"data/train-{n:05}-of-00005.parquet" for n in range(5)]
    assert list(contents(tmp_path / "data")) == ["README.md", *files, MANIFEST, SHARDS]
    assert manifest == load(tmp_path / "data")
    assert (manifest.rows, manifest.positions) == (95, 96)  # the maker finds no draw for one
    assert manifest.counts["recipe"] == {"incline": 47, "pulley": 48}
    assert manifest.counts["kind"] == {"state": 95}


def test_items_come_in_the_order_of_their_positions(data: Path, config: Config) -> None:
    wanted = [config.request(k).id for k in range(96)]
    wanted.remove("incline-easy-numeric-0-3")
    assert [item.id for item in Dataset(data)] == wanted


@pytest.mark.parametrize("workers", [2, pytest.param(4, marks=pytest.mark.slow)])
def test_workers_do_not_change_a_byte(data: Path, make: Make, contents: Contents, workers: int) -> None:
    make("other", workers=workers)
    assert contents(data.parent / "other") == contents(data)


def test_a_position_without_a_draw_is_told(make: Make) -> None:
    (problem,) = make().refused["unfilled"].first
    assert (problem.recipe, problem.index) == ("incline", 3)
    assert problem.reason == "no draw passed: shortcut 12"


def test_refused_draws_are_counted_by_recipe_and_filter(make: Make, config: Config) -> None:
    from fake_makers import steady

    manifest = make()
    made = [steady(config.request(k)).rejected for k in range(96) if config.request(k).recipe == "pulley"]
    assert manifest.rejected["pulley"]["degenerate"] == sum(m.get("degenerate", 0) for m in made)


@pytest.mark.parametrize(
    ("maker", "reason"), [("crashing", "crashed its worker (exit code 3), twice"), ("raising", "")]
)
def test_a_bad_item_is_quarantined_and_no_other_is_lost(make: Make, maker: str, reason: str) -> None:
    manifest = make(workers=2, maker=f"fake_makers:{maker}")
    (problem,) = manifest.refused["quarantined"].first
    assert (problem.recipe, problem.index, problem.seed) == ("pulley", 7, 0)
    assert problem.reason == (reason or "raised ValueError: a defect of two lines")
    assert (manifest.rows, manifest.positions) == (95, 97)


def test_an_item_that_hangs_is_quarantined(make: Make) -> None:
    manifest = make(workers=2, patience=3.0, maker="fake_makers:hanging", items=20)
    (problem,) = manifest.refused["quarantined"].first
    assert problem.reason == "hung its worker, twice"
    assert (manifest.rows, manifest.positions) == (20, 22)


FLAKY = """
import os
from pathlib import Path
import fake_makers

def make(request):
    mark = Path(__file__).with_name("seen")
    if request.index == 7 and not mark.exists():
        mark.touch()
        os._exit(3)
    return fake_makers.steady(request)
"""


def test_one_crash_by_chance_leaves_no_trace(make: Make, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "flaky_maker.py").write_text(FLAKY)
    monkeypatch.syspath_prepend(tmp_path)
    manifest = make(workers=2, maker="flaky_maker:make")
    assert (tmp_path / "seen").exists()
    assert not manifest.refused["quarantined"].total
    assert (manifest.rows, manifest.positions) == (95, 96)


def test_an_item_must_bear_the_id_of_its_request(make: Make, tmp_path: Path) -> None:
    with pytest.raises(DatasetError, match=r"0 problems of 3 asked for, and of 20 tries the last ones gave"):
        make(maker="fake_makers:impostor", items=3, shard=500)
    manifest = load(tmp_path / "data")
    assert manifest.refused["quarantined"].first[0].reason == "made an item of another id: other"
    assert manifest.positions == 20
    assert (manifest.refused["quarantined"].total, manifest.refused["unfilled"].total) == (19, 1)


def test_only_what_there_is_stands_and_is_an_error(make: Make, tmp_path: Path, contents: Contents) -> None:
    """The maker has only a dozen different problems, at any number and in any steps of requests."""
    for name, steps in (("at_once", [60]), ("grown", [10, 40, 60, 60])):
        for items in steps:
            if items <= 10:
                assert make(name, maker="fake_makers:few", items=items, shard=100).rows == items
                continue
            with pytest.raises(DatasetError, match=rf"12 problems of {items} asked for, and of 1\d\d tries"):
                make(name, maker="fake_makers:few", items=items, shard=100)
    whole = contents(tmp_path / "at_once")
    assert contents(tmp_path / "grown") == whole
    assert len(Dataset(tmp_path / "at_once")) == 12
    assert verify(tmp_path / "at_once").faults == ()


@pytest.mark.parametrize("cut", [3, 7, *(pytest.param(cut, marks=pytest.mark.slow) for cut in (1, 5))])
def test_a_run_that_is_interrupted_while_it_makes_up_ends_in_the_same_bytes(
    tmp_path: Path, config: Config, contents: Contents, cut: int
) -> None:
    """The run may be interrupted after any batch, while half of all items are duplicates and one split is small."""
    split = {"test": 0.1, "train": 0.9}
    twins = config.model_copy(update={"items": 30, "maker": "fake_makers:twins", "shard": 20, "split": split})
    calls = 0

    def interrupt(steps: int) -> None:
        nonlocal calls
        del steps
        calls += 1
        if calls > cut:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        build(tmp_path / "cut", twins, workers=1, advance=interrupt)
    build(tmp_path / "cut", twins, workers=2)
    manifest = build(tmp_path / "whole", twins, workers=1)
    assert (manifest.rows, manifest.shards) == (30, 3)
    assert contents(tmp_path / "cut") == contents(tmp_path / "whole")
    assert all(count(path) for path in (tmp_path / "whole/data").iterdir())


@pytest.mark.parametrize("maker", ["nowhere:make", "fake_makers:missing", "fake_makers"])
def test_a_maker_that_can_not_be_imported_is_said_at_once(make: Make, maker: str) -> None:
    with pytest.raises(DatasetError, match="no maker of items can be imported"):
        make(maker=maker)


def test_duplicates_are_left_out_and_told(make: Make, tmp_path: Path) -> None:
    manifest = make(maker="fake_makers:twins")
    found = list(read_refusals(tmp_path / "data", "duplicates"))
    assert found[0].reason == "same as incline-easy-numeric-0-0"
    assert manifest.rejected["pulley"]["distinct: same"] == sum(p.recipe == "pulley" for p in found) == 47
    prompts = [item.prompt for item in Dataset(tmp_path / "data")]
    assert len(prompts) == len(set(prompts)) == manifest.rows


@pytest.mark.parametrize(("changed", "tail"), [({"unfiltered": True}, "-unfiltered"), ({"units": "cgs"}, "-cgs")])
def test_duplicates_are_known_by_their_whole_id(
    make: Make, tmp_path: Path, changed: dict[str, object], tail: str
) -> None:
    make(maker="fake_makers:twins", **changed)
    found = list(read_refusals(tmp_path / "data", "duplicates"))
    assert found[0].reason == f"same as incline-easy-numeric-0-0{tail}"


def test_a_shard_of_a_dataset_with_duplicates_is_remade_to_the_same_bytes(
    make: Make, tmp_path: Path, contents: Contents
) -> None:
    make(maker="fake_makers:twins")
    whole = contents(tmp_path / "data")
    (tmp_path / "data/data/train-00001-of-00010.parquet").unlink()
    make(maker="fake_makers:twins")
    assert contents(tmp_path / "data") == whole


def test_missing_and_damaged_shards_are_remade_and_no_other(data: Path, make: Make, contents: Contents) -> None:
    whole = contents(data)
    (data / "data/train-00003-of-00005.parquet").unlink()
    (data / "data/train-00000-of-00005.parquet").write_bytes(b"PAR1")
    kept = data / "data/train-00001-of-00005.parquet"
    stamp = kept.stat().st_mtime_ns
    make()
    assert contents(data) == whole
    assert kept.stat().st_mtime_ns == stamp


def test_a_second_run_changes_nothing(data: Path, make: Make, contents: Contents) -> None:
    whole = contents(data)
    make(workers=2)
    assert contents(data) == whole


def test_where_nothing_is_left_to_do_nothing_is_written(
    data: Path, config: Config, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A complete dataset on a read-only disk is accepted, a damaged one is not."""

    def refuse(*args: object, **_: object) -> None:
        raise OSError(30, "Read-only file system", str(args[0]))

    done: list[int] = []
    monkeypatch.setattr("sim2reason.datasets.build.Journal", refuse)
    assert build(data, config, advance=done.append) == load(data)
    assert sum(done) == config.items
    (data / "README.md").write_text("")
    with pytest.raises(OSError, match="Read-only"):
        build(data, config)


def test_a_run_goes_on_from_its_journal(tmp_path: Path, config: Config, data: Path, contents: Contents) -> None:
    def interrupt(steps: int) -> None:
        nonlocal done
        done += steps
        if done >= 60:
            raise KeyboardInterrupt

    done = 0
    with pytest.raises(KeyboardInterrupt):
        build(tmp_path / "half", config, workers=1, advance=interrupt)
    assert (tmp_path / "half" / FOLDER / "00002.json").exists()
    (tmp_path / "half" / FOLDER / "train-00003-of-00005.parquet.1.tmp").write_bytes(b"half a file")
    steps: list[int] = []
    build(tmp_path / "half", config, workers=1, advance=steps.append)
    assert steps[:3] == [20, 20, 20]
    assert sum(steps) == 95
    assert contents(tmp_path / "half") == contents(data)


@pytest.mark.parametrize("unfinished", [False, True])
def test_another_configuration_is_refused_and_nothing_is_lost(
    data: Path, make: Make, contents: Contents, unfinished: bool
) -> None:
    if unfinished:
        (data / FOLDER).mkdir()
        manifest = load(data)
        plan = manifest.model_dump_json(include={"config", "versions"})
        (data / FOLDER / "plan.json").write_text(plan)
        (data / MANIFEST).unlink()
    whole = contents(data)
    with pytest.raises(DatasetError, match=r"another configuration \(seed 0 ≠ 1\)"):
        make(seed=1)
    assert contents(data) == whole


def test_other_versions_are_refused(data: Path, make: Make, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sim2reason.datasets.journal.versions", lambda: {**load(data).versions, "numpy": "9"})
    with pytest.raises(DatasetError, match="numpy"):
        make()


def test_a_folder_of_other_things_is_left_alone(make: Make, tmp_path: Path, contents: Contents) -> None:
    (tmp_path / "data").mkdir()
    (tmp_path / "data/thesis.tex").write_text("years of work")
    with pytest.raises(DatasetError, match=r"holds thesis\.tex and is no dataset"):
        make()
    assert contents(tmp_path / "data") == {"thesis.tex": b"years of work"}


@pytest.mark.parametrize("name", [FOLDER, "data", ".journal", ".notes.tmp"])
def test_a_folder_of_somebody_elses_is_refused_whatever_it_is_called(make: Make, tmp_path: Path, name: str) -> None:
    theirs = tmp_path / "theirs" / name
    theirs.mkdir(parents=True)
    (theirs / "thesis.tex").write_text("years of work")
    with pytest.raises(DatasetError, match=f"holds {re.escape(name)} and is no dataset"):
        make("theirs")
    assert (theirs / "thesis.tex").read_text() == "years of work"


def test_a_plan_that_another_part_is_writing_makes_a_folder_nobody_elses(tmp_path: Path, config: Config) -> None:
    """Parts may begin at once, so that one may see the folder before its plan is complete."""
    out = tmp_path / "parts"
    (out / FOLDER).mkdir(parents=True)
    (out / FOLDER / "plan.json.4711.tmp").write_text("{")
    build_part(out, config, (0, 3), workers=1)
    with pytest.raises(DatasetError, match="another configuration"):
        build_part(out, config.model_copy(update={"seed": 1}), (2, 3), workers=1)


def test_a_plan_that_is_none_makes_no_folder_ours(make: Make, data: Path, contents: Contents) -> None:
    (data / MANIFEST).unlink()
    (data / FOLDER).mkdir()
    (data / FOLDER / "plan.json").write_text('{"config": 3}')
    whole = contents(data)
    with pytest.raises(DatasetError, match="and is no dataset"):
        make()
    assert contents(data) == whole


def test_a_run_that_was_killed_before_its_plan_stood_goes_on(make: Make, data: Path, contents: Contents) -> None:
    for name, content in (("empty", None), ("half", "half a pl")):
        (data.parent / name / FOLDER).mkdir(parents=True)
        if content is not None:
            (data.parent / name / FOLDER / "plan.json.77.tmp").write_text(content)
        make(name)
        assert contents(data.parent / name) == contents(data)


def test_parts_may_begin_at_once(tmp_path: Path, config: Config, monkeypatch: pytest.MonkeyPatch) -> None:
    """The second part looks at the folder while the first one, which has made it, is writing its plan."""
    from sim2reason.datasets import journal
    from sim2reason.datasets.journal import Journal

    put_text, begun = journal.put_text, list[Journal]()

    def meanwhile(path: Path, text: str, scratch: Path) -> None:
        if not begun:
            monkeypatch.setattr(journal, "put_text", put_text)
            begun.append(Journal(tmp_path / "out", config, alone=False))
        put_text(path, text, scratch)

    (tmp_path / "out").mkdir()
    monkeypatch.setattr(journal, "put_text", meanwhile)
    assert Journal(tmp_path / "out", config, alone=False).plan == begun[0].plan
    other = config.model_copy(update={"seed": 1})
    with pytest.raises(DatasetError, match="another configuration"):
        Journal(tmp_path / "out", other, alone=False)


def test_what_lies_beside_a_dataset_stays(make: Make, data: Path) -> None:
    """Files named as a shard of another total number stay too, even a copy of a shard."""
    names = ".mine.tmp", "data/.mine.tmp", "notes.md", "data/other.parquet", "data/train-00001-of-00099.parquet"
    strange = {data / name: b"notes" for name in (*names, "data/train-00004-of-00004.parquet")}
    strange |= {data / "data/train-00000-of-00003.parquet": (data / "data/train-00000-of-00005.parquet").read_bytes()}
    for path, content in strange.items():
        path.write_bytes(content)
    make()
    (data / "data/train-00001-of-00005.parquet").unlink()
    make()
    make(items=120)
    make(items=130)
    assert {path: path.read_bytes() for path in strange} == strange
    ours = {f"train-{number:05}-of-00007.parquet" for number in range(7)}
    assert {path.name for path in (data / "data").iterdir()} == ours | {path.name for path in strange} - {"notes.md"}


def test_a_file_in_place_of_a_shard_stays_where_a_dataset_grows_past_its_name(make: Make, data: Path) -> None:
    mine = data / "data/train-00004-of-00005.parquet"
    mine.write_bytes(b"notes")
    make(items=130)
    assert mine.read_bytes() == b"notes"


def test_a_dataset_grows_to_the_bytes_of_a_larger_one(make: Make, tmp_path: Path, contents: Contents) -> None:
    for maker in ("steady", "twins"):
        small = make("small", maker=f"fake_makers:{maker}").shards
        kept = (tmp_path / f"small/data/train-00001-of-{small:05}.parquet").stat().st_mtime_ns
        make("small", items=130, maker=f"fake_makers:{maker}")
        large = make("large", items=130, maker=f"fake_makers:{maker}").shards
        assert contents(tmp_path / "small") == contents(tmp_path / "large")
        assert (tmp_path / f"small/data/train-00001-of-{large:05}.parquet").stat().st_mtime_ns == kept
        shutil.rmtree(tmp_path / "small")
        shutil.rmtree(tmp_path / "large")


def test_a_dataset_that_was_to_grow_does_so_after_an_interrupt(
    make: Make, data: Path, config: Config, contents: Contents
) -> None:
    def interrupt(steps: int) -> None:
        del steps
        raise KeyboardInterrupt

    larger = config.model_copy(update={"items": 130})
    with pytest.raises(KeyboardInterrupt):
        build(data, larger, workers=1, advance=interrupt)
    with pytest.raises(DatasetError, match="items 130 ≠ 95"):
        make()
    build(data, larger, workers=1)
    make("whole", items=130)
    assert contents(data) == contents(data.parent / "whole")


def test_parts_made_by_several_processes_are_the_same_dataset(
    make: Make, data: Path, config: Config, tmp_path: Path, contents: Contents
) -> None:
    del make
    for number in (1, 2, 0):
        build_part(tmp_path / "parts", config, (number, 3), workers=1)
    assert not (tmp_path / "parts" / MANIFEST).exists()
    steps: list[int] = []
    build(tmp_path / "parts", config, workers=1, advance=steps.append)
    assert steps == [20, 20, 20, 20, 15, -1, 1]  # one position holds no item
    assert contents(tmp_path / "parts") == contents(data)


def test_one_part_is_not_made_twice_at_a_time_nor_beside_the_end(data: Path, config: Config, tmp_path: Path) -> None:
    build_part(tmp_path / "parts", config, (0, 2), workers=1)
    lock = tmp_path / "parts" / FOLDER / "part-1-of-2.lock"
    lock.touch()
    with lock_folder(lock), pytest.raises(DatasetError, match="another run"):
        build_part(tmp_path / "parts", config, (0, 2), workers=1)
    with lock_folder(data), pytest.raises(DatasetError, match="another run"):
        build_part(data, config, (0, 2), workers=1)
    with pytest.raises(DatasetError, match="3/2"):
        build_part(data, config, (2, 2), workers=1)


def test_a_dataset_without_end_begins_at_once(tmp_path: Path, config: Config) -> None:
    class EnoughError(Exception):
        pass

    def stop(steps: int) -> None:
        del steps
        if (tmp_path / "endless/data").is_dir():
            raise EnoughError

    with pytest.raises(EnoughError):
        build(tmp_path / "endless", config.model_copy(update={"items": MAX_SEED}), workers=1, advance=stop)


def test_two_runs_do_not_share_a_folder(data: Path, make: Make) -> None:
    with lock_folder(data), pytest.raises(DatasetError, match="another run is writing here"):
        make()


def test_an_empty_dataset_is_one_too(make: Make, tmp_path: Path) -> None:
    assert make(items=0).rows == 0
    assert list(Dataset(tmp_path / "data")) == []


def test_there_is_at_least_one_core() -> None:
    assert cores() >= 1

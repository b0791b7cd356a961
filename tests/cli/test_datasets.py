"""Tests of the commands `generate`, `verify`, `show` and `stats`, with a fake maker."""

import gc
import json
import shutil
import weakref
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result

import sim2reason
from sim2reason.cli import main
from sim2reason.datasets import store
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.inspection import show
from sim2reason.errors import DatasetError
from sim2reason.generation.item import Item

USUAL = "--items", "30", "--recipe", "incline,pulley", "--difficulty", "easy", "--workers", "1"


def call(*args: object) -> Result:
    return CliRunner().invoke(main, [str(arg) for arg in args])


def generate(out: Path, *args: object, maker: str = "steady") -> Result:
    return call("generate", out, *USUAL, "--maker", f"fake_makers:{maker}", *args)


@pytest.fixture
def data(tmp_path: Path) -> Path:
    assert generate(tmp_path / "data").exit_code == 0
    return tmp_path / "data"


def test_generate_says_what_it_made(tmp_path: Path) -> None:
    result = generate(tmp_path / "data")
    assert result.exit_code == 0
    assert f"30 problems in {tmp_path}/data" in result.stdout
    assert "positions without a problem, made up for by later ones: 1\n" in result.stderr
    assert "1 unfilled, the first at position 6 (incline easy numeric, seed 0, index 3): no draw" in result.stderr


def test_generate_gives_the_manifest_to_a_program(tmp_path: Path) -> None:
    result = generate(tmp_path / "data", "--json")
    assert json.loads(result.stdout) == json.loads((tmp_path / "data/manifest.json").read_text())


@pytest.mark.parametrize(
    ("option", "value", "told"),
    [
        (
            "--split",
            "train=0.5,test=0.2",
            "split: the shares add up to 0.7; give all of them, which add up to 1, as in",
        ),
        ("--split", "train=1,test=0", "split: test=0 is no share; give a number above 0 and at most 1, as in --split"),
        ("--split", "train=0.5,test=nan", "split: test=nan is no share; give a number above 0 and at most 1, as in"),
        ("--split", "Train=1", "split: 'Train' is no name of a split; write small letters and digits, as in --split"),
        ("--split", "train=0.5,train=0.5,test=0.5", "--split: train is given twice; give it once."),
        ("--split", "train=0.5,,test=0.5", "--split: '' is no pair; write NAME=NUMBER."),
        ("--weights", "period=1,period=2", "--weights: period is given twice; give it once."),
        ("--split", "", "--split: '' is no pair; write NAME=NUMBER."),
        ("--weights", "", "--weights: '' is no pair; write NAME=NUMBER."),
        ("--shard", "", "--shard: '' is no part; write K/N, as in 3/8."),
        ("--patience", "nan", "nan is not a finite number of seconds."),
        ("--license", "", "license: '' is no licence on the Hugging Face hub; give its name"),
        ("--license", "Apache 2.0", "license: 'Apache 2.0' is no licence on the Hugging Face hub; give its name"),
    ],
)
def test_pairs_and_licences_are_refused_in_one_line(tmp_path: Path, option: str, value: str, told: str) -> None:
    result = generate(tmp_path / "data", option, value)
    assert result.exit_code == 2
    assert told in result.stderr
    assert result.stderr.count("\n") == 1


@pytest.mark.parametrize(
    "order", [{"items": "3"}, {"items": 3.0}, {"items": True}, {"shard": "5"}, {"distance": "0"}, {"solutions": "yes"}]
)
def test_an_order_is_not_guessed(tmp_path: Path, order: dict[str, Any]) -> None:
    with pytest.raises(DatasetError, match=f"^{next(iter(order))}: "):
        sim2reason.generate(tmp_path / "data", **order)
    assert not (tmp_path / "data").exists()


def test_an_order_of_what_there_is_not_is_refused(tmp_path: Path) -> None:
    order: dict[str, Any] = {"items": 1, "recipes": "rocket"}
    with pytest.raises(TypeError, match=r"unexpected keyword argument 'recipes'; an order has .*recipe, "):
        sim2reason.generate(tmp_path / "data", **order)
    assert not (tmp_path / "data").exists()


@pytest.mark.parametrize("workers", [0, -3, True, "2", 1.0])
def test_so_is_a_number_of_workers_that_is_none(tmp_path: Path, workers: object) -> None:
    order: dict[str, Any] = {"items": 1, "workers": workers}
    with pytest.raises(DatasetError, match=r"^workers: .* is no number of processes; give a whole number from 1 on"):
        sim2reason.generate(tmp_path / "data", **order)
    assert not (tmp_path / "data").exists()


def test_a_folder_in_place_of_a_shard_is_named(tmp_path: Path) -> None:
    shard = tmp_path / "data/data/train-00000-of-00001.parquet"
    assert generate(tmp_path / "data").exit_code == 0
    shard.unlink()
    shard.mkdir()
    result = generate(tmp_path / "data")
    assert result.exit_code == 2
    assert result.stderr.startswith(f"sim2reason: {shard}: Is a directory; ")
    assert result.stderr.count("\n") == 1


def test_a_part_says_what_it_made_and_what_ends_the_work(tmp_path: Path) -> None:
    remedy = "when all 4 parts are made, the same command without --shard ends the work"
    for part, told in ("1/4", "1 of 3 shards, 9 problems"), ("4/4", "0 of 3 shards, 0 problems"):
        result = generate(tmp_path / "data", "--shard-size", 10, "--shard", part)
        assert result.exit_code == 0
        assert result.stdout == f"part {part}: {told} in {tmp_path / 'data'}; {remedy}\n"


@pytest.mark.parametrize(("part", "remedy"), [("1/0", "write K/N, as in 3/8"), ("4/3", "count from 1/3 to 3/3")])
def test_a_part_that_there_is_not_is_refused(tmp_path: Path, part: str, remedy: str) -> None:
    result = generate(tmp_path / "data", "--shard", part)
    assert (result.exit_code, result.stderr) == (2, f"sim2reason: part {part}: there is none; {remedy}\n")
    assert not (tmp_path / "data").exists()


def test_quarantine_is_told_with_what_makes_it_again(tmp_path: Path) -> None:
    result = generate(tmp_path / "data", maker="raising")
    assert result.exit_code == 0
    assert "(pulley easy numeric, seed 0, index 7): raised ValueError: a defect of two lines" in result.stderr


def test_another_configuration_is_exit_code_two(data: Path) -> None:
    result = generate(data, "--seed", 1)
    assert result.exit_code == 2
    assert "another configuration (seed 0 ≠ 1)" in result.stderr
    assert call("verify", data).exit_code == 0


@pytest.mark.parametrize(
    ("option", "value", "word"),
    [
        ("--items", "-1", "--items"),
        ("--difficulty", "brutal", "easy, medium, hard"),
        ("--recipe", ",", "names nothing"),
        ("--workers", "0", "--workers"),
        ("--maker", "nowhere:make", "nowhere:make"),
        ("--weights", "period", "write NAME=NUMBER"),
        ("--weights", "period=often", "write NAME=NUMBER"),
        ("--units", "furlongs", "there are: SI, cgs, mixed"),
    ],
)
def test_wrong_options_are_one_line_and_exit_code_two(tmp_path: Path, option: str, value: str, word: str) -> None:
    result = generate(tmp_path / "data", option, value)
    assert result.exit_code == 2
    assert word in result.stderr
    assert result.stderr.count("\n") == 1


def test_a_file_in_the_way_is_said(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    assert generate(tmp_path / "file").exit_code == 2
    assert generate(tmp_path / "file" / "below").exit_code == 2


def test_verify_finds_a_whole_dataset_whole(data: Path) -> None:
    result = call("verify", data)
    assert (result.exit_code, result.stdout) == (0, f"{data}: whole; 30 problems in 1 shard by the manifest\n")


def test_verify_finds_damage(data: Path) -> None:
    (data / "data/train-00000-of-00001.parquet").unlink()
    result = call("verify", data)
    assert result.exit_code == 1
    assert "data/train-00000-of-00001.parquet: missing" in result.stdout
    report = call("verify", data, "--json")
    assert report.exit_code == 1
    assert json.loads(report.stdout)["ok"] is False


def test_verify_refuses_what_is_no_dataset(tmp_path: Path) -> None:
    result = call("verify", tmp_path)
    assert result.exit_code == 2
    assert "no manifest.json here" in result.stderr


def test_show_prints_problems_with_their_answers(data: Path) -> None:
    result = call("show", data, "-n", 3)
    assert result.exit_code == 0
    assert result.stdout.count("Answer: ") == 3
    assert "incline" in result.stdout
    assert "pulley" in result.stdout


def test_one_finding_is_one(data: Path) -> None:
    (data / "README.md").unlink()
    assert f"{data}: damaged: 1 finding; 30 problems" in call("verify", data).stdout
    (data / "shards.jsonl").write_text("{}")
    assert "findings; " in call("verify", data).stdout


def test_show_finds_one_by_its_id(data: Path) -> None:
    result = call("show", data, "--id", "pulley-easy-numeric-0-4", "--scene")
    assert "name: pulley-easy-numeric-0-4" in result.stdout
    items = json.loads(call("show", data, "--id", "pulley-easy-numeric-0-4", "--json").stdout)
    assert [item["id"] for item in items] == ["pulley-easy-numeric-0-4"]
    assert call("show", data, "--id", "nobody").exit_code == 2
    assert call("show", data / "nowhere").exit_code == 2


def test_show_more_than_there_are(data: Path) -> None:
    assert call("show", data, "-n", 100).stdout.count("Answer: ") == 30


def test_weights_are_checked_before_anything_is_made(tmp_path: Path) -> None:
    result = call("generate", tmp_path / "data", "--items", 1, "--recipe", "box", "--weights", "numeric.periods=2")
    assert result.exit_code == 2
    assert result.stderr.startswith("sim2reason: weights: numeric.periods: there is no kind 'periods'")
    assert not (tmp_path / "data").exists()


def test_weights_and_units_are_part_of_the_configuration(tmp_path: Path) -> None:
    assert generate(tmp_path / "data", "--weights", "period=2,reverse.sum=0", "--units", "cgs").exit_code == 0
    config = json.loads((tmp_path / "data/manifest.json").read_text())["config"]
    assert config["weights"] == {"period": 2.0, "reverse.sum": 0.0}
    card = (tmp_path / "data/README.md").read_text()
    assert " --weights period=2.0,reverse.sum=0.0 --units cgs" in card
    assert "another configuration" in generate(tmp_path / "data", "--units", "cgs").stderr


def shown(data: Path, *args: object) -> list[str]:
    result = call("show", data, "-n", 100, "--json", *args)
    assert result.exit_code == 0, result.output
    return [item["id"] for item in json.loads(result.stdout)]


def test_show_picks_what_fits(data: Path) -> None:
    every = shown(data)
    assert shown(data, "--recipe", "pulley") == [name for name in every if name.startswith("pulley")]
    assert (
        shown(data, "--recipe", "pulley,incline", "--mode", "all", "--kind", "state", "--quantity", "weight") == every
    )
    assert shown(data, "--recipe", "incline", "-n", 2)[1:] not in ([], [every[2]]), "from all over those that fit"
    assert [item.id for item in show(data, items=100, recipe="pulley")] == shown(data, "--recipe", "pulley")


@pytest.mark.parametrize(
    ("name", "held"),
    [
        ("--recipe", "incline, pulley"),
        ("--difficulty", "easy"),
        ("--mode", "numeric"),
        ("--kind", "state"),
        ("--quantity", "weight"),
    ],
)
def test_a_name_that_occurs_nowhere_is_told_with_those_that_do(data: Path, name: str, held: str) -> None:
    result = call("show", data, name, f"{held.partition(',')[0]},nope")
    told = f"sim2reason: {data}: holds no problem of {name[2:]} 'nope'; there is {held}\n"
    assert (result.exit_code, result.stdout, result.stderr) == (2, "", told)


def test_where_nothing_fits_it_is_said(data: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Dataset, "some", lambda *_: iter(()))
    result = call("show", data, "--recipe", "pulley,incline", "--kind", "state")
    assert result.exit_code == 2
    assert "holds no problem of recipe pulley or incline, kind state; see: sim2reason stats" in result.stderr
    assert result.stdout == ""


def test_show_picks_splits(tmp_path: Path) -> None:
    data = tmp_path / "data"
    assert generate(data, "--split", "train=0.6,test=0.4", "--shard-size", 10).exit_code == 0
    parts = [shown(data, "--split", name) for name in ("train", "test")]
    assert parts == [[item.id for item in Dataset(data).items(name)] for name in ("train", "test")]
    assert Counter(parts[0] + parts[1]) == Counter(shown(data)) == Counter(shown(data, "--split", "test,train"))
    assert set(shown(data, "--split", "test", "--recipe", "pulley")) == {n for n in parts[1] if n[0] == "p"}
    assert len(shown(data, "--split", "test", "-n", 3)) == 3
    result = call("show", data, "--split", "tset")
    assert (result.exit_code, result.stderr) == (2, f"sim2reason: {data}: has no split 'tset'; there is test, train\n")


def test_an_empty_dataset_shows_nothing(tmp_path: Path) -> None:
    assert generate(tmp_path / "data", "--items", 0).exit_code == 0
    assert call("show", tmp_path / "data", "--json").stdout == "[]\n"
    assert call("stats", tmp_path / "data").exit_code == 0


def test_show_holds_a_file_at_a_time(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert generate(tmp_path / "data", "--shard-size", 5).exit_code == 0
    read, most = store.read, 0
    held: list[weakref.ref[Item]] = []

    def watched(path: Path, places: Sequence[int] | None = None) -> list[Item]:
        nonlocal most
        gc.collect()
        most = max(most, sum(each() is not None for each in held))
        items = read(path, places)
        held.extend(weakref.ref(item) for item in items)
        return items

    monkeypatch.setattr(store, "read", watched)
    assert call("show", tmp_path / "data", "-n", 50_000_000).stdout.count("Answer: ") == 30
    assert len(held) == 30
    assert most <= 5


def test_stats_count_what_is_there(data: Path) -> None:
    told = json.loads(call("stats", data, "--json").stdout)
    items = list(Dataset(data))
    assert told["items"] == 30
    for by in ("recipe", "difficulty", "mode", "kind", "shape"):
        assert told["counts"][by] == Counter(getattr(item, by) for item in items)
    assert told["counts"]["quantity"] == {"weight": 30}
    assert told["counts"]["split"] == {"train": 30}
    refused: Counter[str] = Counter()
    for found in Dataset(data).manifest.rejected.values():
        refused.update(found)
    assert told["refused"] == refused
    answers = sorted(item.answer.value for item in items)
    assert (told["answers"]["N"]["least"], told["answers"]["N"]["greatest"]) == (answers[0], answers[-1])
    assert told["answers"]["N"]["median"] == pytest.approx(answers[14], rel=5e-3)
    words = sorted(len(item.prompt.split()) for item in items)
    assert told["words"] == {"items": 30, "least": words[0], "median": words[14], "greatest": words[-1]}
    table = call("stats", data).stdout
    assert all(name in table for name in ("recipe", "quantity", "weight", "refused draws", "median", "N  "))


@pytest.mark.parametrize("command", ["stats", "show"])
def test_a_changed_manifest_is_one_line(data: Path, tmp_path: Path, command: str) -> None:
    copy = shutil.copytree(data, tmp_path / "copy")
    text = (copy / "manifest.json").read_text()
    (copy / "manifest.json").write_text(text.replace('"weight": 30', '"weight": 93'))
    assert text != (copy / "manifest.json").read_text()
    told = call(command, copy)
    assert (told.exit_code, told.stdout) == (2, "")
    assert told.stderr.count("\n") == 1
    assert "manifest.json: changed since it was written; see: sim2reason verify" in told.stderr


def test_verify_and_show_take_what_generate_gave(tmp_path: Path) -> None:
    """The functions of the commands work one after the other on the same dataset."""
    order = {"items": 6, "recipe": ("incline", "pulley"), "difficulty": "easy", "maker": "fake_makers:steady"}
    made = sim2reason.generate(tmp_path / "data", workers=1, **order)
    assert sim2reason.verify(made.path).faults == ()
    assert [item.id for item in sim2reason.open(made.path)] == [item.id for item in made]
    assert len(list(sim2reason.show(made, items=6))) == len(made) == sim2reason.stats(made).items
    assert sim2reason.show(made, id="pulley-easy-numeric-0-1").__next__().recipe == "pulley"


def test_generate_takes_its_options_from_a_file_and_those_given_come_first(tmp_path: Path) -> None:
    config = tmp_path / "problems.yaml"
    config.write_text("items: 20\nrecipe: [pulley]\ndifficulty: easy\nseed: 3\nsplit: {train: 0.5, test: 0.5}\n")
    maker = "--maker", "fake_makers:steady", "--workers", "1"
    assert call("generate", tmp_path / "file", "--config", config, "--items", "7", *maker).exit_code == 0
    said = "--recipe", "pulley", "--difficulty", "easy", "--seed", "3", "--split", "train=0.5,test=0.5"
    assert call("generate", tmp_path / "said", "--items", "7", *said, *maker).exit_code == 0
    files = [[path.read_bytes() for path in sorted((tmp_path / n).rglob("*.parquet"))] for n in ("file", "said")]
    assert files[0] == files[1]
    assert len(Dataset(tmp_path / "file")) == 7


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("recpie: pulley\n", "problems.yaml: recpie: there is no such option; did you mean: recipe"),
        ("maker: os:system\n", "problems.yaml: maker: there is no such option; there are: items, recipe,"),
        ("workers: 2\n", "problems.yaml: workers: there is no such option"),
        ("items: many\n", "items: 'many' is no whole number"),
        ("recipe: 5\n", "recipe: 5 is no name"),
        ("solutions: 3\n", "solutions: "),
        ("- items\n", "problems.yaml: holds no settings"),
        ("items: &a [*a]\n", "problems.yaml: this is not YAML that we read"),
    ],
)
def test_a_file_of_options_that_makes_no_sense_is_told(tmp_path: Path, text: str, told: str) -> None:
    (tmp_path / "problems.yaml").write_text(text)
    result = call("generate", tmp_path / "new", "--config", tmp_path / "problems.yaml")
    assert result.exit_code == 2
    assert told in result.stderr
    assert result.stderr.count("\n") == 1
    assert not (tmp_path / "new").exists()

"""Tests of the card: the hub reads it, its pictures are those of the dataset, and its command remakes it."""

import shlex
import sys
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import pytest
import yaml
from click.testing import CliRunner

from sim2reason.cli import main
from sim2reason.datasets.card import SIZES, command
from sim2reason.datasets.card_content import EXAMPLE_COUNT, SHOWN, choose_examples, count_histograms, histogram
from sim2reason.datasets.dataset import Dataset, verify
from sim2reason.datasets.generate import Order, build_config, generate
from sim2reason.datasets.manifest import Manifest, load
from sim2reason.datasets.plan import Config
from sim2reason.errors import DatasetError

Make = Callable[..., Manifest]
Contents = Callable[[Path], dict[str, bytes]]
HISTOGRAMS = [f"figures/{name}.png" for name in SHOWN]


def front(out: Path) -> dict[str, object]:
    """Return the metadata as the hub reads it: the YAML between the first two lines `---`."""
    text = (out / "README.md").read_text("utf-8")
    assert text.startswith("---\n")
    return yaml.safe_load(text.split("\n---\n", 1)[0].removeprefix("---\n"))


def test_the_front_matter_says_what_the_hub_asks_for(make: Make, tmp_path: Path) -> None:
    make(split={"test": 0.5, "train": 0.5}, license="cc-by-4.0")
    found = front(tmp_path / "data")
    assert found["license"] == "cc-by-4.0"
    assert found["language"] == ["en"]
    assert found["size_categories"] == ["n<1K"]
    assert found["task_categories"] == ["question-answering", "text-generation"]
    files = [{"split": name, "path": f"data/{name}-*.parquet"} for name in ("test", "train")]
    assert found["configs"] == [{"config_name": "default", "data_files": files}]
    assert all(isinstance(value, str) or all(isinstance(v, str | dict) for v in value) for value in found.values())


def test_sizes_are_those_of_the_hub() -> None:
    names = [name for _, name in SIZES]
    assert names[:2] == ["n<1K", "1K<n<10K"]
    assert all(a.rpartition("<")[2] == b.partition("<")[0] for a, b in pairwise(names[1:]))


def test_the_card_counts_by_everything_and_shows_examples(make: Make, tmp_path: Path) -> None:
    make(maker="fake_makers:masses", items=30)
    text = (tmp_path / "data/README.md").read_text("utf-8")
    for title in ("recipe", "difficulty", "mode", "kind", "quantity", "split"):
        assert f"\n## By {title}\n" in text
    assert "| weight |" in text
    assert "| distinct: alike |" in text
    assert all(f"\n## Example {number}\n" in text for number in range(1, EXAMPLE_COUNT + 1))
    assert "no pictures: matplotlib was missing" in text
    assert "\n\n\n" not in text


def test_the_blocks_of_python_are_python(data: Path) -> None:
    blocks = (data / "README.md").read_text("utf-8").split("```python\n")[1:]
    assert len(blocks) == 3
    for block in blocks:
        compile(block.partition("```")[0], "README.md", "exec")
    ours = blocks[-1].partition("```")[0].replace('"OUT"', repr(str(data)))
    exec(ours, {})


def test_examples_differ_as_much_as_they_can(data: Path) -> None:
    found = choose_examples(Dataset(data))
    assert [item.recipe for item in found] == ["incline", "pulley"] * 3


@pytest.mark.usefixtures("pictures")
def test_pictures_are_the_datasets_own_and_the_same_every_time(make: Make, tmp_path: Path, contents: Contents) -> None:
    manifest = make(workers=2)
    assert manifest.pictures.startswith("matplotlib ")
    assert [name for name in manifest.files if name.startswith("figures/")] == sorted(HISTOGRAMS)
    whole = contents(tmp_path / "data")
    assert all(whole[name].startswith(b"\x89PNG") and b"tEXt" not in whole[name] for name in HISTOGRAMS)
    assert make("again", workers=1).seal == manifest.seal
    assert contents(tmp_path / "again") == whole
    spoiled = bytearray(whole[HISTOGRAMS[0]])
    spoiled[-20] ^= 4
    (tmp_path / "data" / HISTOGRAMS[0]).write_bytes(spoiled)
    (tmp_path / "data" / HISTOGRAMS[1]).unlink()
    assert verify(tmp_path / "data").faults == (f"{HISTOGRAMS[0]}: damaged", f"{HISTOGRAMS[1]}: missing")
    make(workers=1)
    assert contents(tmp_path / "data") == whole


@pytest.mark.usefixtures("pictures")
@pytest.mark.parametrize("items", [95, 120])
def test_pictures_of_before_go_where_none_are_drawn_and_nothing_else_does(
    make: Make, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, items: int
) -> None:
    make()
    theirs = tmp_path / "data/figures/mine.png"
    theirs.write_text("mine")
    (tmp_path / "data" / HISTOGRAMS[2]).write_text("theirs now")
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    manifest = make(items=items)
    assert not manifest.pictures
    assert sorted(path.name for path in (tmp_path / "data/figures").iterdir()) == ["kinds.png", "mine.png"]
    assert not verify(tmp_path / "data").faults


def test_the_command_of_a_card_means_the_same_configuration(tmp_path: Path) -> None:
    (tmp_path / "b.txt").write_text("words")
    order: Order = {
        "items": 3,
        "recipe": ("a", "b"),
        "difficulty": "easy",
        "maker": "fake_makers:steady",
        "weights": {"period": 2.0},
        "split": {"test": 0.25, "train": 0.75},
        "distance": 0.0,
        "license": "mit",
        "units": "cgs",
        "solutions": True,
        "decontaminate": [tmp_path / "b.txt"],
    }
    config = build_config(**order)
    arguments = shlex.split(command(config))[1:]
    arguments[1] = str(tmp_path / "out")
    place = arguments.index("--decontaminate") + 1
    arguments[place] = str(tmp_path / arguments[place])
    result = CliRunner().invoke(main, [*arguments, "--workers", "1", "--maker", "fake_makers:steady"])
    assert result.exit_code == 0, result.stderr
    assert load(tmp_path / "out").config == config
    assert "--distance" not in command(Config(items=1, recipes=("a",)))


@pytest.mark.parametrize("name", ["", "Apache 2.0", "mit\nlicense: none", "a" * 50])
def test_a_licence_is_a_name_of_the_hub(name: str) -> None:
    with pytest.raises(DatasetError, match="license"):
        build_config(items=1, recipe="a", maker="fake_makers:steady", license=name or "-")


def test_histograms_show_every_item_once_and_gaps_between_numbers(data: Path) -> None:
    items = list(Dataset(data))
    for name, counts in count_histograms(items).items():
        shown = histogram(name, counts)
        assert sum(map(sum, shown.series.values())) == len(items)
        assert all(len(values) == len(shown.labels) for values in shown.series.values())
    gaps = histogram("lengths", {"easy": {"20": 1, "50": 2}, "hard": {"30": 1}})
    assert gaps.labels == ["20", "30", "40", "50"]
    assert gaps.series == {"easy": [1, 0, 0, 2], "hard": [0, 1, 0, 0]}


@pytest.mark.slow
@pytest.mark.usefixtures("pictures")
def test_a_real_dataset_has_worked_examples_with_figures(tmp_path: Path) -> None:
    data = generate(tmp_path / "real", items=6, workers=1, recipe=("pulley", "incline"), difficulty="easy", seed=1)
    text = (tmp_path / "real/README.md").read_text("utf-8")
    assert {f"figures/example-{number}.png" for number in range(1, 7)} <= data.manifest.files.keys()
    assert text.count("\\approx \\boxed{") >= 3
    assert not verify(tmp_path / "real").faults

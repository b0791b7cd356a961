"""Regression tests of bug reports that no other test covers: empty splits, plain scripts, completion lengths."""

import subprocess
import sys
from pathlib import Path

import pyarrow.parquet as pq
import pytest
from click.testing import CliRunner

import sim2reason
from plain_scenes import ramp
from sim2reason.cli import main

ROOT = Path(__file__).parent.parent.parent
PAGES = [*ROOT.glob("docs/integrations/*.md"), *ROOT.glob("src/sim2reason/datasets/exports/files/*/*.md")]
SCRIPT = """
import sys
import sim2reason
import sim2reason.datasets.build
sim2reason.datasets.build.put_pictures = lambda *_: ()  # they cost more than all else
print("begins")
sim2reason.generate(sys.argv[1], items=2, recipe="projectile", difficulty="easy", workers=int(sys.argv[2]))
print("ends")
"""


def test_a_split_to_which_nothing_belongs_has_no_file_and_datasets_loads_the_rest(tmp_path: Path) -> None:
    """A shard without rows would make `load_dataset` fail with an Arrow error."""
    out = tmp_path / "data"
    order = ["--items", "2", "--seed", "5", "--recipe", "rolling", "--difficulty", "easy"]
    made = CliRunner().invoke(main, ["generate", str(out), *order, "--split", "train=0.9,test=0.1"])
    assert made.exit_code == 0, made.output
    files = sorted((out / "data").iterdir())
    assert [(file.name.partition("-")[0], pq.read_metadata(file).num_rows) for file in files] == [("train", 2)]
    assert "test-*" not in (out / "README.md").read_text(encoding="utf-8")
    assert CliRunner().invoke(main, ["verify", str(out)]).exit_code == 0
    datasets = pytest.importorskip("datasets")
    loaded = datasets.load_dataset(str(out), cache_dir=str(tmp_path / "cache"))
    assert {name: len(rows) for name, rows in loaded.items()} == {"train": 2}


def test_a_split_may_not_have_the_name_that_datasets_gives_to_all(tmp_path: Path) -> None:
    """The name `all` stands for all splits, both in `datasets` and in this library."""
    order = ["--items", "2", "--split", "all=0.5,test=0.5"]
    refused = CliRunner().invoke(main, ["generate", str(tmp_path / "data"), *order])
    assert refused.exit_code == 2
    assert "'all' stands for all splits" in refused.stderr


@pytest.mark.slow  # datasets/places/test_here does so with a maker that is fast
@pytest.mark.parametrize("workers", [1, 2])
def test_generate_runs_the_lines_of_a_plain_script_once(workers: int, tmp_path: Path) -> None:
    """Workers do not run a script without a `__main__` guard again."""
    script = tmp_path / "plain.py"
    script.write_text(SCRIPT, encoding="utf-8")
    command = [sys.executable, str(script), str(tmp_path / "data"), str(workers)]
    run = subprocess.run(command, check=False, capture_output=True, text=True)
    assert (run.returncode, run.stdout.split()) == (0, ["begins", "ends"]), run.stderr


def test_every_page_on_trl_says_how_long_a_completion_may_be() -> None:
    """TRL's default `max_completion_length` leaves no room for an answer."""
    with_trainer = [page for page in PAGES if "GRPOTrainer(" in page.read_text(encoding="utf-8")]
    assert len(with_trainer) >= 3
    assert all("max_completion_length" in page.read_text(encoding="utf-8") for page in with_trainer)


def test_a_description_is_printed_as_its_text() -> None:
    """The `str` of a description is its text, not the fields of an object."""
    described = sim2reason.describe(ramp())
    assert str(described) == described.text

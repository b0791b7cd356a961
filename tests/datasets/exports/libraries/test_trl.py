"""Tests that `datasets` loads the export, that its reward grades it, and that TRL's trainer takes both."""

import ast
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from sim2reason.generation.item import Item
from sim2reason.rewards import accuracy

datasets = pytest.importorskip("datasets", reason="make test-exports")


def test_datasets_load_it_and_the_reward_grades(
    exported: Callable[[str], Path],
    items: dict[str, Item],
    right: Callable[[Item], str],
    wrong: Callable[[Item], Iterator[str]],
    tmp_path: Path,
) -> None:
    loaded = datasets.load_dataset(str(exported("hf")), cache_dir=str(tmp_path / "cache"))
    rows = [row for split in loaded.values() for row in split]
    assert set(loaded) == {"train", "test"}
    assert {row["id"] for row in rows} == set(items)
    for row in rows:
        item = items[row["id"]]
        assert row["prompt"] == [{"role": "user", "content": item.prompt}]
        said = [[{"role": "assistant", "content": text}] for text in (right(item), *wrong(item))]
        columns = {name: [value] * len(said) for name, value in row.items() if name != "prompt"}
        assert accuracy(prompts=[row["prompt"]] * len(said), completions=said, **columns) == [
            1.0,
            *[0.0] * (len(said) - 1),
        ]


def test_a_trainer_takes_fresh_problems(tmp_path: Path) -> None:
    """The rewards are those of a model that guesses: neither all right nor all wrong."""
    pytest.importorskip("trl", reason="make test-exports")
    environ = os.environ | {"OMP_NUM_THREADS": "1", "HF_HUB_OFFLINE": "1"}
    command = [sys.executable, str(Path(__file__).parents[4] / "examples/train_with_trl.py")]
    done = subprocess.run(command, cwd=tmp_path, env=environ, capture_output=True, text=True, check=False, timeout=900)
    assert done.returncode == 0, done.stderr[-2000:]
    rewards = ast.literal_eval(done.stdout.rpartition("mean rewards: ")[2].strip())
    assert len(rewards) == 6
    assert 0.0 < sum(rewards) / 6 < 0.6


@pytest.mark.slow  # .ci/run runs the commands of all pages, too
@pytest.mark.parametrize("page", ["hf", "trl"])
def test_the_page_is_true(follow: Callable[[str], None], page: str) -> None:
    if page == "trl":
        pytest.importorskip("trl", reason="make test-exports")
    follow(page)

"""Tests that Reasoning Gym makes the dataset by its name, orders it by a seed, and scores replies."""

import importlib
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from sim2reason.generation.item import Item

reasoning_gym = pytest.importorskip("reasoning_gym", reason="make test-exports")


def test_it_is_created_sampled_and_scored(
    exported: Callable[[str], Path],
    items: dict[str, Item],
    right: Callable[[Item], str],
    wrong: Callable[[Item], Iterator[str]],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    from reasoning_gym import composite

    folder = exported("reasoning-gym")
    monkeypatch.syspath_prepend(folder)
    importlib.import_module("sim2reason_problems")
    seen = set()
    for split in ("train", "test"):
        size = len((folder / f"data/{split}.jsonl").read_text().splitlines())
        data = reasoning_gym.create_dataset("sim2reason", split=split, seed=1, size=size)
        for entry in data:
            item = items[entry["metadata"]["id"]]
            seen.add(item.id)
            assert entry["question"] == item.prompt
            assert data.score_answer(entry["answer"], entry) == 1.0
            assert data.score_answer(right(item), entry) == 1.0
            assert [data.score_answer(said, entry) for said in wrong(item)] == [0.0] * len(item.distractors)
            assert [data.score_answer(str(d.value), entry) for d in item.distractors] == [0.0] * len(item.distractors)
            assert data.score_answer(None, entry) == 0.0
        other = reasoning_gym.create_dataset("sim2reason", split=split, seed=2, size=2 * size)
        assert [entry["question"] for entry in other][:size] != [entry["question"] for entry in data]
        assert other[0]["question"] == other[size]["question"]
    assert seen == set(items)
    with pytest.raises(ValueError, match="there is no such split"):
        reasoning_gym.create_dataset("sim2reason", split="dev")
    specs = [composite.DatasetSpec(name=name, weight=1, config={}) for name in ("sim2reason", "leg_counting")]
    mixed = reasoning_gym.create_dataset("composite", seed=3, size=20, datasets=specs)
    for entry in mixed:
        assert mixed.score_answer(entry["answer"], entry) == 1.0


def test_fresh_problems_are_drawn_sampled_and_scored(
    exported: Callable[[str], Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.syspath_prepend(exported("reasoning-gym"))
    importlib.import_module("sim2reason_problems")
    easy = {"recipe": "pulley", "difficulty": "easy"}
    data = reasoning_gym.create_dataset("sim2reason_fresh", seed=1, size=5, **easy)
    assert [data.score_answer(entry["answer"], entry) for entry in data] == [1.0] * 5
    assert [data.score_answer("1e9", entry) for entry in data] == [0.0] * 5
    assert data[3] == list(data)[3], "a place has one problem"
    ids = {entry["metadata"]["id"] for entry in data}
    other = reasoning_gym.create_dataset("sim2reason_fresh", seed=2, size=5, **easy)
    assert len(ids | {entry["metadata"]["id"] for entry in other}) == 10
    with pytest.raises(ValueError, match="size must be positive"):
        reasoning_gym.create_dataset("sim2reason_fresh", size=0)


def test_the_page_is_true(follow: Callable[[str], None]) -> None:
    follow("reasoning-gym")

"""Tests of problems by position, made on request: reproducible, of one split, and with a bounded search."""

import json
import pickle
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import pytest

import fake_makers
from sim2reason.datasets import fresh
from sim2reason.datasets.contamination import Benchmarks
from sim2reason.datasets.fresh import INDEX_STRIDE, LazyProblems
from sim2reason.datasets.plan import Config
from sim2reason.errors import DatasetError, DrawError
from sim2reason.generation.request import Made, Request
from sim2reason.generation.splits import choose_split

SPLIT = {"test": 0.4, "train": 0.6}  # in alphabetical order, as configurations have them


def problems(items: int = 40, of: str = "train", **more: object) -> LazyProblems:
    config = {"recipes": ("pulley", "incline"), "difficulties": ("easy", "hard"), "maker": "fake_makers:steady", **more}
    return LazyProblems(Config.model_validate({"items": items, "seed": 5, **config}), of)


def test_positions_are_those_of_a_dataset_and_what_no_draw_fills_goes_to_an_index_far_beyond() -> None:
    found = problems()
    moved = {}
    for position in range(len(found)):
        item, request = found[position], found.config.request(position)
        if item.id != request.id:
            moved[request.id] = item.id
    assert moved == {
        f"incline-{hard}-numeric-5-3": f"incline-{hard}-numeric-5-{3 + INDEX_STRIDE}" for hard in ("easy", "hard")
    }


def _ids(found: LazyProblems) -> list[str]:
    return [item.id for item in found]


def test_any_process_in_any_order_gets_the_same() -> None:
    found = problems(of="test", split=SPLIT)
    forward = _ids(found)
    assert [found[position].id for position in reversed(range(len(found)))] == forward[::-1]
    assert _ids(pickle.loads(pickle.dumps(found))) == forward
    with ProcessPoolExecutor(1, get_context("spawn")) as pool:
        assert [item.id for item in pool.submit(list, found).result()] == forward


def test_a_longer_one_begins_with_a_shorter_one() -> None:
    assert _ids(problems(60, split=SPLIT))[:40] == _ids(problems(40, split=SPLIT))


def test_splits_are_those_of_a_dataset_and_no_request_comes_twice() -> None:
    ids = []
    for split in SPLIT:
        for item in problems(100, split, split=SPLIT):
            assert choose_split(item, SPLIT) == split
            ids.append(item.id)
    assert len(set(ids)) == len(ids) == 200


def test_what_shares_words_with_a_benchmark_is_passed_over(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = "Item pulley easy numeric: a block of mass 3 kg rests. Find its weight."
    (tmp_path / "known.jsonl").write_text(json.dumps({"problem": text}) + "\n")
    monkeypatch.setattr(fresh, "TRIES", 5)
    config = problems().config
    found = LazyProblems(config, benchmarks=Benchmarks([tmp_path / "known.jsonl"]))
    assert found[1].id == config.request(1).id == "incline-hard-numeric-5-0"
    with pytest.raises(DrawError, match="pulley-easy-numeric-5-0: none of 5 draws"):
        found[0]


@pytest.fixture
def counted(monkeypatch: pytest.MonkeyPatch) -> list[Request]:
    """Return the list of requests to a maker that makes nothing."""
    asked: list[Request] = []

    def nothing(request: Request) -> Made:
        asked.append(request)
        return Made(None, {"shortcut": 1})

    monkeypatch.setattr(fake_makers, "nothing", nothing, raising=False)
    return asked


def test_the_search_is_bounded_and_says_what_to_do(counted: list[Request]) -> None:
    with pytest.raises(DrawError, match="give it a larger share, or leave pulley out"):
        problems(maker="fake_makers:nothing")[0]
    assert len(counted) == len(set(counted)) == fresh.TRIES


@pytest.mark.parametrize("position", [-1, 40, 10**9])
def test_there_is_nothing_beyond_its_length(position: int) -> None:
    with pytest.raises(IndexError, match=f"position {position} of 40"):
        problems()[position]


@pytest.mark.parametrize(
    ("make", "told"),
    [
        (lambda: problems(INDEX_STRIDE + 1), f"items: {INDEX_STRIDE + 1} are too many; give {INDEX_STRIDE} at most"),
        (lambda: problems(of="dev", split=SPLIT), "there is no split 'dev'; there is test, train"),
        (lambda: problems(maker="fake_makers:missing"), "no maker of items can be imported from here"),
    ],
)
def test_what_cannot_be_is_told_at_once(make: Callable[[], object], told: str) -> None:
    with pytest.raises(DatasetError, match=told):
        make()


def test_the_librarys_own_maker_draws() -> None:
    found = LazyProblems(Config(items=4, recipes=("projectile",), seed=2))
    assert found[3] == found[3]
    assert found[3].id == "projectile-easy-numeric-2-1"

from collections.abc import Callable
from pathlib import Path

import pytest

from cells import CELLS
from fake_makers import steady
from shared_items import SharedItems
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.manifest import Manifest
from sim2reason.errors import DatasetError
from sim2reason.generation.item import Item
from sim2reason.generation.request import Request
from sim2reason.generation.splits import choose_split, problem

Make = Callable[..., Manifest]
HALVES = {"test": 0.5, "train": 0.5}


def item(index: int, **changes: object) -> Item:
    made = steady(Request("pulley", "easy", "numeric", 0, index)).item
    assert made is not None
    return made.model_copy(update=changes)


def test_numbers_make_no_other_problem_and_parts_do() -> None:
    light, heavy = (item(n, scene=f"block:\n  mass: {mass}\n  parts.1: x\n") for n, mass in enumerate(("0.5", "-12")))
    other = item(2, scene="block:\n  mass: 0.5\n  parts.2: x\n")
    assert problem(light) == problem(heavy)
    assert problem(light) != problem(other)


def test_what_is_asked_makes_another_problem_and_when_does_not() -> None:
    scene = "block:\n  mass: 1.0\n"
    early, late = (item(4, scene=scene, asked=item(4).asked.model_copy(update={"time": t})) for t in (1.0, 2.0))
    speed = item(4, scene=scene, asked=item(4).asked.model_copy(update={"quantity": "velocity"}))
    assert problem(early) == problem(late)
    assert problem(early) != problem(speed)


def test_all_goes_to_the_only_split() -> None:
    assert {choose_split(item(n), {"train": 1.0}) for n in range(9)} == {"train"}


def test_each_split_holds_its_share_of_the_problems() -> None:
    """A 5 % split of 2000 different problems holds 100 ± 10, by the binomial distribution."""
    found = [choose_split(item(n, kind=f"kind {n}"), {"test": 0.05, "train": 0.95}) for n in range(2000)]
    assert 60 <= found.count("test") <= 140


def test_a_dataset_of_two_splits_holds_every_item_once(make: Make, data: Path) -> None:
    manifest = make("halves", split=HALVES)
    halves = Dataset(data.parent / "halves")
    assert manifest.counts["split"].keys() == HALVES.keys()
    ids = {name: {item.id for item in halves.items(name)} for name in HALVES}
    assert {name: len(found) for name, found in ids.items()} == manifest.counts["split"]
    assert ids["test"].isdisjoint(ids["train"])
    assert ids["test"] | ids["train"] == {item.id for item in Dataset(data)}


def test_two_items_of_one_scene_do_not_stand_in_a_dataset_of_two_splits(make: Make) -> None:
    assert make(maker="fake_makers:one_scene").rows == 95
    with pytest.raises(DatasetError, match="1 problems of 95 asked for"):
        make("halves", maker="fake_makers:one_scene", split=HALVES)


@pytest.mark.parametrize("count", [2, pytest.param(4, marks=pytest.mark.slow)])
def test_no_problem_up_to_numbers_and_no_text_of_one_stands_on_both_sides(
    numeric_items: SharedItems, count: int
) -> None:
    from sim2reason.generation.splits import mask_numbers

    sides: dict[str, dict[str, set[str]]] = {"train": {}, "test": {}}
    for made in numeric_items.of_all(dict.fromkeys(CELLS, count)):
        side = sides[choose_split(made, HALVES)]
        side.setdefault("text", set()).add(mask_numbers(made.prompt))
        side.setdefault("scene", set()).add(made.scene)
        side.setdefault("problem", set()).add(problem(made))
    assert all(sides["train"][by].isdisjoint(found) for by, found in sides["test"].items())

from collections import Counter
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from sim2reason.datasets.card import text
from sim2reason.datasets.items import item, sample, stream
from sim2reason.datasets.manifest import Manifest, merge_counts
from sim2reason.datasets.plan import Config, file_name
from sim2reason.errors import DrawError
from sim2reason.generation.request import MAX_SEED, Request, versions

NAMES = st.lists(st.sampled_from(["pulley", "incline", "hybrid", "collision"]), min_size=1, unique=True).map(tuple)


@given(NAMES, st.integers(0, 200), st.integers(1, 50))
def test_every_position_has_a_request_of_its_own(recipes: tuple[str, ...], items: int, shard: int) -> None:
    config = Config(items=items, recipes=recipes, shard=shard)
    ranges = [config.positions(number, items) for number in range(config.shards(items))]
    requests = [config.request(k) for positions in ranges for k in positions]
    assert [config.position(config.named(request.id)) for request in requests] == list(range(items))
    assert len({request.id for request in requests}) == items
    counts = [sum(request.recipe == recipe for request in requests) for recipe in recipes]
    assert max(counts) - min(counts) <= 1


@given(st.integers(1, 15), st.integers(1, 3), st.integers(1, 5), st.data())
def test_any_first_few_are_spread_over_all(recipes: int, levels: int, modes: int, data: st.DataObject) -> None:
    """Counts per recipe differ by at most 1, per difficulty by 2, per mode by 3, and evenly within each recipe."""
    names = [tuple(f"{what}{n}" for n in range(count)) for what, count in (("r", recipes), ("d", levels), ("m", modes))]
    config = Config(items=1, recipes=names[0], difficulties=names[1], modes=names[2])
    cells = recipes * levels * modes
    dealt = [(r.recipe, r.difficulty, r.mode) for r in map(config.request, range(cells))]
    assert len(set(dealt)) == cells
    first = dealt[: data.draw(st.integers(1, cells))]
    for place, most in enumerate((1, 2, 3)):
        counts = [sum(cell[place] == name for cell in first) for name in names[place]]
        assert max(counts) - min(counts) <= most, (place, counts)
    for recipe in names[0]:
        for place in (1, 2):
            counts = [sum(cell[0] == recipe and cell[place] == name for cell in first) for name in names[place]]
            assert max(counts) - min(counts) <= 1, (recipe, place, counts)


def test_as_many_as_there_are_recipes_are_of_all_of_them() -> None:
    recipes = tuple(f"r{n}" for n in range(15))
    config = Config(items=15, recipes=recipes, modes=("numeric", "reverse", "symbolic"))
    requests = [config.request(k) for k in range(15)]
    assert {r.recipe for r in requests} == set(recipes)
    for name in ("difficulty", "mode"):
        assert sorted(Counter(getattr(r, name) for r in requests).values()) == [5, 5, 5]


def test_indices_run_from_zero_in_every_cell() -> None:
    config = Config(items=12, recipes=("a", "b"), difficulties=("easy", "hard"))
    assert config.request(0) == Request("a", "easy", "numeric", 0, 0)
    assert config.request(1) == Request("b", "hard", "numeric", 0, 0)
    assert config.request(3) == Request("b", "easy", "numeric", 0, 0)
    assert config.request(4) == Request("a", "easy", "numeric", 0, 1)


def test_a_recipe_named_twice_is_dealt_twice_a_round() -> None:
    config = Config(items=6, recipes=("a", "b", "a"), difficulties=("easy",))
    dealt = [(request.recipe, request.index) for request in map(config.request, range(6))]
    assert dealt == [("a", 0), ("b", 0), ("a", 1), ("a", 2), ("b", 1), ("a", 3)]


def test_shards_are_named_as_the_hub_does() -> None:
    config = Config(items=1001, recipes=("a",))
    assert config.shards(1001) == 3
    assert [config.positions(n, 1001) for n in range(3)] == [range(500), range(500, 1000), range(1000, 1001)]
    assert file_name(2, 3) == "data/train-00002-of-00003.parquet"


def test_positions_are_not_counted_out() -> None:
    config = Config(items=MAX_SEED, recipes=("a", "b"))
    assert config.positions(config.shards(MAX_SEED) - 1, MAX_SEED).stop == MAX_SEED
    assert config.position(config.request(MAX_SEED - 1)) == MAX_SEED - 1


def test_a_request_of_another_configuration_has_no_position() -> None:
    config = Config(items=12, recipes=("a", "b"))
    assert config.position(config.request(12)) == 12  # it may have to take the place of another
    for request in (Request("c", "easy", "numeric", 0, 0), Request("a", "easy", "numeric", 1, 0)):
        with pytest.raises(DrawError, match="no item of this dataset"):
            config.position(request)


@pytest.mark.parametrize(
    "change",
    [
        {"items": -1},
        {"recipes": ()},
        {"shard": 0},
        {"shard": 10**9},
        {"seed": -1},
        {"distance": -0.1},
        {"license": "none\ntags: x"},
        {"split": {"a": 0.5}},
        {"split": {"../a": 1.0}},
        {"split": {"all": 0.5, "test": 0.5}},
        {"colour": "red"},
    ],
)
def test_a_configuration_is_checked(change: dict[str, object]) -> None:
    with pytest.raises(ValidationError):
        Config.model_validate({"items": 1, "recipes": ("a",), **change})


def test_the_hash_knows_configuration_and_versions() -> None:
    config = Config(items=1, recipes=("a",))
    other = Config(items=2, recipes=("a",))
    assert len({config.digest({}), other.digest({}), config.digest({"numpy": "1"})}) == 3
    assert {"python", "platform", "numpy", "mujoco", "sim2reason"} <= versions().keys()


def test_counts_of_counts_add_in_alphabetical_order() -> None:
    total = merge_counts([{"b": {"y": 1}}, {"a": {"x": 1}, "b": {"x": 2, "y": 1}}])
    assert list(total.items()) == [("a", {"x": 1}), ("b", {"x": 2, "y": 2})]


def test_the_card_of_an_empty_dataset_has_no_tables_of_nothing() -> None:
    config = Config(items=0, recipes=("a",))
    manifest = Manifest(
        config=config,
        config_hash="0",
        versions={},
        rows=0,
        positions=0,
        counts={},
        cells=(),
        rejected={},
        refused={},
        shards=0,
        files={},
    )
    card = text(manifest, (), ())
    assert card.startswith("---\nlicense: apache-2.0\npretty_name")
    assert "size_categories:\n- n<1K\n" in card
    assert "Refused" not in card
    assert "Example" not in card
    assert "\n\n\n" not in card


@pytest.mark.parametrize("value", [True, False, 1.0, 1.5, "1", None, -1, 2**63, float("nan"), [1]])
def test_a_coordinate_is_a_whole_number(value: Any) -> None:  # noqa: ANN401 - anything
    for seed, index in ((value, 0), (0, value)):
        with pytest.raises(DrawError, match=r"(seed|index): .* is no whole number from 0 to"):
            Request("pulley", "easy", "numeric", seed, index)
    for make in (item, sample):
        with pytest.raises(DrawError, match="seed: "):
            make("rocket", "easy", seed=value)
    for name in ("seed", "start"):
        with pytest.raises(DrawError, match=f"{name}: "):
            next(stream("rocket", "easy", **{name: value}))


def test_whole_numbers_of_numpy_are_as_good() -> None:
    request = Request("pulley", "easy", "numeric", np.int64(3), np.uint8(4))  # type: ignore[arg-type]
    assert request == Request("pulley", "easy", "numeric", 3, 4)
    assert (type(request.seed), type(request.index)) == (int, int)


@pytest.mark.parametrize(("seed", "index"), [(-1, 0), (0, -1), (MAX_SEED + 1, 0)])
def test_coordinates_are_what_a_shard_can_hold(seed: int, index: int) -> None:
    with pytest.raises(DrawError, match="is no whole number from 0 to"):
        Request("pulley", "easy", "numeric", seed, index)
    with pytest.raises(ValidationError):
        Config(items=1, recipes=("pulley",), seed=seed or MAX_SEED + 1)

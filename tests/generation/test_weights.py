"""Tests of the weights of kinds of question, from recipes or by request."""

from collections import Counter

import numpy as np
import pytest

from sim2reason.datasets.items import item, stream
from sim2reason.errors import DatasetError
from sim2reason.generation.filters.well_known import FEW_LAWS
from sim2reason.generation.item_search import ItemSearch
from sim2reason.generation.make import make
from sim2reason.generation.recipes import RECIPES
from sim2reason.generation.request import Request, check, random_kind_order, weight
from sim2reason.questions import KINDS, MODES

ONLY_SUMS = dict.fromkeys(KINDS, 0.0) | {"sum": 1.0}


def test_a_weight_is_the_kinds_share_times_the_recipes_factor() -> None:
    assert weight("event", "numeric", "pulley", {}) == KINDS["event"].share
    factor = RECIPES["projectile"].weights["extremum"]
    assert weight("extremum", "numeric", "projectile", {}) == KINDS["extremum"].share * factor


def test_a_mode_has_factors_of_its_own() -> None:
    factor = MODES["reverse"].weights["sum"]
    assert factor < 1.0
    assert weight("sum", "reverse", "pulley", {}) == factor * weight("sum", "numeric", "pulley", {})


def test_every_mode_weighs_kinds_that_it_can_ask() -> None:
    for found in MODES.values():
        assert found.weights.keys() <= found.kinds
        assert all(factor >= 0.0 for factor in found.weights.values())


def test_the_most_special_name_counts() -> None:
    ordered = {"sum": 1.0, "reverse.sum": 2.0, "box.sum": 3.0, "box.reverse.sum": 4.0}
    found = [weight("sum", mode, recipe, ordered) for recipe in ("box", "chain") for mode in ("reverse", "numeric")]
    assert found == [4.0, 3.0, 2.0, 1.0]


def test_every_recipe_weighs_kinds_that_exist() -> None:
    """Each name is that of a kind, or of a mode and one of its kinds."""
    known = {*KINDS, *(f"{mode}.{kind}" for mode, found in MODES.items() for kind in found.kinds)}
    for found in RECIPES.values():
        assert found.weights.keys() <= known
        assert all(factor >= 0.0 for factor in found.weights.values())


def test_a_recipe_weighs_a_kind_in_one_mode_alone() -> None:
    found = RECIPES["chain"].weights
    reverse, numeric, symbolic = (
        weight("comparison", mode, "chain", {}) for mode in ("reverse", "numeric", "symbolic")
    )
    assert symbolic / numeric == pytest.approx(found["symbolic.comparison"] / found["comparison"])
    assert reverse == MODES["reverse"].weights["comparison"] * numeric


def test_the_first_that_can_be_had_is_drawn_by_its_weight() -> None:
    """With weights 3 : 2 : 1 and an unavailable second kind, the first comes 3 times in 4.

    The order is that of draws without replacement, whose first member among any subset is by weight within it (Luce's
    choice axiom). 4000 draws: the standard deviation is 0.7 %.
    """
    ordered = tuple((dict.fromkeys(KINDS, 0.0) | {"state": 3.0, "event": 2.0, "sum": 1.0}).items())
    rng, first = np.random.default_rng(1), Counter[str]()
    for _ in range(4000):
        order = random_kind_order("numeric", "pulley", ordered, rng)
        assert sorted(order) == ["event", "state", "sum"]  # what has the weight 0 is never asked
        first[next(kind for kind in order if kind != "event")] += 1
    assert first["state"] / 4000 == pytest.approx(0.75, abs=0.03)


@pytest.mark.parametrize(
    ("name", "size", "says"),
    [
        ("sums", 1.0, "weights: sums: there is no kind 'sums'; there are: comparison, "),
        ("reverse", 1.0, "weights: reverse: there is no kind 'reverse'"),
        ("nowhere.sum", 1.0, "weights: nowhere.sum: 'nowhere' is no recipe, mode, or recipe and mode; write KIND"),
        ("numeric.box.sum", 1.0, "weights: numeric.box.sum: 'numeric.box' is no recipe"),
        ("a.box.numeric.sum", 1.0, "'a.box.numeric' is no recipe"),
        ("symbolic.count", 1.0, "weights: symbolic.count: the mode symbolic has no 'count'; it has: "),
        ("box.reverse.count", 0.5, "weights: box.reverse.count: the mode reverse has no 'count'"),
        ("sum", -1.0, "weights: sum: -1.0 is no weight; give a number that is not negative"),
        ("sum", float("nan"), "weights: sum: nan is no weight"),
    ],
)
def test_a_wrong_weight_is_told_with_its_place_and_remedy(name: str, size: float, says: str) -> None:
    with pytest.raises(DatasetError, match="weights: ") as error:
        check({name: size}, ("numeric",), ("box",))
    assert says in str(error.value)


def test_a_kind_that_a_mode_has_not_may_have_the_weight_0() -> None:
    check({"symbolic.count": 0.0}, ("numeric",), ("box",))
    with pytest.raises(DatasetError, match=r"weights: box\.symbolic: all kinds have the weight 0"):
        check(dict.fromkeys(KINDS, 0.0) | {"count": 1.0}, ("numeric", "symbolic"), ("box",))


def test_one_kind_must_be_left_in_every_mode_and_recipe() -> None:
    nothing = dict.fromkeys(KINDS, 0.0)
    with pytest.raises(DatasetError, match=r"weights: chain\.numeric: all kinds have the weight 0; leave one"):
        check(nothing | {"box.sum": 1.0}, ("numeric",), ("box", "chain"))
    check(nothing | {"box.sum": 1.0, "numeric.sum": 1.0}, ("numeric",), ("box", "chain"))


def test_items_are_of_the_kinds_that_are_ordered() -> None:
    made = [item("incline", "medium", seed=4, index=k, weights=ONLY_SUMS) for k in range(3)]
    assert {found.kind for found in made} == {"sum"}
    assert all(found.provenance.weights == ONLY_SUMS for found in made)
    assert len({found.id for found in made} | {item("incline", "medium", seed=4).id}) == 4  # other weights, other name
    assert next(stream("incline", "medium", seed=4, weights=ONLY_SUMS)) == made[0]
    with pytest.raises(DatasetError, match="there is no kind 'sums'"):
        item("incline", weights={"sums": 1.0})


@pytest.mark.parametrize("count", [8, pytest.param(24, marks=pytest.mark.slow)])
def test_what_is_wanted_is_nearly_always_kept(count: int) -> None:
    """At least three of four items are of the kind that their weights choose (54 % before)."""
    made = [make(Request("pulley", "easy", "numeric", seed, k)) for seed in (9, 10) for k in range(count)]
    chosen = [found for found in made if found.wanted]  # empty: a textbook has all its answers ready
    assert len(chosen) >= 5 * count // 3
    assert sum(found.item is not None and found.item.kind == found.wanted for found in chosen) >= 0.75 * len(chosen)
    assert len({found.wanted for found in chosen}) >= 4


def test_a_search_is_a_pure_function_of_its_request() -> None:
    request = Request("incline", "easy", "numeric", 2, 5)
    searches = ItemSearch(request), ItemSearch(request)
    prompts = [found.prompt for search in searches if (found := search.find()) is not None]
    assert len(prompts) == 2
    assert prompts[0] == prompts[1]
    assert searches[0].rejected == searches[1].rejected
    assert searches[0].first_kind == searches[1].first_kind


def test_what_a_textbook_has_ready_is_not_counted_as_asked_for() -> None:
    """Hard periods of planets follow from Kepler's third law, or are too easy, so the cell does not count."""
    only_periods = tuple((dict.fromkeys(KINDS, 0.0) | {"period": 1.0}).items())
    search = ItemSearch(Request("orbital", "hard", "numeric", 4, 0, weights=only_periods))
    assert search.find() is None
    assert search.rejected.keys() == {FEW_LAWS, "difficulty: too easy"}
    assert search.first_kind == ""

"""Tests of the mathematics that solutions may need: mostly elementary by default, or as requested."""

from pathlib import Path

import pytest

import sim2reason
from sim2reason.datasets.items import make_item
from sim2reason.datasets.plan import find_needs
from sim2reason.errors import DatasetError, DrawError, UnknownNameError
from sim2reason.generation.item_search import EVERY_NEED_PROBABILITY, SIMPLE, allowed_needs
from sim2reason.generation.request import Request
from sim2reason.questions.difficulty import DIFFICULTIES, ELEMENTARY, EVERY, NEEDS, Need
from sim2reason.solutions import solve

ORDERED = ("special function",)


def test_few_requests_may_be_filled_by_what_needs_more() -> None:
    """Each request draws by its coordinates alone; a share of one in ten is above twenty standard errors."""
    requests = [Request("pendulum", "easy", mode, 4, n) for mode in ("numeric", "reverse") for n in range(2000)]
    drawn = [allowed_needs(request) for request in requests]
    assert {*drawn} == {SIMPLE, EVERY}
    assert drawn == [allowed_needs(request) for request in requests]
    assert abs(drawn.count(EVERY) / len(drawn) - EVERY_NEED_PROBABILITY) < 0.02
    assert max(SIMPLE) == ELEMENTARY


def test_what_is_ordered_is_had_and_recorded() -> None:
    """Times of a swing take elliptic integrals, which few pendulum problems ask for by default."""
    item = sim2reason.item("pendulum", "medium", seed=3, needs=ORDERED, solutions=True)
    assert item.needs == "special function"
    assert item.provenance.needs == ORDERED
    assert item.solution is not None
    assert item.measured is not None
    plain = [sim2reason.item("pendulum", "easy", index=index) for index in range(4)]
    assert all(NEEDS[found.needs] <= ELEMENTARY for found in plain)


def test_its_id_is_its_own() -> None:
    """The request of an item is recovered from the item; its id alone does not contain the needs."""
    item = sim2reason.item("springs", needs="all", index=2)
    request = Request("springs", "medium", "numeric", 0, 2, needs=tuple(NEEDS))
    assert Request.of(item) == request
    assert Request("springs", "medium", "numeric", 0, 2).id == "springs-medium-numeric-0-2"
    with pytest.raises(DrawError, match="needs do not stand in its id"):
        Request.named(item.id)


def test_names_are_put_in_order() -> None:
    """Each name occurs once, and a hyphen stands for a space."""
    assert find_needs(("root", "inverse-function", "root")) == ("inverse function", "root")
    assert find_needs("quadratic") == ("quadratic",)
    assert find_needs("all") == tuple(NEEDS)
    assert find_needs(()) == ()


def test_another_name_is_refused(tmp_path: Path) -> None:
    """The one-line error lists the existing names."""
    with pytest.raises(UnknownNameError, match=r"^no such need: 'calculus'; there are: arithmetic, .*, or all$"):
        sim2reason.item(needs="calculus")
    with pytest.raises(UnknownNameError, match="no such need"):
        sim2reason.generate(tmp_path / "out", items=1, needs=("root", "calculus"))
    with pytest.raises(DatasetError, match=r"^needs: 5 is no name"):
        sim2reason.generate(tmp_path / "out", items=1, needs=(5,))  # pyright: ignore[reportArgumentType] - that is it


def test_a_dataset_keeps_it(tmp_path: Path) -> None:
    """The needs are in each item, in the manifest and its counts, and in the command on the card."""
    data = sim2reason.generate(tmp_path / "out", items=3, recipe="pulley", needs=("arithmetic",), workers=1)
    assert {item.needs for item in data.items()} == {"arithmetic"}
    assert data.manifest.config.needs == ("arithmetic",)
    assert data.manifest.counts["needs"] == {"arithmetic": 3}
    assert "--needs arithmetic" in (tmp_path / "out" / "README.md").read_text(encoding="utf-8")
    assert all(data.item(item.id) == item for item in data.items())
    assert len(list(sim2reason.show(data, needs="arithmetic"))) == 3
    assert sim2reason.stats(data).counts["needs"] == {"arithmetic": 3}


@pytest.mark.parametrize("recipe", ["projectile", pytest.param("rocket", marks=pytest.mark.slow)])
@pytest.mark.parametrize("mode", ["numeric", "reverse", "symbolic"])
def test_a_shown_solution_needs_what_its_item_says(mode: str, recipe: str) -> None:
    """The shown solution is the measured one, or needs as much."""
    for label in DIFFICULTIES:
        request = Request(recipe, label, mode, 8, 0)
        item, found = make_item(request)
        shown = solve(found.setting)
        assert shown.answer is not None
        assert shown.needs == NEEDS[item.needs]
        assert NEEDS[item.needs] in allowed_needs(request)


def test_needs_ascend() -> None:
    """Items, the command line and the docs use this order and these names."""
    names = ["arithmetic", "quadratic", "inverse function", "root", "special function", "integration"]
    assert [need.label for need in sorted(Need)] == list(NEEDS) == names

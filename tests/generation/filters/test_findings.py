"""Tests of the numbers in the findings of filters about kept problems."""

import pytest

from sim2reason.generation.filters import FILTERS
from sim2reason.generation.item_search import ItemSearch
from sim2reason.generation.request import Request


@pytest.mark.parametrize(
    ("recipe", "mode", "filters"),
    [
        ("pulley", "numeric", ("degenerate", "taut", "jerk", "hidden numbers")),
        ("pulley", "symbolic", ("few symbols",)),
        ("springs", "reverse", ("identifiable",)),
    ],
)
def test_numbers_come_with_the_verdict(recipe: str, mode: str, filters: tuple[str, ...]) -> None:
    found = ItemSearch(Request(recipe, "easy", mode, 3, 0)).find()
    assert found is not None
    for name in filters:
        told = list(FILTERS[name].findings(found.candidate))
        assert any(letter.isdigit() for line in told for letter in line), name

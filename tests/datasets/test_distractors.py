"""What an item marks as having no bearing."""

import pytest

from sim2reason.datasets.items import item


@pytest.mark.parametrize(
    ("recipe", "index", "idle"),
    [
        ("chain", 0, ()),  # carts on a level track, of whose g the text says nothing
        ("springs", 1, ("springs.block.mass",)),  # an equilibrium, for which it leaves the start out
    ],
)
def test_only_stated_numbers_are_marked(recipe: str, index: int, idle: tuple[str, ...]) -> None:
    assert item(recipe, "easy", seed=771, index=index).idle_numbers == idle

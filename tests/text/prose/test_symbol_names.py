"""Tests that symbols have nouns if numbers need none, and that such a text can be read."""

import pytest

from sim2reason.generation.item_search import sample
from sim2reason.generation.recipes import RECIPES
from sim2reason.text.prose.description import describe, with_names, without_names
from sim2reason.text.prose.voices import symbolic_but_zero


@pytest.mark.parametrize("recipe", list(RECIPES))
def test_a_text_loses_its_nouns_again(recipe: str) -> None:
    for seed in range(4):
        plain = describe(sample(recipe, "medium", seed=seed), seed, symbolic_but_zero)
        assert without_names(with_names(plain).text) == plain.text


def test_a_symbol_stands_behind_its_noun() -> None:
    plain = describe(sample("projectile", "easy", seed=1), 1, symbolic_but_zero)
    named = with_names(plain).text
    assert " at $v$" not in named
    assert " a height of a " not in named
    assert not any(f"({symbol}" in named for symbol in ("$m$)", "$M$)"))

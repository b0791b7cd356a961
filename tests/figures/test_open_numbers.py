"""Tests that drawings do not reveal numbers that the text leaves open or gives as symbols."""

import re
from collections import Counter

import pytest

from sim2reason.figures.drawing import drawing
from sim2reason.generation.item_search import sample
from sim2reason.generation.recipes import RECIPES
from sim2reason.scenes.dsl.model import Parameter
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.text.prose.description import describe
from sim2reason.text.prose.voices import Voice, numeric, symbolic_at, symbolic_but_zero


def shown(scene: Scene, voice: Voice) -> set[str]:
    """Return the labels of a drawing without names: *34 N* of *F = 34 N*, *8.1 kg* of *W (8.1 kg)*."""
    labels = drawing(scene, describe(scene, voice=voice), numbers=True).labels
    return {re.sub(r"^.*(= |\()", "", label.text).rstrip(")") for label in labels}


def stated(scene: Scene) -> dict[str, Parameter]:
    """Return the numbers with units that the text states, except those that occur twice."""
    said = {p.path: p.measure.say(p.value) for p in scene.parameters if not p.hidden and p.value}
    count = Counter(said.values())
    return {said[p.path]: p for p in scene.parameters if p.path in said and p.measure.unit and count[said[p.path]] == 1}


@pytest.mark.parametrize("recipe", sorted(RECIPES))
def test_symbols_stand_where_numbers_stood(recipe: str) -> None:
    scene = sample(recipe, "medium", seed=3)
    symbols = shown(scene, symbolic_but_zero)
    assert not symbols & stated(scene).keys()
    assert any("$" in label for label in symbols) == bool(shown(scene, numeric) & stated(scene).keys())


@pytest.mark.parametrize("step", [3, pytest.param(1, marks=pytest.mark.slow)])
@pytest.mark.parametrize("recipe", sorted(RECIPES))
def test_an_unknown_is_shown_by_its_symbol_alone(recipe: str, step: int) -> None:
    """Every third number is tested, or every one in the slow test."""
    scene = sample(recipe, "medium", seed=3)
    for number, parameter in list(stated(scene).items())[::step]:
        assert number not in shown(scene, symbolic_at(parameter.path))

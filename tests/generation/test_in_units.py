"""Tests of items in other units: both text and answer use them, and lead back to the same scene."""

import re
from functools import cache

import pytest

from sim2reason.datasets.grade import grade
from sim2reason.datasets.items import item
from sim2reason.generation.item import Item
from sim2reason.generation.make import in_units
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions.prompt import parse_prompt
from sim2reason.questions.spoken_units import system_named
from sim2reason.scenes.dsl.units import parse_unit

CASES = [
    *((recipe, "numeric") for recipe in RECIPES),
    *((recipe, "reverse") for recipe in ("collision", "electromagnetic", "springs")),
]

made = cache(lambda recipe, mode: item(recipe, "easy", mode, seed=3))


@pytest.mark.parametrize("units", ["cgs", "mixed"])
@pytest.mark.parametrize(("recipe", "mode"), CASES)
def test_the_same_problem_in_other_units(recipe: str, mode: str, units: str) -> None:
    usual: Item = made(recipe, mode)
    other = in_units(system_named(units), usual)
    assert other.scene == usual.scene
    factor = parse_unit(usual.answer.unit).factor_to(parse_unit(other.answer.unit))
    assert factor is not None
    assert other.answer.value == pytest.approx(usual.answer.value * factor, rel=1e-12)
    assert [wrong.value for wrong in other.distractors] == pytest.approx([w.value * factor for w in usual.distractors])
    read = parse_prompt(other.prompt)
    assert read.answer == pytest.approx(other.answer.value, rel=0.01), other.prompt
    number = f"{usual.answer.value:.4g}"
    unit = rf"\ \text{{{usual.answer.unit}}}" if usual.answer.unit else ""
    assert grade(other, rf"\boxed{{{number}{unit}}}").reward == 1.0
    assert (grade(other, rf"\boxed{{{number}}}").reward == 1.0) == (factor == 1.0)


def test_an_item_that_is_ordered_in_other_units_says_so() -> None:
    usual, other = item("pulley", "easy", seed=3), item("pulley", "easy", seed=3, units="cgs")
    assert other.id == f"{usual.id}-cgs"
    assert (usual.provenance.units, other.provenance.units) == ("SI", "cgs")
    assert other.prompt == in_units(system_named("cgs"), usual).prompt != usual.prompt


@pytest.mark.parametrize(
    ("units", "said"),
    [
        ("SI", {"kg", "m/s²", "km/s", "kg/s", "s", "m"}),
        ("cgs", {"g", "cm/s²", "cm/s", "g/s", "s", "cm"}),
        ("mixed", {"kg", "m/s²", "km/s", "kg/s", "s", "m"}),
    ],
)
def test_a_rocket_has_units_that_belong_together(units: str, said: set[str]) -> None:
    told = item("rocket", index=2, weights={"state": 1e6}, units=units)
    found = re.findall(r"(?<=[ (])(?!0 )[\d.]+(?:×10[⁰¹²³⁴-⁹])? ([a-z]+(?:/[a-z]+²?)?)", told.prompt)
    assert {*found, told.answer.unit} == said
    assert parse_prompt(told.prompt).answer == pytest.approx(told.answer.value, rel=0.01)


def test_no_metre_and_no_kilogram_is_left() -> None:
    told = [item("pulley", "medium", seed=5, index=k, units="cgs") for k in range(3)]
    assert any(" g " in found.prompt or " g)" in found.prompt for found in told)
    assert not any(unit in found.prompt for found in told for unit in (" m ", " kg", " m/s", " N ", " J "))

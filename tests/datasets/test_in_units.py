"""Items in other units: the text speaks in them, the answer is in them, and both lead back to the same scene."""

import pytest

from sim2reason.datasets.grade import grade
from sim2reason.datasets.items import item
from sim2reason.dsl.units import parse_unit
from sim2reason.questions.parse_prompt import parse_prompt
from sim2reason.recipes import RECIPES

MODES_AND_UNITS = [("numeric", "cgs"), ("numeric", "mixed"), ("reverse", "cgs")]


@pytest.mark.parametrize("recipe", RECIPES)
@pytest.mark.parametrize(("mode", "units"), MODES_AND_UNITS)
def test_the_same_problem_in_other_units(recipe: str, mode: str, units: str) -> None:
    usual = item(recipe, "easy", mode, seed=3)
    other = item(recipe, "easy", mode, seed=3, units=units)
    assert other.scene == usual.scene
    assert other.id == f"{usual.id}-{units}"
    factor = parse_unit(usual.answer.unit).factor_to(parse_unit(other.answer.unit))
    assert factor is not None
    assert other.answer.value == pytest.approx(usual.answer.value * factor, rel=1e-12)
    assert [wrong.value for wrong in other.distractors] == pytest.approx([w.value * factor for w in usual.distractors])
    read = parse_prompt(other.prompt)
    assert read.answer == pytest.approx(other.answer.value, rel=0.01), other.prompt
    assert grade(other, rf"\boxed{{{usual.answer.value:.4g}\ \text{{{usual.answer.unit}}}}}").reward == 1.0
    if factor != 1.0:
        assert grade(other, rf"\boxed{{{usual.answer.value:.4g}}}").reward == 0.0


@pytest.mark.parametrize(("units", "spoken", "unspoken"), [("cgs", " cm", " m "), ("mixed", " cm", " m ")])
def test_no_metre_is_left(units: str, spoken: str, unspoken: str) -> None:
    made = [item("pulley", "medium", seed=5, index=k, units=units) for k in range(4)]
    assert any(spoken in found.prompt for found in made)
    assert not any(unspoken in found.prompt for found in made)
    assert all("kg" not in found.prompt for found in made if units == "cgs")

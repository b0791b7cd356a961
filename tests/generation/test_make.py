"""Tests of items from the maker."""

import re

import pytest

from sim2reason.generation.item import Item
from sim2reason.generation.make import make
from sim2reason.generation.request import Request
from sim2reason.grading.formula import compile_formula
from sim2reason.scenes.dsl.units import parse_unit

CELLS = (
    *(("electromagnetic", "easy"), ("rocket", "easy"), ("projectile", "medium")),
    *(("orbital", "easy"), ("rotation", "easy")),
)
ASTRONOMICAL = re.compile(r"\b(au|yr|Msun)\b")


def items() -> list[Item]:
    made = (make(Request(*cell, "symbolic", 41, index)).item for cell in CELLS for index in range(3))
    return [item for item in made if item is not None]


def size(unit: str) -> float:
    """Return the size of a unit in the SI, or 1 for astronomical units, in which formulas use 4π² for G."""
    return 1.0 if ASTRONOMICAL.search(unit) else parse_unit(unit).factor


def test_the_units_of_a_formula_are_those_of_its_numbers() -> None:
    """A formula whose numbers are converted to the SI by its declared units gives the item's answer in the SI."""
    units = set[str]()
    for item in items():
        formula, value = item.answer.formula, item.answer.value * size(item.answer.unit)
        assert formula is not None
        function = compile_formula(formula.latex, formula.symbols)
        for binding in formula.bindings:
            held = zip(formula.symbols, binding.numbers, formula.units, strict=True)
            found = function.value({name: number * size(unit) for name, number, unit in held})
            assert found == pytest.approx(binding.answer * size(formula.unit), rel=1e-5), item.id
        assert formula.bindings[0].answer * size(formula.unit) == pytest.approx(value, rel=1e-9), item.id
        units |= {formula.unit, *formula.units}
    assert {"kg", "uC", "m/s", "rad", "au"} <= units
    assert not {"g", "mC", "km/s", "deg"} & units

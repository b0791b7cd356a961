"""Conversion of a worked solution to the units that the text of a problem asks for."""

from dataclasses import replace

from sim2reason.questions.spoken_units import SpokenUnits
from sim2reason.solutions.solution import Solution
from sim2reason.solutions.writing.unit_latex import latex

GIVEN = "Given: "


def convert_answer(system: SpokenUnits, solution: Solution, unit: str) -> Solution:
    """Return a solution in SI units that ends with a conversion to the unit in which the prompt asks for the answer."""
    other, factor = system.spelled(unit)
    if solution.answer is None or solution.formula or not system.says_otherwise:
        return solution
    steps = tuple(
        replace(step, text=step.text.replace(GIVEN, "Given, in SI units: ", 1)) if step.kind == "givens" else step
        for step in solution.steps
    )
    return replace(
        solution, steps=steps, asked_unit=(latex(other), float(factor)) if other != unit else solution.asked_unit
    )

"""A worked solution told for the text of a problem: in the units for which that asks."""

from dataclasses import replace

from sim2reason.questions.spoken_units import SpokenUnits
from sim2reason.solutions.solution import Solution
from sim2reason.solutions.writing.unit_latex import latex

GIVEN = "Given: "


def told_in(system: SpokenUnits, solution: Solution, unit: str) -> Solution:
    """Worked out in the SI, and the answer, which is in `unit` there, converted at the end; a formula holds in any."""
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

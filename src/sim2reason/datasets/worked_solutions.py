"""Worked solutions of problems, as their texts ask for the answer."""

from sim2reason.datasets.item import SolutionRecord, SolutionStep
from sim2reason.datasets.question_search import CertifiedQuestion
from sim2reason.datasets.request import Request
from sim2reason.questions.spoken_units import system_named
from sim2reason.solutions import Solution, solve
from sim2reason.solutions.writing.asked_units import told_in


def worked(request: Request, found: CertifiedQuestion) -> Solution:
    """The solution of a question that passed, in the units of its text; one without an answer says why."""
    asked = found.question
    units = system_named(request.units).beside(found.prompt, (asked.answer, asked.unit))
    return told_in(units, solve(found.setting), asked.unit)


def recorded(solution: Solution) -> tuple[SolutionRecord | None, str]:
    """Its record, or None and why there is none."""
    if solution.answer is None:
        return None, solution.reason
    steps = tuple(
        SolutionStep(
            kind=step.kind, text=step.text, relations=tuple(held.latex() for held in step.relations), needs=step.needs
        )
        for step in solution.steps
    )
    record = SolutionRecord(strategy=solution.strategy, derived=solution.derived, text=solution.text, steps=steps)
    return record, ""

"""Worked solutions of problems, as their texts ask for the answer."""

from sim2reason.generation.certified import CertifiedQuestion
from sim2reason.generation.item import SolutionRecord, SolutionStep
from sim2reason.generation.request import Request
from sim2reason.questions import Question
from sim2reason.questions.choice_prompts import LETTERS as LETTERS_OF_OPTIONS
from sim2reason.questions.spoken_units import system_named
from sim2reason.solutions import Solution, solve
from sim2reason.solutions.multipart.in_sequence import in_sequence
from sim2reason.solutions.parts import chosen, together
from sim2reason.solutions.writing.asked_units import told_in


def worked(request: Request, found: CertifiedQuestion) -> Solution:
    """Return the solution of a question that passed, in the units of its text; one without an answer says why.

    Where there are several parts, it is that of all.
    """
    if found.parts:
        return together(worked_parts(request, found, whole=True))
    solution = _in_units(request, found, found.question, solve(found.setting))
    if found.options and solution.answer is not None:
        return chosen(solution, LETTERS_OF_OPTIONS[found.options.index(None)])
    return solution


def worked_parts(request: Request, found: CertifiedQuestion, *, whole: bool = False) -> list[Solution]:
    """Return the solution of each part of a problem, starting from the answers to earlier parts; see `in_sequence`."""
    settings = [part.certified.setting for part in found.parts]
    solutions = in_sequence(settings, [part.solution for part in found.parts], whole=whole)
    asked = (part.certified.question for part in found.parts)
    return [_in_units(request, found, *pair) for pair in zip(asked, solutions, strict=True)]


def _in_units(request: Request, found: CertifiedQuestion, asked: Question, solution: Solution) -> Solution:
    """Return the solution of one question in the units of the whole text."""
    answers = [part.certified.question for part in found.parts] or [asked]
    said = ((question.answer, question.unit) for question in answers)
    return told_in(system_named(request.units).beside(found.prompt, *said), solution, asked.unit)


def recorded(solution: Solution) -> tuple[SolutionRecord | None, str]:
    """Return its record, or None and why there is none."""
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

"""Worked solutions of problems, as their texts ask for the answer."""

from functools import partial

from sim2reason.datasets.certified import CertifiedQuestion
from sim2reason.datasets.item import SolutionRecord, SolutionStep
from sim2reason.datasets.request import Request
from sim2reason.grading.parts import LABELS
from sim2reason.questions import Question
from sim2reason.questions.choice_prompts import LETTERS as LETTERS_OF_OPTIONS
from sim2reason.questions.spoken_units import system_named
from sim2reason.solutions import Setting, Solution, solve
from sim2reason.solutions.multipart.faults import naming_fault
from sim2reason.solutions.multipart.naming import consistent
from sim2reason.solutions.multipart.quoting import quoting
from sim2reason.solutions.multipart.recall import starting_from
from sim2reason.solutions.multipart.shortcuts import shortened
from sim2reason.solutions.multipart.unused import without_unused
from sim2reason.solutions.parts import chosen, together
from sim2reason.solutions.verification import verified
from sim2reason.solutions.writing.asked_units import told_in

UNCLEAR = "the names of its parts are not clear"


def worked(request: Request, found: CertifiedQuestion) -> Solution:
    """The solution of a question that passed, in the units of its text; one without an answer says why.

    Where there are several parts, it is that of all.
    """
    if found.parts:
        return together(worked_parts(request, found, whole=True))
    solution = _in_units(request, found, found.question, solve(found.setting))
    if found.options and solution.answer is not None:
        return chosen(solution, LETTERS_OF_OPTIONS[found.options.index(None)])
    return solution


def worked_parts(request: Request, found: CertifiedQuestion, *, whole: bool = False) -> list[Solution]:
    """The solution of each part, which starts from the answers to earlier ones.

    With `whole` it starts from all that their solutions find, too, as whoever has read them can. Names mean the same in
    all parts; where they do not, none is shown.
    """
    fixed = {given.symbol for part in found.parts for given in part.certified.setting.lexicon.givens.values()}
    named = consistent([part.solution for part in found.parts], fixed)
    solutions, earlier = list[Solution](), list[tuple[str, Solution]]()
    for label, held, part in zip(LABELS, named, found.parts, strict=False):
        setting = part.certified.setting
        solution = starting_from(held, earlier, whole=whole)
        if whole:
            direct = (starting_from(each, earlier, whole=True) for each in shortened(held, earlier))
            solution = next((each for each in direct if _accepted(each, setting)), solution)
        checked = solution if solution is held else verified(solution, setting)
        solutions.append(checked if whole else without_unused(checked, partial(_accepted, setting=setting)))
        earlier.append((label, solutions[-1]))
    if fault := naming_fault(solutions):
        return [Solution("", reason=f"{UNCLEAR}: {fault}") for _ in solutions]
    solutions = quoting(solutions) if whole else solutions
    asked = (part.certified.question for part in found.parts)
    return [_in_units(request, found, *pair) for pair in zip(asked, solutions, strict=True)]


def _accepted(solution: Solution, setting: Setting) -> bool:
    return verified(solution, setting).answer is not None


def _in_units(request: Request, found: CertifiedQuestion, asked: Question, solution: Solution) -> Solution:
    """The solution of one question in the units of the whole text."""
    answers = [part.certified.question for part in found.parts] or [asked]
    said = ((question.answer, question.unit) for question in answers)
    return told_in(system_named(request.units).beside(found.prompt, *said), solution, asked.unit)


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

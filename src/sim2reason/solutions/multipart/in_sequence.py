"""The solutions of all parts of a problem, each of which starts from those of the parts before it."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial

from sim2reason.grading.parts import LABELS
from sim2reason.solutions.laws.tension_checks import TAUT
from sim2reason.solutions.multipart.faults import naming_fault
from sim2reason.solutions.multipart.naming import consistent
from sim2reason.solutions.multipart.quoting import quoting
from sim2reason.solutions.multipart.recall import given_for, renumbered, starting_from
from sim2reason.solutions.multipart.shortcuts import shortened
from sim2reason.solutions.multipart.unused import without_unused
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.solution import Solution
from sim2reason.solutions.verification import verified

UNCLEAR = "the names of its parts are not clear"


def in_sequence(settings: Sequence[Setting], solutions: Sequence[Solution], *, whole: bool = False) -> list[Solution]:
    """Return a solution of each part that starts from earlier answers; `solutions` are those of the parts alone.

    With `whole`, a solution also starts from all results of earlier solutions, as a reader of these can. Names mean the
    same in all parts; if they do not, no part has an answer.
    """
    fixed = {given.symbol for setting in settings for given in setting.lexicon.givens.values()}
    found, earlier = list[Solution](), list[tuple[str, Solution]]()
    for label, alone, setting in zip(LABELS, consistent(solutions, fixed), settings, strict=False):
        held = _without_repeated_checks(alone, earlier) if whole else alone
        solution = starting_from(held, earlier, whole=whole)
        known = results_of(found, whole=whole)
        accepted = partial(_accepted, setting=setting, known=known)
        if whole:
            direct = (starting_from(each, earlier, whole=True) for each in shortened(held, earlier))
            solution = next((each for each in direct if accepted(each)), solution)
        checked = solution if solution is held else verified(solution, setting, known)
        found.append(checked if whole else without_unused(checked, accepted))
        earlier.append((label, found[-1]))
    if fault := naming_fault(found):
        return [Solution("", reason=f"{UNCLEAR}: {fault}") for _ in found]
    return quoting(found) if whole else found


def _without_repeated_checks(solution: Solution, earlier: Sequence[tuple[str, Solution]]) -> Solution:
    """Return a solution that does not say again that strings stay taut, as an earlier part has said of the motion."""
    if not any(step.kind == TAUT for _, other in earlier for step in other.steps):
        return solution
    kept = [step for step in solution.steps if step.kind != TAUT]
    if len(kept) == len(solution.steps):
        return solution
    symbols = {name for step in kept if step.kind != "givens" for name in step.symbols()} | {solution.goal}
    return replace(
        solution, steps=renumbered([given_for(step, symbols) if step.kind == "givens" else step for step in kept])
    )


def _accepted(solution: Solution, setting: Setting, known: Mapping[str, float]) -> bool:
    return verified(solution, setting, known).answer is not None


def results_of(earlier: Iterable[Solution], *, whole: bool = False) -> dict[str, float]:
    """Return the numbers by name that a later part may start from: answers, with `whole` all results on the way."""
    found: dict[str, float] = {}
    for solution in earlier:
        if solution.answer is None:
            continue
        names = [solution.goal, *(name for step in solution.steps for name in step.gives if whole)]
        found |= {name: solution.values[name] for name in names if name in solution.values}
    return found

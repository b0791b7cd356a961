"""The solutions of all parts of a problem, each of which starts from those of the parts before it."""

from collections.abc import Sequence
from functools import partial

from sim2reason.grading.parts import LABELS
from sim2reason.solutions.multipart.faults import naming_fault
from sim2reason.solutions.multipart.naming import consistent
from sim2reason.solutions.multipart.quoting import quoting
from sim2reason.solutions.multipart.recall import starting_from
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
    for label, held, setting in zip(LABELS, consistent(solutions, fixed), settings, strict=False):
        solution = starting_from(held, earlier, whole=whole)
        if whole:
            direct = (starting_from(each, earlier, whole=True) for each in shortened(held, earlier))
            solution = next((each for each in direct if _accepted(each, setting)), solution)
        checked = solution if solution is held else verified(solution, setting)
        found.append(checked if whole else without_unused(checked, partial(_accepted, setting=setting)))
        earlier.append((label, found[-1]))
    if fault := naming_fault(found):
        return [Solution("", reason=f"{UNCLEAR}: {fault}") for _ in found]
    return quoting(found) if whole else found


def _accepted(solution: Solution, setting: Setting) -> bool:
    return verified(solution, setting).answer is not None

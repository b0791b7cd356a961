"""Only solutions whose data lead to the answer are shown."""

from sim2reason.solutions.checking import recompute
from sim2reason.solutions.data import Data, as_data
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.solution import SAME, WELL, Solution

WHY = "recomputed from what it states, it does not lead to the answer"


def verified(solution: Solution, setting: Setting) -> Solution:
    """Recompute the answer from the data of a solution; give back one without an answer if that fails, saying why.

    The answer must be the engine's, without a fault, and the numbers that are given must be those of the question.
    """
    if solution.answer is None:
        return solution
    reason = refusal(as_data(solution), setting)
    return Solution(solution.strategy, reason=f"{WHY}: {reason}") if reason else solution


def refusal(data: Data, setting: Setting) -> str:
    """Why a solution can't be shown, by its data; empty if it can."""
    said = {given.symbol: given.value for given in setting.lexicon.givens.values()}
    for name, value in data["givens"].items():
        if name in said and abs(value - said[name]) > WELL * abs(said[name]):
            return f"{name} is {said[name]:g} in the question, not {value:g}"
    found = recompute(data)
    if found.faults:
        return found.faults[0]
    if setting.answer is None or not found.agrees(setting.answer, SAME):
        return f"it leads to {found.answer}, not to {setting.answer}"
    return ""

"""Only solutions whose data lead to the answer are shown."""

from sim2reason.solutions.checking import recompute
from sim2reason.solutions.data import as_data
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.solution import SAME, WELL, Solution

WHY = "recomputed from what it states, it does not lead to the answer"


def verified(solution: Solution, setting: Setting) -> Solution:
    """Recompute the answer from the data of a solution; give back one without an answer if that fails, saying why.

    The answer must be the engine's, without a fault, and the numbers that are given must be those of the question.
    """
    if solution.answer is None or setting.answer is None:
        return solution
    data = as_data(solution)
    said = {given.symbol: given.value for given in setting.lexicon.givens.values()}
    for name, value in data["givens"].items():
        if name in said and abs(value - said[name]) > WELL * abs(said[name]):
            return Solution(solution.strategy, reason=f"{WHY}: {name} is {said[name]:g} in the question, not {value:g}")
    found = recompute(data)
    if found.agrees(setting.answer, SAME):
        return solution
    reached = f"it leads to {found.answer:.9g}, not {setting.answer:.9g}" if found.answer is not None else "to nothing"
    return Solution(solution.strategy, reason=f"{WHY}: {found.faults[0] if found.faults else reached}")

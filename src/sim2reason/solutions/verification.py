"""Verification that the data of a solution lead to the answer."""

from collections.abc import Iterator, Mapping
from math import radians

from sim2reason.solutions.checking import recompute
from sim2reason.solutions.data import Data, as_data
from sim2reason.solutions.reverse import forward
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.solution import ANSWER_RTOL, RELATION_RTOL, Solution

STATED_RESULT_RTOL = 1e-5  # relative tolerance of stated results, which have five digits
RECOMPUTATION_FAILED = "recomputed from what it states, it does not lead to the answer"


def verify_solution(
    solution: Solution, setting: ProblemContext, earlier: Mapping[str, float] | None = None
) -> Solution:
    """Return a solution if its answer is recomputed from its data, else a solution without one and the reason.

    The recomputed answer must be the engine's, and the given numbers must be those of the text and the question, or
    results of `earlier` parts by name.
    """
    if solution.answer is None:
        return solution
    reason = verification_fault(as_data(solution), setting, earlier)
    return Solution(solution.strategy, reason=f"{RECOMPUTATION_FAILED}: {reason}") if reason else solution


def verification_fault(data: Data, setting: ProblemContext, earlier: Mapping[str, float] | None = None) -> str:
    """Return why a solution's data fail the check; empty if they pass. `earlier` has results of earlier parts."""
    setting = forward(setting)
    stated = named_in_text(setting) | dict(earlier or {})
    for name, value in data["givens"].items():
        if name in stated and not _same(value, stated[name]):
            return f"{name} is {stated[name]:g} in the question, not {value:g}"
        if name not in stated and not any(_same(value, number) for number in stated_by_question(setting)):
            return f"{name} = {value:g} is not given by the text"
    recomputed = recompute(data)
    if recomputed.faults:
        return recomputed.faults[0]
    if setting.answer is None or not recomputed.agrees(setting.answer, ANSWER_RTOL):
        return f"it leads to {recomputed.answer}, not to {setting.answer}"
    return next(_misstated(data, recomputed.values), "")


def _misstated(data: Data, values: Mapping[str, float]) -> Iterator[str]:
    """Yield a message for each stated result that differs from the recomputed one."""
    for name, value in ((name, value) for step in data["steps"] for name, value in step["results"].items()):
        if name in values and abs(values[name] - value) > STATED_RESULT_RTOL * abs(value):
            yield f"{name} is {values[name]:.6g}, not {value:.6g}"


def named_in_text(setting: ProblemContext) -> dict[str, float]:
    """Return, by symbol, the values of the numbers in the text, without the unknown, and the gravitational constant."""
    pulls = setting.mechanism.attractions
    constants = {"G": pulls[0].constant} if pulls else {}
    givens = setting.lexicon.givens.items()
    return constants | {given.symbol: given.value for path, given in givens if path != setting.unknown}


def stated_by_question(setting: ProblemContext) -> Iterator[float]:
    """Yield each number that defines a question's moment or its given result, also converted from degrees to radians.

    Solutions choose names for them. The time of a moment is left out if the question asks for it.
    """
    moment, result = setting.query.moment, setting.stated
    numbers = [number for number, _ in moment.stated] if moment is not None else []
    if setting.sought is not None and not setting.unknown:
        numbers = [number for number in numbers if number != setting.sought]
    for number in [*numbers, *([result.value] if result is not None else [])]:
        yield from (number, radians(number))


def _same(value: float, other: float) -> bool:
    return abs(value - other) <= RELATION_RTOL * abs(other)

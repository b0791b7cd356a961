"""A control reward for any readable answer."""

from sim2reason.evaluation.benchmarks.scoring import SCORINGS
from sim2reason.training.problem import Problem
from sim2reason.training.rewards import REWARDS, Reward

__all__ = ["Format"]


@REWARDS.register("format")
class Format(Reward):
    """1 for a readable answer, correct or not."""

    def earned(self, problem: Problem, response: str, number: int) -> float:
        """Return 1 if the problem's rule finds an answer."""
        del number
        return float(SCORINGS[problem.item.scoring].award(response, problem.item.reference).readable)

"""A control: any answer that can be read is paid."""

from sim2reason.evaluation.benchmarks.scoring import SCORINGS
from sim2reason.training.problem import Problem
from sim2reason.training.rewards import REWARDS, Reward

__all__ = ["Format"]


@REWARDS.register("format")
class Format(Reward):
    """1 for an answer that can be read, be it right or wrong."""

    def earned(self, problem: Problem, response: str, number: int) -> float:
        """By whether the rule of the problem finds an answer."""
        del number
        return float(SCORINGS[problem.item.scoring].award(response, problem.item.reference).readable)

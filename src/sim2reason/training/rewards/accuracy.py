"""The accuracy reward: whether the answer is correct."""

from sim2reason.evaluation.benchmarks.scoring import SCORINGS
from sim2reason.training.problem import Problem
from sim2reason.training.rewards import REWARDS, Reward

__all__ = ["Accuracy"]


@REWARDS.register("accuracy")
class Accuracy(Reward):
    """1 for a correct answer, else 0: by the library's grader, or by the scoring rule of the problem's corpus."""

    def earned(self, problem: Problem, response: str, number: int) -> float:
        """Return the reward by the problem's own rule."""
        del number
        return SCORINGS[problem.item.scoring].award(response, problem.item.reference).points

"""The reward that counts: whether the answer is right."""

from sim2reason.evaluation.benchmarks.scoring import SCORINGS
from sim2reason.training.problem import Problem
from sim2reason.training.rewards import REWARDS, Reward

__all__ = ["Accuracy"]


@REWARDS.register("accuracy")
class Accuracy(Reward):
    """1 for a right answer, else 0: by our grader, or by the rule of the corpus that the problem is from."""

    def earned(self, problem: Problem, response: str, number: int) -> float:
        """By the problem's own rule."""
        del number
        return SCORINGS[problem.item.scoring].award(response, problem.item.reference).points

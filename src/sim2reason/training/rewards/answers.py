"""Rewards of an answer: for a correct one, and two controls, for any readable one and at random."""

from sim2reason.evaluation.benchmarks.scoring import SCORINGS
from sim2reason.generation.item_search import generator
from sim2reason.training.rewards import REWARDS, Reward
from sim2reason.training.sources import Problem

__all__ = ["Accuracy", "Format", "Random"]


@REWARDS.register("accuracy")
class Accuracy(Reward):
    """1 for a correct answer, else 0: by the library's grader, or by the scoring rule of the problem's corpus."""

    def earned(self, problem: Problem, response: str, number: int) -> float:
        """Return the reward by the problem's own rule."""
        del number
        return SCORINGS[problem.item.scoring].award(response, problem.item.reference).points


@REWARDS.register("format")
class Format(Reward):
    """1 for a readable answer, correct or not."""

    def earned(self, problem: Problem, response: str, number: int) -> float:
        """Return 1 if the problem's rule finds an answer."""
        del number
        return float(SCORINGS[problem.item.scoring].award(response, problem.item.reference).readable)


@REWARDS.register("random")
class Random(Reward):
    """1 or 0 at random, whatever the response is (Shao et al., Spurious rewards, 2025)."""

    def earned(self, problem: Problem, response: str, number: int) -> float:
        """Return a random reward from the seed, the problem and the number of the response."""
        del response
        return float(generator("reward", self.seed, problem.item.id, number).random() < 0.5)

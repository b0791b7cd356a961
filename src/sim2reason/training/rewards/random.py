"""A random control reward."""

from sim2reason.generation.item_search import generator
from sim2reason.training.problem import Problem
from sim2reason.training.rewards import REWARDS, Reward

__all__ = ["Random"]


@REWARDS.register("random")
class Random(Reward):
    """1 or 0 at random, whatever the response is (Shao et al., Spurious rewards, 2025)."""

    def earned(self, problem: Problem, response: str, number: int) -> float:
        """Return a random reward from the seed, the problem and the number of the response."""
        del response
        return float(generator("reward", self.seed, problem.item.id, number).random() < 0.5)

"""Rewards: the library's grader, and controls for experiments, one module each."""

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from typing import Annotated, Any, cast

from annotated_types import Ge
from pydantic import BaseModel, ConfigDict

from sim2reason.base.registry import Registry
from sim2reason.base.settings import build_member
from sim2reason.errors import TrainingError
from sim2reason.training.sources import Problem

__all__ = ["REWARDS", "Reward", "build_reward", "reward_function"]


class Reward(BaseModel, ABC):
    """A function from a response to a number from 0 to 1; each subclass is a kind that a configuration names."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    seed: Annotated[int, Ge(0)] = 0
    """Of rewards that are drawn."""

    @abstractmethod
    def earned(self, problem: Problem, response: str, number: int) -> float:
        """Return the reward of the `number`-th response to a problem; no response text raises an error."""


REWARDS: Registry[type[Reward]] = Registry("training.rewards")


def build_reward(settings: object) -> object:
    """Return the reward from its name or settings with a `kind`; other values unchanged.

    Raises:
        TrainingError: a setting that is unknown or makes no sense.
        UnknownNameError: no such kind.
    """
    if isinstance(settings, str):
        settings = {"kind": settings}
    if not isinstance(settings, Mapping):
        return settings
    return build_member(REWARDS, cast("Mapping[str, object]", settings), "reward", TrainingError)


def reward_function(reward: Reward) -> Callable[..., list[float | None]]:
    """Return a reward in TRL's form, for completions as texts or messages."""

    def earned(
        prompts: Sequence[object], completions: Sequence[object], *, problem: Sequence[str], **columns: object
    ) -> list[float | None]:
        del prompts, columns
        seen: dict[str, tuple[Problem, int]] = {}
        rewards = list[float | None]()
        for text, completion in zip(problem, completions, strict=True):
            parsed_problem, number = seen.get(text) or (Problem.model_validate_json(text), 0)
            seen[text] = parsed_problem, number + 1
            rewards.append(reward.earned(parsed_problem, _said(completion), number))
        return rewards

    return earned


def _said(completion: object) -> str:
    """Return the text of a completion."""
    if isinstance(completion, str):
        return completion
    messages = cast("Sequence[Mapping[str, Any]]", completion)
    return "\n".join(str(message.get("content") or "") for message in messages)

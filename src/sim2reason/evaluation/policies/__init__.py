"""Policies: models that answer prompts, behind an endpoint or in this process, one module each.

SampleRequest (prompt, seed) ── Policy.complete ↦ Completion ── samples.journal ── scores
"""

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from annotated_types import Ge, Gt, Le
from pydantic import BaseModel, ConfigDict, Field, FiniteFloat

from sim2reason.base.registry import Registry
from sim2reason.base.settings import build_member
from sim2reason.errors import PolicyError
from sim2reason.grading import opened

__all__ = ["POLICIES", "Completion", "Finish", "Limits", "Name", "Policy", "SampleRequest", "Sampling", "build_policy"]

Name = Annotated[str, Field(pattern=r"^[A-Za-z0-9][A-Za-z0-9._-]{0,79}$")]
"""What may be the name of a file, too: letters, digits, dots, dashes and underscores."""

Finish = Literal["stop", "length", "refused", "overflow", "unknown"]
"""Why a text ends: the model stopped, its tokens were used up, it or a content filter refused, the prompt is longer
than its context, or nobody says."""


class _Settings(BaseModel):
    """The base of settings: frozen, without unknown names."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)


class Sampling(_Settings):
    """The sampling parameters of a model; None leaves a parameter to the model."""

    temperature: Annotated[FiniteFloat, Ge(0.0), Le(10.0)] | None = 1.0
    """Zero takes the most likely token."""
    top_p: Annotated[FiniteFloat, Gt(0.0), Le(1.0)] | None = None
    max_tokens: Annotated[int, Ge(1), Le(10_000_000)] = 4096
    """Of a response, with its thinking."""


class Limits(_Settings):
    """The budget of a policy in a run, including resumptions; None means without limit."""

    tokens: Annotated[int, Ge(1)] | None = None
    """Of prompts and responses."""
    cost: Annotated[FiniteFloat, Gt(0.0)] | None = None
    """In the currency of the prices."""
    price_in: Annotated[FiniteFloat, Ge(0.0)] = 0.0
    """Of a million tokens of prompts."""
    price_out: Annotated[FiniteFloat, Ge(0.0)] = 0.0
    """Of a million tokens of responses."""


@dataclass(frozen=True, slots=True)
class SampleRequest:
    """A request for one response: the `sample`-th to the prompt of the problem `id`."""

    id: str
    sample: int
    prompt: str
    seed: int
    """From 0 to 2³¹ - 1."""


class Completion(BaseModel):
    """The response of a policy, as stored in a journal."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    text: str
    finish: Finish = "unknown"
    thinking: str = ""
    """Where the endpoint gives it apart from the text."""
    prompt_tokens: int | None = None
    completion_tokens: int | None = None
    """With the thinking. None where nobody counted."""
    thinking_opened: bool = False
    """Whether the text begins within the thinking, which the prompt opened."""

    @property
    def whole(self) -> str:
        """Return the response for a grader: the thinking in its tags, then the text."""
        if not self.thinking:
            return str(opened(self.text)) if self.thinking_opened else self.text
        return f"<think>{self.thinking}</think>{self.text}" if self.text else f"<think>{self.thinking}"


class Policy(_Settings, ABC):
    """A model with its settings; each subclass is a kind that a configuration names.

    If `in_flight` exceeds one, `complete` is called from several threads at once.
    """

    name: Name
    """By which reports call it."""
    sampling: Sampling = Sampling()
    limits: Limits = Limits()
    thinking_opened: bool = False
    """Whether its chat template ends within the thinking, so that a text without the end of it has no answer."""
    step: Annotated[int, Ge(0)] | None = None
    """After how many steps of training this model was saved, for plots over training."""

    operational: ClassVar[frozenset[str]] = frozenset({"limits", "step"})
    """Settings that change no answer, and so may change while a run is not finished."""

    @property
    def in_flight(self) -> int:
        """Return the number of concurrent calls of `complete`."""
        return 1

    @property
    def batch(self) -> int:
        """Return the number of requests in one call of `complete`."""
        return 1

    def check(self) -> None:
        """Check before a run that the policy is available.

        Raises:
            PolicyError: there is no such model, device or key.
            MissingExtraError: a library that it needs.
        """

    @abstractmethod
    def complete(self, requests: Sequence[SampleRequest]) -> Sequence[Completion]:
        """Return a completion for each request, in order.

        Raises:
            NoAnswerError: these requests got no answer; others may.
            PolicyError: no request will get one.
        """

    @property
    def settings(self) -> dict[str, object]:
        """Return the policy's settings for the record of a run, without secret keys."""
        return self.model_dump(mode="json")

    @property
    def decisive(self) -> dict[str, object]:
        """Return the settings that affect the answers."""
        return {name: value for name, value in self.settings.items() if name not in self.operational}


POLICIES: Registry[type[Policy]] = Registry("policies", package="sim2reason.evaluation.policies")


def build_policy(settings: Mapping[str, object], location: str = "policy") -> Policy:
    """Return the policy described by settings; `kind` is its registered name.

    Raises:
        PolicyError: a setting that is unknown, missing or makes no sense.
        UnknownNameError: no such kind.
    """
    return build_member(POLICIES, settings, location, PolicyError)

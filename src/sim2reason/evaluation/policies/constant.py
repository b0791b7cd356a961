"""A constant policy: a baseline for models, and a test run without a model."""

from collections.abc import Sequence

from sim2reason.evaluation.policies import POLICIES, Completion, Policy, SampleRequest

__all__ = ["Constant"]


@POLICIES.register("constant")
class Constant(Policy):
    """The same text for every prompt."""

    text: str

    def complete(self, requests: Sequence[SampleRequest]) -> Sequence[Completion]:
        """Return the text for each request, with zero tokens."""
        return [Completion(text=self.text, finish="stop", prompt_tokens=0, completion_tokens=0) for _ in requests]

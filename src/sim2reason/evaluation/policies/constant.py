"""Always the same answer: the floor that a model has to rise above, and a run without a model."""

from collections.abc import Sequence

from sim2reason.evaluation.policies import POLICIES, Completion, Policy, SampleRequest

__all__ = ["Constant"]


@POLICIES.register("constant")
class Constant(Policy):
    """The same text for every prompt."""

    text: str

    def complete(self, requests: Sequence[SampleRequest]) -> Sequence[Completion]:
        """Return the text; it costs no tokens."""
        return [Completion(text=self.text, finish="stop", prompt_tokens=0, completion_tokens=0) for _ in requests]

"""Policy for tests that answers from a table, without a model."""

from collections.abc import Sequence

from pydantic import Field, PrivateAttr

from sim2reason.evaluation.policies import Completion, Policy, SampleRequest


class Told(Policy):
    """Policy with a table of responses; by default right or wrong answers to *How much is N?*."""

    right: float = 1.0
    """The share of problems that it answers rightly, the first ones."""
    of: int = 20
    """How many problems there are."""
    texts: dict[str, list[str]] = Field(default_factory=dict)
    """What it says to problems of some id, sample by sample."""
    _asked: list[SampleRequest] = PrivateAttr(default_factory=list)

    def complete(self, requests: Sequence[SampleRequest]) -> Sequence[Completion]:
        """Return the responses at once, with 3 tokens each."""
        self._asked.extend(requests)
        return [self._said(request) for request in requests]

    def _said(self, request: SampleRequest) -> Completion:
        number = int("".join(sign for sign in request.id if sign.isdigit()) or 0)
        value = number if number < self.right * self.of else -1
        held = self.texts.get(request.id)
        text = held[request.sample] if held else rf"\boxed{{{value}}}"
        return Completion(text=text, finish="stop", prompt_tokens=5, completion_tokens=3 + number)

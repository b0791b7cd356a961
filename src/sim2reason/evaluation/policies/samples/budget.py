"""Budgets of policies: each request reserves its largest possible use before it is sent."""

from collections.abc import Iterable
from pathlib import Path
from threading import Condition

from sim2reason.errors import PolicyError
from sim2reason.evaluation.policies import Completion, Policy, SampleRequest
from sim2reason.evaluation.policies.samples.journal import finished

__all__ = ["Budget"]

TEMPLATE = 64  # tokens that a chat template may add to a prompt


class Budget:
    """The tokens and cost of one policy, shared by several threads."""

    def __init__(self, policy: Policy) -> None:
        """Start with nothing spent."""
        self._policy, self._limits = policy, policy.limits
        self._spent, self._reserved = [0, 0.0], [0, 0.0]
        self._changed = Condition()

    def _cost(self, tokens_in: int, tokens_out: int) -> tuple[int, float]:
        price = (tokens_in * self._limits.price_in + tokens_out * self._limits.price_out) / 1e6
        return tokens_in + tokens_out, price

    def most(self, request: SampleRequest) -> tuple[int, float]:
        """Return the largest number of tokens and the cost that a request may cause, before it is sent."""
        return self._cost(len(request.prompt.encode(errors="replace")) + TEMPLATE, self._policy.sampling.max_tokens)

    def used(self, completion: Completion, most: tuple[int, float]) -> tuple[int, float]:
        """Return the tokens and cost of a completion; the largest possible ones if the endpoint reports none."""
        if completion.finish == "overflow":
            return 0, 0.0
        if completion.prompt_tokens is None or completion.completion_tokens is None:
            return most
        return self._cost(completion.prompt_tokens, completion.completion_tokens)

    def charge(self, used: tuple[int, float]) -> None:
        """Add tokens and cost to those spent so far."""
        self._spent = [self._spent[0] + used[0], self._spent[1] + used[1]]

    def charge_finished(self, journal: Path, requests: Iterable[SampleRequest]) -> None:
        """Add the tokens and cost of a journal's samples; those in `requests` count fully if they are unreported."""
        by_key = {(request.id, request.sample): request for request in requests}
        for found in finished(journal):
            request = by_key.get(found.key)
            self.charge(self.used(found.completion, self.most(request) if request else (0, 0.0)))

    def reserve(self, most: tuple[int, float]) -> None:
        """Reserve tokens and cost before a request, waiting for others to finish; PolicyError beyond the budget."""
        with self._changed:
            while not self._fits(most):
                if not self._reserved[0]:
                    raise PolicyError(
                        f"policy {self._policy.name!r}: its limit is reached ({self._spent[0]} tokens, cost "
                        f"{self._spent[1]:.4g}); raise limits in the configuration to go on"
                    )
                self._changed.wait()
            self._reserved = [self._reserved[0] + most[0], self._reserved[1] + most[1]]

    def settle(self, most: tuple[int, float], used: tuple[int, float]) -> None:
        """Replace the tokens and cost reserved for a request by those that it really used."""
        with self._changed:
            self._reserved = [self._reserved[0] - most[0], self._reserved[1] - most[1] if self._reserved[0] else 0.0]
            self.charge(used)
            self._changed.notify_all()

    def _fits(self, most: tuple[int, float]) -> bool:
        wanted = [s + r + m for s, r, m in zip(self._spent, self._reserved, most, strict=True)]
        limits = self._limits.tokens, self._limits.cost
        return all(limit is None or value <= limit for limit, value in zip(limits, wanted, strict=True))

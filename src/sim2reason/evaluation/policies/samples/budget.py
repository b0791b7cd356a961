"""What a policy may use up: each request sets aside the most that it can need before it is sent."""

from collections.abc import Iterable
from pathlib import Path
from threading import Condition

from sim2reason.errors import PolicyError
from sim2reason.evaluation.policies import Completion, Policy, SampleRequest
from sim2reason.evaluation.policies.samples.journal import finished

__all__ = ["Budget"]

TEMPLATE = 64  # tokens that a chat template may add to a prompt


class Budget:
    """Tokens and cost of one policy, counted by several threads."""

    def __init__(self, policy: Policy) -> None:
        """Nothing is spent."""
        self._policy, self._limits = policy, policy.limits
        self._spent, self._reserved = [0, 0.0], [0, 0.0]
        self._changed = Condition()

    def _cost(self, tokens_in: int, tokens_out: int) -> tuple[int, float]:
        price = (tokens_in * self._limits.price_in + tokens_out * self._limits.price_out) / 1e6
        return tokens_in + tokens_out, price

    def most(self, request: SampleRequest) -> tuple[int, float]:
        """Tokens and cost that a request can need at most: a token has at least one byte."""
        return self._cost(len(request.prompt.encode(errors="replace")) + TEMPLATE, self._policy.sampling.max_tokens)

    def used(self, completion: Completion, most: tuple[int, float]) -> tuple[int, float]:
        """Tokens and cost of a completion; the most that it can have needed where nobody counted."""
        if completion.finish == "overflow":
            return 0, 0.0
        if completion.prompt_tokens is None or completion.completion_tokens is None:
            return most
        return self._cost(completion.prompt_tokens, completion.completion_tokens)

    def charge(self, used: tuple[int, float]) -> None:
        """Count what was used before."""
        self._spent = [self._spent[0] + used[0], self._spent[1] + used[1]]

    def charge_finished(self, journal: Path, requests: Iterable[SampleRequest]) -> None:
        """Count what a journal's samples used; those that are among `requests` are known best."""
        by_key = {(request.id, request.sample): request for request in requests}
        for found in finished(journal):
            request = by_key.get(found.key)
            self.charge(self.used(found.completion, self.most(request) if request else (0, 0.0)))

    def reserve(self, most: tuple[int, float]) -> None:
        """Set `most` aside, waiting for what others set aside; PolicyError if it can't be had."""
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
        """Give back what was set aside, and count what was used."""
        with self._changed:
            self._reserved = [self._reserved[0] - most[0], self._reserved[1] - most[1] if self._reserved[0] else 0.0]
            self.charge(used)
            self._changed.notify_all()

    def _fits(self, most: tuple[int, float]) -> bool:
        wanted = [s + r + m for s, r, m in zip(self._spent, self._reserved, most, strict=True)]
        limits = self._limits.tokens, self._limits.cost
        return all(limit is None or value <= limit for limit, value in zip(limits, wanted, strict=True))

"""Samples of a policy: requested by several threads within its budget, and written to disk when finished.

Each request reserves its largest possible use of the budget before it is sent.
"""

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, wait
from dataclasses import dataclass, field
from hashlib import blake2b
from itertools import islice
from pathlib import Path
from threading import Condition, Thread

from sim2reason.errors import PolicyError
from sim2reason.evaluation.policies import Completion, Policy, SampleRequest
from sim2reason.evaluation.policies.journal import SampleJournal, read_finished

__all__ = ["Budget", "NoAnswerError", "RequestSummary", "ask", "requests_for", "sample_seed"]


class NoAnswerError(PolicyError):
    """An error for a request without an answer, while others may succeed."""


MAX_TEMPLATE_TOKENS = 64  # tokens that a chat template may add to a prompt


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
        return self._cost(
            len(request.prompt.encode(errors="replace")) + MAX_TEMPLATE_TOKENS, self._policy.sampling.max_tokens
        )

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
        for sample in read_finished(journal):
            request = by_key.get(sample.key)
            self.charge(self.used(sample.completion, self.most(request) if request else (0, 0.0)))

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


MAX_FAILURES = 8  # failed requests in a row after which the endpoint counts as down


@dataclass
class RequestSummary:
    """The counts of samples finished before and now, and the reasons why other requests got no answer."""

    finished_before: int = 0
    finished_now: int = 0
    open: list[str] = field(default_factory=list[str])
    """Why a request got no answer, for each one that did not."""


def sample_seed(seed: int, name: str, sample: int) -> int:
    """Return the seed of a sample of a problem, 0 to 2³¹ - 1, the same in every run."""
    digest = blake2b(f"{seed}\0{name}\0{sample}".encode(errors="replace"), digest_size=4, person=b"sample").digest()
    return int.from_bytes(digest, "big") >> 1


def requests_for(prompts: Iterable[tuple[str, str]], samples: int, seed: int) -> Iterator[SampleRequest]:
    """Yield `samples` requests for each id and prompt: first one of each, then the second of each.

    Hence an interrupted run has asked about as many problems as possible.
    """
    pairs = list(prompts)
    for sample in range(samples):
        for name, prompt in pairs:
            yield SampleRequest(name, sample, prompt, sample_seed(seed, name, sample))


def ask(
    policy: Policy,
    requests: Iterable[SampleRequest],
    journal: SampleJournal,
    *,
    budget: Budget | None = None,
    advance: Callable[[int], object] = lambda _: None,
) -> RequestSummary:
    """Request all samples that the journal does not contain; `advance` receives the numbers finished.

    `budget` may be shared by several journals, and is already charged for their samples; by default it is for this
    journal alone.

    Raises:
        PolicyError: the policy cannot be asked, or its limit is reached; all that was finished stays in the journal.
        EvaluationError: the journal holds answers to other prompts.
    """
    wanted = list(requests)
    missing = [request for request in wanted if not journal.holds(request)]
    progress = RequestSummary(finished_before=len(wanted) - len(missing))
    advance(progress.finished_before)
    if budget is None:
        budget = Budget(policy)
        budget.charge_finished(journal.path, wanted)
    charged_budget = budget
    source = iter(missing)
    batches = iter(lambda: list(islice(source, policy.batch)), [])
    _run(policy.in_flight, batches, lambda batch: _one(policy, batch, journal, charged_budget), progress, advance)
    return progress


def _run(
    width: int,
    batches: Iterator[list[SampleRequest]],
    work: Callable[[list[SampleRequest]], int],
    progress: RequestSummary,
    advance: Callable[[int], object],
) -> None:
    """Keep `width` batches of requests running at once; stop at the first error that would affect all others.

    Batches in flight are then awaited, since they are paid for, except when a person interrupts.
    """
    running: set[Future[int]] = set()
    row = 0
    while True:
        running |= {_begun(work, batch) for batch in islice(batches, width - len(running))}
        if not running:
            return
        done, running = wait(running, return_when=FIRST_COMPLETED)
        for future in done:
            error = future.exception()
            if isinstance(error, NoAnswerError):
                progress.open.append(str(error))
                row += 1
                if row >= MAX_FAILURES:
                    wait(running)
                    raise PolicyError(f"{error}; {row} requests in a row went so; try again later")
            elif error is not None:
                wait(running)
                raise error
            else:
                row = 0
                progress.finished_now += future.result()
                advance(future.result())


def _begun(work: Callable[[list[SampleRequest]], int], batch: list[SampleRequest]) -> Future[int]:
    """Start a batch in a daemon thread, which does not block an interrupted program."""
    future: Future[int] = Future()

    def fulfil() -> None:
        try:
            future.set_result(work(batch))
        except BaseException as error:  # noqa: BLE001 - it is raised where the result is wanted
            future.set_exception(error)

    Thread(target=fulfil, daemon=True).start()
    return future


def _one(policy: Policy, batch: list[SampleRequest], journal: SampleJournal, budget: Budget) -> int:
    """Request one batch and store it in the journal; return its number of samples."""
    most = [budget.most(request) for request in batch]
    total = sum(tokens for tokens, _ in most), sum(cost for _, cost in most)
    budget.reserve(total)
    used = 0, 0.0
    try:
        completions = policy.complete(batch)
        for request, completion, limit in zip(batch, completions, most, strict=True):
            recorded = completion.model_copy(update={"thinking_opened": True}) if policy.thinking_opened else completion
            journal.add(request, recorded)
            tokens, cost = budget.used(completion, limit)
            used = used[0] + tokens, used[1] + cost
    finally:
        budget.settle(total, used)
    return len(batch)

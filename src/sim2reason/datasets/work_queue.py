"""Which positions wait, which are being made, and which ranges of them are complete."""

from collections import deque
from collections.abc import Iterable, Iterator

from sim2reason.datasets.places import Reply
from sim2reason.datasets.plan import Config
from sim2reason.datasets.worker import Attempt, Batch

BATCH = 10  # items: half a second of work, so that talking to a worker costs little


class WorkQueue:
    """Hands out batches and collects what becomes of them.

    After a crash or a hang, each position of the batch is tried once more, alone: the guilty one is found,
    the others are not lost. A position that fails alone gives an outcome with a failure.
    """

    def __init__(self, config: Config, missing: Iterable[range | None]) -> None:
        """Plan the positions that are to be made, each range of one shard; they are asked for when their turn comes.

        None among them says that there are none before some of those that were given are made.
        """
        self._config = config
        self._open: dict[int, tuple[range, list[Attempt]]] = {}
        self._fresh = self._cut(missing)
        self._again: deque[int] = deque()
        self._second: set[int] = set()
        self.done = 0
        """Positions whose outcome is known."""

    def _cut(self, missing: Iterable[range | None]) -> Iterator[range]:
        for positions in missing:
            if positions is None:
                yield range(0)
                continue
            self._open[positions.start // self._config.shard] = positions, []
            for start in range(positions.start, positions.stop, BATCH):
                yield range(start, min(start + BATCH, positions.stop))

    @property
    def open(self) -> bool:
        """Return whether some range that was given is not complete."""
        return bool(self._open)

    def next(self) -> Batch | None:
        """Return the next batch; None if there is none now (a reply may bring more)."""
        positions = [self._again.popleft()] if self._again else next(self._fresh, ())
        return [(k, self._config.request(k)) for k in positions] or None

    def settle(self, batch: Batch, reply: Reply) -> Iterator[tuple[range, list[Attempt]]]:
        """Take a reply in, and give each range that it completes with its outcomes in order."""
        if isinstance(reply, str):
            reply = list(self._retry(batch, reply))
        self.done += len(reply)
        for outcome in reply:
            number = outcome.position // self._config.shard
            self._second.discard(outcome.position)
            positions, outcomes = self._open[number]
            outcomes.append(outcome)
            if len(outcomes) == len(positions):
                del self._open[number]
                yield positions, sorted(outcomes, key=lambda each: each.position)

    def _retry(self, batch: Batch, why: str) -> Iterator[Attempt]:
        for position, _ in batch:
            if position in self._second:
                yield Attempt(position, None, {}, f"{why}, twice")
            else:
                self._second.add(position)
                self._again.append(position)

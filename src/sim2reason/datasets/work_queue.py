"""Which positions wait, which are being made, and which shards are complete."""

from collections import deque
from collections.abc import Iterator, Sequence

from sim2reason.datasets.plan import Config
from sim2reason.datasets.pool import Reply
from sim2reason.datasets.worker import Attempt, Batch

BATCH = 10  # items: half a second of work, so that talking to a worker costs little


class WorkQueue:
    """Hands out batches and collects what becomes of them.

    After a crash or a hang, each position of the batch is tried once more, alone: the guilty one is found,
    the others are not lost. A position that fails alone gives an outcome with a failure.
    """

    def __init__(self, config: Config, shards: Sequence[range]) -> None:
        """RunPlan the `shards` that are to be made."""
        self._config = config
        self._shards = {k: shard for shard in shards for k in shard}
        self._open: dict[range, list[Attempt]] = {shard: [] for shard in shards}
        self._fresh = self._cut(shards)
        self._again: deque[int] = deque()
        self._second: set[int] = set()
        self.done = 0
        """Positions whose outcome is known."""

    def _cut(self, shards: Sequence[range]) -> Iterator[range]:
        for shard in shards:
            for start in range(shard.start, shard.stop, BATCH):
                yield range(start, min(start + BATCH, shard.stop))

    def next(self) -> Batch | None:
        """The next batch; None if there is none now (a reply may bring more)."""
        positions = [self._again.popleft()] if self._again else next(self._fresh, ())
        return [(k, self._config.request(k)) for k in positions] or None

    def settle(self, batch: Batch, reply: Reply) -> Iterator[tuple[range, list[Attempt]]]:
        """Take a reply in, and give each shard that it completes with its outcomes in order."""
        if isinstance(reply, str):
            reply = list(self._retry(batch, reply))
        self.done += len(reply)
        for outcome in reply:
            shard = self._shards[outcome.position]
            self._open[shard].append(outcome)
            if len(self._open[shard]) == len(shard):
                yield shard, sorted(self._open.pop(shard), key=lambda each: each.position)

    def _retry(self, batch: Batch, why: str) -> Iterator[Attempt]:
        for position, _ in batch:
            if position in self._second:
                yield Attempt(position, None, {}, f"{why}, twice")
            else:
                self._second.add(position)
                self._again.append(position)

"""Rounds of work that make the positions of a dataset, shard by shard, until it has enough items."""

from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import closing
from functools import partial

from sim2reason.datasets.contamination import Overlap
from sim2reason.datasets.duplicates import POSITION, Duplicate, find_duplicates
from sim2reason.datasets.journal import Journal
from sim2reason.datasets.manifest import Counts, RefusedPosition, Shard, merge_counts, table
from sim2reason.datasets.places import Reply, Run
from sim2reason.datasets.plan import Config
from sim2reason.datasets.shard_files import lengthened, read_items, read_marks, read_shard, write_shard
from sim2reason.datasets.worker import Attempt, Batch
from sim2reason.generation.item import Item

BATCH_ITEMS = 10  # items: half a second of work, so that communication costs little


class WorkQueue:
    """A queue of batches of positions to make; it collects the results, and retries failed positions singly.

    After a crash or a timeout, each position of the batch is retried alone, so that only the faulty one is lost; its
    result records the failure.
    """

    def __init__(self, config: Config, missing: Iterable[range | None]) -> None:
        """Queue the positions to make, each range within one shard; None means to wait until all before are done."""
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
            for start in range(positions.start, positions.stop, BATCH_ITEMS):
                yield range(start, min(start + BATCH_ITEMS, positions.stop))

    @property
    def open(self) -> bool:
        """Return whether some range of positions that workers have begun is incomplete."""
        return bool(self._open)

    def next(self) -> Batch | None:
        """Return the next batch of positions; None if workers must first finish earlier ones."""
        positions = [self._again.popleft()] if self._again else next(self._fresh, ())
        return [(k, self._config.request(k)) for k in positions] or None

    def settle(self, batch: Batch, reply: Reply) -> Iterator[tuple[range, list[Attempt]]]:
        """Accept the results of a batch, and yield each range of positions that is complete now, with its results."""
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


FindsOverlap = Callable[[str], Overlap | None]
"""Finds the words that a prompt shares with a benchmark."""
Advance = Callable[[int], object]
"""Is told how many more positions are done; less than none where that many hold no item, and others are to."""

Watch = Callable[[Attempt], object]
"""Is told what became of each position, before it is written; what crashes or hangs is tried again, or quarantined."""


def make_all(journal: Journal, run: Run, overlap: FindsOverlap, advance: Advance, watch: Watch) -> None:
    """Make positions until there are as many items as requested, or no new ones are expected."""
    told = 0

    def tell(steps: int) -> None:
        nonlocal told
        told += steps
        if steps:
            advance(steps)

    def rounds() -> Iterator[range | None]:
        numbers, standing = range(journal.shards), tell
        while numbers:
            yield from _missing(journal, numbers, standing)
            while queue.open:
                yield None
            _remove_duplicates(journal)
            tell(_rows(journal) - told)
            numbers, standing = _lengthened(journal), _told_before

    queue = WorkQueue(journal.plan.config, rounds())
    _work(journal, queue, run, overlap, tell, watch)


def make_positions(
    journal: Journal, numbers: range, run: Run, overlap: FindsOverlap, advance: Advance, watch: Watch
) -> None:
    """Make the missing positions of some shards; positions without an item are not replaced by others."""
    queue = WorkQueue(journal.plan.config, _missing(journal, numbers, advance))
    _work(journal, queue, run, overlap, advance, watch)


def _told_before(done: int) -> None:
    """Ignore progress on positions of an earlier round, which was already reported."""
    del done


def _missing(journal: Journal, numbers: range, advance: Advance) -> Iterator[range]:
    """Yield the missing positions of some shards."""
    for number in numbers:
        positions, standing = journal.range(number), journal.valid_record(number)
        begin = standing.positions[1] if standing is not None else positions.start
        if begin > positions.start:
            advance(begin - positions.start)
        if begin < positions.stop:
            yield range(begin, positions.stop)


def _work(journal: Journal, queue: WorkQueue, run: Run, overlap: FindsOverlap, advance: Advance, watch: Watch) -> None:
    with closing(run(queue.next)) as replies:
        for batch, reply in replies:
            before = queue.done
            for attempt in () if isinstance(reply, str) else reply:
                watch(attempt)
            for positions, outcomes in queue.settle(batch, reply):
                _write(journal, overlap, positions, outcomes)
            advance(queue.done - before)


def _lengthened(journal: Journal) -> range:
    """Add positions to make if items are missing, and return the numbers of their shards; empty if none are added."""
    config, shards = journal.plan.config, journal.shards
    barren_from = config.barren_from(_behind_last_item(journal))
    end = max(journal.positions, min(journal.positions + config.items - _rows(journal), barren_from))
    if end == journal.positions:
        return range(0)
    journal.positions = end
    return range(shards - 1 if shards == journal.shards else 0, journal.shards)  # of more shards, all are renamed


def _rows(journal: Journal) -> int:
    return sum(read_shard(journal, number).rows for number in range(journal.shards))


def _write(journal: Journal, overlap: FindsOverlap, positions: range, outcomes: Sequence[Attempt]) -> None:
    """Write the items of a completed range of positions into its shard, after those that the shard already has."""
    number = positions.start // journal.plan.config.shard
    placed = [(outcome.position, outcome.item) for outcome in outcomes if outcome.item is not None]
    overlaps = {position: shared for position, item in placed if (shared := overlap(item.prompt))}
    items = [(position, item) for position, item in placed if position not in overlaps]
    shard = _record(journal.plan.config, positions, outcomes, overlaps)
    if positions.start > journal.range(number).start:
        before = read_shard(journal, number)
        shard, items = lengthened(before, shard), [*read_items(journal, before), *items]
    write_shard(journal, shard, items)


def _record(config: Config, positions: range, outcomes: Sequence[Attempt], overlaps: dict[int, Overlap]) -> Shard:
    """Return the record of a range: its requests, and its positions without items."""
    requests = [(outcome, config.request(outcome.position)) for outcome in outcomes]
    wanted = [((r.mode, each.wanted, r.recipe), 1) for each, r in requests if each.wanted]
    failed = [RefusedPosition.of(each.position, r, each.failure) for each, r in requests if each.failure]
    empty = [(each, r) for each, r in requests if not each.failure and each.item is None]
    return Shard(
        number=positions.start // config.shard,
        positions=(positions.start, positions.stop),
        files=(),
        counts={},
        rejected=merge_counts({r.recipe: each.rejected} for each, r in requests),
        cells=table(wanted, ()),
        quarantined=tuple(failed),
        contaminated=tuple(RefusedPosition.of(k, config.request(k), overlap.text) for k, overlap in overlaps.items()),
        unfilled=tuple(RefusedPosition.of(each.position, r, _why(each.rejected)) for each, r in empty),
    )


def _why(rejected: Counts) -> str:
    return "no draw passed: " + (", ".join(f"{name} {n}" for name, n in sorted(rejected.items())) or "none was made")


def _behind_last_item(journal: Journal) -> int:
    """Return the first position after the last one that holds an item."""
    for number in reversed(range(journal.shards)):
        positions = read_marks(journal, number).table[:, POSITION]
        if len(positions):
            return int(positions.max()) + 1
    return 0


def _remove_duplicates(journal: Journal) -> None:
    """Rewrite shards without duplicates of items at lower positions."""
    read = partial(read_marks, journal)
    for number, duplicates in find_duplicates(read, journal.shards, journal.positions, journal.plan.config.distance):
        _leave_out(journal, number, duplicates)


def _leave_out(journal: Journal, number: int, duplicates: Sequence[Duplicate]) -> None:
    config, shard, gone = journal.plan.config, read_shard(journal, number), {each.position for each in duplicates}
    kept: list[tuple[int, Item]] = [pair for pair in read_items(journal, shard) if pair[0] not in gone]
    changed = {
        "duplicates": _refused_positions(shard.duplicates, config, [each for each in duplicates if not each.alike]),
        "variants": _refused_positions(shard.variants, config, [each for each in duplicates if each.alike]),
    }
    write_shard(journal, shard.model_copy(update=changed), kept)


def _refused_positions(
    before: Sequence[RefusedPosition], config: Config, duplicates: Sequence[Duplicate]
) -> tuple[RefusedPosition, ...]:
    """Return the positions of a shard without an item, after the duplicates found now are added, in order."""
    more = [
        RefusedPosition.of(
            each.position,
            config.request(each.position),
            f"{'like' if each.alike else 'same as'} {config.request(each.first).id}",
        )
        for each in duplicates
    ]
    return tuple(sorted([*before, *more], key=lambda each: each.position))

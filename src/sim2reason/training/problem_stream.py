"""Stream of the prompts of a run, generated ahead of time, and the curriculum that weights them.

Other processes generate problems in advance, so that no step waits for them.
"""

import os
import time
from collections.abc import Generator, Mapping, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Annotated, Any

from annotated_types import Gt, Le, Lt
from pydantic import BaseModel, ConfigDict, JsonValue, ValidationError

from sim2reason.base.settings import first_fault
from sim2reason.datasets.processes import SPAWN_CONTEXT, end_with_parent
from sim2reason.errors import TrainingError
from sim2reason.training.sources import Problem, ProblemSource

__all__ = ["Curriculum", "Prefetcher", "ProblemStream", "StreamState", "begin_worker", "prefetching"]

Key = tuple[str, str, int]
"""Source, cell, index."""
Made = tuple[Problem | None, float]
"""A problem, and the CPU time that it took, s."""


class Prefetcher:
    """A cache of problems generated ahead; missing ones are awaited or generated on request.

    It affects only when problems are generated; they are pure functions of their coordinates.
    """

    def __init__(self, pool: ProcessPoolExecutor | None, depth: int) -> None:
        """Store the pool and `depth`, the number of problems of each cell generated ahead."""
        self._pool, self._depth = pool, depth
        self._ordered: dict[Key, Future[Made]] = {}
        self.cpu_seconds = 0.0
        """That other processes have spent on problems so far, asked for or not."""

    def at(self, source: ProblemSource, cell: str, index: int) -> Problem | None:
        """Return the problem of a cell and index; request the following ones from the other processes."""
        self.order(source, cell, index)
        future = self._ordered.pop((source.name, cell, index), None)
        if future is not None:
            try:
                return future.result()[0]
            except BrokenProcessPool:  # a process was killed, for want of memory say: go on without
                self._pool = None
                self._ordered.clear()
        return source.at(cell, index)

    def order(self, source: ProblemSource, cell: str, start: int) -> None:
        """Request the problems of a cell from index `start` on from the other processes, unless requested before."""
        if self._pool is None:
            return
        try:
            for index in range(start, start + self._depth):
                if (source.name, cell, index) not in self._ordered:
                    ordered = self._pool.submit(_made, source, cell, index)
                    ordered.add_done_callback(self._count)
                    self._ordered[source.name, cell, index] = ordered
        except BrokenProcessPool:
            self._pool = None
            self._ordered.clear()

    def _count(self, done: "Future[Made]") -> None:
        """Add the CPU time that another process spent on a finished problem; only one thread calls this."""
        if not done.cancelled() and done.exception() is None:
            self.cpu_seconds += done.result()[1]


@contextmanager
def prefetching(workers: int, depth: int) -> Generator[Prefetcher]:
    """Return a context with a prefetcher with `workers` processes; without any, problems are made on request."""
    if not workers:
        yield Prefetcher(None, depth)
        return
    pool = ProcessPoolExecutor(workers, mp_context=SPAWN_CONTEXT, initializer=begin_worker)
    try:
        yield Prefetcher(pool, depth)
    finally:
        pool.shutdown(wait=True, cancel_futures=True)  # of those that are being made it waits for the end


def begin_worker() -> None:
    """Limit a worker to one thread and low priority, and stop it with its parent."""
    end_with_parent()
    os.environ["OMP_NUM_THREADS"] = "1"
    os.nice(5)


def _made(source: ProblemSource, cell: str, index: int) -> Made:
    begun = time.process_time()
    return source.at(cell, index), time.process_time() - begun


UNTRIED_PASS_RATE = 0.5  # pass rate of an untried cell


class Curriculum(BaseModel):
    """The sampling weights of the cells of problems (such as difficulties), from their measured pass rates.

    A cell of pass rate p has the weight `floor` + 4 p (1 − p): the variance of its rewards, which scales the gradient
    of a group-relative advantage, and a floor so that no cell is abandoned.
    """

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    floor: Annotated[float, Gt(0.0), Le(10.0)] = 0.2
    memory: Annotated[float, Gt(0.0), Lt(1.0)] = 0.98
    """How much of an average over groups stays when another group of the cell is seen."""

    def weight(self, rate: float | None) -> float:
        """Return the sampling weight of a cell of problems by its pass rate; `rate` is None for an untried cell."""
        p = UNTRIED_PASS_RATE if rate is None else rate
        return self.floor + 4.0 * p * (1.0 - p)

    def after(self, rate: float | None, seen: float) -> float:
        """Return the new average pass rate of a cell after responses of which the fraction `seen` was correct."""
        before = UNTRIED_PASS_RATE if rate is None else rate
        return self.memory * before + (1.0 - self.memory) * seen


MAX_FAILED_REQUESTS = 200  # failed requests of a cell in a row after which it counts as empty


class StreamState(BaseModel):
    """The state of a stream, from which it continues identically with the same configuration."""

    model_config = ConfigDict(extra="forbid")

    drawn: int = 0
    """Prompts so far."""
    next: dict[str, int] = {}
    """The next index of each cell."""
    deficits: dict[str, float] = {}
    """By how much each cell has had less than its share, in prompts (deficit round robin)."""
    rates: dict[str, float] = {}
    """The measured pass rate of each cell."""


@dataclass
class ProblemStream:
    """Prompts from several sources by weight, and from their cells by the curriculum.

    The cell with the largest deficit comes next, so that all proportions hold in any interval; nothing is random, and
    prefetching does not affect the result.
    """

    sources: Sequence[ProblemSource]
    prefetcher: Prefetcher = field(default_factory=lambda: Prefetcher(None, 0))
    curriculum: Curriculum | None = None
    avoid: frozenset[str] = frozenset()
    """Prompts and fingerprints of problems that are kept for evaluation."""
    cursor: StreamState = field(default_factory=StreamState)
    chat: bool = False
    """Whether prompts are messages, for a model that has a chat template."""

    def __post_init__(self) -> None:
        """Raise TrainingError if two sources have the same name."""
        names = [source.name for source in self.sources]
        if twice := sorted({name for name in names if names.count(name) > 1}):
            raise TrainingError(f"problems: the name {twice[0]!r} stands twice; give each source its own")
        self._cells = {f"{source.name}/{cell}": (source, cell) for source in self.sources for cell in source.cells}
        if not self._cells:
            raise TrainingError("problems: no source has any problem")

    @property
    def cpu_seconds(self) -> float:
        """Return the CPU time that other processes have spent on problems so far."""
        return self.prefetcher.cpu_seconds

    def begin(self) -> None:
        """Request the first problems ahead of time."""
        for key, (source, cell) in self._cells.items():
            self.prefetcher.order(source, cell, self.cursor.next.get(key, 0))

    def probe(self) -> None:
        """Generate one problem of each cell before a run, without using it; TrainingError for a cell without any."""
        for key in self._cells:
            self._at_or_after(key, self.cursor.next.get(key, 0))

    def next_prompts(self, count: int) -> list[dict[str, Any]]:
        """Return the next prompts as rows for a trainer.

        Raises:
            TrainingError: a cell whose requests no draw fills.
        """
        return [problem.row(chat=self.chat) for problem in self.problems(count)]

    def problems(self, count: int) -> list[Problem]:
        """Return the next `count` problems."""
        return [self._next() for _ in range(count)]

    def observe(self, row: Mapping[str, Any], rewards: Sequence[float]) -> None:
        """Update the pass rate of a problem's cell with the rewards of the responses to it."""
        problem = Problem.model_validate_json(row["problem"])
        key, rates = f"{problem.source}/{problem.cell}", self.cursor.rates
        passed = sum(reward >= 1.0 for reward in rewards) / max(len(rewards), 1)
        rates[key] = (self.curriculum or Curriculum()).after(rates.get(key), passed)

    def state(self) -> JsonValue:
        """Return the state after the last prompt."""
        return self.cursor.model_dump(mode="json")

    def restore(self, state: JsonValue) -> None:
        """Restore a state; TrainingError if it is invalid, or belongs to other sources."""
        try:
            cursor = StreamState.model_validate(state)
        except ValidationError as error:
            raise TrainingError(f"the checkpoint's place among the problems: {first_fault(error)}") from None
        if unknown := sorted({*cursor.next} - {*self._cells}):
            raise TrainingError(f"the checkpoint has drawn from {unknown[0]!r}, which the configuration does not have")
        self.cursor = cursor
        self.begin()

    def shares(self) -> dict[str, float]:
        """Return the probability with which each cell provides the next prompt."""
        probabilities: dict[str, float] = {}
        total_weight = sum(source.weight for source in self.sources)
        for source in self.sources:
            keys = [f"{source.name}/{cell}" for cell in source.cells]
            curriculum, rates = self.curriculum, self.cursor.rates
            weights = {key: 1.0 if curriculum is None else curriculum.weight(rates.get(key)) for key in keys}
            total = sum(weights.values())
            probabilities |= {key: source.weight / total_weight * weight / total for key, weight in weights.items()}
        return probabilities

    def _next(self) -> Problem:
        deficits, cursor = self.cursor.deficits, self.cursor
        for key, share in self.shares().items():
            deficits[key] = deficits.get(key, 0.0) + share
        key = max(deficits, key=lambda name: deficits[name])  # the first of equals
        deficits[key] -= 1.0
        index, problem = self._at_or_after(key, cursor.next.get(key, 0))
        cursor.next[key] = index + 1
        cursor.drawn += 1
        return problem

    def _at_or_after(self, key: str, start: int) -> tuple[int, Problem]:
        """Return the first problem of a cell from an index on, with its index."""
        source, cell = self._cells[key]
        for index in range(start, start + MAX_FAILED_REQUESTS):
            problem = self.prefetcher.at(source, cell, index)
            if problem is not None and not {problem.item.prompt, problem.fingerprint} & self.avoid:
                return index, problem
        raise TrainingError(
            f"problems: {key} gave nothing in {MAX_FAILED_REQUESTS} draws; choose other recipes, kinds or weights"
        )

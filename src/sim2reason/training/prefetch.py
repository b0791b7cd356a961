"""Problems generated ahead of time in other processes, so that no step waits for them."""

import os
import time
from collections.abc import Generator
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager

from sim2reason.datasets.processes import ALONE, end_with_parent
from sim2reason.training.problem import Problem
from sim2reason.training.sources import ProblemSource

__all__ = ["Prefetcher", "begin_worker", "prefetching"]

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
        found = self._ordered.pop((source.name, cell, index), None)
        if found is not None:
            try:
                return found.result()[0]
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
    pool = ProcessPoolExecutor(workers, mp_context=ALONE, initializer=begin_worker)
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

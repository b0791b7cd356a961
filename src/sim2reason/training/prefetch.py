"""Problems made in other processes before they are asked for, so that no step waits for them."""

import os
from collections.abc import Generator
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from multiprocessing import get_context

from sim2reason.datasets.end_with_parent import end_with_parent
from sim2reason.training.problem import Problem
from sim2reason.training.sources import ProblemSource

__all__ = ["Prefetcher", "begin_worker", "prefetching"]

Key = tuple[str, str, int]
"""Source, cell, index."""


class Prefetcher:
    """A store of problems that will be asked for; what is not there yet is waited for, what is not ordered is made.

    It changes when problems are made, never which: they are pure functions of their coordinates.
    """

    def __init__(self, pool: ProcessPoolExecutor | None, depth: int) -> None:
        """`depth` is how many problems of each cell are ordered before they are asked for."""
        self._pool, self._depth = pool, depth
        self._ordered: dict[Key, Future[Problem | None]] = {}

    def at(self, source: ProblemSource, cell: str, index: int) -> Problem | None:
        """The problem, and an order for those after it."""
        self.order(source, cell, index)
        found = self._ordered.pop((source.name, cell, index), None)
        if found is not None:
            try:
                return found.result()
            except BrokenProcessPool:  # a process was killed, for want of memory say: go on without
                self._pool = None
                self._ordered.clear()
        return source.at(cell, index)

    def order(self, source: ProblemSource, cell: str, start: int) -> None:
        """Have problems made from `start` on."""
        if self._pool is None:
            return
        try:
            for index in range(start, start + self._depth):
                if (source.name, cell, index) not in self._ordered:
                    self._ordered[source.name, cell, index] = self._pool.submit(_made, source, cell, index)
        except BrokenProcessPool:
            self._pool = None
            self._ordered.clear()


@contextmanager
def prefetching(workers: int, depth: int) -> Generator[Prefetcher]:
    """A store whose problems so many processes make; none: each is made when it is asked for."""
    if not workers:
        yield Prefetcher(None, depth)
        return
    pool = ProcessPoolExecutor(workers, mp_context=get_context("spawn"), initializer=begin_worker)
    try:
        yield Prefetcher(pool, depth)
    finally:
        pool.shutdown(wait=True, cancel_futures=True)  # of those that are being made it waits for the end


def begin_worker() -> None:
    """One thread each, and the trainer comes first; without it there is nothing to do."""
    end_with_parent()
    os.environ["OMP_NUM_THREADS"] = "1"
    os.nice(5)


def _made(source: ProblemSource, cell: str, index: int) -> Problem | None:
    return source.at(cell, index)

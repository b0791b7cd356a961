"""Rows of problems generated from a seed by several processes, independent of their number."""

from collections import Counter
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from itertools import count
from math import ceil

from sim2reason.datasets.processes import ALONE
from sim2reason.generation.request import Request
from sim2reason.training.corpora import Row
from sim2reason.training.prefetch import begin_worker
from sim2reason.training.sources.fresh import Fresh

__all__ = ["RowsOf", "drawn_rows"]

TOGETHER = 16  # problems that a process makes per task, at most
EMPTY = 50  # requests per wanted problem after which the search fails
RowsOf = Callable[[Request], list[Row] | None]
"""The rows of a problem: none if it can have no rows, None if there is no such problem. A pure function."""


def drawn_rows(
    problems: Fresh, rows_of: RowsOf, items: int, workers: int, left_out: Counter[str], reason: str
) -> Iterator[Row]:
    """Yield the rows (prompts with completions) of the first `items` problems that have some, in order.

    There are fewer rows if problems are too rare. Problems without rows are counted under `reason`.
    """
    found, size = 0, min(TOGETHER, items)
    with ProcessPoolExecutor(workers, mp_context=ALONE, initializer=begin_worker) as pool:
        ahead = [pool.submit(_stretch, problems, rows_of, number, size) for number in range(2 * workers)]
        for number in count(len(ahead)):
            for rows in ahead.pop(0).result():
                if rows and found < items:
                    found += 1
                    yield from rows
                elif not rows:
                    left_out[reason] += 1
            if found >= items or number > EMPTY * ceil(items / size):
                break
            ahead.append(pool.submit(_stretch, problems, rows_of, number, size))
        pool.shutdown(wait=True, cancel_futures=True)
    if found < items:
        left_out["given up"] += items - found


def _stretch(problems: Fresh, rows_of: RowsOf, number: int, size: int) -> list[list[Row]]:
    """Return the rows (prompts with completions) of each problem in an interval of indices."""
    cells, found = problems.cells, list[list[Row]]()
    for place in range(number * size, (number + 1) * size):
        index, cell = divmod(place, len(cells))
        rows = rows_of(problems.request(cells[cell], index))
        if rows is not None:
            found.append(rows)
    return found

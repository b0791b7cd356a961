"""Problems with their solutions as arithmetic, some with slips: for models too small to learn prose."""

from collections import Counter
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from itertools import count
from math import ceil
from multiprocessing import get_context
from typing import Annotated

import numpy as np
from annotated_types import Ge, Le
from pydantic import Field, field_validator

from sim2reason.datasets.item_search import ItemSearch
from sim2reason.datasets.make import item_of
from sim2reason.datasets.plan import Request
from sim2reason.datasets.random_scenes import generator
from sim2reason.datasets.worked_solutions import worked
from sim2reason.solutions.arithmetic import Definitions, arithmetic
from sim2reason.solutions.renumbering import renumbered
from sim2reason.solutions.slips import SLIPS, slipped
from sim2reason.training.corpora import CORPORA, Corpus, Row
from sim2reason.training.prefetch import begin_worker
from sim2reason.training.sources.fresh import Fresh, fingerprint

__all__ = ["Arithmetic"]

Share = Annotated[float, Ge(0.0), Le(1.0)]
TOGETHER = 16  # problems that a process makes before it gives them back
BARREN = 50  # requests for each problem that is wanted, after which too few are found


@CORPORA.register("arithmetic")
class Arithmetic(Corpus):
    """Solutions as arithmetic of problems drawn from a seed; where slips are asked for, of mixed quality."""

    problems: Fresh
    """What is drawn, as a source of prompts has it; of another seed than those that are trained or evaluated on."""
    items: Annotated[int, Ge(1), Le(10**7)] = 1000
    """How many problems are drawn."""
    rows_each: Annotated[int, Ge(1), Le(1000)] = 1
    """Rows of each problem: the first with its own numbers, the others with other numbers, and slips of their own.

    Problems with other numbers are no more certified, nor has any filter seen them.
    """
    slips: dict[str, Share] = Field(default_factory=dict[str, Share])
    """How often a solution has each kind of slip, where there is place for it."""
    workers: Annotated[int, Ge(1), Le(1024)] = 1
    """Processes that make the problems; they never change which."""

    @field_validator("slips")
    @classmethod
    def _known(cls, value: dict[str, float]) -> dict[str, float]:
        for name in value:
            if name not in SLIPS:
                raise ValueError(f"no such slip: {name!r}; there are: {', '.join(SLIPS)}")
        return value

    def rows(self, left_out: Counter[str]) -> Iterator[Row]:
        """Those of the problems in their order; one whose solution is no arithmetic is left out."""
        found = 0
        with ProcessPoolExecutor(self.workers, mp_context=get_context("spawn"), initializer=begin_worker) as pool:
            ahead = [pool.submit(self.rows_at, n) for n in range(2 * self.workers)]
            for number in count(len(ahead)):
                for each in ahead.pop(0).result():
                    if each and found < self.items:
                        found += 1
                        yield from each
                    elif not each:
                        left_out["no arithmetic"] += 1
                if found >= self.items or number > BARREN * ceil(self.items / TOGETHER):
                    break
                ahead.append(pool.submit(self.rows_at, number))
            pool.shutdown(wait=True, cancel_futures=True)

    def rows_at(self, number: int) -> list[list[Row]]:
        """The rows of each problem of a stretch; none of one that has no arithmetic. A pure function."""
        cells, found = self.problems.cells, list[list[Row]]()
        for place in range(number * TOGETHER, (number + 1) * TOGETHER):
            index, cell = divmod(place, len(cells))
            rows = self._rows_of(self.problems.request(cells[cell], index))
            if rows is not None:
                found.append(rows)
        return found

    def _rows_of(self, request: Request) -> list[Row] | None:
        """Of one problem; None where there is no such problem."""
        certified = ItemSearch(request).found()
        if certified is None or not self.problems.wants(item := item_of(request, certified)):
            return None
        solution = worked(request, certified)
        rows = list[Row]()
        for number in range(self.rows_each):
            rng = generator("corpus", request.id, number)
            prompt, held = (number and renumbered(item.prompt, solution, rng)) or (item.prompt, solution)
            right, text = arithmetic(held), arithmetic(held, self._slips(rng))
            if text:
                known = fingerprint(item) if held is solution else ""
                rows.append(Row(prompt, text, _answer(text) == _answer(right), known))
        return rows

    def _slips(self, rng: np.random.Generator) -> Callable[[Definitions], Definitions]:
        return lambda held: slipped(held, self.slips, rng)


def _answer(text: str) -> str:
    """What stands in the box."""
    return text.rpartition("\n")[2]

"""Problems of a finished dataset or a benchmark's file, repeated in a new order each time."""

from collections.abc import Iterator
from typing import Annotated, Any

from annotated_types import Ge, Le
from pydantic import field_validator

from sim2reason.base.records import cached_property
from sim2reason.errors import Sim2ReasonError
from sim2reason.evaluation.benchmarks import Benchmark, BenchmarkItem, benchmark_from, items_of
from sim2reason.evaluation.benchmarks.scoring import SCORINGS
from sim2reason.generation.item_search import generator
from sim2reason.generation.request import LARGEST
from sim2reason.training.problem import Problem
from sim2reason.training.sources import SOURCES, ProblemSource

__all__ = ["BenchmarkSource"]

BY = "difficulty"


@SOURCES.register("benchmark")
class BenchmarkSource(ProblemSource):
    """Problems of a benchmark: a dataset folder, or a file of questions."""

    benchmark: dict[str, Any]
    """Its settings, as an evaluation has them: kind, file or dataset, columns, scoring."""
    seed: Annotated[int, Ge(0), Le(LARGEST)] = 0
    """Of the orders."""

    @field_validator("benchmark")
    @classmethod
    def _readable(cls, value: dict[str, Any]) -> dict[str, Any]:
        try:
            benchmark_from({"name": "source", **value})
        except Sim2ReasonError as error:
            raise ValueError(str(error)) from None
        return value

    @cached_property
    def _benchmark(self) -> Benchmark:
        return benchmark_from({"name": self.name, **self.benchmark})

    @cached_property
    def _held(self) -> dict[str, list[BenchmarkItem]]:
        found: dict[str, list[BenchmarkItem]] = {}
        items = items_of(self._benchmark)
        for rule in {item.scoring for item in items}:
            SCORINGS[rule].check()
        for item in items:
            found.setdefault(next(iter(item.tags.get(BY, ())), self.name), []).append(item)
        return found

    @property
    def cells(self) -> tuple[str, ...]:
        """Return the difficulties if the items have some; else a single cell."""
        return tuple(self._held)

    def at(self, cell: str, index: int) -> Problem | None:
        """Return the `index`-th problem of a cell, whose problems repeat in a new random order."""
        held = self._held[cell]
        turn, place = divmod(index, len(held))
        order = generator("order", self.seed, self.name, cell, turn).permutation(len(held))
        item = held[int(order[place])]
        return Problem(item=item, source=self.name, cell=cell)

    def items(self) -> Iterator[BenchmarkItem]:
        """Yield all problems of the benchmark."""
        for held in self._held.values():
            yield from held

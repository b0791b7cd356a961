"""Benchmarks from files of problems: JSON lines, saved problems, and freshly generated problems."""

from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from typing import Annotated, Self

from annotated_types import Ge, Le
from pydantic import JsonValue, ValidationError, model_validator

from sim2reason.base.settings import first_fault
from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.items import stream
from sim2reason.datasets.plan import Chosen, find_modes
from sim2reason.errors import EvaluationError
from sim2reason.evaluation.benchmarks import BENCHMARKS, Benchmark, BenchmarkItem
from sim2reason.evaluation.benchmarks.files import QuestionFile, rows
from sim2reason.generation.item import Item
from sim2reason.generation.request import MAX_SEED

__all__ = ["SYNTHETIC", "AnyFile", "Saved", "Synthetic", "benchmark_item"]


@BENCHMARKS.register("jsonl")
class AnyFile(QuestionFile):
    """Any .json, .jsonl or .parquet file of questions with answers; columns and scoring rule are settings."""


@BENCHMARKS.register("saved")
class Saved(Benchmark):
    """Problems saved by a run: the held-out ones of a training, or those of another evaluation."""

    file: Path
    """A .jsonl file such as RUN/problems/BENCHMARK.jsonl."""

    def problems(self) -> Iterator[BenchmarkItem]:
        """Yield the problems of the file in order."""
        for number, row in enumerate(rows(self.file)):
            try:
                yield BenchmarkItem.model_validate(row)
            except ValidationError as error:
                raise EvaluationError(f"{self.file}: row {number}: {first_fault(error)}") from None


SYNTHETIC = "synthetic"
DEFAULT_ITEMS = 100


def benchmark_item(item: Item, *, lenient: bool = False) -> BenchmarkItem:
    """Return an item as a benchmark problem, scored by the library's grader and tagged for reports."""
    tags = {
        "recipe": (item.recipe,),
        "difficulty": (item.difficulty,),
        "mode": (item.mode,),
        "kind": (item.kind,),
        "quantity": (item.asked.quantity,),
        "entity": tuple(sorted(set(item.entities))),
    }
    answer = item.answer.model_dump(mode="json")
    reference: dict[str, JsonValue] = {"answer": answer, "told": item.answer.told, "lenient": lenient}
    return BenchmarkItem(id=item.id, prompt=item.prompt, scoring="sim2reason", reference=reference, tags=tags)


@BENCHMARKS.register(SYNTHETIC)
class Synthetic(Chosen, Benchmark):
    """Problems of this library: from a dataset folder, or generated from a seed."""

    dataset: Path | None = None
    """A folder that ``sim2reason generate`` has finished; else problems are drawn."""
    split: str | None = None
    """Of the dataset; by default all."""
    seed: Annotated[int, Ge(0), Le(MAX_SEED)] | None = None
    """Of the draws; keep it from all training."""
    items: Annotated[int, Ge(1)] = DEFAULT_ITEMS
    """How many are drawn, of each mode."""

    @model_validator(mode="after")
    def _one_source(self) -> Self:
        if (self.dataset is None) == (self.seed is None):
            raise ValueError("give either dataset, a folder, or seed, to draw problems")
        if self.split is not None and self.dataset is None:
            raise ValueError("split is one of a dataset")
        if self.dataset is not None and (idle := sorted(self.model_fields_set & {*Chosen.model_fields, "items"})):
            raise ValueError(f"{idle[0]} is of problems that are drawn; a dataset is taken as it is, or its split")
        return self

    @property
    def pure(self) -> bool:
        """Return whether the problems are generated, not read from a folder."""
        return self.seed is not None

    def problems(self) -> Iterator[BenchmarkItem]:
        """Yield the problems in the order of the dataset or of generation."""
        return (benchmark_item(item, lenient=self.lenient) for item in self._items())

    def _items(self) -> Iterator[Item]:
        if self.dataset is not None:
            yield from Dataset(self.dataset).items(self.split)
            return
        assert self.seed is not None
        for mode in find_modes(self.modes):
            yield from islice(stream(self.recipe, self.difficulty, mode, seed=self.seed), self.items)

"""Corpora of the library's worked solutions, from a dataset or generated from a seed."""

from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Self

from annotated_types import Ge, Le
from pydantic import model_validator

from sim2reason.datasets.dataset import Dataset
from sim2reason.errors import TrainingError
from sim2reason.generation.certified import worked_solution
from sim2reason.generation.item import Item
from sim2reason.generation.item_search import ItemSearch
from sim2reason.generation.make import item_of
from sim2reason.generation.request import Request
from sim2reason.training.corpora import CORPORA, Corpus, Row
from sim2reason.training.corpora.parts.drawing import drawn_rows
from sim2reason.training.sources.fresh import Fresh, fingerprint

__all__ = ["Worked"]

UNSOLVED = "no worked solution"


@CORPORA.register("worked")
class Worked(Corpus):
    """Worked solutions with boxed answers, from a dataset or generated from a seed."""

    dataset: Path | None = None
    """A folder that ``sim2reason generate --solutions`` has finished; else problems are drawn."""
    split: str | None = None
    """Of the dataset; by default all."""
    problems: Fresh | None = None
    """What is drawn, as a source of prompts has it; of another seed than those that are trained or evaluated on."""
    items: Annotated[int, Ge(1), Le(10**7)] = 1000
    """How many problems are drawn."""
    workers: Annotated[int, Ge(1), Le(1024)] = 1
    """Processes that make the problems; they never change which."""

    @model_validator(mode="after")
    def _one_source(self) -> Self:
        if (self.dataset is None) == (self.problems is None):
            raise ValueError("give either dataset, a folder, or problems, to draw some")
        if self.split is not None and self.dataset is None:
            raise ValueError("split is one of a dataset")
        if "items" in self.model_fields_set and self.problems is None:
            raise ValueError("items is of problems that are drawn; of a dataset say limit")
        return self

    def rows(self, left_out: Counter[str]) -> Iterator[Row]:
        """Yield the rows in the order of the dataset or of generation, without unsolved problems."""
        if self.problems is not None:
            yield from drawn_rows(self.problems, self.rows_of, self.items, self.workers, left_out, UNSOLVED)
            return
        for item in self._items():
            if item.solution is None:
                left_out[UNSOLVED] += 1
            else:
                yield _row(item, item.solution.text)

    def check(self) -> None:
        """Open the dataset of worked solutions, so that errors occur before a run."""
        if self.dataset is not None:
            self._items()

    def rows_of(self, request: Request) -> list[Row] | None:
        """Return the rows of one problem; None if there is no such problem."""
        certified = ItemSearch(request).find()
        if certified is None:
            return None
        item = item_of(request, certified)
        solution = worked_solution(request, certified)
        return [] if solution.answer is None else [_row(item, solution.text)]

    def _items(self) -> Iterator[Item]:
        assert self.dataset is not None
        source = Dataset(self.dataset)
        if not source.manifest.config.solutions:
            raise TrainingError(f"{source.path}: its problems have no solutions; generate it with --solutions")
        return source.items(self.split)


def _row(item: Item, text: str) -> Row:
    return Row(item.prompt, text, right=True, fingerprint=fingerprint(item))

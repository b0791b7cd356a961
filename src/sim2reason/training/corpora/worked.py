"""Our own worked solutions: those of a dataset, or of problems drawn from a seed."""

from collections import Counter
from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from typing import Annotated, Self

from annotated_types import Ge, Le
from pydantic import Field, model_validator

from sim2reason.datasets.dataset import Dataset
from sim2reason.datasets.item import Item
from sim2reason.datasets.items import stream
from sim2reason.datasets.plan import LARGEST, SI
from sim2reason.errors import TrainingError
from sim2reason.training.corpora import CORPORA, Corpus, Row
from sim2reason.training.sources.fresh import fingerprint

__all__ = ["Worked"]

DRAWN = 1000


@CORPORA.register("worked")
class Worked(Corpus):
    """Worked solutions of ours, each with its answer in a box: a dataset with them, or drawn from a seed."""

    dataset: Path | None = None
    """A folder that ``sim2reason generate --solutions`` has finished; else problems are drawn, which takes long."""
    split: str | None = None
    """Of the dataset; by default all."""
    seed: Annotated[int, Ge(0), Le(LARGEST)] | None = None
    """Of the draws; evaluate on another one."""
    items: Annotated[int, Ge(1), Le(LARGEST)] = DRAWN
    """How many are drawn, over all recipes, difficulties and modes."""
    recipe: str | tuple[str, ...] = "all"
    difficulty: str | tuple[str, ...] = "all"
    mode: str | tuple[str, ...] = "numeric"
    weights: dict[str, float] = Field(default_factory=dict[str, float])
    """How often kinds of question are asked."""
    units: str = SI

    @model_validator(mode="after")
    def _one_source(self) -> Self:
        if (self.dataset is None) == (self.seed is None):
            raise ValueError("give either dataset, a folder, or seed, to draw problems")
        if self.split is not None and self.dataset is None:
            raise ValueError("split is one of a dataset")
        return self

    def rows(self, left_out: Counter[str]) -> Iterator[Row]:
        """In the dataset's order, or in that of the draws; a problem without a solution is left out."""
        for item in self._items():
            if item.solution is None:
                left_out["no worked solution"] += 1
            else:
                yield Row(item.prompt, item.solution.text, right=True, fingerprint=fingerprint(item))

    def _items(self) -> Iterator[Item]:
        if self.seed is None:
            assert self.dataset is not None
            source = Dataset(self.dataset)
            if not source.manifest.config.solutions:
                raise TrainingError(f"{source.path}: its problems have no solutions; generate it with --solutions")
            return source.items(self.split)
        drawn = stream(
            self.recipe,
            self.difficulty,
            self.mode,
            seed=self.seed,
            weights=self.weights,
            units=self.units,
            solutions=True,
        )
        return islice(drawn, self.items)

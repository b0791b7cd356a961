"""Problems drawn on the fly from a seed: no prompt ever comes back."""

from dataclasses import replace
from hashlib import blake2b
from typing import Annotated, Self

from annotated_types import Ge, Le
from pydantic import Field, field_validator, model_validator

from sim2reason.base.lazy import cached_property
from sim2reason.base.settings import held_to
from sim2reason.datasets.duplicates import variant
from sim2reason.datasets.plan import Chosen, Config, difficulties_named, modes_named, recipes_named
from sim2reason.evaluation.benchmarks.own import benchmark_item
from sim2reason.generation.item import Item
from sim2reason.generation.make import make
from sim2reason.generation.request import LARGEST, SI, Request, check
from sim2reason.questions import KINDS
from sim2reason.questions.spoken_units import system_named
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.training.problem import Problem
from sim2reason.training.sources import SOURCES, ProblemSource

__all__ = ["Fresh", "fingerprint"]

ROUNDED = 6  # decimals of logarithms


@SOURCES.register("fresh")
class Fresh(Chosen, ProblemSource):
    """Problems drawn by seed and index, as a dataset would have them; a cell is a difficulty."""

    seed: Annotated[int, Ge(0), Le(LARGEST)]
    """Another than that of what the model is evaluated on."""
    kinds: tuple[str, ...] = ()
    """Only these kinds of question; none: as `weights` and the recipes have them."""
    weights: dict[str, float] = Field(default_factory=dict[str, float])
    """How often kinds of question are asked, as a dataset has them."""
    quantities: tuple[str, ...] = ()
    """Only questions about these; none: about any."""
    units: str = SI
    unfiltered: bool = False
    """A control: any question that has an answer, whatever the filters say of it."""

    @model_validator(mode="after")
    def _kinds_or_weights(self) -> Self:
        if self.kinds and self.weights:
            raise ValueError("give either kinds or weights")
        if unknown := [kind for kind in self.kinds if kind not in KINDS]:
            raise ValueError(f"no such kind: {unknown[0]!r}; there are: {', '.join(KINDS)}")
        return held_to(lambda own: own.cells, self)

    @field_validator("units")
    @classmethod
    def _units(cls, value: str) -> str:
        return held_to(system_named, value)

    @field_validator("quantities")
    @classmethod
    def _known(cls, value: tuple[str, ...]) -> tuple[str, ...]:
        for name in value:
            if name not in QUANTITIES and name != "time":
                raise ValueError(f"no such quantity: {name!r}; see: sim2reason list quantities")
        return value

    @field_validator("weights")
    @classmethod
    def _weights(cls, value: dict[str, float]) -> dict[str, float]:
        return dict(sorted(value.items()))

    @cached_property
    def _configs(self) -> dict[str, Config]:
        """The order of recipes and modes in each difficulty."""
        recipes, modes = recipes_named(self.recipe), modes_named(self.modes)
        weights = self.weights if not self.kinds else {kind: float(kind in self.kinds) for kind in KINDS}
        check(weights, modes, recipes)
        units = system_named(self.units).name
        return {
            difficulty: Config(
                items=0,
                recipes=recipes,
                difficulties=(difficulty,),
                modes=modes,
                seed=self.seed,
                weights=weights,
                units=units,
                unfiltered=self.unfiltered,
            )
            for difficulty in difficulties_named(self.difficulty)
        }

    @property
    def cells(self) -> tuple[str, ...]:
        """The difficulties, from easy to hard."""
        return tuple(self._configs)

    def request(self, cell: str, index: int) -> Request:
        """Return the order for the problem of that index."""
        return replace(self._configs[cell].request(index), quantities=self.quantities)

    def at(self, cell: str, index: int) -> Problem | None:
        """Made now; None where no draw passes the filters."""
        item = make(self.request(cell, index)).item
        if item is None:
            return None
        return Problem(item=benchmark_item(item), source=self.name, cell=cell, fingerprint=fingerprint(item))


def fingerprint(item: Item) -> str:
    """Return a hash that two items share if they are one problem with the same numbers, in whatever words."""
    found = variant(item)
    text = f"{found.problem}\n{[round(each, ROUNDED) for each in found.logarithms]}"
    return blake2b(text.encode(), digest_size=8).hexdigest()

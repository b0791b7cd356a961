"""Sources of training problems, one module per kind, mixed by weight in a configuration."""

from abc import ABC, abstractmethod
from collections.abc import Mapping
from typing import Annotated, Any

from annotated_types import Gt
from pydantic import BaseModel, ConfigDict

from sim2reason.base.registry import Registry
from sim2reason.base.settings import build_member
from sim2reason.errors import TrainingError
from sim2reason.evaluation.benchmarks import BenchmarkItem
from sim2reason.evaluation.policies import Name

__all__ = ["SOURCES", "Problem", "ProblemSource", "build_source"]


class Problem(BaseModel):
    """A prompt with its answer and scoring rule, its origin, and its cell in the curriculum."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    item: BenchmarkItem
    source: str
    """The name of its source."""
    cell: str
    fingerprint: str = ""
    """What the same problem of the same numbers has, too, in whatever words; empty where it is not known."""

    def row(self, *, chat: bool) -> dict[str, Any]:
        """Return the problem as a row for trainers; with `chat` the prompt is a list of messages."""
        prompt: Any = [{"role": "user", "content": self.item.prompt}] if chat else self.item.prompt
        return {"prompt": prompt, "problem": self.model_dump_json()}


class ProblemSource(BaseModel, ABC):
    """An endless source of problems in cells that a curriculum may weight; each subclass is a kind."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    name: Name
    weight: Annotated[float, Gt(0.0)] = 1.0
    """How many prompts come from it, compared with the other sources."""

    @property
    @abstractmethod
    def cells(self) -> tuple[str, ...]:
        """Return the names of the source's cells, at least one."""

    @abstractmethod
    def at(self, cell: str, index: int) -> Problem | None:
        """Return the `index`-th problem of a cell, always the same; None if there is none.

        Raises:
            EvaluationError, DatasetError: a file or folder that cannot be read.
        """


SOURCES: Registry[type[ProblemSource]] = Registry("training.sources")


def build_source(settings: Mapping[str, object], location: str) -> ProblemSource:
    """Return the source described by settings; `kind` is its registered name.

    Raises:
        TrainingError: a setting that is unknown, missing or makes no sense.
        UnknownNameError: no such kind.
    """
    return build_member(SOURCES, settings, location, TrainingError)

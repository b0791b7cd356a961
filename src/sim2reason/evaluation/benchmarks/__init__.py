"""Benchmarks: problems with known answers, generated or published, one module each.

Benchmark (settings) ↦ BenchmarkItem (prompt, reference) ── a policy's samples ── Scoring ↦ Award
"""

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping
from hashlib import sha256
from typing import Annotated

from annotated_types import Ge, Le
from pydantic import BaseModel, ConfigDict, Field, JsonValue

from sim2reason.base.atomic_files import canonical
from sim2reason.base.registry import Registry
from sim2reason.base.settings import build_member
from sim2reason.errors import EvaluationError
from sim2reason.evaluation.policies import Name

__all__ = ["BENCHMARKS", "Benchmark", "BenchmarkItem", "build_benchmark", "data_hash", "load_items"]

MOST_SAMPLES = 4096


class BenchmarkItem(BaseModel):
    """One problem of a benchmark: prompt, scoring rule, the data that the rule needs, and tags for reports."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    id: str
    prompt: str
    scoring: str
    """The registered rule by which responses are scored."""
    reference: dict[str, JsonValue]
    """What that rule needs to know: the answer, its unit, and so on."""
    tags: dict[str, tuple[str, ...]] = Field(default_factory=dict[str, tuple[str, ...]])
    """By which reports group it, such as a subject, a recipe or its entities."""

    @property
    def answer_text(self) -> str:
        """Return the answer as readable text."""
        answer = self.reference.get("told", self.reference.get("answer", ""))
        return answer if isinstance(answer, str) else str(answer)


class Benchmark(BaseModel, ABC):
    """A set of problems with its settings; each subclass is a kind that a configuration names."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    name: Name
    """By which reports call it."""
    samples: Annotated[int, Ge(1), Le(MOST_SAMPLES)] | None = None
    """How many responses each policy gives to each problem; else as many as the configuration says."""
    limit: Annotated[int, Ge(1)] | None = None
    """The first so many problems only."""
    expected: Annotated[int, Ge(1)] | None = None
    """How many problems there must be, after all filters and before the limit."""
    lenient: bool = False
    """Without a box, the last number of a response is its answer, where the rule knows that."""

    @property
    def pure(self) -> bool:
        """Return whether the settings and the library's version alone determine the problems, without any file."""
        return False

    @abstractmethod
    def problems(self) -> Iterable[BenchmarkItem]:
        """Return all problems, in order.

        Raises:
            EvaluationError: a file that is missing, damaged, or holds something else.
        """


BENCHMARKS: Registry[type[Benchmark]] = Registry("benchmarks", package="sim2reason.evaluation.benchmarks")


def build_benchmark(settings: Mapping[str, object], location: str = "benchmark") -> Benchmark:
    """Return the benchmark described by settings; `kind` is its registered name.

    Raises:
        EvaluationError: a setting that is unknown, missing or makes no sense.
        UnknownNameError: no such kind.
    """
    return build_member(BENCHMARKS, settings, location, EvaluationError)


def load_items(benchmark: Benchmark) -> list[BenchmarkItem]:
    """Return the problems of a benchmark, after checking their number and the uniqueness of their ids.

    Raises:
        EvaluationError: none, another number than expected, or the same id twice.
    """
    items = list(benchmark.problems())
    if benchmark.expected is not None and len(items) != benchmark.expected:
        raise EvaluationError(
            f"benchmark {benchmark.name!r}: {len(items)} problems where {benchmark.expected} are expected; "
            "see its filters and its file"
        )
    if not items:
        raise EvaluationError(f"benchmark {benchmark.name!r}: no problem passes its filters")
    seen: set[str] = set()
    for item in items:
        if item.id in seen:
            raise EvaluationError(f"benchmark {benchmark.name!r}: holds {item.id!r} twice")
        seen.add(item.id)
    return items[: benchmark.limit]


def data_hash(items: Iterable[BenchmarkItem]) -> str:
    """Return a hash of all prompts and answers."""
    digest = sha256()
    for item in items:
        digest.update(canonical(item.model_dump(mode="json")).encode(errors="replace"))
    return digest.hexdigest()

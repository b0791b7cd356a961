"""Problems that a run has saved as they were asked: a line of JSON each, with the rule and the answer."""

from collections.abc import Iterator
from pathlib import Path

from pydantic import ValidationError

from sim2reason.benchmarks import BENCHMARKS, Benchmark, BenchmarkItem
from sim2reason.benchmarks.parts.files import rows
from sim2reason.errors import EvaluationError
from sim2reason.policies.parts.words import first_fault

__all__ = ["Saved"]


@BENCHMARKS.register("saved")
class Saved(Benchmark):
    """Problems that a run has saved: the held-out ones of a training, or those of another evaluation."""

    file: Path
    """A .jsonl file such as RUN/problems/BENCHMARK.jsonl."""

    def problems(self) -> Iterator[BenchmarkItem]:
        """Those of the file, in its order."""
        for number, row in enumerate(rows(self.file)):
            try:
                yield BenchmarkItem.model_validate(row)
            except ValidationError as error:
                raise EvaluationError(f"{self.file}: row {number}: {first_fault(error)}") from None

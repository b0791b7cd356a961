"""Corpora from files and from sampled solutions."""

from collections import Counter
from collections.abc import Iterator
from itertools import islice
from pathlib import Path

from pydantic import ValidationError

from sim2reason.base.atomic_files import checksum
from sim2reason.errors import TrainingError
from sim2reason.training.corpora import CORPORA, Corpus, Row
from sim2reason.training.corpora.parts.lines import rows_in
from sim2reason.training.sample_solutions import RESULT, SOLUTIONS, Sampled

__all__ = ["JsonLines", "SampledSolutions"]


@CORPORA.register("jsonl")
class JsonLines(Corpus):
    """JSON lines of any origin, each with a prompt and a completion."""

    file: Path
    prompt: str = "prompt"
    """The name of the field with the prompt."""
    completion: str = "completion"
    """The name of that with the completion."""

    def rows(self, left_out: Counter[str]) -> Iterator[Row]:
        """Yield the prompts with completions in the file."""
        del left_out
        return rows_in(self.file, self.prompt, self.completion)

    def check(self) -> None:
        """Read all requested rows of the file, so that errors occur before a run."""
        if not sum(1 for _ in islice(self.rows(Counter()), self.limit)):
            raise TrainingError(f"{self.file}: holds no row")


@CORPORA.register("sampled")
class SampledSolutions(Corpus):
    """Responses of a policy that were graded as correct."""

    folder: Path

    def rows(self, left_out: Counter[str]) -> Iterator[Row]:
        """Yield the prompts with correct responses in the folder of solutions, after checking its hash."""
        del left_out
        try:
            found = Sampled.model_validate_json((self.folder / RESULT).read_bytes())
        except FileNotFoundError:
            raise TrainingError(
                f"{self.folder}: no {RESULT} here; give a folder that sim2reason sample-solutions has finished"
            ) from None
        except ValidationError:
            raise TrainingError(f"{self.folder / RESULT}: damaged; give the same sample-solutions again") from None
        if checksum(self.folder / SOLUTIONS) != found.solutions:
            raise TrainingError(f"{self.folder / SOLUTIONS}: changed or missing; give the same sample-solutions again")
        return rows_in(self.folder / SOLUTIONS)

    def check(self) -> None:
        """Check that the folder of solutions exists and is unchanged since it was written."""
        self.rows(Counter())

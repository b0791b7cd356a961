"""Right responses of a policy: the folder that ``sim2reason sample-solutions`` has finished."""

from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from pydantic import ValidationError

from sim2reason.base.atomic_files import checksum
from sim2reason.errors import TrainingError
from sim2reason.training.corpora import CORPORA, Corpus, Row
from sim2reason.training.corpora.parts.lines import rows_in
from sim2reason.training.sample_solutions import RESULT, SOLUTIONS, Sampled

__all__ = ["SampledSolutions"]


@CORPORA.register("sampled")
class SampledSolutions(Corpus):
    """Responses of a policy that were graded as right."""

    folder: Path

    def rows(self, left_out: Counter[str]) -> Iterator[Row]:
        """Return those of the folder, whose hash is checked."""
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
        """Look at the folder and its hash."""
        self.rows(Counter())

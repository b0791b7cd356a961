"""A file of somebody's own: JSON lines with two named fields."""

from collections import Counter
from collections.abc import Iterator
from itertools import islice
from pathlib import Path

from sim2reason.errors import TrainingError
from sim2reason.training.corpora import CORPORA, Corpus, Row
from sim2reason.training.corpora.parts.lines import rows_in

__all__ = ["JsonLines"]


@CORPORA.register("jsonl")
class JsonLines(Corpus):
    """JSON lines of any origin, each with a prompt and a completion."""

    file: Path
    prompt: str = "prompt"
    """The name of the field with the prompt."""
    completion: str = "completion"
    """The name of that with the completion."""

    def rows(self, left_out: Counter[str]) -> Iterator[Row]:
        """Return those of the file."""
        del left_out
        return rows_in(self.file, self.prompt, self.completion)

    def check(self) -> None:
        """Read all rows that are asked for."""
        if not sum(1 for _ in islice(self.rows(Counter()), self.limit)):
            raise TrainingError(f"{self.file}: holds no row")

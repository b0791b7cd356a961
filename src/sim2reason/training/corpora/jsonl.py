"""A file of somebody's own: JSON lines with two named fields."""

from collections import Counter
from collections.abc import Iterator
from pathlib import Path

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
        """Those of the file."""
        del left_out
        return rows_in(self.file, self.prompt, self.completion)

    def check(self) -> None:
        """Read the first row."""
        next(self.rows(Counter()), None)

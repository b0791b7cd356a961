"""Problems for trainers: prompt, data for the reward, and origin."""

from typing import Any

from pydantic import BaseModel, ConfigDict

from sim2reason.evaluation.benchmarks import BenchmarkItem

__all__ = ["Problem"]


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

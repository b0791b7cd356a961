"""Pretrained checkpoints: a folder, or a name on the Hugging Face Hub."""

from collections.abc import Iterable
from pathlib import Path
from typing import Annotated

from annotated_types import MinLen

from sim2reason.training.models import MODELS, Checkpoint, ModelSettings
from sim2reason.training.models.parts.checkpoint import Attention, Precision

__all__ = ["Pretrained"]


@MODELS.register("pretrained")
class Pretrained(ModelSettings):
    """A checkpoint of the transformers library, by its folder or its name on the Hub."""

    model: Annotated[str, MinLen(1)]
    revision: str | None = None
    """Of a name on the hub: a branch, a tag or a commit."""
    precision: Precision = "auto"
    """Of the weights; by default that of the checkpoint, and in reinforcement learning float32 if they are trained."""
    attention: Attention = "auto"
    """How attention is computed; by default the library's choice."""

    def checkpoint(self, texts: Iterable[str], out: Path) -> Checkpoint:
        """Return the saved checkpoint, without reading or writing."""
        del texts, out
        return self._checkpoint

    def check(self) -> None:
        """Check that the checkpoint exists, by reading its configuration."""
        self._checkpoint.check()

    @property
    def _checkpoint(self) -> Checkpoint:
        return Checkpoint(self.model, self.revision, self.precision, self.attention)

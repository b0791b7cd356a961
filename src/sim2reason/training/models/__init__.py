"""Models to train: checkpoints, and tiny ones created here, one module each.

ModelSettings.checkpoint (texts, a folder) ↦ Checkpoint (a path, and how it is loaded) ↦ Loaded (model, tokenizer)
"""

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Literal, cast

from pydantic import BaseModel, ConfigDict

from sim2reason.base.registry import Registry
from sim2reason.base.settings import build_member
from sim2reason.errors import TrainingError
from sim2reason.training.extras import External
from sim2reason.training.models.checkpoints import Checkpoint, LoadedModel

__all__ = ["MODELS", "Checkpoint", "LoadedModel", "ModelSettings", "build_model", "model_given", "uses_chat_template"]


class ModelSettings(BaseModel, ABC):
    """A model with its settings; each subclass is a kind that a configuration names."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    @abstractmethod
    def checkpoint(self, texts: Iterable[str], out: Path) -> Checkpoint:
        """Return the checkpoint of the untrained model and its tokenizer.

        `texts` are those that the model will read and write, used only to train a tokenizer. New models are saved in
        the folder `out`, where the same call finds them again.

        Raises:
            TrainingError: `out` holds another model.
            MissingExtraError: a library of the extra [train] is missing.
        """

    def load(self, texts: Iterable[str], out: Path) -> LoadedModel:
        """Return the model and its tokenizer, ready to be trained.

        Raises:
            TrainingError: there is no such model, or `out` holds another.
            MissingExtraError: a library of the extra [train] is missing.
        """
        return self.checkpoint(texts, out).load()

    def check(self) -> None:
        """Check before a run that the model exists; TrainingError if not."""


MODELS: Registry[type[ModelSettings]] = Registry("training.models")


def model_given(given: object) -> object:
    """Return the model described by settings; other values unchanged, for later validation."""
    return build_model(cast("Mapping[str, object]", given)) if isinstance(given, Mapping) else given


def build_model(settings: Mapping[str, object], location: str = "model") -> ModelSettings:
    """Return the model described by settings; `kind` is its registered name.

    Raises:
        TrainingError: a setting that is unknown, missing or makes no sense.
        UnknownNameError: no such kind.
    """
    return build_member(MODELS, settings, location, TrainingError)


def uses_chat_template(tokenizer: External, path: str, *, chat: bool | Literal["auto"]) -> bool:
    """Return whether prompts are messages; TrainingError if required without a chat template."""
    templated = tokenizer.chat_template is not None
    if chat is True and not templated:
        raise TrainingError(f"chat: the tokenizer of {path!r} has no chat template; set chat to false")
    return templated if chat == "auto" else chat

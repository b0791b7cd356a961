"""Models that are trained: checkpoints, and tiny ones made here. One file each.

ModelSettings.load (texts, a folder) ↦ Loaded (model, tokenizer, and the path under which both are loaded again)
"""

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import cast

from pydantic import BaseModel, ConfigDict

from sim2reason.errors import TrainingError
from sim2reason.policies.parts.settings import of_kind
from sim2reason.registry import Registry
from sim2reason.training.extras import External

__all__ = ["MODELS", "Loaded", "ModelSettings", "model_from", "model_given"]


@dataclass(frozen=True, slots=True)
class Loaded:
    """A causal language model of the transformers library, and its tokenizer, which has tokens to pad and to end."""

    model: External
    tokenizer: External
    path: str
    """A folder, or a name on the hub, under which both are loaded again as they were before training."""
    revision: str | None = None
    """Of the name on the hub."""


class ModelSettings(BaseModel, ABC):
    """A model with its settings; each subclass is a kind that a configuration names."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    @abstractmethod
    def load(self, texts: Iterable[str], out: Path) -> Loaded:
        """The model and its tokenizer, ready to be trained.

        `texts` are what it will read and write; they are looked at only by a kind that makes its tokenizer from them.
        What is made here is saved in the folder `out`, where it is found again by the same call.

        Raises:
            TrainingError: there is no such model, or `out` holds another.
            MissingExtraError: a library of the extra [train] is missing.
        """

    def check(self) -> None:
        """Look whether there is such a model, before anything is made; TrainingError if not. By default it is made."""


MODELS: Registry[type[ModelSettings]] = Registry("training.models")


def model_given(given: object) -> object:
    """The model that a configuration's settings describe; anything else as it is, to be refused later."""
    return model_from(cast("Mapping[str, object]", given)) if isinstance(given, Mapping) else given


def model_from(settings: Mapping[str, object], place: str = "model") -> ModelSettings:
    """The model that settings describe; its `kind` is a registered name.

    Raises:
        TrainingError: a setting that is unknown, missing or makes no sense.
        UnknownNameError: no such kind.
    """
    return of_kind(MODELS, settings, place, TrainingError)

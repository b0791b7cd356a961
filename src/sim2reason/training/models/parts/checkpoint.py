"""A checkpoint and its tokenizer, read by the transformers library; no code that comes with one is run."""

from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import Any, Literal

from sim2reason.base.lazy import cached_property
from sim2reason.errors import TrainingError
from sim2reason.evaluation.policies.parts.hub import explained, loading
from sim2reason.training.extras import External, library

__all__ = ["Attention", "Checkpoint", "Loaded", "Precision", "context_of"]

Precision = Literal["auto", "float32", "bfloat16", "float16"]
Attention = Literal["auto", "eager", "sdpa", "flash_attention_2", "flash_attention_3"]
ENDLESS = 2**31


@dataclass(frozen=True, slots=True)
class Loaded:
    """A causal language model of the transformers library, and its tokenizer, which has tokens to pad and to end."""

    model: External
    tokenizer: External
    path: str
    """Where it was loaded from."""


@dataclass(frozen=True)
class Checkpoint:
    """Where a model and its tokenizer are loaded from, a folder or a name on the hub, and how."""

    path: str
    revision: str | None = None
    """Of a name on the hub."""
    precision: Precision = "auto"
    """Of the weights; by default as they were saved."""
    attention: Attention = "auto"

    def load(self) -> Loaded:
        """Both; TrainingError if they are not there, or no text ends."""
        tokenizer = self.tokenizer()
        with self._explained():
            kind = library("transformers").AutoModelForCausalLM
            model = kind.from_pretrained(self.path, **{"dtype": "auto", **self.settings})
        return Loaded(model, tokenizer, self.path)

    def tokenizer(self, **settings: object) -> External:
        """Return that of the checkpoint; one without a token to pad with pads with the one that ends a text."""
        with self._explained():
            found = library("transformers").AutoTokenizer.from_pretrained(self.path, **self._source, **settings)
        if found.eos_token_id is None:
            raise TrainingError(f"the tokenizer of {self.path!r} has no token that ends a text; set its eos_token")
        if found.pad_token_id is None:
            found.pad_token = found.eos_token
        return found

    @property
    def context(self) -> int:
        """Return how many tokens the model was made for; without end where its configuration does not say."""
        return context_of(self._config())

    def check(self) -> None:
        """TrainingError if there is no configuration of a model."""
        self._config()

    def _config(self) -> External:
        with self._explained():
            return library("transformers").AutoConfig.from_pretrained(self.path, **self._source)

    @property
    def settings(self) -> dict[str, Any]:
        """Return what `from_pretrained` of a model is told beside the path: what is chosen, and nothing else."""
        chosen = {"dtype": self.precision, "attn_implementation": self.attention}
        with self._explained():
            return {**self._source, **{name: value for name, value in chosen.items() if value != "auto"}}

    @cached_property
    def _source(self) -> dict[str, Any]:
        """Asked for once: out of reach, the hub takes its time."""
        return loading(self.path, self.revision)

    def _explained(self) -> AbstractContextManager[None]:
        return explained(self.path, TrainingError)


def context_of(config: External) -> int:
    """Return how many tokens a model of this configuration was made for."""
    return getattr(config.get_text_config(), "max_position_embeddings", None) or ENDLESS

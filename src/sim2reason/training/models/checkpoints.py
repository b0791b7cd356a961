"""Checkpoints with tokenizers, loaded by transformers without running code that comes with them."""

from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import Any, Literal

from sim2reason.base.records import cached_property
from sim2reason.errors import TrainingError
from sim2reason.evaluation.policies.network import explain_errors, loading_arguments
from sim2reason.training.extras import External, library

__all__ = ["Attention", "Checkpoint", "LoadedModel", "Precision", "context_length"]

Precision = Literal["auto", "float32", "bfloat16", "float16"]
Attention = Literal["auto", "eager", "sdpa", "flash_attention_2", "flash_attention_3"]
UNLIMITED_CONTEXT = 2**31


@dataclass(frozen=True, slots=True)
class LoadedModel:
    """A causal language model with its tokenizer, which has padding and end tokens."""

    model: External
    tokenizer: External
    path: str
    """Where it was loaded from."""


@dataclass(frozen=True)
class Checkpoint:
    """The folder or Hub name of a model and its tokenizer, with options of loading."""

    path: str
    revision: str | None = None
    """Of a name on the hub."""
    precision: Precision = "auto"
    """Of the weights; by default as they were saved."""
    attention: Attention = "auto"

    def load(self) -> LoadedModel:
        """Return the model and tokenizer; TrainingError if they do not exist, or there is no end token."""
        tokenizer = self.tokenizer()
        with self._explained():
            kind = library("transformers").AutoModelForCausalLM
            model = kind.from_pretrained(self.path, **{"dtype": "auto", **self.settings})
        return LoadedModel(model, tokenizer, self.path)

    def tokenizer(self, **settings: object) -> External:
        """Return the tokenizer; without a padding token, the end token is used for padding."""
        with self._explained():
            loaded = library("transformers").AutoTokenizer.from_pretrained(self.path, **self._source, **settings)
        if loaded.eos_token_id is None:
            raise TrainingError(f"the tokenizer of {self.path!r} has no token that ends a text; set its eos_token")
        if loaded.pad_token_id is None:
            loaded.pad_token = loaded.eos_token
        return loaded

    @property
    def context(self) -> int:
        """Return the context length in tokens; a huge number if the configuration does not state it."""
        return context_length(self._config())

    def check(self) -> None:
        """Raise TrainingError if there is no model configuration."""
        self._config()

    def _config(self) -> External:
        with self._explained():
            return library("transformers").AutoConfig.from_pretrained(self.path, **self._source)

    @property
    def settings(self) -> dict[str, Any]:
        """Return the explicitly chosen arguments of `from_pretrained`."""
        chosen = {"dtype": self.precision, "attn_implementation": self.attention}
        with self._explained():
            return {**self._source, **{name: value for name, value in chosen.items() if value != "auto"}}

    @cached_property
    def _source(self) -> dict[str, Any]:
        """Return the arguments of `from_pretrained` that locate the files, determined once."""
        return loading_arguments(self.path, self.revision)

    def _explained(self) -> AbstractContextManager[None]:
        return explain_errors(self.path, TrainingError)


def context_length(config: External) -> int:
    """Return the context length, in tokens, of a model configuration."""
    return getattr(config.get_text_config(), "max_position_embeddings", None) or UNLIMITED_CONTEXT

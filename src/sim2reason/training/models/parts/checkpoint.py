"""A checkpoint and its tokenizer, read by the transformers library; no code that comes with one is run."""

from collections.abc import Generator
from contextlib import contextmanager
from typing import Any, Literal

from sim2reason.errors import TrainingError
from sim2reason.policies.parts.hub import loading
from sim2reason.training.extras import library
from sim2reason.training.models import Loaded

__all__ = ["Attention", "Precision", "check", "read"]

Precision = Literal["auto", "float32", "bfloat16", "float16"]
Attention = Literal["auto", "eager", "sdpa", "flash_attention_2", "flash_attention_3"]
SHOWN = 200  # characters of what the library says about an error


def read(
    path: str, revision: str | None = None, precision: Precision = "auto", attention: Attention = "auto"
) -> Loaded:
    """The model at `path`, a folder or a name on the hub, with weights of `precision`; TrainingError if there is none.

    A tokenizer without a token to pad with pads with the one that ends a text.
    """
    transformers = library("transformers")
    chosen: dict[str, Any] = {} if attention == "auto" else {"attn_implementation": attention}
    with _explained(path):
        source = {"revision": revision, **loading(path, revision)}
        tokenizer = transformers.AutoTokenizer.from_pretrained(path, **source)
        model = transformers.AutoModelForCausalLM.from_pretrained(path, dtype=precision, **source, **chosen)
    if tokenizer.eos_token_id is None:
        raise TrainingError(f"the tokenizer of {path!r} has no token that ends a text; set its eos_token")
    if tokenizer.pad_token_id is None:
        tokenizer.pad_token = tokenizer.eos_token
    return Loaded(model, tokenizer, path, revision)


def check(path: str, revision: str | None = None) -> None:
    """TrainingError if there is no configuration of a model at `path`."""
    with _explained(path):
        library("transformers").AutoConfig.from_pretrained(path, revision=revision, **loading(path, revision))


@contextmanager
def _explained(path: str) -> Generator[None]:
    """Say in one line what the library could not load."""
    try:
        yield
    except (OSError, ValueError, ImportError) as error:
        why = " ".join(str(error).split())[:SHOWN]
        raise TrainingError(f"no model could be loaded from {path!r}: {why}") from None

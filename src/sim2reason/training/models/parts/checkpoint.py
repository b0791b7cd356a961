"""A checkpoint and its tokenizer, read by the transformers library; no code that comes with one is run."""

from typing import Any, Literal

from sim2reason.errors import TrainingError
from sim2reason.policies.parts.hub import loading
from sim2reason.training.extras import library
from sim2reason.training.models import Loaded

__all__ = ["Attention", "Precision", "read"]

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
    try:
        source = {"revision": revision, **loading(path, revision)}
        tokenizer = transformers.AutoTokenizer.from_pretrained(path, **source)
        model = transformers.AutoModelForCausalLM.from_pretrained(path, dtype=precision, **source, **chosen)
    except (OSError, ValueError, ImportError) as error:
        why = " ".join(str(error).split())[:SHOWN]
        raise TrainingError(f"no model could be loaded from {path!r}: {why}") from None
    if tokenizer.eos_token_id is None:
        raise TrainingError(f"the tokenizer of {path!r} has no token that ends a text; set its eos_token")
    if tokenizer.pad_token_id is None:
        tokenizer.pad_token = tokenizer.eos_token
    return Loaded(model, tokenizer, path, revision)

"""Language models: pretrained checkpoints, and tiny transformers with random weights and their own tokenizers.

A pretrained checkpoint is a folder, or a name on the Hugging Face Hub. A tiny transformer has the architecture of
Qwen3: rotary position embeddings, RMS normalisation of queries and keys, a gated feed-forward network (Yang et al.,
Qwen3 technical report, 2025). Hence any loader of checkpoints can load its folder.

Its tokenizer is trained on the texts of a run, by byte-pair encoding whose pieces may span spaces and sentences.
Prompts of one recipe share most of their words, so that a small vocabulary encodes them in few tokens. Some characters
are never merged with others: digits, so that numbers are encoded uniformly, and signs of operations. The alphabet is
bytes (Sennrich et al., 2016; Radford et al., 2019), so that any text is encoded and decoded without loss.
"""

import re
from collections.abc import Iterable, Iterator
from hashlib import sha256
from pathlib import Path
from typing import Annotated, Self

from annotated_types import Ge, Le, MinLen
from pydantic import BaseModel, ConfigDict, Field, ValidationError, model_validator

from sim2reason.base.atomic_files import canonical, put_text
from sim2reason.errors import TrainingError
from sim2reason.training.extras import External, library
from sim2reason.training.models import MODELS, Checkpoint, ModelSettings
from sim2reason.training.models.checkpoints import Attention, Precision

__all__ = ["ALONE", "END", "MIN_VOCABULARY", "PAD", "Pretrained", "Scratch", "train_tokenizer"]

ALONE = "0123456789*=;/-+"
PAD, END = "<|pad|>", "<|end|>"
MIN_VOCABULARY = 256 + 2
"""The vocabulary of bytes and of the tokens that pad and end."""


def train_tokenizer(texts: Iterable[str], vocabulary: int, alone: str = ALONE) -> External:
    """Return a tokenizer with at most `vocabulary` pieces, none of which joins a character of `alone` to others.

    The result depends on the set of texts with multiplicity, not on their order or the number of threads.
    """
    tokenizers, transformers = library("tokenizers"), library("transformers")
    tokenizer = tokenizers.Tokenizer(tokenizers.models.BPE())
    steps = tokenizers.pre_tokenizers
    parts = [steps.ByteLevel(add_prefix_space=False, use_regex=False)]
    if alone:
        one = tokenizers.Regex("|".join(re.escape(sign) for sign in sorted(set(alone))))
        parts.insert(0, steps.Split(one, behavior="isolated"))
    tokenizer.pre_tokenizer = steps.Sequence(parts)
    tokenizer.decoder = tokenizers.decoders.ByteLevel()
    learner = tokenizers.trainers.BpeTrainer(
        vocab_size=vocabulary,
        special_tokens=[PAD, END],
        initial_alphabet=sorted(steps.ByteLevel.alphabet()),
        show_progress=False,
    )
    tokenizer.train_from_iterator(texts, learner)
    return transformers.PreTrainedTokenizerFast(
        tokenizer_object=tokenizer, pad_token=PAD, eos_token=END, clean_up_tokenization_spaces=False
    )


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


RECORD = "scratch.json"
MAX_SEED = 2**63 - 1


@MODELS.register("scratch")
class Scratch(ModelSettings):
    """A tiny transformer with random weights, and a tokenizer made from the texts of the run."""

    layers: Annotated[int, Ge(1), Le(256)] = 3
    width: Annotated[int, Ge(4), Le(65_536)] = 96
    """Of the hidden states."""
    heads: Annotated[int, Ge(1), Le(1024)] = 3
    """Of attention; they share the width, an even number for each."""
    feed_forward: Annotated[int, Ge(1), Le(1_048_576)] | None = None
    """The width of the gated feed-forward network; by default four times that of the hidden states."""
    vocabulary: Annotated[int, Ge(MIN_VOCABULARY), Le(1_000_000)] = 1024
    """Pieces of the tokenizer, at most: few texts have fewer."""
    context: Annotated[int, Ge(8), Le(1_048_576)] = 512
    """Tokens of a prompt and its response."""
    tied: bool = True
    """Whether the embeddings are also the weights of the last layer."""
    alone: Annotated[str, Field(max_length=256)] = ALONE
    """Characters that are pieces of their own."""
    seed: Annotated[int, Ge(0), Le(MAX_SEED)] = 0
    """Of the weights."""

    @model_validator(mode="after")
    def _even_heads(self) -> Self:
        if self.width % (2 * self.heads):  # rotary embeddings turn pairs of coordinates
            raise ValueError(f"width: {self.width} is no multiple of {2 * self.heads}, twice the number of heads")
        return self

    def checkpoint(self, texts: Iterable[str], out: Path) -> Checkpoint:
        """Return the checkpoint in `out`, which the first process creates if it does not exist."""
        state = library("accelerate").PartialState()
        with state.main_process_first():
            if state.is_main_process and not self._contains_model(out):
                self._make(texts, out)
        return Checkpoint(str(out), precision="float32")

    def _contains_model(self, out: Path) -> bool:
        """Return whether the folder contains this model; TrainingError if it contains something else."""
        if not out.is_dir() or not any(out.iterdir()):
            return False
        try:
            record = _Record.model_validate_json((out / RECORD).read_bytes())
        except (FileNotFoundError, ValidationError):
            raise TrainingError(f"{out}: holds something, but no model that was made here; remove that") from None
        if record.settings != self:
            raise TrainingError(f"{out}: holds a model of other settings; remove it, or choose a new folder")
        return True

    def _make(self, texts: Iterable[str], out: Path) -> None:
        """Create and save the tokenizer and weights, with their record last."""
        digest = sha256()
        tokenizer = train_tokenizer(_counted(texts, digest), self.vocabulary, self.alone)
        tokenizer.model_max_length = self.context
        model = self._weights(tokenizer)
        scratch = out.with_name(f"{out.name}.part")
        for target in (tokenizer, model):
            target.save_pretrained(scratch)
        record = _Record(
            settings=self, pieces=len(tokenizer), parameters=model.num_parameters(), texts=digest.hexdigest()
        )
        put_text(scratch / RECORD, canonical(record.model_dump(mode="json")), scratch)
        if out.is_dir():
            out.rmdir()  # empty
        scratch.rename(out)

    def _weights(self, tokenizer: External) -> External:
        """Return a model with random weights, without changing the global random state."""
        torch, transformers = library("torch"), library("transformers")
        config = transformers.Qwen3Config(
            vocab_size=len(tokenizer),
            hidden_size=self.width,
            intermediate_size=self.feed_forward or 4 * self.width,
            num_hidden_layers=self.layers,
            num_attention_heads=self.heads,
            num_key_value_heads=self.heads,
            head_dim=self.width // self.heads,
            max_position_embeddings=self.context,
            tie_word_embeddings=self.tied,
            pad_token_id=tokenizer.pad_token_id,
            bos_token_id=None,
            eos_token_id=tokenizer.eos_token_id,
        )
        with torch.random.fork_rng(devices=[]):
            torch.manual_seed(self.seed)
            return transformers.Qwen3ForCausalLM(config).float()


class _Record(BaseModel):
    """The contents of ``scratch.json``: the settings and texts behind the model."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    settings: Scratch
    pieces: int
    parameters: int
    texts: str
    """The SHA-256 of all texts, each behind its length."""


def _counted(texts: Iterable[str], digest: External) -> Iterator[str]:
    """Yield the texts while adding them to a hash."""
    for text in texts:
        encoded = text.encode(errors="replace")
        digest.update(len(encoded).to_bytes(8, "big") + encoded)
        yield encoded.decode()

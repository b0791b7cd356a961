"""Training of a tokenizer on few texts: byte-pair encoding whose pieces may span spaces and sentences.

Prompts of one recipe share most of their words, so that a small vocabulary encodes them in few tokens. Some characters
are never merged with others: digits, so that numbers are encoded uniformly, and signs of operations. The alphabet is
bytes (Sennrich et al., 2016; Radford et al., 2019), so that any text is encoded and decoded without loss.
"""

import re
from collections.abc import Iterable

from sim2reason.training.extras import External, library

__all__ = ["ALONE", "END", "PAD", "SMALLEST", "train_tokenizer"]

ALONE = "0123456789*=;/-+"
PAD, END = "<|pad|>", "<|end|>"
SMALLEST = 256 + 2
"""The vocabulary of bytes and of the tokens that pad and end."""


def train_tokenizer(texts: Iterable[str], vocabulary: int, alone: str = ALONE) -> External:
    """Return a tokenizer with at most `vocabulary` pieces, none of which joins a character of `alone` to others.

    The result depends on the set of texts with multiplicity, not on their order or the number of threads.
    """
    tokenizers, transformers = library("tokenizers"), library("transformers")
    found = tokenizers.Tokenizer(tokenizers.models.BPE())
    steps = tokenizers.pre_tokenizers
    parts = [steps.ByteLevel(add_prefix_space=False, use_regex=False)]
    if alone:
        one = tokenizers.Regex("|".join(re.escape(sign) for sign in sorted(set(alone))))
        parts.insert(0, steps.Split(one, behavior="isolated"))
    found.pre_tokenizer = steps.Sequence(parts)
    found.decoder = tokenizers.decoders.ByteLevel()
    learner = tokenizers.trainers.BpeTrainer(
        vocab_size=vocabulary,
        special_tokens=[PAD, END],
        initial_alphabet=sorted(steps.ByteLevel.alphabet()),
        show_progress=False,
    )
    found.train_from_iterator(texts, learner)
    return transformers.PreTrainedTokenizerFast(
        tokenizer_object=found, pad_token=PAD, eos_token=END, clean_up_tokenization_spaces=False
    )

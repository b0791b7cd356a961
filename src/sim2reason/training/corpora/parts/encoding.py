"""Rows as tokens: what the model reads, and behind it what it learns to write, the token that ends a text included.

Prompt and completion are encoded apart, as they are when the model answers: a piece that would join the end of the one
with the start of the other is never seen then.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from sim2reason.training.corpora import Row
from sim2reason.training.extras import External

__all__ = ["EncodedRow", "Limits", "encoded", "templated"]

IGNORED = -100  # the label of a token that no loss is computed of, as torch has it


@dataclass(frozen=True, slots=True)
class Limits:
    """How many tokens rows have at most."""

    prompt: int
    completion: int
    """With the token that ends it."""
    both: int
    """Those of the model's context."""


@dataclass(frozen=True, slots=True)
class EncodedRow:
    """A row in tokens."""

    prompt: list[int]
    completion: list[int]

    @property
    def columns(self) -> dict[str, list[int]]:
        """As trainers take it: all tokens, and for each its label, which is ignored in the prompt."""
        labels = [IGNORED] * len(self.prompt) + self.completion
        return {"input_ids": self.prompt + self.completion, "labels": labels}

    def excess(self, limits: Limits) -> str:
        """Which limit it passes; empty if none."""
        if len(self.prompt) > limits.prompt:
            return "prompt too long"
        if len(self.completion) > limits.completion:
            return "completion too long"
        return "longer than the context" if len(self.prompt) + len(self.completion) > limits.both else ""


def encoded(rows: Sequence[Row], tokenizer: External, *, chat: bool) -> list[EncodedRow]:
    """All rows in tokens; with `chat` as messages in the tokenizer's template, else as plain texts."""
    pairs = [templated(row, tokenizer) if chat else (row.prompt, row.completion) for row in rows]
    first = _tokens([prompt for prompt, _ in pairs], tokenizer, special=not chat)
    second = _tokens([completion for _, completion in pairs], tokenizer, special=False)
    end = tokenizer.eos_token_id
    return [EncodedRow(a, b if b[-1:] == [end] else [*b, end]) for a, b in zip(first, second, strict=True)]


def templated(row: Row, tokenizer: External) -> tuple[str, str]:
    """A row as its messages are written: what stands before the completion, and that to the end of its turn.

    Where a template writes an earlier turn otherwise than the one to be answered, the completion stands as it is.
    """
    asked = [{"role": "user", "content": row.prompt}]
    said = [*asked, {"role": "assistant", "content": row.completion}]
    prompt = tokenizer.apply_chat_template(asked, tokenize=False, add_generation_prompt=True)
    whole = tokenizer.apply_chat_template(said, tokenize=False)
    rest = whole.removeprefix(prompt).rstrip()
    if not whole.startswith(prompt) or row.completion.strip() not in rest:
        return prompt, row.completion
    return prompt, rest


def _tokens(texts: list[str], tokenizer: External, *, special: bool) -> list[list[int]]:
    if not texts:
        return []
    return tokenizer(texts, add_special_tokens=special, verbose=False)["input_ids"]

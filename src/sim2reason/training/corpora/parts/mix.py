"""Mixture of corpora, and tokenization of rows."""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import chain, islice

import numpy as np
import pyarrow as pa

from sim2reason.errors import TrainingError
from sim2reason.generation.item_search import generator
from sim2reason.training.corpora import CORPORA, Corpus, Row
from sim2reason.training.extras import External

__all__ = [
    "MOST_ROWS",
    "Counted",
    "EncodedRow",
    "Limits",
    "Mix",
    "counted",
    "encoded",
    "encoded_table",
    "mixed",
    "templated",
]

# pyarrow ships no types:
# pyright: reportMissingTypeStubs=false, reportUnknownMemberType=false, reportUnknownParameterType=false
# pyright: reportUnknownVariableType=false, reportUnknownArgumentType=false


IGNORED = -100  # label of a token that is excluded from the loss, as in torch
TOGETHER = 8192  # rows tokenized at once
TOKENS = pa.list_(pa.int32())


@dataclass(frozen=True, slots=True)
class Limits:
    """The largest allowed numbers of tokens of a row: in its prompt, its completion, and both together."""

    prompt: int
    completion: int
    """With the token that ends it."""
    both: int
    """Those of the model's context."""


@dataclass(frozen=True, slots=True)
class EncodedRow:
    """A prompt and its completion as tokens."""

    prompt: list[int]
    completion: list[int]

    @property
    def tokens(self) -> list[int]:
        """Return all tokens, prompt and completion."""
        return self.prompt + self.completion

    @property
    def labels(self) -> list[int]:
        """Return the labels of all tokens; prompt tokens are ignored."""
        return [IGNORED] * len(self.prompt) + self.completion

    def excess(self, limits: Limits) -> str:
        """Return in words which token limit the row exceeds; empty if the row exceeds none."""
        if len(self.prompt) > limits.prompt:
            return "prompt too long"
        if len(self.completion) > limits.completion:
            return "completion too long"
        return "longer than the context" if len(self.prompt) + len(self.completion) > limits.both else ""


def encoded_table(
    rows: Sequence[Row], tokenizer: External, limits: Limits, *, chat: bool
) -> tuple[pa.Table, Counter[str]]:
    """Return the rows within limits as a table for trainers, and counts of rows beyond each limit.

    The columns are `input_ids` and `labels`, both of tokens, and `length`, their number.
    """
    left_out = Counter[str]()
    schema = pa.schema({"input_ids": TOKENS, "labels": TOKENS, "length": pa.int32()})
    slices = (encoded(rows[start : start + TOGETHER], tokenizer, chat=chat) for start in range(0, len(rows), TOGETHER))
    return pa.Table.from_batches(_batches(slices, limits, left_out), schema), left_out


def _batches(slices: Iterator[list[EncodedRow]], limits: Limits, left_out: Counter[str]) -> Iterator[pa.RecordBatch]:
    for rows in slices:
        excess = [row.excess(limits) for row in rows]
        left_out.update(why for why in excess if why)
        held = [row for row, why in zip(rows, excess, strict=True) if not why]
        tokens, labels = _lists([row.tokens for row in held]), _lists([row.labels for row in held])
        yield pa.record_batch({"input_ids": tokens, "labels": labels, "length": tokens.value_lengths()})


def _lists(held: Sequence[Sequence[int]]) -> pa.ListArray:
    """Return lists as one array, which is much faster than type inference by pyarrow."""
    ends = np.cumsum([0, *map(len, held)], dtype=np.int32)
    values = np.fromiter(chain.from_iterable(held), np.int32, count=int(ends[-1]))
    return pa.ListArray.from_arrays(ends, values)


def encoded(rows: Sequence[Row], tokenizer: External, *, chat: bool) -> list[EncodedRow]:
    """Return the tokenized rows; with `chat` as messages in the tokenizer's template, else as plain texts."""
    pairs = [templated(row, tokenizer) if chat else (row.prompt, row.completion) for row in rows]
    first = _tokens([prompt for prompt, _ in pairs], tokenizer, special=not chat)
    second = _tokens([completion for _, completion in pairs], tokenizer, special=False)
    end = tokenizer.eos_token_id
    return [EncodedRow(a, b if b[-1:] == [end] else [*b, end]) for a, b in zip(first, second, strict=True)]


def templated(row: Row, tokenizer: External) -> tuple[str, str]:
    """Return a row in the chat template: the text before the completion, and the completion with its end.

    If a template changes earlier turns, the completion is used without the template.
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


MOST_ROWS = 10_000_000


@dataclass(frozen=True, slots=True)
class Counted:
    """The numbers of rows of a corpus: all, those used, those known to be wrong, and the omitted ones by reason."""

    kind: str
    rows: int
    """Those that it has."""
    taken: int
    """Those in the mix; with a weight above one, the same row counts each time."""
    wrong: int = 0
    """Those of the rows whose completions are known to be wrong."""
    left_out: dict[str, int] = field(default_factory=dict[str, int])
    """What could be no row, by its reason."""


@dataclass(frozen=True, slots=True)
class Mix:
    """All rows in the order of training, and the counts of rows of each corpus."""

    rows: list[Row]
    corpora: list[Counted]


def mixed(corpora: Sequence[Corpus], seed: int, avoid: frozenset[str] = frozenset()) -> Mix:
    """Return all rows of all corpora, weighted and shuffled, as a pure function of corpora and seed.

    Held-out rows, whose prompt or fingerprint is in `avoid`, are omitted.

    Raises:
        TrainingError: a corpus without a row, or more rows than fit.
    """
    rows, counts = list[Row](), list[Counted]()
    for number, corpus in enumerate(corpora):
        left_out = Counter[str]()
        found = list(islice(corpus.rows(left_out), min(corpus.limit or MOST_ROWS, MOST_ROWS)))
        held = [row for row in found if not {row.prompt, row.fingerprint} & avoid]
        if len(held) < len(found):
            left_out["held out"] += len(found) - len(held)
        kind = CORPORA.name_of(corpus)
        if not held:
            why = f"left out: {counted(left_out)}" if left_out else "it is empty"
            raise TrainingError(f"corpora[{number}]: no row to learn from in this {kind}; {why}")
        chosen = _weighted(held, corpus.weight, generator("corpus", seed, number))
        rows += chosen
        if len(rows) > MOST_ROWS:
            raise TrainingError(f"corpora[{number}].weight: more than {MOST_ROWS} rows in all; give a smaller one")
        wrong = sum(row.right is False for row in held)
        counts.append(Counted(kind, len(held), len(chosen), wrong, dict(sorted(left_out.items()))))
    order = generator("mix", seed).permutation(len(rows))
    return Mix([rows[place] for place in order], counts)


def counted(reasons: Mapping[str, int]) -> str:
    """Return counts of rows by reason as a text."""
    return ", ".join(f"{count} ({reason})" for reason, count in sorted(reasons.items()))


def _weighted(rows: list[Row], weight: float, rng: np.random.Generator) -> list[Row]:
    """Return the rows repeated as often as the weight says, with a random part for its fraction; at least one row."""
    times, part = divmod(weight, 1.0)
    more = rng.permutation(len(rows))[: round(part * len(rows))]
    return rows * int(times) + [rows[place] for place in sorted(more)] or [rows[0]]

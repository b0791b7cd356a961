"""Several corpora as one: each row as often as its corpus weighs, in a random order that a seed decides."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import islice

import numpy as np

from sim2reason.errors import TrainingError
from sim2reason.generation.random_scenes import generator
from sim2reason.training.corpora import CORPORA, Corpus, Row

__all__ = ["MOST_ROWS", "Counted", "Mix", "counted", "mixed"]

MOST_ROWS = 10_000_000


@dataclass(frozen=True, slots=True)
class Counted:
    """What became of one corpus."""

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
    """Rows in the order in which they are learned from, and where they are from."""

    rows: list[Row]
    corpora: list[Counted]


def mixed(corpora: Sequence[Corpus], seed: int, avoid: frozenset[str] = frozenset()) -> Mix:
    """Return all rows of all corpora, weighted and shuffled: a pure function of the corpora and the seed.

    Rows whose prompt or fingerprint is one to `avoid`, which is kept for evaluation, are left out.

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
    """In words."""
    return ", ".join(f"{count} ({reason})" for reason, count in sorted(reasons.items()))


def _weighted(rows: list[Row], weight: float, rng: np.random.Generator) -> list[Row]:
    """Return each row as many times as the weight is whole, and a random part of them once more; at least one."""
    times, part = divmod(weight, 1.0)
    more = rng.permutation(len(rows))[: round(part * len(rows))]
    return rows * int(times) + [rows[place] for place in sorted(more)] or [rows[0]]

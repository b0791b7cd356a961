"""Corpora: sources of prompts with completions for fine-tuning, one module each.

Corpus (settings) ↦ Row (prompt, completion) ── mixed ── encoded ── a trainer of supervised fine-tuning
"""

from abc import ABC, abstractmethod
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Annotated, ClassVar

from annotated_types import Ge, Gt, Le
from pydantic import BaseModel, ConfigDict

from sim2reason.base.registry import Registry
from sim2reason.base.settings import build_member
from sim2reason.errors import TrainingError

__all__ = ["CORPORA", "MAX_WEIGHT", "Corpus", "Row", "build_corpus"]

MAX_WEIGHT = 1000.0


@dataclass(frozen=True, slots=True)
class Row:
    """A prompt and the completion to learn, as plain texts, to which a chat template may be applied."""

    prompt: str
    completion: str
    right: bool | None = None
    """Whether the completion is right; None where nobody has looked."""
    fingerprint: str = ""
    """What the same problem of the same numbers has, too, in whatever words; empty where it is not known."""


class Corpus(BaseModel, ABC):
    """A source of rows with its settings; each subclass is a kind that a configuration names."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    weight: Annotated[float, Gt(0.0), Le(MAX_WEIGHT)] = 1.0
    """How often each row stands in the mix: 2 is twice, 0.25 is a random quarter of the rows once."""
    limit: Annotated[int, Ge(1)] | None = None
    """The first so many rows only."""

    operational: ClassVar[frozenset[str]] = frozenset({"workers"})
    """Settings that change no row."""

    def check(self) -> None:
        """Check before a run that the input of the corpus exists; TrainingError or DatasetError if not."""

    @abstractmethod
    def rows(self, left_out: Counter[str]) -> Iterator[Row]:
        """Yield all prompts with completions in a fixed order; omitted ones are counted by reason in `left_out`.

        Raises:
            TrainingError: a file that is missing, damaged, or holds something else.
            DatasetError: the same of a dataset.
        """


CORPORA: Registry[type[Corpus]] = Registry("training.corpora")


def build_corpus(settings: Mapping[str, object], location: str = "corpus") -> Corpus:
    """Return the corpus described by settings; `kind` is its registered name.

    Raises:
        TrainingError: a setting that is unknown, missing or makes no sense.
        UnknownNameError: no such kind.
    """
    return build_member(CORPORA, settings, location, TrainingError)

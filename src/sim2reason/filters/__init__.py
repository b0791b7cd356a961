"""Filters: each drops questions for one reason, which the manifest of a dataset counts."""

from dataclasses import dataclass
from typing import Protocol

from sim2reason.questions import Question, Study
from sim2reason.registry import Registry
from sim2reason.simulation.certify import Certificate


@dataclass(frozen=True)
class Candidate:
    """A question that may become an item, with what it was asked about."""

    study: Study
    question: Question
    prompt: str
    sentences: tuple[str, ...] = ()  # of the scene's text
    certificate: Certificate | None = None  # once the witness has been heard


@dataclass(frozen=True, slots=True)
class Verdict:
    """Whether a filter keeps a question, and if not, why."""

    keep: bool
    filter: str
    reason: str = ""


class Filter(Protocol):
    """One reason to drop a question. `needs_witness` filters run last, since the witness costs most."""

    needs_witness: bool
    order: int

    def reason(self, candidate: Candidate) -> str:
        """Why the question must go, in a few words; empty if it may stay."""
        ...


FILTERS: Registry[Filter] = Registry("filters")


def sift(candidate: Candidate, *, witnessed: bool) -> Verdict:
    """The first verdict against a question among the filters that need a witness, or that need none."""
    chosen = [(f.order, name, f) for name, f in FILTERS.items() if f.needs_witness == witnessed]
    for _, name, found in sorted(chosen, key=lambda item: item[:2]):
        if reason := found.reason(candidate):
            return Verdict(keep=False, filter=name, reason=reason)
    return Verdict(keep=True, filter="")

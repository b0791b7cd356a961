"""Assumptions of a symbolic question as one sentence, and the parser of that sentence."""

import re
from collections.abc import Iterator, Sequence
from itertools import product

from sim2reason.questions.regimes import Regime, possible
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words

ASSUME = "Assume that "
_JOINTS = re.compile(r", and that |, that | and that ")
MAX_PARSES = 1000  # parses of one sentence that are tried


def assuming(assumed: Sequence[Regime], words: Words) -> str:
    """Return the sentence that states some assumptions.

    For example: *assume that block A moves down the slope and that the string stays taut*. Assumptions are in the order
    of time: the start, the whole motion, the moment. If two consecutive clauses concern one body, the second one calls
    it *it*.
    """
    ordered = sorted(assumed, key=lambda held: (held.stage, held.clause(words)))
    clauses = [_clause(held, ordered[:number], assumed, words) for number, held in enumerate(ordered)]
    if len(clauses) < 3:
        return f"{ASSUME}{' and that '.join(clauses)}."
    return f"{ASSUME}{', that '.join(clauses[:-1])}, and that {clauses[-1]}."


def assumed_in(sentence: str, study: SimulatedScene, words: Words) -> tuple[Regime, ...] | None:
    """Return the assumptions that a sentence states about a scene; None if it is not such a sentence."""
    said = _JOINTS.split(sentence.removeprefix(ASSUME).removesuffix("."))
    regimes = possible(study, words)
    meant = [[held for held in regimes if clause in _forms(held, words)] for clause in said]
    readings = product(*meant)
    for _, reading in zip(range(MAX_PARSES), readings, strict=False):
        if assuming(reading, words) == sentence:
            return reading
    return None


def split_assumptions(text: str) -> tuple[str, str]:
    """Split a question into its assumptions (may be empty) and the rest."""
    asked, stop, assumed = text.partition(f" {ASSUME}")
    return f"{ASSUME}{assumed}" if stop else "", asked


def _clause(held: Regime, before: Sequence[Regime], beside: Sequence[Regime], words: Words) -> str:
    clause, subject = held.clause_beside(words, beside), _subject(held, words)
    same = bool(before) and subject and subject == _subject(before[-1], words)
    return _with_it(clause, subject) if same else clause


def _forms(held: Regime, words: Words) -> Iterator[str]:
    for clause in (held.clause(words), held.short_clause(words)):
        yield clause
        yield _with_it(clause, _subject(held, words))


def _subject(held: Regime, words: Words) -> str:
    """Return the name of the body with which a clause begins; empty without a single body."""
    called = words.called(held.of).get(held.name, "")
    return called if called and held.clause(words).startswith(f"{called} ") else ""


def _with_it(clause: str, subject: str) -> str:
    return f"it{clause.removeprefix(subject)}" if subject else clause

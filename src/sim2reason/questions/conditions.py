"""Sentences that give a result and ask for a number that the text leaves unknown."""

from collections.abc import Iterator

from sim2reason.questions.given import StatedResult
from sim2reason.questions.kinds import KINDS
from sim2reason.questions.query import Query
from sim2reason.questions.targets import Noun
from sim2reason.questions.unknown import Unknown
from sim2reason.questions.words import Words


def asking_for(unknown: Unknown, query: Query, given: StatedResult, words: Words, noun: Noun | None) -> tuple[str, ...]:
    """Return all ways to ask which value of the unknown makes the answer to a query what is given."""
    kind, sense = KINDS[query.kind], query.target.sense if query.target is not None else None
    wanted, told = kind.wanted(query, words, noun), kind.told(query, words, noun, given.said)
    plain = [f"{called} is {given.said}" for called in kind.called(query, words, noun)[:1]]
    clauses = tuple(dict.fromkeys((*told[:1], *plain)))
    counted = f", {sense.positive} being positive" if sense is not None and not sense.fixed else ""
    shapes = (
        shape
        for phrase in unknown.phrases
        for shape in (
            *_stated(told, clauses, phrase, counted),
            *(shape for name in wanted for shape in _wanted(name, given.said, phrase, unknown.symbol, counted)),
        )
    )
    return tuple(dict.fromkeys(shapes))


def _stated(told: tuple[str, ...], clauses: tuple[str, ...], unknown: str, counted: str) -> Iterator[str]:
    """Yield the result first, in a sentence of its own, or as what is given, in a clause."""
    for statement in told:
        if statement[0].isalpha():
            yield f"{statement}{counted}. What is {unknown}?"
            yield f"{statement}{counted}. Find {unknown}."
            yield f"{statement}{counted}. Determine {unknown}."
    for clause in clauses:
        yield f"find {unknown}, given that {clause}{counted}."
        yield f"calculate {unknown} if {clause}{counted}."
        yield f"what is {unknown} if {clause}{counted}?"


def _wanted(called: str, value: str, unknown: str, symbol: str, counted: str) -> Iterator[str]:
    """Yield the result as what shall be."""
    yield f"what must {unknown} be if {called} is to be {value}{counted}?"
    yield f"determine {unknown} so that {called} is {value}{counted}."
    yield f"for which value of {symbol} is {called} equal to {value}{counted}?"

"""Pairs that do not meet, in words: several of one kind in one clause."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial

from sim2reason.solutions.setting import joined


@dataclass(frozen=True)
class Excluded:
    """A pair that does not meet, in words and by its letters, with the kind of argument and its number.

    `motion` tells its relative position and velocity, from which the number follows.
    """

    kind: str
    who: str
    letters: str
    said: str
    limit: str = ""
    motion: str = ""


def clauses(told: Sequence[Excluded]) -> Iterator[str]:
    """Return a clause for each kind of argument."""
    for kind, clause in CLAUSES.items():
        held = [each for each in told if each.kind == kind]
        if held:
            yield clause(held)


def _pairs(held: Sequence[Excluded]) -> str:
    """Return the subject of a clause, such as *pucks A and B* or *the pairs AB and AC*."""
    return held[0].who if len(held) == 1 else f"the pairs {joined([each.letters for each in held])}"


def _numbers(held: Sequence[Excluded]) -> str:
    return joined([each.said for each in held])


def _meet_later(held: Sequence[Excluded]) -> str:
    where = f", with their centres ${held[0].limit}$ apart," if held[0].limit else ""
    return f"{_pairs(held)} would meet{where} only after {_numbers(held)}"


def _pass(held: Sequence[Excluded]) -> str:
    return f"{_pairs(held)} would be {_numbers(held)} apart where they are closest, more than ${held[0].limit}$"


def _part(held: Sequence[Excluded]) -> str:
    """Return the clause about discs that move apart: relative position and velocity have a positive product."""
    return f"{_pairs(held)} move apart, since {_numbers(held)} {'is' if len(held) == 1 else 'are'} positive"


def _part_in_line(held: Sequence[Excluded]) -> str:
    return f"{_pairs(held)} move apart at {_numbers(held)}"


def _at_walls(held: Sequence[Excluded], verb: str) -> str:
    return joined([f"{each.who} {verb} {each.said}" for each in held])


CLAUSES: Mapping[str, Callable[[Sequence[Excluded]], str]] = {
    "later": _meet_later,
    "wall later": partial(_at_walls, verb="would reach the wall only after"),
    "pass": _pass,
    "apart": _part,
    "line apart": _part_in_line,
    "wall apart": partial(_at_walls, verb="moves away from the wall at"),
}

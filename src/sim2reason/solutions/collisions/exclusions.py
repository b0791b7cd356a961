"""Pairs that do not meet, in words: several of one kind in one clause."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from sim2reason.solutions.setting import joined


@dataclass(frozen=True)
class Excluded:
    """A pair that does not meet, in words and by its letters, with the kind of argument and its number.

    The number follows from its relative position and velocity, which `motion` tells in a sentence; on a line, `aside`
    tells them in a few words.
    """

    kind: str
    who: str
    letters: str
    said: str
    limit: str = ""
    motion: str = ""
    aside: str = ""


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
    return f"{_pairs(held)} would meet, with their centres ${held[0].limit}$ apart, only at {_numbers(held)}"


def _meet_later_in_line(held: Sequence[Excluded]) -> str:
    return joined([f"{each.who}, {each.aside}, would meet only at {each.said}" for each in held])


def _reach_later(held: Sequence[Excluded]) -> str:
    return joined([f"{each.who}, {each.aside}, would reach {each.limit} only at {each.said}" for each in held])


def _pass(held: Sequence[Excluded]) -> str:
    return f"the centres of {_pairs(held)} would be {_numbers(held)} apart where closest, more than ${held[0].limit}$"


def _part(held: Sequence[Excluded]) -> str:
    """Return the clause about discs that move apart: relative position and velocity have a positive product."""
    return f"{_pairs(held)} move apart, since {_numbers(held)} {'is' if len(held) == 1 else 'are'} positive"


def _part_in_line(held: Sequence[Excluded]) -> str:
    return f"{_pairs(held)} move apart at {_numbers(held)}"


def _slide_off(held: Sequence[Excluded]) -> str:
    """Return the clause about discs that have only slid past each other since an inelastic collision."""
    return (
        f"{_pairs(held)} keep only a relative velocity perpendicular to their line of centres, which takes them apart"
    )


def _go_together(held: Sequence[Excluded]) -> str:
    """Return the clause about discs that an inelastic head-on collision leaves no relative velocity at all."""
    return f"{_pairs(held)} move on together at the same velocity"


def _leave_walls(held: Sequence[Excluded]) -> str:
    return joined([f"{each.who} moves away from {each.limit} at {each.said}" for each in held])


CLAUSES: Mapping[str, Callable[[Sequence[Excluded]], str]] = {
    "later": _meet_later,
    "line later": _meet_later_in_line,
    "wall later": _reach_later,
    "pass": _pass,
    "apart": _part,
    "touching": _slide_off,
    "together": _go_together,
    "line apart": _part_in_line,
    "wall apart": _leave_walls,
}

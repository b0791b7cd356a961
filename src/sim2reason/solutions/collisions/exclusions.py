"""Pairs that do not meet, in words: several of one kind in one clause."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial

from sim2reason.solutions.setting import joined


@dataclass(frozen=True)
class Excluded:
    """A pair that does not meet: the kind of argument, the pair in words, and the number that shows it."""

    kind: str
    who: str
    said: str
    limit: str = ""


def _meet_later(held: Sequence[Excluded], verb: str = "would meet") -> str:
    first, *others = held
    return joined(
        [f"{first.who} {verb} only after {first.said}", *(f"{each.who} only after {each.said}" for each in others)]
    )


def _pass(held: Sequence[Excluded]) -> str:
    first, *others = held
    told = [f"{first.who} pass at a distance of {first.said}", *(f"{each.who} at {each.said}" for each in others)]
    return f"{joined(told)}, more than ${first.limit}$"


def _part(held: Sequence[Excluded]) -> str:
    """Discs in a plane whose relative position and velocity, multiplied, show that they move apart."""
    told = joined([each.said for each in held])
    return (
        f"{joined([each.who for each in held])} move apart, since {told} {'is' if len(held) == 1 else 'are'} positive"
    )


def _part_in_line(held: Sequence[Excluded], verb: str = "move apart") -> str:
    return joined([f"{each.who} {verb} at {each.said}" for each in held])


CLAUSES: Mapping[str, Callable[[Sequence[Excluded]], str]] = {
    "later": _meet_later,
    "wall later": partial(_meet_later, verb="would reach the wall"),
    "pass": _pass,
    "apart": _part,
    "line apart": _part_in_line,
    "wall apart": partial(_part_in_line, verb="moves away from the wall"),
}


def clauses(told: Sequence[Excluded]) -> Iterator[str]:
    """Return a clause for each kind of argument."""
    for kind, clause in CLAUSES.items():
        held = [each for each in told if each.kind == kind]
        if held:
            yield clause(held)

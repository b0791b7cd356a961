"""Matching of several correct answers with several given ones, in any order."""

from collections.abc import Callable, Sequence
from typing import TypeVar

__all__ = ["paired"]

T = TypeVar("T")


def paired(right: Sequence[T], said: Sequence[str], fits: Callable[[T, str], bool]) -> bool:
    """Return whether `right` and `said` can be matched one to one by `fits` (Kuhn's algorithm)."""
    if len(right) != len(said):
        return False
    good = [[place for place, answer in enumerate(said) if fits(each, answer)] for each in right]
    taken: dict[int, int] = {}

    def place(number: int, tried: set[int]) -> bool:
        for spot in good[number]:
            if spot not in tried:
                tried.add(spot)
                if spot not in taken or place(taken[spot], tried):
                    taken[spot] = number
                    return True
        return False

    return all(place(number, set()) for number in range(len(right)))

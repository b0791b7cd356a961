"""Forces that the motion leaves open, as where two rough blocks at rest are tied together: how far they can hold.

Each of some conditions (a string does not push, friction is at most µN) has a margin that depends on the free
forces z: base + Σ part·z. All can be met as long as the greatest possible least of them is not negative.
"""

from collections.abc import Sequence
from typing import NamedTuple

FAINT = 1e-12  # a part that is none
MOST = 4000  # combinations that are followed


class Condition(NamedTuple):
    """base + Σ part·z ≥ least, and which of the given conditions were combined into it."""

    base: float
    parts: tuple[float, ...]
    of: frozenset[int]


def greatest_least(bases: Sequence[float], parts: Sequence[Sequence[float]]) -> tuple[float, frozenset[int]]:
    """The greatest value, over all z, of the least margin, and which margins set it; infinity if nothing does.

    Fourier and Motzkin's elimination: any two conditions in which a free force has opposite signs combine, with
    weights of sum 1, into one without it.
    """
    found = [Condition(b, tuple(p), frozenset({i})) for i, (b, p) in enumerate(zip(bases, parts, strict=True))]
    for place in range(len(parts[0]) if parts else 0):
        rising = [one for one in found if one.parts[place] > FAINT]
        falling = [one for one in found if one.parts[place] < -FAINT]
        kept = [one for one in found if abs(one.parts[place]) <= FAINT]
        found = [*kept, *(_combined(one, other, place) for one in rising for other in falling)][:MOST]
    least = min(found, key=lambda one: one.base, default=Condition(float("inf"), (), frozenset()))
    return least.base, least.of


def _combined(one: Condition, other: Condition, place: int) -> Condition:
    up, down = one.parts[place], -other.parts[place]
    first, second = down / (up + down), up / (up + down)
    parts = tuple(first * a + second * b for a, b in zip(one.parts, other.parts, strict=True))
    return Condition(first * one.base + second * other.base, parts, one.of | other.of)

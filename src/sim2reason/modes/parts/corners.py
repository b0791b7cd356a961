"""Numbers at the ends of their ranges at which something that a motion does is no longer done, if there are any.

A string may go slack, or what slides stick, without a sum in the formula of an answer turning its sign.
"""

from collections.abc import Callable, Sequence
from itertools import product
from math import inf

import numpy as np

from sim2reason.dsl.state import Array
from sim2reason.modes.parts.variations import Variation, Variations

Margin = Callable[[Variation], float | None]
"""How far a scene is from where something is no longer done; None where that says nothing."""

LOW, HIGH, SIDES = 0, 2, 3  # of a number: the low end of its range, the high one; between them it is as it was
GUESSES, SEED = 2000, 0  # choices of ends that are guessed for
SAME = 1e-9  # of a margin: less is no change


def leaving(
    variations: Variations, margin: Margin, others: Sequence[Margin], known: Sequence[Variation]
) -> Variation | None:
    """The scene with numbers at ends of their ranges where a margin is least while others are more than nothing.

    Which ends these are is guessed as if all that each of them changes, as is `known` of it alone, added up; then each
    number is tried at its other ends. None if nothing is known of the margin.
    """
    own = variations.own()
    here = [each(own) for each in (margin, *others)] if own is not None else [None]
    if own is None or here[0] is None:
        return None
    told = [each for each, found in zip((margin, *others), here, strict=True) if found is not None]
    factors, changes = _alone(variations, told, known, own)
    ends = np.random.default_rng(SEED).integers(0, SIDES, (GUESSES, len(factors)))
    for n, held in enumerate(variations.symbols):  # what is asked about comes sooner, where that is all the same
        if not held.path and np.abs(changes[0, n]).max() <= SAME:
            ends[:, n] = LOW
    start = np.array([found for found in here if found is not None])
    guessed = start[:, None] + changes[:, np.arange(len(factors)), ends].sum(2)
    fitting = np.flatnonzero((guessed[1:] > 0.0).all(0))
    if not fitting.size:
        return None
    return _descended(variations, told, factors, ends[fitting[np.argmin(guessed[0, fitting])]].tolist())


def _alone(
    variations: Variations, told: Sequence[Margin], known: Sequence[Variation], own: Variation
) -> tuple[Array, Array]:
    """What either end multiplies each number by, (n, 3), and by how much that alone changes each margin, (m, n, 3)."""
    symbols = [held.symbol for held in variations.symbols]
    factors, changes = np.ones((len(symbols), SIDES)), np.zeros((len(told), len(symbols), SIDES))
    here = np.array([each(own) or 0.0 for each in told])
    for other in known:
        moved = [n for n, symbol in enumerate(symbols) if other.values[symbol] != own.values[symbol]]
        if len(moved) == 1:
            times = other.values[symbols[moved[0]]] / own.values[symbols[moved[0]]]
            side = HIGH if times > 1.0 else LOW
            factors[moved[0], side] = times
            changes[:, moved[0], side] = np.array([each(other) or 0.0 for each in told]) - here
    return factors, changes


def _descended(variations: Variations, told: Sequence[Margin], factors: Array, ends: list[int]) -> Variation | None:
    """The scene with some ends, and then with each number at another end where that lessens the first margin."""

    def at(ends: Sequence[int]) -> tuple[Variation | None, float]:
        times = factors[np.arange(len(ends)), ends].tolist()
        found = variations.having([held.value * by for held, by in zip(variations.symbols, times, strict=True)])
        if found is None or any((each(found) or 0.0) < 0.0 for each in told[1:]):
            return found, inf
        least = told[0](found)
        return found, inf if least is None else least

    best, least = at(ends)
    for n, side in product(range(len(ends)), range(SIDES)):
        if least <= 0.0:
            break
        if factors[n, side] != factors[n, ends[n]]:
            tried = [*ends[:n], side, *ends[n + 1 :]]
            other, found = at(tried)
            if found < least:
                ends, best, least = tried, other, found
    return best

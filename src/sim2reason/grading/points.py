"""Test points for formulas: unpredictable values of all symbols within their ranges."""

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from hashlib import blake2b
from itertools import islice
from typing import Final

from sim2reason.grading import arithmetic
from sim2reason.grading.alphabet import is_angle
from sim2reason.grading.arithmetic import Node

__all__ = ["POINTS", "Bindings", "Ranges", "draw_points", "opposite_sign_points", "well_conditioned_points"]

POINTS: Final = 8
MAX_CANDIDATES: Final = 128  # candidate points
USUAL: Final = 0.2, 1.5  # default range of a positive quantity, all of one magnitude; angles acute
WIDE: Final = 1e-3, 5.0  # range over several decades, in which single terms of a formula dominate
MAX_FACTOR: Final = 3.0  # largest factor between a given value and a test value
AFAR: Final = 20.0  # largest factor in the search for a value of the opposite sign
FAR_TRIES, TURNED = 24, 2
RIGHT_ANGLE: Final = math.pi / 2
MARGIN: Final = 0.01  # of a right angle, between angles and its multiples
STEP: Final = 1e-9
STEEPEST: Final = 1e4  # condition number above which a value has lost its digits

Bindings = Mapping[str, float]
Ranges = Mapping[str, tuple[float, float]]


def _share(*seed: object) -> float:
    """Return a pseudo-random number in [0, 1) determined by `seed`."""
    digest = blake2b("\0".join(map(str, seed)).encode(errors="replace"), digest_size=8).digest()
    return int.from_bytes(digest) / 2**64


def draw_points(
    node: Node, table: Collection[str], given: Sequence[Bindings], ranges: Ranges, seed: str
) -> Iterator[Bindings]:
    """Yield values of all symbols at which the correct formula has a value, near given values or within ranges."""
    names = sorted(table)
    if given:
        around = (_around(given[attempt % len(given)], names, seed, attempt) for attempt in range(MAX_CANDIDATES))
        yield from _valued(node, around)
        return
    for low, high in (USUAL, WIDE):
        ends = {name: _ends(name, ranges, low, high) for name in names}
        yield from _valued(node, (_within(ends, seed, attempt, low) for attempt in range(MAX_CANDIDATES)))


def opposite_sign_points(
    node: Node, table: Collection[str], given: Sequence[Bindings], sign: float, seed: str
) -> list[Bindings]:
    """Return values of the symbols at which the correct formula has the opposite sign, to detect a lost sign."""
    names = sorted(table)
    far = (_around(given[attempt % len(given)], names, seed, POINTS + attempt, AFAR) for attempt in range(FAR_TRIES))
    return list(islice((point for point in far if (arithmetic.value(node, point) or 0.0) * sign < 0.0), TURNED))


def _valued(node: Node, points: Iterator[Bindings]) -> Iterator[Bindings]:
    return islice((point for point in points if well_conditioned_points(node, [point])), POINTS)


def _ends(name: str, ranges: Ranges, low: float, high: float) -> tuple[float, float]:
    if name in ranges:
        return ranges[name]
    return (low, min(high, USUAL[1])) if is_angle(name) else (low, high)


def _within(ends: Ranges, seed: str, attempt: int, scale: float) -> Bindings:
    """Return a random value of each symbol within its range; on a logarithmic scale if the range is wide."""
    point: dict[str, float] = {}
    for name, (low, high) in ends.items():
        share = _share(seed, attempt, name, scale)
        spread = low > 0 and high / low > MAX_FACTOR**3
        point[name] = low * (high / low) ** share if spread else low + (high - low) * share
    return point


def _around(given: Bindings, names: Sequence[str], seed: str, attempt: int, far: float = MAX_FACTOR) -> Bindings:
    """Return given values of the symbols, each times a random factor; angles stay in their quadrants."""
    point: dict[str, float] = {}
    for name in names:
        value, share = given[name], _share(seed, attempt, name)
        low, high = value / far, value * far
        if is_angle(name) and value > 0:
            quadrant = value // RIGHT_ANGLE
            low, high = max(low, (quadrant + MARGIN) * RIGHT_ANGLE), (quadrant + 1 - MARGIN) * RIGHT_ANGLE
        point[name] = low * (high / low) ** share if value else share
    return point


def well_conditioned_points(node: Node, points: Sequence[Bindings]) -> list[tuple[Bindings, float]]:
    """Return the test points, each with the formula's value, at which small changes of symbols change it little."""
    found: list[tuple[Bindings, float]] = []
    for point in points:
        value = arithmetic.value(node, point)
        if value:
            moved = arithmetic.value(
                node, {name: x * (1 + STEP * (1 + n % 3)) for n, (name, x) in enumerate(point.items())}
            )
            if moved is not None and abs(moved - value) <= STEEPEST * STEP * abs(value):
                found.append((point, value))
    return found

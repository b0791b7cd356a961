"""Floating-point expressions as functions of symbol values, and test points at which they are compared."""

import math
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from hashlib import blake2b
from itertools import islice
from math import isfinite
from typing import Final

from sim2reason.grading.alphabet import is_angle
from sim2reason.grading.score import Outcome, Refused

__all__ = [
    "CONSTANTS",
    "TEST_POINTS",
    "Bindings",
    "Node",
    "Ranges",
    "call",
    "constant",
    "degrees",
    "draw_points",
    "inverse",
    "negated",
    "opposite_sign_points",
    "power",
    "product",
    "root",
    "symbol",
    "total",
    "value",
    "well_conditioned_points",
]

Node = Callable[[Mapping[str, float]], float]

CONSTANTS: Final = {"pi": math.pi, "e": math.e, "inf": math.inf}


def _reciprocal(function: Callable[[float], float]) -> Callable[[float], float]:
    return lambda x: 1 / function(x)


def _apply_to_reciprocal(function: Callable[[float], float]) -> Callable[[float], float]:
    return lambda x: function(1 / x)


_FUNCTIONS: Final[dict[str, Callable[[float], float]]] = {
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "cot": _reciprocal(math.tan),
    "sec": _reciprocal(math.cos),
    "csc": _reciprocal(math.sin),
    "arcsin": math.asin,
    "arccos": math.acos,
    "arctan": math.atan,
    "arccot": _apply_to_reciprocal(math.atan),
    "arcsec": _apply_to_reciprocal(math.acos),
    "arccsc": _apply_to_reciprocal(math.asin),
    "sinh": math.sinh,
    "cosh": math.cosh,
    "tanh": math.tanh,
    "coth": _reciprocal(math.tanh),
    "arsinh": math.asinh,
    "arcosh": math.acosh,
    "artanh": math.atanh,
    "exp": math.exp,
    "ln": math.log,
    "log": math.log,
    "log_e": math.log,
    "log_10": math.log10,
    "log_2": math.log2,
    "sqrt": math.sqrt,
    "abs": abs,
}
_ALIASES: Final = {"asin": "arcsin", "acos": "arccos", "atan": "arctan"} | {
    spelling: name for name in ("arsinh", "arcosh", "artanh") for spelling in (f"arc{name[2:]}", f"a{name[2:]}")
}
_HYPERBOLIC: Final = {"sinh": "arsinh", "cosh": "arcosh", "tanh": "artanh"}


def _finite(x: float) -> float:
    if not isfinite(x):
        raise OverflowError
    return x


def value(node: Node, bindings: Mapping[str, float]) -> float | None:
    """Return the value of an expression for given symbol values; None where it is not a finite real number."""
    try:
        result = node(bindings)
    except (ArithmeticError, ValueError):
        return None
    return result if isfinite(result) else None


def constant(x: float) -> Node:
    """Return a constant as an expression; with an infinite constant every result is undefined."""
    return (lambda _: x) if isfinite(x) else (lambda _: _finite(x))


def symbol(name: str) -> Node:
    """Return an expression whose value is that of a symbol."""
    return lambda bindings: bindings[name]


def negated(node: Node) -> Node:
    """Return the expression for minus `node`."""
    return lambda bindings: -node(bindings)


def degrees(node: Node) -> Node:
    """Return an expression that converts an angle from degrees to radians."""
    return lambda bindings: math.radians(node(bindings))


def total(terms: Sequence[tuple[Node, bool]]) -> Node:
    """Return the sum of expressions, each with whether it is subtracted, evaluated without recursion."""
    if len(terms) == 1:
        return negated(terms[0][0]) if terms[0][1] else terms[0][0]

    def evaluate(bindings: Mapping[str, float]) -> float:
        result = 0.0
        for node, minus in terms:
            result = result - node(bindings) if minus else result + node(bindings)
        return result if isfinite(result) else _finite(result)

    return evaluate


def product(factors: Sequence[tuple[Node, bool]]) -> Node:
    """Return the product of expressions, each with whether it divides, from left to right."""
    if len(factors) == 1 and not factors[0][1]:
        return factors[0][0]

    def evaluate(bindings: Mapping[str, float]) -> float:
        result = 1.0
        for node, divides in factors:
            result = result / node(bindings) if divides else result * node(bindings)
        return result if isfinite(result) else _finite(result)  # each factor is finite, so a step that was not stays so

    return evaluate


def power(base: Node, exponent: Node) -> Node:
    """Return a real power; a negative base with a fractional exponent is undefined."""

    def evaluate(bindings: Mapping[str, float]) -> float:
        result = math.pow(base(bindings), exponent(bindings))
        return result if isfinite(result) else _finite(result)

    return evaluate


def root(radicand: Node, index: Node) -> Node:
    """Return the real root, also of a negative number if the index is odd."""

    def evaluate(bindings: Mapping[str, float]) -> float:
        x, n = radicand(bindings), index(bindings)
        odd = n % 2 == 1
        return math.copysign(math.pow(abs(x), 1 / n), x) if odd else math.pow(x, 1 / n)

    return evaluate


def call(name: str, argument: Node) -> Node:
    """Return an elementary function, by name, of `argument`."""
    function = _FUNCTIONS.get(_ALIASES.get(name, name))
    if function is None:
        raise Refused(Outcome.UNREADABLE, f"{name!r} is no function that is known here")

    def evaluate(bindings: Mapping[str, float]) -> float:
        result = function(argument(bindings))
        return result if isfinite(result) else _finite(result)

    return evaluate


def inverse(name: str) -> str:
    r"""Return the name of the inverse function that ``\name^{-1}`` denotes, such as arcsin for sin."""
    return _HYPERBOLIC.get(name, f"arc{name}")


TEST_POINTS: Final = 8
MAX_CANDIDATES: Final = 128  # candidate points
USUAL_RANGE: Final = 0.2, 1.5  # default range of a positive quantity, all of one magnitude; angles acute
WIDE_RANGE: Final = 1e-3, 5.0  # range over several decades, in which single terms of a formula dominate
MAX_FACTOR: Final = 3.0  # largest factor between a given value and a test value
MAX_FAR_FACTOR: Final = 20.0  # largest factor in the search for a value of the opposite sign
FAR_TRIES, TURNED = 24, 2
RIGHT_ANGLE: Final = math.pi / 2
ANGLE_MARGIN: Final = 0.01  # of a right angle, between angles and its multiples
DIFFERENCE_RTOL: Final = 1e-9
MAX_CONDITION_NUMBER: Final = 1e4  # condition number above which a value has lost its digits

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
        around = (_draw_around(given[attempt % len(given)], names, seed, attempt) for attempt in range(MAX_CANDIDATES))
        yield from _valued(node, around)
        return
    for low, high in (USUAL_RANGE, WIDE_RANGE):
        ends = {name: _ends(name, ranges, low, high) for name in names}
        yield from _valued(node, (_within(ends, seed, attempt, low) for attempt in range(MAX_CANDIDATES)))


def opposite_sign_points(
    node: Node, table: Collection[str], given: Sequence[Bindings], sign: float, seed: str
) -> list[Bindings]:
    """Return values of the symbols at which the correct formula has the opposite sign, to detect a lost sign."""
    names = sorted(table)
    far = (
        _draw_around(given[attempt % len(given)], names, seed, TEST_POINTS + attempt, MAX_FAR_FACTOR)
        for attempt in range(FAR_TRIES)
    )
    return list(islice((point for point in far if (value(node, point) or 0.0) * sign < 0.0), TURNED))


def _valued(node: Node, points: Iterator[Bindings]) -> Iterator[Bindings]:
    return islice((point for point in points if well_conditioned_points(node, [point])), TEST_POINTS)


def _ends(name: str, ranges: Ranges, low: float, high: float) -> tuple[float, float]:
    if name in ranges:
        return ranges[name]
    return (low, min(high, USUAL_RANGE[1])) if is_angle(name) else (low, high)


def _within(ends: Ranges, seed: str, attempt: int, scale: float) -> Bindings:
    """Return a random value of each symbol within its range; on a logarithmic scale if the range is wide."""
    point: dict[str, float] = {}
    for name, (low, high) in ends.items():
        share = _share(seed, attempt, name, scale)
        spread = low > 0 and high / low > MAX_FACTOR**3
        point[name] = low * (high / low) ** share if spread else low + (high - low) * share
    return point


def _draw_around(given: Bindings, names: Sequence[str], seed: str, attempt: int, far: float = MAX_FACTOR) -> Bindings:
    """Return given values of the symbols, each times a random factor; angles stay in their quadrants."""
    point: dict[str, float] = {}
    for name in names:
        stated, share = given[name], _share(seed, attempt, name)
        low, high = stated / far, stated * far
        if is_angle(name) and stated > 0:
            quadrant = stated // RIGHT_ANGLE
            low, high = max(low, (quadrant + ANGLE_MARGIN) * RIGHT_ANGLE), (quadrant + 1 - ANGLE_MARGIN) * RIGHT_ANGLE
        point[name] = low * (high / low) ** share if stated else share
    return point


def well_conditioned_points(node: Node, points: Sequence[Bindings]) -> list[tuple[Bindings, float]]:
    """Return the test points, each with the formula's value, at which small changes of symbols change it little."""
    stable_points: list[tuple[Bindings, float]] = []
    for point in points:
        here = value(node, point)
        if here:
            moved = value(
                node, {name: x * (1 + DIFFERENCE_RTOL * (1 + n % 3)) for n, (name, x) in enumerate(point.items())}
            )
            if moved is not None and abs(moved - here) <= MAX_CONDITION_NUMBER * DIFFERENCE_RTOL * abs(here):
                stable_points.append((point, here))
    return stable_points

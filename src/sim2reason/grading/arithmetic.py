"""Floating-point expressions as functions of symbol values; undefined or infinite steps make the value undefined."""

import math
from collections.abc import Callable, Mapping, Sequence
from math import isfinite
from typing import Final

from sim2reason.grading.score import Outcome, Refused

__all__ = [
    "CONSTANTS",
    "Node",
    "call",
    "constant",
    "degrees",
    "inverse",
    "negated",
    "power",
    "product",
    "root",
    "symbol",
]
__all__ += ["total", "value"]

Node = Callable[[Mapping[str, float]], float]

CONSTANTS: Final = {"pi": math.pi, "e": math.e, "inf": math.inf}


def _reciprocal(function: Callable[[float], float]) -> Callable[[float], float]:
    return lambda x: 1 / function(x)


def _of_reciprocal(function: Callable[[float], float]) -> Callable[[float], float]:
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
    "arccot": _of_reciprocal(math.atan),
    "arcsec": _of_reciprocal(math.acos),
    "arccsc": _of_reciprocal(math.asin),
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
        found = node(bindings)
    except (ArithmeticError, ValueError):
        return None
    return found if isfinite(found) else None


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

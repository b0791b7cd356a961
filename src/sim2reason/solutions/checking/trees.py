"""Values and derivatives of prefix trees such as ``["+", ["*", "m", "g"], 3.0]``; strings are symbols.

Operations: ``+`` and ``*`` of any number of parts, ``/``, ``^`` with a whole exponent, ``sqrt``, ``abs``, ``sin``,
``cos``, ``tan``, ``arcsin``, ``arccos``, ``arctan``, ``ln``, ``exp``, ``pi``, ``elliptic K`` of a modulus,
``elliptic F`` and ``amplitude`` of an argument and a modulus; ``["worked", tree, number]``, a formula with its stated
value; ``["root", name, tree, near]``, the zero of a formula in `name` close to a number; and ``["solve", near]``, the
value close to a number for which all earlier relations hold.
"""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import reduce
from itertools import pairwise
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from sim2reason.solutions.checking.numerical_methods import ELLIPTIC_ARITY, ELLIPTIC_FUNCTIONS

Tree: TypeAlias = float | str | list["Tree"]
Values = Mapping[str, float]
Derived = tuple[float, dict[str, float]]
"""A value with its partial derivatives."""
Array: TypeAlias = npt.NDArray[np.float64]
EvaluateAll = Callable[[Mapping[str, float | Array]], float | Array]

NODES, DEPTH = 4000, 100  # most nodes and greatest depth of a tree
NEWTON_ITERATIONS = 60  # of Newton's method
CONVERGENCE_RTOL = 4e-16  # relative
STATED_ROOT_RTOL = 1e-4  # relative: rounding of roots, which are stated to five digits
SAMPLES = 8  # subintervals searched for other roots
FUNCTIONS: Mapping[str, tuple[Callable[[float], float], Callable[[float], float]]] = {
    "sqrt": (math.sqrt, lambda x: 0.5 / math.sqrt(x)),
    "abs": (abs, lambda x: math.copysign(1.0, x)),
    "sin": (math.sin, math.cos),
    "cos": (math.cos, lambda x: -math.sin(x)),
    "tan": (math.tan, lambda x: 1.0 / math.cos(x) ** 2),
    "arcsin": (math.asin, lambda x: 1.0 / math.sqrt(1.0 - x * x)),
    "arccos": (math.acos, lambda x: -1.0 / math.sqrt(1.0 - x * x)),
    "arctan": (math.atan, lambda x: 1.0 / (1.0 + x * x)),
    "ln": (math.log, lambda x: 1.0 / x),
    "exp": (math.exp, math.exp),
}  # functions with their derivatives
VECTORS: Mapping[str, Callable[[Any], Any]] = {name: getattr(np, {"ln": "log"}.get(name, name)) for name in FUNCTIONS}
ARITY = {**ELLIPTIC_ARITY, "/": 2, "^": 2, "pi": 0, "worked": 2, "root": 3, "solve": 1} | dict.fromkeys(FUNCTIONS, 1)


class TreeError(ValueError):
    """An error raised for a tree that is malformed or has no value."""


def check(tree: Tree) -> None:
    """Raise TreeError if a tree is malformed or too large."""
    waiting: list[tuple[Tree, int]] = [(tree, 0)]
    for _ in range(NODES):
        if not waiting:
            return
        node, depth = waiting.pop()
        if depth > DEPTH:
            break
        if isinstance(node, list):
            _check_operation(node)
            waiting += [(part, depth + 1) for part in node[1:]]
        elif not isinstance(node, str) and not math.isfinite(node):
            raise TreeError(f"{node} is no number")
    raise TreeError("a formula is too large")


def _check_operation(node: list[Tree]) -> None:
    """Raise TreeError if an operation is unknown or has a wrong number of operands."""
    operation = node[0] if node else None
    if not isinstance(operation, str) or (operation not in ARITY and operation not in ("+", "*")):
        raise TreeError(f"there is no operation {operation!r}")
    if len(node) - 1 != ARITY.get(operation, max(1, len(node) - 1)):
        raise TreeError(f"the operation {operation!r} has {len(node) - 1} parts")
    number = {"^": 2, "worked": 2, "root": 3, "solve": 1}.get(operation)
    if number is not None and not isinstance(node[number], float | int):
        raise TreeError(f"the operation {operation!r} needs a number in place {number}")
    if operation == "root" and not isinstance(node[1], str):
        raise TreeError("the unknown of an equation must be a symbol")


def symbols(tree: Tree) -> Iterator[str]:
    """Yield the free symbols of a tree from left to right, with repetitions."""
    if isinstance(tree, str):
        yield tree
    elif isinstance(tree, list):
        if tree[0] == "root":
            yield from (name for name in symbols(tree[2]) if name != tree[1])
        else:
            for part in tree[1:]:
                if isinstance(part, str):
                    yield part
                elif isinstance(part, list):
                    yield from symbols(part)


def parts_named(tree: Tree, operation: str) -> Iterator[list[Tree]]:
    """Yield the subtrees with a given operation, except those within the equations of roots."""
    if isinstance(tree, list):
        if tree[0] == operation:
            yield tree
        if tree[0] != "root":
            for part in tree[1:]:
                if isinstance(part, list):
                    yield from parts_named(part, operation)


def compiled_for_many(tree: Tree) -> EvaluateAll:
    """Compile a tree to a function of arrays of values; it returns NaN where the tree is undefined."""
    if isinstance(tree, str):
        return lambda at: at[tree]
    if not isinstance(tree, list):
        return _constant(float(tree))
    operation, *rest = tree
    if operation == "pi":
        return _constant(math.pi)
    if operation in ("root", "solve") or operation in ELLIPTIC_FUNCTIONS:
        raise TreeError(f"the operation {operation!r} can't stand here")
    parts = [compiled_for_many(part) for part in rest]
    if operation == "^":
        base, exponent = parts[0], int(float(rest[1]))  # type: ignore[arg-type]
        return lambda at: base(at) ** exponent
    return parts[0] if operation == "worked" else _applied(str(operation), parts)


def _constant(number: float) -> Callable[[Any], float]:
    return lambda _: number


def _applied(operation: str, parts: list[EvaluateAll]) -> Callable[[Any], Any]:
    one, other = parts[0], parts[-1]
    if operation == "/":
        return lambda at: one(at) / other(at)
    if operation in FUNCTIONS:
        function = VECTORS[operation]
        return lambda at: function(one(at))
    if len(parts) == 2:
        return (lambda at: one(at) + other(at)) if operation == "+" else (lambda at: one(at) * other(at))
    if operation == "*":
        return lambda at: math.prod([part(at) for part in parts])
    return lambda at: sum(part(at) for part in parts)


def value(tree: Tree, at: Values) -> float:
    """Return the value of a tree for given values of its symbols."""
    if isinstance(tree, str):
        return at[tree]
    if not isinstance(tree, list):
        return float(tree)
    operation, *rest = tree
    match operation:
        case "root":
            return root(tree, at)
        case "worked":
            return value(rest[0], at)
        case "^":
            return value(rest[0], at) ** int(float(rest[1]))  # type: ignore[arg-type]
        case _:
            return _operated(str(operation), [value(part, at) for part in rest])


def _operated(operation: str, parts: Sequence[float]) -> float:
    """Return the value of an operation on numbers."""
    match operation:
        case "pi":
            return math.pi
        case "+":
            return parts[0] + parts[1] if len(parts) == 2 else math.fsum(parts)
        case "*":
            return parts[0] * parts[1] if len(parts) == 2 else math.prod(parts)
        case "/":
            return parts[0] / parts[1]
        case name if name in FUNCTIONS:
            return FUNCTIONS[name][0](parts[0])
        case name if name in ELLIPTIC_FUNCTIONS:
            return float(ELLIPTIC_FUNCTIONS[name](*parts)[0])
        case name:
            raise TreeError(f"the operation {name!r} can't stand here")


def terms(tree: Tree) -> list[Tree]:
    """Return the terms of a sum; any other tree is its own only term."""
    return tree[1:] if isinstance(tree, list) and tree[0] == "+" else [tree]


def largest_term(tree: Tree, at: Values) -> float:
    """Return the magnitude of the largest term of a tree."""
    return max(abs(value(term, at)) for term in terms(tree))


def magnitude_bound(tree: Tree, at: Values) -> float:
    """Return the value of a tree with all terms taken as positive; ArithmeticError or ValueError if undefined."""
    if not isinstance(tree, list) or tree[0] in ("root", "pi"):
        return abs(value(tree, at))
    operation, *parts = tree
    if operation == "+":
        return math.fsum(magnitude_bound(part, at) for part in parts)
    if operation == "*":
        return math.prod(magnitude_bound(part, at) for part in parts)
    if operation == "/":
        return magnitude_bound(parts[0], at) / abs(value(parts[1], at))
    if operation == "^" and float(parts[1]) > 0.0:  # type: ignore[arg-type]
        return magnitude_bound(parts[0], at) ** int(float(parts[1]))  # type: ignore[arg-type]
    return magnitude_bound(parts[0], at) if operation == "worked" else abs(value(tree, at))


def derivatives(tree: Tree, at: Values) -> Derived:
    """Return a tree's value and partial derivatives; ArithmeticError or ValueError if it is undefined."""
    if isinstance(tree, str):
        return at[tree], {tree: 1.0}
    if not isinstance(tree, list):
        return float(tree), {}
    operation, *rest = tree
    if operation == "root":
        return _root_derivatives(tree, at)
    if operation == "^":
        (x, slopes), n = derivatives(rest[0], at), int(float(rest[1]))  # type: ignore[arg-type]
        return x**n, _combined([(n * x ** (n - 1), slopes)])
    if operation == "worked":
        return derivatives(rest[0], at)
    return _combination(str(operation), [derivatives(part, at) for part in rest])


def _combination(operation: str, parts: Sequence[Derived]) -> Derived:
    """Return the value and derivatives of an operation on values with derivatives."""
    match operation, parts:
        case "pi", _:
            return math.pi, {}
        case "+", _:
            return math.fsum(x for x, _ in parts), _combined((1.0, slopes) for _, slopes in parts)
        case "*", _:
            return reduce(_product, parts)
        case "/", ((x, over), (y, under)):
            return x / y, _combined([(1.0 / y, over), (-x / y**2, under)])
        case name, _ if name in ELLIPTIC_FUNCTIONS:
            integral, by = ELLIPTIC_FUNCTIONS[name](*(x for x, _ in parts))
            return integral, _combined((slope, slopes) for slope, (_, slopes) in zip(by, parts, strict=True))
        case _:
            (x, slopes), *_ = parts
            function, slope = FUNCTIONS[operation]
            return function(x), _combined([(slope(x), slopes)]) if slopes else {}


def _combined(parts: Iterable[tuple[float, Mapping[str, float]]]) -> dict[str, float]:
    """Return a linear combination of gradients."""
    gradient: dict[str, float] = {}
    for factor, slopes in parts:
        for name, slope in slopes.items():
            gradient[name] = gradient.get(name, 0.0) + factor * slope
    return gradient


def _product(one: Derived, other: Derived) -> Derived:
    """Return the value and derivatives of a product."""
    return one[0] * other[0], _combined([(other[0], one[1]), (one[0], other[1])])


def _root_derivatives(tree: list[Tree], at: Values) -> Derived:
    """Return the value and derivatives of a root by the implicit function theorem."""
    name, x = str(tree[1]), root(tree, at)
    _, slopes = derivatives(tree[2], {**at, name: x})
    own = slopes.pop(name)
    return x, {other: -slope / own for other, slope in slopes.items()}


def root(tree: list[Tree], at: Values) -> float:
    """Find the root of ``["root", name, residual, near]`` by Newton's method; TreeError if it does not converge."""
    _, name, residual, near = tree
    assert isinstance(name, str)
    there, x = dict(at), float(near)  # type: ignore[arg-type]
    last = math.inf
    for _ in range(NEWTON_ITERATIONS):
        there[name] = x
        off, slopes = derivatives(residual, there)
        slope = slopes.get(name, 0.0)
        if not slope:
            break
        step = off / slope
        if abs(step) <= CONVERGENCE_RTOL * abs(x) or (abs(step) >= 0.5 * last and abs(step) <= 1e-12 * abs(x)):
            return x
        x, last = x - step, abs(step)
    raise TreeError(f"no root for {name} near {near}")


def has_other_root(tree: list[Tree], at: Values) -> bool:
    """Return whether the interval of numbers with the stated digits contains a second root, or no root."""
    _, name, residual, near = tree
    middle = float(near)  # type: ignore[arg-type]
    if abs(root(tree, at) - middle) > STATED_ROOT_RTOL * abs(middle):
        return True
    places = [middle * (1.0 + STATED_ROOT_RTOL * (2.0 * n / SAMPLES - 1.0) * 1.01) for n in range(SAMPLES + 1)]
    signs = [math.copysign(1.0, value(residual, {**at, str(name): x})) for x in places]
    return sum(one != other for one, other in pairwise(signs)) > 1


def tree_text(tree: Tree) -> str:
    """Return a tree on one line, for error messages."""
    if not isinstance(tree, list):
        return tree if isinstance(tree, str) else f"{tree:.6g}"
    return f"{tree[0]}({', '.join(map(tree_text, tree[1:]))})"

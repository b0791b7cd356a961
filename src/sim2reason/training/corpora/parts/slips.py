"""Slips: formulas of a solution as somebody writes them who takes the wrong function, sign, factor or too few terms.

What follows from a slip is worked out all the same, so that its result is what such a person would get. Models that
learn by trial need something to choose among: solutions of mixed quality, as any collected from the world are.
"""

from collections.abc import Callable, Iterator, Mapping
from typing import Final

import numpy as np

from sim2reason.solutions.algebra.expressions import Expression, Number, Product, Sum
from sim2reason.solutions.algebra.functions import Call
from sim2reason.training.corpora.parts.operations import Definitions

__all__ = ["SLIPS", "slipped"]

Changes = Callable[[Expression], Iterator[Expression]]
"""All ways in which a formula, apart from its parts, is changed by one slip."""


def _function(held: Expression) -> Iterator[Expression]:
    """Sine for cosine, and the other way round."""
    match held:
        case Call("sin", angle):
            yield Call("cos", angle)
        case Call("cos", angle):
            yield Call("sin", angle)
        case _:
            pass


def _factor(held: Expression) -> Iterator[Expression]:
    """Without the number in front, as in a half or two thirds."""
    match held:
        case Product((Number(x), *rest)) if abs(x) != 1.0:
            yield Number(1.0 if x > 0.0 else -1.0) * held.built_of(rest)
        case _:
            pass


def _sign(held: Expression) -> Iterator[Expression]:
    """With another sign of one term."""
    match held:
        case Sum(terms):
            for place in range(1, len(terms)):
                yield held.built_of([-term if n == place else term for n, term in enumerate(terms)])
        case _:
            pass


def _term(held: Expression) -> Iterator[Expression]:
    """Without one term."""
    match held:
        case Sum(terms):
            for place in range(len(terms)):
                yield held.built_of([term for n, term in enumerate(terms) if n != place])
        case _:
            pass


SLIPS: Final[Mapping[str, Changes]] = {"factor": _factor, "function": _function, "sign": _sign, "term": _term}
"""The kinds of slips by name."""


def slipped(held: Definitions, shares: Mapping[str, float], rng: np.random.Generator) -> Definitions:
    """Return the same formulas with slips: each kind is made with its probability, where there is place for one."""
    for kind, share in sorted(shares.items()):
        wrong = rng.random() < share
        ways = [(name, way) for name, formula in held.items() for way in _anywhere(formula, SLIPS[kind])]
        if wrong and ways:
            name, way = ways[int(rng.integers(len(ways)))]
            held = {**held, name: way}
    return held


def _anywhere(held: Expression, changes: Changes) -> Iterator[Expression]:
    """Yield a formula with one slip, in itself or in one of its parts."""
    yield from changes(held)
    for place, part in enumerate(held.parts):
        for changed in _anywhere(part, changes):
            yield held.built_of([changed if n == place else other for n, other in enumerate(held.parts)])

"""Tests that every class of expressions has an entry in the table of required operations."""

import inspect
import pkgutil
import sys
from collections.abc import Iterator
from importlib import import_module

import pytest

import sim2reason.solutions
from sim2reason.questions.difficulty import Need
from sim2reason.solutions.algebra.evaluated import (
    Chain,
    ClosedRoot,
    CompleteElliptic,
    ImplicitRoot,
    NumericFormula,
    NumericRoot,
    QuadraticRoot,
)
from sim2reason.solutions.algebra.expressions import ONE, Expression, Number, Quotient, Symbol
from sim2reason.solutions.algebra.functions import Call, Power, Root, need_of, operation

X, HALF = Symbol("x"), Number(0.5)
KEPLER = X - HALF * Call("sin", X) - ONE


def subclasses(cls: type[Expression]) -> Iterator[type[Expression]]:
    for child in cls.__subclasses__():
        yield child
        yield from subclasses(child)


def test_every_class_of_expressions_has_a_need() -> None:
    """Modules that are not imported elsewhere are included."""
    for module in pkgutil.walk_packages(sim2reason.solutions.__path__, "sim2reason.solutions."):
        import_module(module.name)
    modules = (module for name, module in sys.modules.items() if name.startswith("sim2reason."))
    named = {id(member) for module in modules for member in vars(module).values()}
    ours = [cls for cls in subclasses(Expression) if id(cls) in named]  # slots leave classes behind that nobody has
    assert len(ours) > 15
    for cls in ours:
        if not inspect.isabstract(cls) and not cls.__name__.startswith("_"):
            assert operation(cls) in Need


@pytest.mark.parametrize(
    ("held", "need"),
    [
        (Quotient(X + HALF, Power(X, 3)), Need.ARITHMETIC),
        (Call("cos", X) * Call("tan", X), Need.ARITHMETIC),
        (ONE / Root(X), Need.QUADRATIC),
        (Call("sin", Root(X)), Need.QUADRATIC),
        (Call("arccos", Root(X)), Need.INVERSE_FUNCTION),
        (Call("ln", X), Need.INVERSE_FUNCTION),
        (Call("exp", X) + ONE, Need.INVERSE_FUNCTION),
        (NumericFormula(Root(X), 2.0), Need.QUADRATIC),
        (Chain((("a", Call("arcsin", X)), ("b", Symbol("a") + ONE))), Need.INVERSE_FUNCTION),
        (NumericRoot(KEPLER, "x", 1.5), Need.ROOT),
        (ImplicitRoot(KEPLER, "x", 1.5), Need.ROOT),
        (QuadraticRoot(Power(X, 2) - 2.0, "x", 1.41), Need.QUADRATIC),
        (ONE + CompleteElliptic(HALF), Need.SPECIAL_FUNCTION),
        (ClosedRoot(KEPLER, "x", 1.5, X, Root(HALF)), Need.QUADRATIC),
        (ClosedRoot(KEPLER, "x", 1.5, X, HALF), Need.ARITHMETIC),
    ],
)
def test_the_most_advanced_operation_counts(held: Expression, need: Need) -> None:
    assert need_of(held) == need

"""Tests of formulas as trees: every class has one, and a tree has the value of its formula."""

import json
from collections.abc import Iterator
from math import isclose

import pytest

from sim2reason.solutions.algebra.evaluated import (
    Amplitude,
    Chain,
    ClosedRoot,
    CompleteElliptic,
    ImplicitRoot,
    IncompleteElliptic,
    NumericFormula,
    NumericRoot,
    QuadraticRoot,
)
from sim2reason.solutions.algebra.expressions import Expression, Number, Product, Quotient, Sum, Symbol
from sim2reason.solutions.algebra.functions import PI, Absolute, Call, Power, Root
from sim2reason.solutions.checking.trees import FUNCTIONS, check, derivatives, symbols, value
from sim2reason.solutions.data import tree

X, Y = Symbol("x"), Symbol("y")
AT = {"x": 0.3, "y": 1.7}
FORMULAS = [
    Number(2.5),
    X,
    Sum((X, Y, Number(-1.0))),
    Product((Number(3.0), X, Y)),
    Quotient(X, Y),
    Power(Y, -3),
    Root(Y),
    Absolute(Sum((X, -Y))),
    PI,
    *(Call(name, X) for name in FUNCTIONS if name not in ("sqrt", "abs")),  # type: ignore[arg-type]
    CompleteElliptic(X),
    IncompleteElliptic(Y, X),
    IncompleteElliptic(Product((Number(5.0), Y)), X),
    Amplitude(Y, X),
    Product((NumericFormula(Product((Number(2.0), Y)), 3.4), X)),
    NumericRoot(Sum((Power(Symbol("z"), 2), -Y)), "z", 1.3038),
    ImplicitRoot(Sum((Power(Symbol("z"), 2), -Y)), "z", 1.3038),
    QuadraticRoot(Sum((Power(Symbol("z"), 2), -Y)), "z", 1.3038),
    ClosedRoot(Sum((Power(Symbol("z"), 2), -Y)), "z", 1.3038, Sum((Power(Symbol("z"), 2), Number(-1.7))), Root(Y)),
]


def classes(of: type[Expression] = Expression) -> Iterator[type[Expression]]:
    for found in of.__subclasses__():
        yield found
        yield from classes(found)


@pytest.mark.parametrize("formula", FORMULAS, ids=str)
def test_a_tree_has_the_value_the_derivatives_and_the_symbols_of_its_formula(formula: Expression) -> None:
    held = json.loads(json.dumps(tree(formula)))
    check(held)
    assert {*symbols(held)} == {*formula.symbols()}
    found, slopes = derivatives(held, AT)
    assert isclose(found, complex(formula.value(AT)).real, rel_tol=1e-14)
    assert isclose(value(held, AT), found, rel_tol=1e-14)
    for name, x in AT.items():
        slope = complex(formula.value({**AT, name: x + 1e-30j})).imag / 1e-30
        assert isclose(slopes.get(name, 0.0), slope, rel_tol=1e-12, abs_tol=1e-14)


def test_every_class_of_formulas_has_a_tree() -> None:
    """Private and abstract base classes are left out; chains only occur in the equations of numeric roots."""
    made = {type(held).__name__ for formula in FORMULAS for held in (formula, *formula.parts)}
    ours = {found.__name__ for found in classes() if found.__module__.startswith("sim2reason.")}
    assert {name for name in ours if not name.startswith("_")} == made | {"Chain", "SpecialFunction"}
    solved = NumericRoot(Sum((Chain((("y", Power(X, 2)),)), Number(-2.0))), "x", 1.41421356)
    assert tree(solved) == ["solve", 1.4142]


def test_a_class_without_a_tree_is_an_error() -> None:
    with pytest.raises(TypeError, match="has no tree"):
        tree(Chain((("y", X),)))

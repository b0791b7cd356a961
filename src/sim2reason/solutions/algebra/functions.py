"""Powers, roots, absolute values and elementary functions, and the mathematics that their evaluation needs."""

import cmath
import math
from collections.abc import Iterable, Mapping, Sequence
from functools import cache, lru_cache, reduce
from typing import Literal, cast

import numpy as np

from sim2reason.base.records import record
from sim2reason.questions.difficulty import Need, most_advanced
from sim2reason.scenes.dsl.state import Array
from sim2reason.solutions.algebra.evaluated import (
    Chain,
    ClosedRoot,
    NumericFormula,
    NumericRoot,
    QuadraticRoot,
    SpecialFunction,
)
from sim2reason.solutions.algebra.expressions import (
    ONE,
    ZERO,
    Expression,
    Number,
    Product,
    Quotient,
    Scalar,
    Sum,
    Symbol,
    Values,
    multiply_factors,
    parenthesized,
    ratio,
    sum_terms,
)

Function = Literal["sin", "cos", "tan", "arctan", "arccos", "arcsin", "ln", "exp"]
MATH_NAMES = {"arctan": "atan", "arccos": "acos", "arcsin": "asin"}  # where the names in `math` differ from NumPy's


def _applied(name: str, inside: Scalar) -> Scalar:
    """Apply a named function to a number or elementwise to an array."""
    if isinstance(inside, np.ndarray):
        return getattr(np, name)(inside)
    return getattr(cmath if isinstance(inside, complex) else math, MATH_NAMES.get(name, name))(inside)


@record(slots=True, hashed_once=True)
class Power(Expression):
    """An integer power."""

    base: Expression
    exponent: int

    @property
    def parts(self) -> tuple[Expression, ...]:
        """Return the base."""
        return (self.base,)

    def built_of(self, parts: Sequence[Expression]) -> Expression:
        """Return the power of another base."""
        (base,) = parts
        return Power(base, self.exponent)

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Return the power."""
        return self.base.value(at, digits) ** self.exponent

    def _written(self) -> str:
        """Return the power in LaTeX; the exponent of a sine stands before its argument."""
        if isinstance(self.base, Call) and self.base.function != "exp":
            return rf"\{self.base.function}^{{{self.exponent}}} {parenthesized(self.base.argument, 2)}"
        inner = -self.base if self.exponent % 2 == 0 and self.base.negative else self.base  # (−x)² is x²
        base = rf"\left({inner.latex()}\right)" if isinstance(inner, Power | Number | Call) else parenthesized(inner, 2)
        if isinstance(inner, Symbol) and "'" in inner.name:
            base = f"{{{base}}}"  # in TeX a prime is a superscript, and a second one is an error
        return f"{base}^{{{self.exponent}}}"


@record(slots=True, hashed_once=True)
class _UnaryFunction(Expression):
    """A function of one formula."""

    inside: Expression

    @property
    def parts(self) -> tuple[Expression, ...]:
        """Return the argument."""
        return (self.inside,)

    def built_of(self, parts: Sequence[Expression]) -> Expression:
        """Return the same function of another argument."""
        (inside,) = parts
        return type(self)(inside)


@record(slots=True, hashed_once=True)
class Root(_UnaryFunction):
    """A nonnegative square root."""

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Return the square root; ValueError for negative radicands."""
        return _applied("sqrt", self.inside.value(at, digits))

    def _written(self) -> str:
        """Return the root in LaTeX."""
        return rf"\sqrt{{{self.inside.latex()}}}"


@record(slots=True, hashed_once=True)
class Call(Expression):
    """An elementary function of an angle in radians or of a ratio."""

    function: Function
    argument: Expression

    @property
    def parts(self) -> tuple[Expression, ...]:
        """Return the argument."""
        return (self.argument,)

    def built_of(self, parts: Sequence[Expression]) -> Expression:
        """Return the same function of another argument."""
        (argument,) = parts
        return Call(self.function, argument)

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Return the value of the function."""
        return _applied("log" if self.function == "ln" else self.function, self.argument.value(at, digits))

    def _written(self) -> str:
        """Return the function in LaTeX; a symbol as its argument has no parentheses."""
        inside = self.argument.latex()
        if isinstance(self.argument, Symbol):
            return rf"\{self.function}{inside if inside.startswith(chr(92)) else ' ' + inside}"
        return rf"\{self.function}\left({inside}\right)"


@record(slots=True, hashed_once=True)
class Absolute(_UnaryFunction):
    """An absolute value."""

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Return the absolute value; a complex value gets the sign of its real part, to stay differentiable."""
        inside = self.inside.value(at, digits)
        if isinstance(inside, np.ndarray):
            return np.abs(inside)
        return -inside if inside.real < 0.0 else inside

    def _written(self) -> str:
        """Return the formula between bars."""
        return rf"\left|{self.inside.latex()}\right|"


@record(slots=True, hashed_once=True)
class Pi(Expression):
    """The number π."""

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Return π."""
        del at, digits
        return math.pi

    def _written(self) -> str:
        """Return the LaTeX of π."""
        return r"\pi"


PI = Pi()


def simplify_inverse(expression: Expression) -> Expression:
    """Simplify a function of an inverse function, such as sin(arccos x) to √(1 − x²); return others unchanged."""
    if not isinstance(expression, Call) or not isinstance(expression.argument, Call):
        return expression
    x = expression.argument.argument
    beside = Root(ONE - Power(x, 2)) if expression.argument.function != "arctan" else Root(ONE + Power(x, 2))
    undone: dict[tuple[Function, Function], Expression] = {
        ("sin", "arcsin"): x,
        ("cos", "arccos"): x,
        ("tan", "arctan"): x,
        ("sin", "arccos"): beside,
        ("cos", "arcsin"): beside,
        ("tan", "arcsin"): x / beside,
        ("tan", "arccos"): beside / x,
        ("sin", "arctan"): x / beside,
        ("cos", "arctan"): ONE / beside,
    }
    return undone.get((expression.function, expression.argument.function), expression)


def sum_formulas(parts: Iterable[Expression]) -> Expression:
    """Return the sum of formulas."""
    return reduce(sum_terms, parts, ZERO)


def sum_of_squares(parts: Iterable[Expression]) -> Expression:
    """Return the sum of the squares of formulas, without zeros."""
    return sum_formulas(Power(-part if part.negative else part, 2) for part in parts if part != ZERO)


def vector_length(parts: Iterable[Expression]) -> Expression:
    """Return the length of a vector with given components; a single nonzero one gives its absolute value."""
    kept = [part for part in parts if part != ZERO]
    if len(kept) != 1:
        return Root(sum_of_squares(kept))
    (lone,) = kept
    return Absolute(-lone if lone.negative else lone)


def array_values(expression: Expression, at: Mapping[str, Array]) -> Array:
    """Return the values of a formula, (m,), for arrays of values of its symbols; NaN where it is undefined."""
    with np.errstate(all="ignore"):
        values = expression.value(cast("Values", at))
    return np.where(np.isfinite(values), values, np.nan) * np.ones_like(next(iter(at.values())))


ODD_FUNCTIONS = ("sin", "tan", "arcsin", "arctan")


def with_plain_signs(expression: Expression) -> Expression:
    """Rewrite a formula with as few minus signs as in handwriting; its value is unchanged."""
    if not expression.parts or isinstance(expression, NumericFormula):
        return expression
    rebuilt = expression.built_of([with_plain_signs(part) for part in expression.parts])
    if isinstance(rebuilt, Power) and rebuilt.base.negative and rebuilt.exponent % 2 == 0:
        return Power(_opposite(rebuilt.base), rebuilt.exponent)
    if isinstance(rebuilt, Call) and rebuilt.argument.negative and rebuilt.function in (*ODD_FUNCTIONS, "cos"):
        turned = Call(rebuilt.function, _opposite(rebuilt.argument))
        return turned if rebuilt.function == "cos" else -turned
    if isinstance(rebuilt, Product):
        return _product(rebuilt.factors)
    return _fraction(rebuilt) if isinstance(rebuilt, Quotient) else rebuilt


def _product(factors: Sequence[Expression]) -> Expression:
    """Return a product of factors without signs, with at most one minus sign in front."""
    sign, kept = 1.0, list[Expression]()
    for factor in factors:
        turned = factor.negative if not isinstance(factor, NumericFormula) else factor.comes_to < 0.0
        sign = -sign if turned else sign
        kept.append(_opposite(factor) if turned else factor)
    product = reduce(multiply_factors, kept)
    return product if sign > 0.0 else _negated(product)


def _negated(expression: Expression) -> Expression:
    """Return the negative of a formula; in a fraction, a difference in the denominator is reversed."""
    if isinstance(expression, Quotient) and is_difference(expression.below):
        return Quotient(expression.above, -expression.below)
    return multiply_factors(Number(-1.0), expression)


def _fraction(quotient: Quotient) -> Expression:
    """Return a fraction with its minus sign in front, or removed by reversing a difference in the denominator."""
    if quotient.above.negative and is_difference(quotient.below):
        return Quotient(_opposite(quotient.above), -quotient.below)
    if isinstance(quotient.above, Sum) and quotient.above.negative:
        return multiply_factors(Number(-1.0), Quotient(-quotient.above, quotient.below))
    return quotient


def is_difference(expression: Expression) -> bool:
    """Return whether a formula is a sum with positive and negative terms."""
    return isinstance(expression, Sum) and len({term.negative for term in expression.terms}) > 1


def _opposite(expression: Expression) -> Expression:
    """Return a formula without its leading minus sign."""
    return ratio(_opposite(expression.above), expression.below) if isinstance(expression, Quotient) else -expression


OPERATIONS: Mapping[type[Expression], Need] = {
    Number: Need.ARITHMETIC,
    Symbol: Need.ARITHMETIC,
    Pi: Need.ARITHMETIC,
    Sum: Need.ARITHMETIC,
    Product: Need.ARITHMETIC,
    Quotient: Need.ARITHMETIC,
    Power: Need.ARITHMETIC,
    Absolute: Need.ARITHMETIC,
    NumericFormula: Need.ARITHMETIC,
    Chain: Need.ARITHMETIC,
    ClosedRoot: Need.ARITHMETIC,
    Root: Need.QUADRATIC,
    Call: Need.INVERSE_FUNCTION,
    NumericRoot: Need.ROOT,
    QuadraticRoot: Need.QUADRATIC,
    SpecialFunction: Need.SPECIAL_FUNCTION,
}
"""What it takes to work out an expression of a class, or of a subclass, once all that is inside it is known."""
LEAVES = frozenset[type[Expression]]({Number, Symbol, Pi})
"""Classes without anything inside."""
DIRECT = frozenset[Function]({"sin", "cos", "tan"})  # functions of known angles; all other functions are inverse ones


@lru_cache(maxsize=4096)
def need_of(expression: Expression) -> Need:
    """Return the most advanced mathematics that the evaluation of an expression needs, cached for repeated formulas."""
    cls = type(expression)
    if cls in LEAVES:
        return Need.ARITHMETIC
    direct = isinstance(expression, Call) and expression.function in DIRECT
    own = Need.ARITHMETIC if direct else operation(cls)
    return max(own, most_advanced(map(need_of, _inside(expression))))


@cache
def operation(cls: type[Expression]) -> Need:
    """Return the mathematics that the operation of a class of expressions needs; KeyError if none is recorded."""
    return OPERATIONS[next((base for base in cls.__mro__ if base in OPERATIONS), cls)]


def _inside(expression: Expression) -> Iterable[Expression]:
    """Return the subexpressions that must be evaluated first; for a numerical root, its equation."""
    match expression:
        case NumericFormula():
            return (expression.inner,)
        case ClosedRoot():
            return (expression.closed,)
        case NumericRoot():
            return (expression.residual,)
        case Chain():
            return (formula for _, formula in expression.formulas)
        case _:
            return expression.parts

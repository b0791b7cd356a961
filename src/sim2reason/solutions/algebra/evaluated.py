"""Formulas written as numbers, numerical roots, exact derivatives and elliptic integrals."""

import cmath
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from math import pi

from sim2reason.base.records import record
from sim2reason.solutions.algebra.expressions import Expression, Number, Scalar, Values
from sim2reason.solutions.algebra.rounded_numbers import round_to_digits, rounded_latex, with_guard_digits

MAX_MEAN_STEPS = 40  # most steps of the arithmetic-geometric mean; six suffice for nearly all moduli
MEANS_ATOL = 1e-17  # difference of the two means at which the iteration ends


class SpecialFunction(Expression):
    """A non-elementary function, whose values are computed numerically or taken from tables."""

    __slots__ = ()


@record(slots=True, hashed_once=True)
class CompleteElliptic(SpecialFunction):
    """The complete elliptic integral of the first kind, K(k), of a modulus k between 0 and 1."""

    modulus: Expression

    @property
    def parts(self) -> tuple[Expression, ...]:
        """Return the modulus."""
        return (self.modulus,)

    def built_of(self, parts: Sequence[Expression]) -> Expression:
        """Return the integral with another modulus."""
        (modulus,) = parts
        return CompleteElliptic(modulus)

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Return π/(2 a), where a is the arithmetic-geometric mean of 1 and √(1 − k²)."""
        return _real_if(0.5 * pi / _means(self.modulus.value(at, digits))[-1][0])

    def _written(self) -> str:
        """Return K(k) in LaTeX."""
        return rf"\operatorname{{K}}\left({self.modulus.latex()}\right)"


@record(slots=True, hashed_once=True)
class _ModulusFunction(SpecialFunction):
    """A function of an argument and a modulus k between 0 and 1."""

    argument: Expression
    modulus: Expression

    @property
    def parts(self) -> tuple[Expression, ...]:
        """Return the argument and the modulus."""
        return self.argument, self.modulus

    def built_of(self, parts: Sequence[Expression]) -> Expression:
        """Return the same function of another argument and modulus."""
        argument, modulus = parts
        return type(self)(argument, modulus)


@record(slots=True, hashed_once=True)
class IncompleteElliptic(_ModulusFunction):
    """The incomplete elliptic integral of the first kind, F(θ, k), of an angle θ in radians."""

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Return θ′/(2ⁿ a) by Landen's transformation, tan(θ′ − θ) = (b/a) tan θ."""
        angle = complex(self.argument.value(at, digits))
        means = _means(self.modulus.value(at, digits))
        for a, b in means[:-1]:
            angle += cmath.atan(b / a * cmath.tan(angle)) + pi * round(angle.real / pi)
        return _real_if(angle / (2.0 ** (len(means) - 1) * means[-1][0]))

    def _written(self) -> str:
        """Return F(θ, k) in LaTeX."""
        return rf"\operatorname{{F}}\left({self.argument.latex()}, {self.modulus.latex()}\right)"


@record(slots=True, hashed_once=True)
class Amplitude(_ModulusFunction):
    """Jacobi's amplitude am(u, k), in radians: the angle whose incomplete elliptic integral of the first kind is u."""

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Return the amplitude in radians by sin(2θ − θ′) = (c′/a′) sin θ′, backwards from 2ⁿ a u."""
        means = _means(self.modulus.value(at, digits))
        angle = 2.0 ** (len(means) - 1) * means[-1][0] * complex(self.argument.value(at, digits))
        for (a, b), (mean, _) in reversed(list(pairwise(means))):
            angle = 0.5 * (angle + cmath.asin(0.5 * (a - b) / mean * cmath.sin(angle)))
        return _real_if(angle)

    def _written(self) -> str:
        """Return am(u, k) in LaTeX."""
        return rf"\operatorname{{am}}\left({self.argument.latex()}, {self.modulus.latex()}\right)"


def _means(modulus: Scalar) -> list[tuple[complex, complex]]:
    """Return the successive arithmetic and geometric means, from 1 and √(1 − k²); ValueError unless 0 ≤ k < 1."""
    if not 0.0 <= modulus.real < 1.0:
        raise ValueError(f"an elliptic integral of the modulus {modulus.real:g}")
    means = [(complex(1.0), cmath.sqrt(1.0 - complex(modulus) ** 2))]
    while len(means) < MAX_MEAN_STEPS and abs(means[-1][0] - means[-1][1]) > MEANS_ATOL:
        a, b = means[-1]
        means.append((0.5 * (a + b), cmath.sqrt(a * b)))
        if means[-1][0] == a:  # the limit of floating-point precision
            break
    return means


def _real_if(value: complex) -> Scalar:
    """Return a number as a real one if its imaginary part is zero; else as it is, for complex-step derivatives."""
    return value if value.imag else value.real


NEWTON_STEPS = 6  # Newton steps from an approximate root
ROUNDED_RESULT_RTOL = 5e-5  # relative: largest error of a result computed from rounded numbers
COMPLEX_STEP = 1e-30  # imaginary step of the complex-step derivative


@record(slots=True, hashed_once=True)
class NumericFormula(Expression):
    """A formula that is written as its numerical value, as in *34.800 a*; with guard digits no value ends in 0."""

    inner: Expression
    comes_to: float
    guarded: bool = False

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Return the value of the formula, rounded if `digits` are given."""
        result = self.inner.value(at, digits)
        return result if digits is None or isinstance(result, complex) else round_to_digits(result, digits)

    def _written(self) -> str:
        """Return the number in LaTeX."""
        return with_guard_digits(self.comes_to) if self.guarded else rounded_latex(self.comes_to)

    def symbols(self) -> Iterator[str]:
        """Yield the symbols of the formula."""
        return self.inner.symbols()

    def __neg__(self) -> Expression:
        """Return the negative as a single number."""
        return NumericFormula(-self.inner, -self.comes_to, self.guarded)

    @property
    def rank(self) -> int:
        """Return the precedence for parentheses: 0 for negative numbers, 1 with a power of ten, 2 for all others."""
        return 0 if self.comes_to < 0.0 else 1 if "times" in self.latex() else 2


@record(slots=True, hashed_once=True)
class NumericRoot(Expression):
    """The root of an equation in one unknown, found by Newton's method near a known value and written as a number."""

    residual: Expression
    name: str
    near: float

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Return the root after Newton's method; complex values of symbols give exact derivatives."""
        plain = {name: value.real for name, value in at.items()}
        root = self.near
        for _ in range(NEWTON_STEPS):
            there = self.residual.value({**plain, self.name: root}, digits).real
            root -= there / self.slope(plain, root)
        if not any(isinstance(value, complex) for value in at.values()):
            return root
        return root - self.residual.value({**at, self.name: complex(root)}) / self.slope(plain, root)

    def slope(self, at: Mapping[str, float], root: float) -> float:
        """Return the derivative of the formula with respect to the unknown."""
        return complex(self.residual.value({**at, self.name: root + COMPLEX_STEP * 1j})).imag / COMPLEX_STEP

    def _written(self) -> str:
        """Return the number in LaTeX."""
        return rounded_latex(self.near)

    def symbols(self) -> Iterator[str]:
        """Yield the symbols of the formula without the unknown."""
        return (name for name in self.residual.symbols() if name != self.name)


@record(slots=True, hashed_once=True)
class ClosedRoot(NumericRoot):
    """The root of an equation that has a closed form once all other symbols have numerical values.

    The vanishing formula `equation` and its root `closed` hold for these values only. The value of the root is computed
    from the residual, so that it also holds for other values.
    """

    equation: Expression
    closed: Expression


@record(slots=True, hashed_once=True)
class ImplicitRoot(NumericRoot):
    """A root that depends on unknowns: its equation is stated, but no number."""

    def _written(self) -> str:
        """Return the name of the unknown."""
        return self.name


class QuadraticRoot(ImplicitRoot):
    """An implicit root of a quadratic equation, which has a closed form."""

    __slots__ = ()


@record(slots=True, hashed_once=True)
class Chain(Expression):
    """A sequence of named formulas, each of earlier names; its value is that of the last. It has no LaTeX itself."""

    formulas: tuple[tuple[str, Expression], ...]

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Evaluate the formulas in order and return the last value."""
        known = dict(at)
        for name, formula in self.formulas:
            known[name] = formula.value(known, digits)
        return known[self.formulas[-1][0]]

    def _written(self) -> str:
        """Return the name of the last formula."""
        return self.formulas[-1][0]

    def symbols(self) -> Iterator[str]:
        """Yield the symbols that the chain does not define."""
        own = {name for name, _ in self.formulas}
        return (name for _, formula in self.formulas for name in formula.symbols() if name not in own)


def numeric_parts(expression: Expression) -> Iterator[Expression]:
    """Yield the outermost parts of a formula that the text writes as numbers instead of symbols."""
    if isinstance(expression, NumericFormula | NumericRoot):
        if not isinstance(expression, ImplicitRoot):
            yield expression
        return
    for part in expression.parts:
        yield from numeric_parts(part)


def loses_digits(expression: Expression, at: Values) -> bool:
    """Return whether the rounded numbers in a formula change its result within five significant digits."""
    exact = expression.value(at).real
    return abs(_as_written(expression).value(at).real - exact) > ROUNDED_RESULT_RTOL * abs(exact)


def _as_written(expression: Expression) -> Expression:
    """Return a formula with its numbers rounded as in the text."""
    if isinstance(expression, NumericFormula):
        return Number(round_to_digits(expression.comes_to))
    return expression.built_of([_as_written(part) for part in expression.parts]) if expression.parts else expression


def is_special(expression: Expression) -> bool:
    """Return whether a formula contains a special function; symbolic problems allow none."""
    return isinstance(expression, SpecialFunction) or any(map(is_special, expression.parts))


def gradient(expression: Expression, at: Mapping[str, float], names: Mapping[str, int]) -> list[float]:
    """Return the exact partial derivatives of an analytic formula; `names` has each symbol's index in the list."""
    derivatives = [0.0] * len(names)
    for name in dict.fromkeys(expression.symbols()):
        if name in names:
            derivatives[names[name]] = (
                complex(expression.value({**at, name: at[name] + COMPLEX_STEP * 1j})).imag / COMPLEX_STEP
            )
    return derivatives

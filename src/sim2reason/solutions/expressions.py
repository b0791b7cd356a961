"""Formulas that know their value and how they are written: what the relations of a worked solution are made of."""

import cmath
import math
from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Literal

DIGITS = 5  # significant ones that a worked solution carries
NEWTON = 6  # steps from a root that is known nearly
STEP = 1e-30  # imaginary: a derivative by it is exact

Scalar = float | complex
Values = Mapping[str, Scalar]


class Expression(ABC):
    """A formula. Symbols are named by their LaTeX."""

    @abstractmethod
    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Its value where symbols have theirs; with `digits`, what was worked out on the way is rounded to as many."""

    @abstractmethod
    def latex(self) -> str:
        """How it is written, without dollars."""

    @abstractmethod
    def symbols(self) -> Iterator[str]:
        """The names in it, from left to right, some more than once."""

    @property
    def rank(self) -> int:
        """How tightly it holds together when written: 0 a sum, 1 a product, 2 what needs no parentheses."""
        return 2

    def __add__(self, other: "Expression | float") -> "Expression":
        return added(self, lifted(other))

    def __radd__(self, other: "Expression | float") -> "Expression":
        return added(lifted(other), self)

    def __sub__(self, other: "Expression | float") -> "Expression":
        return added(self, -lifted(other))

    def __rsub__(self, other: "Expression | float") -> "Expression":
        return added(lifted(other), -self)

    def __mul__(self, other: "Expression | float") -> "Expression":
        return multiplied(self, lifted(other))

    def __rmul__(self, other: "Expression | float") -> "Expression":
        return multiplied(lifted(other), self)

    def __truediv__(self, other: "Expression | float") -> "Expression":
        divisor = lifted(other)
        return self if divisor == ONE else Quotient(self, divisor)

    def __neg__(self) -> "Expression":
        if isinstance(self, Sum):
            return Sum(tuple(-term for term in self.terms))
        return multiplied(Number(-1.0), self)

    def __pow__(self, exponent: int) -> "Expression":
        return self if exponent == 1 else Power(self, exponent)


@dataclass(frozen=True, slots=True)
class Number(Expression):
    """A pure number, written as a fraction where it is a simple one."""

    x: float

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """It itself."""
        del at, digits
        return self.x

    def latex(self) -> str:
        """As in: 2, 2/5 or 0.30000."""
        fraction = Fraction(self.x).limit_denominator(60)
        if abs(float(fraction) - self.x) > 1e-12 * max(1.0, abs(self.x)):
            return rounded(self.x)
        if fraction.denominator == 1:
            return str(fraction.numerator)
        sign = "-" if fraction < 0 else ""
        return rf"{sign}\tfrac{{{abs(fraction.numerator)}}}{{{fraction.denominator}}}"

    def symbols(self) -> Iterator[str]:
        """None."""
        return iter(())

    @property
    def rank(self) -> int:
        """A negative one needs parentheses."""
        return 2 if self.x >= 0.0 else 0


@dataclass(frozen=True, slots=True)
class Symbol(Expression):
    """A named value."""

    name: str

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """What stands under its name."""
        return at[self.name]

    def latex(self) -> str:
        """Its name."""
        return self.name

    def symbols(self) -> Iterator[str]:
        """Its own name."""
        yield self.name


@dataclass(frozen=True, slots=True)
class Sum(Expression):
    """Terms added up."""

    terms: tuple[Expression, ...]

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Their sum."""
        return sum((term.value(at, digits) for term in self.terms), 0.0)

    def latex(self) -> str:
        """A term that is positive first, if there is one."""
        parts = sorted((term.latex() for term in self.terms), key=lambda part: part.startswith("-"))
        return parts[0] + "".join(f" - {part[1:]}" if part.startswith("-") else f" + {part}" for part in parts[1:])

    def symbols(self) -> Iterator[str]:
        """Those of the terms."""
        for term in self.terms:
            yield from term.symbols()

    @property
    def rank(self) -> int:
        """The lowest."""
        return 0


@dataclass(frozen=True, slots=True)
class Product(Expression):
    """Factors multiplied."""

    factors: tuple[Expression, ...]

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Their product."""
        found: Scalar = 1.0
        for factor in self.factors:
            found = found * factor.value(at, digits)
        return found

    def latex(self) -> str:
        """Side by side; numbers in digits are kept apart by a sign."""
        first, *rest = self.factors
        if first == Number(-1.0):
            return "-" + Product(tuple(rest)).latex() if len(rest) > 1 else f"-{parenthesized(rest[0], 1)}"
        text = first.latex() if isinstance(first, Number) else parenthesized(first, 1)
        for factor in rest:
            part = parenthesized(factor, 1)
            joint = r" \cdot " if part[0].isdigit() or part.startswith("-") else r"\," if text[-1].isdigit() else " "
            text += joint + part
        return text

    def symbols(self) -> Iterator[str]:
        """Those of the factors."""
        for factor in self.factors:
            yield from factor.symbols()

    @property
    def rank(self) -> int:
        """That of a product; one with a minus sign is like a sum."""
        return 0 if isinstance(self.factors[0], Number) and self.factors[0].x < 0.0 else 1


@dataclass(frozen=True, slots=True)
class Quotient(Expression):
    """One divided by another, written as a fraction."""

    above: Expression
    below: Expression

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Their quotient."""
        return self.above.value(at, digits) / self.below.value(at, digits)

    def latex(self) -> str:
        """As a fraction; a minus sign of the numerator stands before it."""
        above = self.above.latex()
        if self.above.rank or not isinstance(self.above, Product):
            return rf"\frac{{{above}}}{{{self.below.latex()}}}"
        return rf"-\frac{{{above[1:]}}}{{{self.below.latex()}}}"

    def symbols(self) -> Iterator[str]:
        """Those of both."""
        yield from self.above.symbols()
        yield from self.below.symbols()

    @property
    def rank(self) -> int:
        """As of a product."""
        return 0 if self.latex().startswith("-") else 1


@dataclass(frozen=True, slots=True)
class Power(Expression):
    """A whole power."""

    base: Expression
    exponent: int

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """The power."""
        return self.base.value(at, digits) ** self.exponent

    def latex(self) -> str:
        """With the exponent raised; that of a sine stands before its angle."""
        if isinstance(self.base, Call):
            return rf"\{self.base.function}^{{{self.exponent}}} {parenthesized(self.base.argument, 2)}"
        return f"{parenthesized(self.base, 2)}^{{{self.exponent}}}"

    def symbols(self) -> Iterator[str]:
        """Those of the base."""
        return self.base.symbols()


@dataclass(frozen=True, slots=True)
class Root(Expression):
    """A square root, the positive one."""

    inside: Expression

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """The root; ValueError below zero."""
        inside = self.inside.value(at, digits)
        return cmath.sqrt(inside) if isinstance(inside, complex) else math.sqrt(inside)

    def latex(self) -> str:
        """Under its sign."""
        return rf"\sqrt{{{self.inside.latex()}}}"

    def symbols(self) -> Iterator[str]:
        """Those under it."""
        return self.inside.symbols()


@dataclass(frozen=True, slots=True)
class Call(Expression):
    """A function of an angle in radians, or of a ratio."""

    function: Literal["sin", "cos", "tan", "arctan", "arccos", "arcsin", "ln", "exp"]
    argument: Expression

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """The value of the function."""
        inside = self.argument.value(at, digits)
        name = {"arctan": "atan", "arccos": "acos", "arcsin": "asin", "ln": "log"}.get(self.function, self.function)
        return getattr(cmath if isinstance(inside, complex) else math, name)(inside)

    def latex(self) -> str:
        """As in: \\sin\\theta."""
        inside = self.argument.latex()
        if isinstance(self.argument, Symbol):
            return rf"\{self.function}{inside if inside.startswith(chr(92)) else ' ' + inside}"
        return rf"\{self.function}\left({inside}\right)"

    def symbols(self) -> Iterator[str]:
        """Those of the argument."""
        return self.argument.symbols()


@dataclass(frozen=True, slots=True)
class Worked(Expression):
    """A formula that is written as the number that it comes to, as in *34.800 a*."""

    inner: Expression
    comes_to: float

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """The formula's, rounded if that is asked for."""
        found = self.inner.value(at, digits)
        return found if digits is None or isinstance(found, complex) else shortened(found, digits)

    def latex(self) -> str:
        """The number."""
        return rounded(self.comes_to)

    def symbols(self) -> Iterator[str]:
        """Those of the formula."""
        return self.inner.symbols()

    @property
    def rank(self) -> int:
        """A negative one needs parentheses."""
        return 2 if self.comes_to >= 0.0 else 0


ZERO, ONE = Number(0.0), Number(1.0)


def ratio(above: Expression, below: Expression) -> Expression:
    """A fraction whose denominator does not begin with a minus sign."""
    if below.latex().startswith("-"):
        return Quotient(-above, -below)
    return above if below == ONE else Quotient(above, below)


def lifted(value: "Expression | float") -> Expression:
    """A number as a formula."""
    return value if isinstance(value, Expression) else Number(float(value))


def added(one: Expression, other: Expression) -> Expression:
    """A sum without zeros."""
    terms = [
        term
        for side in (one, other)
        for term in (side.terms if isinstance(side, Sum) else (side,))
        if not (isinstance(term, Number) and term.x == 0.0)
    ]
    return Sum(tuple(terms)) if len(terms) > 1 else terms[0] if terms else ZERO


def multiplied(one: Expression, other: Expression) -> Expression:
    """A product with one number in front, and none that changes nothing."""
    number, factors = 1.0, list[Expression]()
    for side in (one, other):
        for factor in side.factors if isinstance(side, Product) else (side,):
            if isinstance(factor, Number):
                number *= factor.x
            else:
                factors.append(factor)
    if number == 0.0 or not factors:
        return Number(number)
    if number != 1.0:
        factors.insert(0, Number(number))
    return Product(tuple(factors)) if len(factors) > 1 else factors[0]


def parenthesized(held: Expression, rank: int) -> str:
    """Written so that it can stand beside what binds as tightly as `rank`."""
    return held.latex() if held.rank >= rank else rf"\left({held.latex()}\right)"


def shortened(value: float, digits: int = DIGITS) -> float:
    """A number rounded to so many significant digits."""
    return float(f"{value:.{digits - 1}e}")


def rounded(value: float) -> str:
    """A number with five significant digits, in LaTeX."""
    if value == 0.0:
        return "0"
    mantissa, _, power = f"{value:.{DIGITS - 1}e}".partition("e")
    exponent = int(power)
    if -4 < exponent < 6:
        return f"{value:.{max(0, DIGITS - 1 - exponent)}f}"
    return rf"{mantissa} \times 10^{{{exponent}}}"


def gradient(held: Expression, at: Mapping[str, float], names: Mapping[str, int]) -> list[float]:
    """The derivatives by some symbols, each at its place; of analytic formulas exact."""
    found = [0.0] * len(names)
    for name in dict.fromkeys(held.symbols()):
        if name in names:
            found[names[name]] = complex(held.value({**at, name: at[name] + STEP * 1j})).imag / STEP
    return found


@dataclass(frozen=True, slots=True)
class NumericRoot(Expression):
    """Where a formula of one further symbol vanishes, found by Newton's method from near by; written as its value."""

    residual: Expression
    name: str
    near: float

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """The root, refined; with complex values its derivative is exact."""
        plain = {name: value.real for name, value in at.items()}
        root = self.near
        for _ in range(NEWTON):
            there = self.residual.value({**plain, self.name: root}, digits).real
            root -= there / self._slope(plain, root)
        if not any(isinstance(value, complex) for value in at.values()):
            return root
        return root - self.residual.value({**at, self.name: complex(root)}) / self._slope(plain, root)

    def _slope(self, at: Mapping[str, float], root: float) -> float:
        return complex(self.residual.value({**at, self.name: root + STEP * 1j})).imag / STEP

    def latex(self) -> str:
        """The number."""
        return rounded(self.near)

    def symbols(self) -> Iterator[str]:
        """Those of the formula, without the unknown."""
        return (name for name in self.residual.symbols() if name != self.name)

"""Symbolic expressions with values and LaTeX: numbers, symbols, sums, products and quotients."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, fields
from math import prod

from sim2reason.base.records import record
from sim2reason.solutions.algebra.rounded_numbers import pure_number

FRACTION = r"\frac{"
FUNCTIONS = ("\\sin", "\\cos", "\\tan", "\\arc", "\\ln", "\\exp")
Scalar = float | complex
Values = Mapping[str, Scalar]


@record(slots=True, eq=False)
class Expression:
    """A symbolic formula. Symbols are named by their LaTeX.

    It is no ABC, since `isinstance` is several times slower for an ABC, and formulas are often matched by class.
    Formulas are deep and immutable, and their hash, LaTeX and names are read often: each object computes them once.
    """

    kept_hash: int | None = field(default=None, init=False, repr=False, compare=False)
    _latex: str | None = field(default=None, init=False, repr=False, compare=False)
    _names: frozenset[str] | None = field(default=None, init=False, repr=False, compare=False)

    def __reduce__(self) -> "tuple[type[Expression], tuple[object, ...]]":
        """Return the class and the fields for pickling, without the hash, which differs between processes."""
        return type(self), tuple(getattr(self, each.name) for each in fields(self) if each.init)

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Evaluate the formula for given values of its symbols; with `digits`, intermediate results are rounded."""
        raise NotImplementedError

    def latex(self) -> str:
        """Return the LaTeX without dollar signs."""
        text = self._latex
        if text is None:
            text = self._written()
            object.__setattr__(self, "_latex", text)
        return text

    def _written(self) -> str:
        """Return the LaTeX without dollar signs, not cached."""
        raise NotImplementedError

    def symbols(self) -> Iterator[str]:
        """Yield the names of the symbols from left to right, with repetitions."""
        waiting = [*self.parts[::-1]]
        while waiting:  # a generator for each part would take twice as long
            part = waiting.pop()
            if isinstance(part, Symbol):
                yield part.name
            elif type(part).symbols is Expression.symbols:
                waiting += part.parts[::-1]
            else:
                yield from part.symbols()

    @property
    def names(self) -> frozenset[str]:
        """Return the names of the symbols."""
        names = self._names
        if names is None:
            names = frozenset(self.symbols())
            object.__setattr__(self, "_names", names)
        return names

    @property
    def parts(self) -> "tuple[Expression, ...]":
        """Return the subexpressions; none by default."""
        return ()

    def built_of(self, parts: "Sequence[Expression]") -> "Expression":
        """Return the same kind of expression with other subexpressions; by default the expression itself."""
        del parts
        return self

    @property
    def rank(self) -> int:
        """Return the precedence for parentheses in LaTeX: 0 for sums, 1 for products, 2 if it never needs them."""
        return 2

    @property
    def negative(self) -> bool:
        """Return whether the LaTeX begins with a minus sign."""
        match self:
            case Sum(terms):  # a positive term would stand first
                return all(term.negative for term in terms)
            case Product((Number(x), *_)) | Quotient(Product((Number(x), *_)), _):
                return x < 0.0
            case _:
                return not isinstance(self, Product | Quotient) and self.latex().startswith("-")

    def __add__(self, other: "Expression | float") -> "Expression":
        """Return the sum."""
        return sum_terms(self, as_expression(other))

    def __sub__(self, other: "Expression | float") -> "Expression":
        """Return the difference."""
        return sum_terms(self, -as_expression(other))

    def __mul__(self, other: "Expression | float") -> "Expression":
        """Return the product."""
        return multiply_factors(self, as_expression(other))

    def __rmul__(self, other: "Expression | float") -> "Expression":
        """Return the product."""
        return multiply_factors(as_expression(other), self)

    def __truediv__(self, other: "Expression | float") -> "Expression":
        """Return the quotient as a fraction that contains no fraction above or below."""
        match self, as_expression(other):
            case _, divisor if divisor == ONE or self == ZERO:
                return self
            case _, Quotient(above, below):
                return multiply_factors(self, below) / above
            case Quotient(above, below), divisor:
                return above / multiply_factors(below, divisor)
            case _, (Number(x) | Product((Number(x), *_))) as divisor if (1.0 / x).is_integer() and abs(x) < 1.0:
                return multiply_factors(Number(1.0 / x), self) / multiply_factors(Number(1.0 / x), divisor)
            case _, divisor:
                return Quotient(-self, -divisor) if divisor.negative else Quotient(self, divisor)

    def __neg__(self) -> "Expression":
        """Return the negative; a sum is negated term by term."""
        if isinstance(self, Sum):
            return Sum(tuple(-term for term in self.terms))
        if isinstance(self, Quotient) and self.negative:
            return Quotient(-self.above, self.below)
        return multiply_factors(MINUS_ONE, self)


@record(slots=True)
class Number(Expression):
    """A pure number, written as a fraction where that is simple."""

    x: float

    def __hash__(self) -> int:
        """Return the hash of the number."""
        return hash(self.x)

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Return the number."""
        del at, digits
        return self.x

    def latex(self) -> str:
        """Return the LaTeX of the number, such as *2*, *0.30000* or a fraction."""
        return pure_number(self.x)

    @property
    def rank(self) -> int:
        """Return 0 for negative numbers, which need parentheses, else 2."""
        return 2 if self.x >= 0.0 else 0


@record(slots=True)
class Symbol(Expression):
    """A variable or constant with a name."""

    name: str

    def __hash__(self) -> int:
        """Return the hash of the name, which Python caches, since polynomials look up symbols often."""
        return hash(self.name)

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Return the value of the name."""
        del digits
        return at[self.name]

    def latex(self) -> str:
        """Return the name."""
        return self.name

    def symbols(self) -> Iterator[str]:
        """Yield the name."""
        yield self.name


@record(slots=True, hashed_once=True)
class Sum(Expression):
    """A sum of terms."""

    terms: tuple[Expression, ...]

    @property
    def parts(self) -> tuple[Expression, ...]:
        """Return the terms."""
        return self.terms

    def built_of(self, parts: Sequence[Expression]) -> Expression:
        """Return the sum of other terms."""
        return sum_terms(*parts)

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Return the sum of the values."""
        return sum([term.value(at, digits) for term in self.terms], 0.0)  # a generator would take longer

    def _written(self) -> str:
        """Return the terms joined by signs, with a positive term first if there is one."""
        parts = sorted((term.latex() for term in self.terms), key=lambda part: part.startswith("-"))
        return parts[0] + "".join(f" - {part[1:]}" if part.startswith("-") else f" + {part}" for part in parts[1:])

    @property
    def rank(self) -> int:
        """Return 0, the lowest precedence: within a product, a sum stands in parentheses."""
        return 0


@record(slots=True, hashed_once=True)
class Product(Expression):
    """A product of factors."""

    factors: tuple[Expression, ...]

    @property
    def parts(self) -> tuple[Expression, ...]:
        """Return the factors."""
        return self.factors

    def built_of(self, parts: Sequence[Expression]) -> Expression:
        """Return the product of other factors."""
        return multiply_factors(*parts)

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Return the product of the values."""
        return prod([factor.value(at, digits) for factor in self.factors], start=1.0)

    def _written(self) -> str:
        """Return the factors side by side, with a dot between numbers."""
        first, *rest = self.factors
        if first == MINUS_ONE:
            return "-" + Product(tuple(rest)).latex() if len(rest) > 1 else f"-{parenthesized(rest[0], 1)}"
        plain = [factor.latex() for factor in self.factors]
        parts = [p if factor.rank else rf"\left({p}\right)" for factor, p in zip(self.factors, plain, strict=True)]
        text = plain[0] if isinstance(first, Number) else parts[0]
        for before, part in zip(plain, parts[1:], strict=False):
            needs_space = text[-1].isdigit() or before.startswith(FUNCTIONS)  # sin θ m would be the sine of θ m
            mixed = text[-1].isdigit() and part.startswith(FRACTION) and part[len(FRACTION)].isdigit()  # 4 ⅖
            joint = r" \cdot " if mixed or part[0].isdigit() or part.startswith("-") else r"\," if needs_space else " "
            text += joint + part
        return text

    @property
    def rank(self) -> int:
        """Return the precedence for parentheses: 1, or 0 for a product with a minus sign."""
        return 0 if self.negative else 1


@record(slots=True, hashed_once=True)
class Quotient(Expression):
    """A quotient, written as a fraction."""

    above: Expression
    below: Expression

    @property
    def parts(self) -> tuple[Expression, ...]:
        """Return the numerator and the denominator."""
        return self.above, self.below

    def built_of(self, parts: Sequence[Expression]) -> Expression:
        """Return the quotient of another numerator and denominator."""
        above, below = parts
        return ratio(above, below)

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Return the quotient of the values."""
        return self.above.value(at, digits) / self.below.value(at, digits)

    def _written(self) -> str:
        """Return the fraction, with a minus sign of the numerator in front."""
        above, sign = self.above.latex(), "-" if self.negative else ""
        return rf"{sign}{FRACTION}{above[len(sign) :]}}}{{{self.below.latex()}}}"

    @property
    def rank(self) -> int:
        """Return the precedence for parentheses: 1, or 0 for a negative quotient."""
        return 0 if self.negative else 1


ZERO, ONE, MINUS_ONE = Number(0.0), Number(1.0), Number(-1.0)


def ratio(above: Expression, below: Expression) -> Expression:
    """Return the quotient of two formulas with a denominator that does not begin with a minus sign."""
    return -above / -below if below.negative else above / below


def as_expression(value: "Expression | float") -> Expression:
    """Convert a number to a formula; a formula is returned unchanged."""
    return value if isinstance(value, Expression) else Number(float(value))


def sum_terms(*parts: Expression) -> Expression:
    """Return the sum of formulas as one flat sum without zero terms."""
    terms = [
        term
        for side in parts
        for term in (side.terms if isinstance(side, Sum) else (side,))
        if not (isinstance(term, Number) and term.x == 0.0)
    ]
    return Sum(tuple(terms)) if len(terms) > 1 else terms[0] if terms else ZERO


def multiply_factors(*parts: Expression) -> Expression:
    """Return the product of formulas as one flat product with a single numerical factor in front."""
    number, factors = 1.0, list[Expression]()
    for side in parts:
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


def parenthesized(expression: Expression, rank: int) -> str:
    """Return the LaTeX of a formula, in parentheses if its precedence is lower than `rank`."""
    return expression.latex() if expression.rank >= rank else rf"\left({expression.latex()}\right)"

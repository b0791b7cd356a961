"""Formulas that know their value and how they are written: what the relations of a worked solution are made of."""

from collections.abc import Iterator, Mapping, Sequence
from math import prod

from sim2reason.base.record import record
from sim2reason.solutions.algebra.digits import pure_number

FRACTION = r"\frac{"
FUNCTIONS = ("\\sin", "\\cos", "\\tan", "\\arc", "\\ln", "\\exp")
Scalar = float | complex
Values = Mapping[str, Scalar]


class Expression:
    """A formula. Symbols are named by their LaTeX.

    It is no ABC, since `isinstance` takes several times as long with one, and formulas are matched by class all along.
    """

    __slots__ = ()

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Its value where symbols have theirs; with `digits`, what was worked out on the way is rounded to as many."""
        raise NotImplementedError

    def latex(self) -> str:
        """Return how it is written, without dollars."""
        raise NotImplementedError

    def symbols(self) -> Iterator[str]:
        """Yield the names in it, from left to right, some more than once; by default those of its parts."""
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
    def parts(self) -> "tuple[Expression, ...]":
        """The formulas that it is built of; none by default."""
        return ()

    def built_of(self, parts: "Sequence[Expression]") -> "Expression":
        """Return the same of other parts, in their order; by default itself."""
        del parts
        return self

    @property
    def rank(self) -> int:
        """Return how tightly it holds together when written: 0 a sum, 1 a product, 2 what needs no parentheses."""
        return 2

    @property
    def negative(self) -> bool:
        """Return whether it is written with a minus sign in front."""
        match self:
            case Sum(terms):  # a positive one would stand first
                return all(term.negative for term in terms)
            case Product((Number(x), *_)) | Quotient(Product((Number(x), *_)), _):
                return x < 0.0
            case _:
                return not isinstance(self, Product | Quotient) and self.latex().startswith("-")

    def __add__(self, other: "Expression | float") -> "Expression":
        """Their sum."""
        return added(self, lifted(other))

    def __sub__(self, other: "Expression | float") -> "Expression":
        """Their difference."""
        return added(self, -lifted(other))

    def __mul__(self, other: "Expression | float") -> "Expression":
        """Their product."""
        return multiplied(self, lifted(other))

    def __rmul__(self, other: "Expression | float") -> "Expression":
        """Their product."""
        return multiplied(lifted(other), self)

    def __truediv__(self, other: "Expression | float") -> "Expression":
        """Their quotient, as a fraction of one storey, without fractions of numbers in its denominator."""
        match self, lifted(other):
            case _, divisor if divisor == ONE or self == ZERO:
                return self
            case _, Quotient(above, below):
                return multiplied(self, below) / above
            case Quotient(above, below), divisor:
                return above / multiplied(below, divisor)
            case _, (Number(x) | Product((Number(x), *_))) as divisor if (1.0 / x).is_integer() and abs(x) < 1.0:
                return multiplied(Number(1.0 / x), self) / multiplied(Number(1.0 / x), divisor)
            case _, divisor:
                return Quotient(-self, -divisor) if divisor.negative else Quotient(self, divisor)

    def __neg__(self) -> "Expression":
        """Return its negative, term by term."""
        if isinstance(self, Sum):
            return Sum(tuple(-term for term in self.terms))
        if isinstance(self, Quotient) and self.negative:
            return Quotient(-self.above, self.below)
        return multiplied(MINUS_ONE, self)


@record(slots=True)
class Number(Expression):
    """A pure number, written as a fraction where it is a simple one."""

    x: float

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """It itself."""
        del at, digits
        return self.x

    def latex(self) -> str:
        """Return a text such as *2, 2/5 or 0.30000*."""
        return pure_number(self.x)

    @property
    def rank(self) -> int:
        """A negative one needs parentheses."""
        return 2 if self.x >= 0.0 else 0


@record(slots=True)
class Symbol(Expression):
    """A named value."""

    name: str

    def __hash__(self) -> int:
        """Return that of its name, which the string keeps: polynomials look symbols up all along."""
        return hash(self.name)

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Return what stands under its name."""
        del digits
        return at[self.name]

    def latex(self) -> str:
        """Return its name."""
        return self.name

    def symbols(self) -> Iterator[str]:
        """Yield its own name."""
        yield self.name


@record(slots=True)
class Sum(Expression):
    """Terms added up."""

    terms: tuple[Expression, ...]

    @property
    def parts(self) -> tuple[Expression, ...]:
        """The terms."""
        return self.terms

    def built_of(self, parts: Sequence[Expression]) -> Expression:
        """Return the sum of others."""
        return added(*parts)

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Their sum."""
        return sum((term.value(at, digits) for term in self.terms), 0.0)

    def latex(self) -> str:
        """Return a term that is positive first, if there is one."""
        parts = sorted((term.latex() for term in self.terms), key=lambda part: part.startswith("-"))
        return parts[0] + "".join(f" - {part[1:]}" if part.startswith("-") else f" + {part}" for part in parts[1:])

    @property
    def rank(self) -> int:
        """The lowest."""
        return 0


@record(slots=True)
class Product(Expression):
    """Factors multiplied."""

    factors: tuple[Expression, ...]

    @property
    def parts(self) -> tuple[Expression, ...]:
        """The factors."""
        return self.factors

    def built_of(self, parts: Sequence[Expression]) -> Expression:
        """Return the product of others."""
        return multiplied(*parts)

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Their product."""
        return prod((factor.value(at, digits) for factor in self.factors), start=1.0)

    def latex(self) -> str:
        """Side by side; numbers in digits are kept apart by a sign."""
        first, *rest = self.factors
        if first == MINUS_ONE:
            return "-" + Product(tuple(rest)).latex() if len(rest) > 1 else f"-{parenthesized(rest[0], 1)}"
        plain = [factor.latex() for factor in self.factors]
        parts = [p if factor.rank else rf"\left({p}\right)" for factor, p in zip(self.factors, plain, strict=True)]
        text = plain[0] if isinstance(first, Number) else parts[0]
        for before, part in zip(plain, parts[1:], strict=False):
            apart = text[-1].isdigit() or before.startswith(FUNCTIONS)  # sin θ m would be the sine of θ m
            mixed = text[-1].isdigit() and part.startswith(FRACTION) and part[len(FRACTION)].isdigit()  # 4 ⅖
            joint = r" \cdot " if mixed or part[0].isdigit() or part.startswith("-") else r"\," if apart else " "
            text += joint + part
        return text

    @property
    def rank(self) -> int:
        """That of a product; one with a minus sign is like a sum."""
        return 0 if self.negative else 1


@record(slots=True)
class Quotient(Expression):
    """One divided by another, written as a fraction."""

    above: Expression
    below: Expression

    @property
    def parts(self) -> tuple[Expression, ...]:
        """Return what is divided, and by what."""
        return self.above, self.below

    def built_of(self, parts: Sequence[Expression]) -> Expression:
        """Return the quotient of others."""
        above, below = parts
        return ratio(above, below)

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Their quotient."""
        return self.above.value(at, digits) / self.below.value(at, digits)

    def latex(self) -> str:
        """As a fraction; a minus sign of the numerator stands before it."""
        above, sign = self.above.latex(), "-" if self.negative else ""
        return rf"{sign}{FRACTION}{above[len(sign) :]}}}{{{self.below.latex()}}}"

    @property
    def rank(self) -> int:
        """As of a product."""
        return 0 if self.negative else 1


ZERO, ONE, MINUS_ONE = Number(0.0), Number(1.0), Number(-1.0)


def ratio(above: Expression, below: Expression) -> Expression:
    """Return a fraction whose denominator does not begin with a minus sign."""
    return -above / -below if below.negative else above / below


def lifted(value: "Expression | float") -> Expression:
    """Return a number as a formula."""
    return value if isinstance(value, Expression) else Number(float(value))


def added(*parts: Expression) -> Expression:
    """Return a sum without zeros."""
    terms = [
        term
        for side in parts
        for term in (side.terms if isinstance(side, Sum) else (side,))
        if not (isinstance(term, Number) and term.x == 0.0)
    ]
    return Sum(tuple(terms)) if len(terms) > 1 else terms[0] if terms else ZERO


def multiplied(*parts: Expression) -> Expression:
    """Return a product with one number in front, and none that changes nothing."""
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


def parenthesized(held: Expression, rank: int) -> str:
    """Written so that it can stand beside what binds as tightly as `rank`."""
    return held.latex() if held.rank >= rank else rf"\left({held.latex()}\right)"

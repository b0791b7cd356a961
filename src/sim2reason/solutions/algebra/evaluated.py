"""Formulas that stand in a text as the numbers that they come to, and exact derivatives."""

from collections.abc import Iterator, Mapping

from sim2reason.record import record
from sim2reason.solutions.algebra.digits import rounded, shortened, with_guard_digits
from sim2reason.solutions.algebra.elliptic import SpecialFunction
from sim2reason.solutions.algebra.expressions import Expression, Number, Scalar, Values

NEWTON = 6  # steps from a root that is known nearly
WRITTEN = 5e-5  # relative: how well a result of five digits follows from the numbers beside it
STEP = 1e-30  # imaginary: a derivative by it is exact


@record(slots=True)
class Worked(Expression):
    """A formula that is written as the number that it comes to, as in *34.800 a*; with guard digits none end in 0."""

    inner: Expression
    comes_to: float
    guarded: bool = False

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """The formula's, rounded if that is asked for."""
        found = self.inner.value(at, digits)
        return found if digits is None or isinstance(found, complex) else shortened(found, digits)

    def latex(self) -> str:
        """The number."""
        return with_guard_digits(self.comes_to) if self.guarded else rounded(self.comes_to)

    def symbols(self) -> Iterator[str]:
        """Those of the formula."""
        return self.inner.symbols()

    def __neg__(self) -> Expression:
        """Return the negative, again as one number."""
        return Worked(-self.inner, -self.comes_to, self.guarded)

    @property
    def rank(self) -> int:
        """Return 0 for a negative number, 1 for one with a power of ten, which is a product, and 2 for others."""
        return 0 if self.comes_to < 0.0 else 1 if "times" in self.latex() else 2


@record(slots=True)
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
            root -= there / self.slope(plain, root)
        if not any(isinstance(value, complex) for value in at.values()):
            return root
        return root - self.residual.value({**at, self.name: complex(root)}) / self.slope(plain, root)

    def slope(self, at: Mapping[str, float], root: float) -> float:
        """Return the derivative of the formula with respect to the symbol."""
        return complex(self.residual.value({**at, self.name: root + STEP * 1j})).imag / STEP

    def latex(self) -> str:
        """The number."""
        return rounded(self.near)

    def symbols(self) -> Iterator[str]:
        """Those of the formula, without the unknown."""
        return (name for name in self.residual.symbols() if name != self.name)


@record(slots=True)
class ClosedRoot(NumericRoot):
    """The root of an equation that has a closed form once all but the unknown is in numbers.

    The `equation`, a formula that vanishes, and what it gives, `closed`, hold for these numbers. The value is worked
    out from the residual, so that it holds for others, too.
    """

    equation: Expression
    closed: Expression


@record(slots=True)
class ImplicitRoot(NumericRoot):
    """A root that hangs on what is unknown, so that no number is written: its equation alone is told."""

    def latex(self) -> str:
        """Its name."""
        return self.name


class QuadraticRoot(ImplicitRoot):
    """Such a root of a quadratic equation, which has a closed form."""

    __slots__ = ()


@record(slots=True)
class Chain(Expression):
    """A chain of named formulas, each of names before it, with the value of the last one; it is never written."""

    formulas: tuple[tuple[str, Expression], ...]

    def value(self, at: Values, digits: int | None = None) -> Scalar:
        """Worked out from the first to the last."""
        known = dict(at)
        for name, formula in self.formulas:
            known[name] = formula.value(known, digits)
        return known[self.formulas[-1][0]]

    def latex(self) -> str:
        """Its name."""
        return self.formulas[-1][0]

    def symbols(self) -> Iterator[str]:
        """All that it rests on."""
        own = {name for name, _ in self.formulas}
        return (name for _, formula in self.formulas for name in formula.symbols() if name not in own)


def numbers(held: Expression) -> Iterator[Expression]:
    """All parts of a formula that are written as the numbers that they come to."""
    if isinstance(held, Worked | NumericRoot):
        if not isinstance(held, ImplicitRoot):
            yield held
        return
    for part in held.parts:
        yield from numbers(part)


def loses_digits(held: Expression, at: Values) -> bool:
    """Return whether rounded numbers, as they are written in a formula, give another result to five digits."""
    exact = held.value(at).real
    return abs(_as_written(held).value(at).real - exact) > WRITTEN * abs(exact)


def _as_written(held: Expression) -> Expression:
    if isinstance(held, Worked):
        return Number(shortened(held.comes_to))
    return held.built_of([_as_written(part) for part in held.parts]) if held.parts else held


def is_special(held: Expression) -> bool:
    """Return whether a formula contains a special function, of which problems in symbols have none."""
    return isinstance(held, SpecialFunction) or any(map(is_special, held.parts))


def gradient(held: Expression, at: Mapping[str, float], names: Mapping[str, int]) -> list[float]:
    """The derivatives by some symbols, each at its place; of analytic formulas exact."""
    found = [0.0] * len(names)
    for name in dict.fromkeys(held.symbols()):
        if name in names:
            found[names[name]] = complex(held.value({**at, name: at[name] + STEP * 1j})).imag / STEP
    return found

"""Fractions of polynomials, and linear equations with symbols or numbers as coefficients."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import permutations
from math import gcd

from sim2reason.solutions.algebra.evaluated import NumericFormula
from sim2reason.solutions.algebra.expressions import (
    ZERO,
    Expression,
    Number,
    Quotient,
    Symbol,
    multiply_factors,
    parenthesized,
    sum_terms,
)
from sim2reason.solutions.algebra.polynomials import Polynomial, total
from sim2reason.solutions.writing.steps import SolutionBuilder, StepBuilder

INTEGER_ATOL = 1e-12  # largest difference between a factor and an integer


def reduced_quotient(above: Polynomial, below: Polynomial, *, grouped: bool = False) -> Expression:
    """Return the quotient of two polynomials in lowest terms; with `grouped`, factor common numbers out of sums."""
    if below.number is None:
        above, below = _cancelled(above, below)
        above, below = cancel_common_sum(above, below) or (above, below)
    if below.number is not None:
        above = above.scale(1.0 / below.number)
        shared = _shared_number([*above.terms.values()]) if grouped else 1.0
        return multiply_factors(Number(shared), above.scale(1.0 / shared).factored())
    if all(part < 0.0 for part in below.terms.values()):
        above, below = above.scale(-1.0), below.scale(-1.0)
    shared = _common_number([*above.terms.values(), *below.terms.values()])
    above, below = above.scale(1.0 / shared), below.scale(1.0 / shared)
    return Quotient(above.factored(), below.factored())


def _common_number(factors: list[float]) -> float:
    """Return the greatest common divisor of integer coefficients; 1 if a coefficient is no integer."""
    integers = [round(factor) for factor in factors]
    if any(abs(factor - number) > INTEGER_ATOL for factor, number in zip(factors, integers, strict=True)):
        return 1.0
    return float(gcd(*integers)) or 1.0


def _shared_number(factors: list[float]) -> float:
    """Return the coefficient of smallest magnitude if it divides all others, else 1."""
    smallest = min(map(abs, factors), default=1.0)
    divides_all = len(factors) > 1 and all(
        abs(factor / smallest - round(factor / smallest)) <= INTEGER_ATOL for factor in factors
    )
    return smallest if divides_all else 1.0


def cancel_common_sum(above: Polynomial, below: Polynomial) -> tuple[Polynomial, Polynomial] | None:
    """Cancel two polynomials whose ratio is a single term: return the new numerator and denominator; else None."""
    for dividend, part in ((above, below), (below, above)):
        if not dividend.terms or len(dividend.terms) != len(part.terms):
            continue
        (monomial, factor), *_ = part.terms.items()
        for term, value in dividend.terms.items():
            powers = dict(term)
            for atom, power in monomial:
                powers[atom] = powers.get(atom, 0) - power
            ratio = Polynomial({tuple((atom, power) for atom, power in powers.items() if power): value / factor})
            if min(powers.values(), default=0) >= 0 and not ratio * part - dividend:
                one = Polynomial.from_expression(1.0)
                return (ratio, one) if dividend is above else (one, ratio)
    return None


def _cancelled(above: Polynomial, below: Polynomial) -> tuple[Polynomial, Polynomial]:
    """Cancel the symbols, functions and roots that all terms of numerator and denominator have in common."""
    monomials = [*above.terms, *below.terms]
    if not above.terms:
        return above, below
    shared = dict(monomials[0])
    for monomial in monomials[1:]:
        powers = dict(monomial)
        shared = {atom: min(p, powers[atom]) for atom, p in shared.items() if atom in powers}
    for atom, power in shared.items():
        above, below = _lowered(above, atom, power), _lowered(below, atom, power)
    return above, below


def _lowered(polynomial: Polynomial, atom: Expression, power: int) -> Polynomial:
    """Divide a polynomial by a power of a symbol, function or root that all of its terms contain."""
    terms = dict[tuple[tuple[Expression, int], ...], float]()
    for monomial, part in polynomial.terms.items():
        powers = dict(monomial)
        powers[atom] -= power
        terms[tuple((a, p) for a, p in powers.items() if p)] = part
    return Polynomial(terms)


Rows = Sequence[Sequence[Polynomial]]


def cramer(rows: Rows, right: Sequence[Polynomial]) -> list[Expression]:
    """Return the solution, (n,), of n linear equations by Cramer's rule; the determinant must not be zero."""
    below = determinant(rows)
    solution: list[Expression] = []
    for n in range(len(rows)):
        above = determinant([_put(row, n, constant) for row, constant in zip(rows, right, strict=True)])
        solution.append(reduced_quotient(above, below) if above else ZERO)
    return solution


def _put(row: Sequence[Polynomial], column: int, entry: Polynomial) -> list[Polynomial]:
    """Return a row of a matrix with the coefficient at one place replaced."""
    return [entry if n == column else part for n, part in enumerate(row)]


def determinant(rows: Rows) -> Polynomial:
    """Return the determinant by Leibniz's formula."""
    parts: list[Polynomial] = []
    for sign, order in signed_permutations(len(rows)):
        product = Polynomial.from_expression(sign)
        for row, j in zip(rows, order, strict=True):
            product = product * row[j]
        parts.append(product)
    return total(parts)


def signed_permutations(size: int) -> Iterator[tuple[float, tuple[int, ...]]]:
    """Yield all permutations of n indices with their signs: 1 for even ones, else −1."""
    for order in permutations(range(size)):
        swaps = sum(a > b for n, a in enumerate(order) for b in order[n + 1 :])
        yield (-1.0 if swaps % 2 else 1.0), order


@dataclass(frozen=True, slots=True)
class SymbolicEquation:
    """A linear equation with symbolic coefficients: `rest` = Σ coefficient · unknown."""

    label: str
    left: Mapping[str, Polynomial]
    rest: Polynomial

    @property
    def negated(self) -> "SymbolicEquation":
        """Return the equation with all signs reversed."""
        left = {name: part.scale(-1.0) for name, part in self.left.items()}
        return SymbolicEquation(self.label, left, self.rest.scale(-1.0))

    @property
    def sides(self) -> tuple[Expression, Expression]:
        """Return both sides as formulas, with the unknowns on the right."""
        linear_form = total(part * Polynomial.from_expression(Symbol(name)) for name, part in self.left.items())
        return self.rest.expression(), linear_form.collected(self.left)


class CrossElimination:
    """A solver of symbolic linear equations that eliminates by cross-multiplication and writes the steps."""

    def __init__(self, book: SolutionBuilder, units: Mapping[str, str], opened: Callable[[str], StepBuilder]) -> None:
        """Take the LaTeX `units` of the unknowns and the function `opened` that begins a step."""
        self.book, self.units, self._opened = book, units, opened

    def reduce(self, equations: Sequence[SymbolicEquation], names: Sequence[str]) -> None:
        """Write the steps that solve the equations for all unknowns in `names`, the first unknown first."""
        last = names[-1]
        having = [equation for equation in equations if last in equation.left]
        pivot = min(having, key=lambda equation: (len(equation.left[last].terms), len(equation.left)))
        if len(names) > 1:
            rest = [equation for equation in equations if equation is not pivot]
            reduced = [self._without(equation, pivot, last) if last in equation.left else equation for equation in rest]
            self.reduce(reduced, names[:-1])
        step = self._opened("solve")
        step.rest_on(pivot.label)
        above, below = pivot.rest, pivot.left[last]
        for name, part in pivot.left.items():
            above = above - part * Polynomial.from_expression(Symbol(name)) if name != last else above
        if sum(below.terms.values()) < 0.0:
            above, below = above.scale(-1.0), below.scale(-1.0)
        where = f"From {pivot.label}, " if len(names) > 1 else "So "
        step.add_text(f"{where}{step.result(Symbol(last), reduced_quotient(above, below), self.units[last])}.")
        step.close()

    def _without(self, held: SymbolicEquation, pivot: SymbolicEquation, last: str) -> SymbolicEquation:
        """Eliminate an unknown by cross-multiplication of two equations; write and return their difference."""
        mine, other = _signed(pivot.left[last]), _signed(held.left[last])
        sign = -mine[0] * other[0]
        names = dict.fromkeys((*held.left, *pivot.left))
        none = Polynomial({})
        left = {
            name: held.left.get(name, none) * mine[1] + (pivot.left.get(name, none) * other[1]).scale(sign)
            for name in names
            if name != last
        }
        rest = held.rest * mine[1] + (pivot.rest * other[1]).scale(sign)
        difference = SymbolicEquation(self.book.labels.next(), {n: part for n, part in left.items() if part}, rest)
        step = self._opened("combine")
        step.rest_on(held.label)
        step.rest_on(pivot.label)
        step.label(difference.label)
        terms = [_times(mine[1], held.label), _times(other[1], pivot.label)]
        if sign < 0.0 and sum(part for held in difference.left.values() for part in held.terms.values()) < 0.0:
            difference = difference.negated
            terms.reverse()
        step.add_text(
            f"{(' + ' if sign > 0.0 else ' − ').join(terms)}: {difference.label} {step.derived(*difference.sides)}."
        )
        step.close()
        return difference


def _signed(polynomial: Polynomial) -> tuple[float, Polynomial]:
    """Return the common sign of all terms and the polynomial without it."""
    negative = all(part < 0.0 for part in polynomial.terms.values())
    return (-1.0, polynomial.scale(-1.0)) if negative else (1.0, polynomial)


def _times(weight: Polynomial, label: str) -> str:
    """Return the text of a weight times the label of an equation."""
    return label if weight.number == 1.0 else f"${parenthesized(weight.expression(), 1)}$·{label}"


@dataclass(frozen=True, slots=True)
class NumericEquation:
    """A linear equation with numerical coefficients: Σ coefficient · unknown = `right`."""

    label: str
    left: Mapping[str, Expression]
    right: Expression

    @property
    def sum(self) -> Expression:
        """Return the left side as one formula."""
        expression: Expression = ZERO
        for name, part in self.left.items():
            expression = sum_terms(expression, signed_term(part, name, 1.0))
        return expression


def signed_term(part: Expression, name: str, sign: float) -> Expression:
    """Return sign · coefficient · symbol, with the sign of a numerical coefficient in front of the whole term."""
    negative = isinstance(part, NumericFormula) and part.comes_to < 0.0
    size = -part if negative else part
    return multiply_factors(Number(-sign if negative else sign), multiply_factors(size, Symbol(name)))

"""Formulas simplified by sympy, which is loaded on first use; the shortest equivalent form is kept.

A formula is brought over one denominator in the field of rational functions, whose generators are its symbols, sines
and roots. Common factors are cancelled there; the result is factored or collected.
"""

# sympy ships no types; it is used only in this module, whose interface is typed:
# pyright: reportMissingTypeStubs=false, reportUnknownMemberType=false, reportUnknownVariableType=false
# pyright: reportUnknownArgumentType=false, reportUnknownParameterType=false
from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import reduce
from itertools import product
from math import inf
from operator import add, mul, truediv
from typing import Any

from sim2reason.solutions.algebra.expressions import (
    ONE,
    Expression,
    Number,
    Product,
    Quotient,
    Sum,
    Symbol,
    multiply_factors,
    ratio,
)
from sim2reason.solutions.algebra.functions import Call, Pi, Power, Root
from sim2reason.solutions.algebra.polynomials import Monomial, Polynomial, atom_sort_key

MIN_SIMPLIFIED_LENGTH = 60  # characters: shorter formulas are not simplified further
MAX_LENGTH_BY_PARTS = 400  # characters: simplifying longer formulas part by part has never saved half
MAX_SYMBOLS_BY_PARTS = 80  # symbols in a formula that is simplified part by part, at most
SHORTER_RATIO = 0.9  # relative length of a form that replaces a plainer one, at most
LEADING_MINUS_PENALTY = 8  # characters that a leading minus sign costs
MAX_FACTORED_TERMS = 30  # terms of a factored polynomial, at most
FUNCTIONS = 8  # sines, cosines and roots in one formula, at most
MAX_FRACTION_TERMS = 40  # terms in a numerator or denominator, at most


OPERATIONS = ((Sum, add), (Product, mul), (Quotient, truediv))


class TooLongError(Exception):
    """An error raised for a formula that exceeds the limits on its length."""


def shortest_form(expression: Expression, room: float = inf) -> Expression:
    """Return the shortest equivalent form found: over one denominator as a whole, or part by part.

    The search part by part stops when the symbols of the parts exceed `room` characters.
    """
    shortest = min((*_over_one(expression), expression), key=latex_length)
    many = sum(1 for _ in expression.symbols()) > MAX_SYMBOLS_BY_PARTS
    if (
        many
        or not MIN_SIMPLIFIED_LENGTH < latex_length(shortest) <= MAX_LENGTH_BY_PARTS
        or not any(name.startswith("\\sqrt") for name in _functions(expression))
    ):
        return shortest
    parts = list[Expression]()
    for part in expression.parts:
        parts.append(shortest_form(part, room))
        room -= sum(map(len, parts[-1].symbols()))
        if room < 0.0:
            return shortest
    parted = expression.built_of(parts)
    return parted if latex_length(parted) < SHORTER_RATIO * latex_length(shortest) else shortest


def latex_length(expression: Expression) -> int:
    """Return the number of characters of a formula's LaTeX, plus a penalty for avoidable minus signs."""
    latex = expression.latex()
    return len(latex) + LEADING_MINUS_PENALTY * (latex.count(r"\left(-") + latex.count("{-") + latex.startswith("-"))


def _over_one(expression: Expression) -> Iterator[Expression]:
    """Yield equivalent forms of a formula as one fraction; none if an intermediate form gets too long."""
    names = tuple(dict.fromkeys(expression.symbols()))
    if not names:
        return
    try:
        field = RationalFunctions(names, len(set(_functions(expression))))
        reduced = field.reduce_root_squares(field.to_field(expression))
        yield from field.rewritten_forms(reduced)
        plainer = field.without_sines_squared(reduced)
        if plainer != reduced:
            yield from field.rewritten_forms(plainer)
    except (TooLongError, ZeroDivisionError):
        return


class RationalFunctions:
    """The field of rational functions of symbols, sines and roots, as sympy represents it."""

    def __init__(self, names: tuple[str, ...], functions: int) -> None:
        """Take the symbols, and the largest number of sines and roots."""
        from sympy import ZZ  # noqa: PLC0415 - half a second, for which no other mode waits
        from sympy.polys.fields import field  # noqa: PLC0415

        if functions > FUNCTIONS:
            raise TooLongError
        self._field, *generators = field([f"x{k}" for k in range(len(names) + functions)], ZZ)
        self._symbols = dict(zip(names, generators, strict=False))
        self._atoms: list[Expression] = [Symbol(name) for name in names]
        self._spare = generators[len(names) :]
        self._met: dict[tuple[str, Any], Any] = {}
        self._squares: dict[int, Any] = {}  # radicands, by index of the root's generator

    def to_field(self, held: Expression) -> Any:
        """Return a formula as an element of the field."""
        if isinstance(held, Symbol):
            return self._symbols[held.name]
        if isinstance(held, Number):
            fraction = Fraction(held.x).limit_denominator(10**6)
            return self._field(fraction.numerator) / self._field(fraction.denominator)
        parts = [self.to_field(part) for part in held.parts]
        if isinstance(held, Pi):
            return self._atom(held, self._field(1))
        if isinstance(held, Root | Call):
            inner = self.reduce_root_squares(parts[0])
            return self._atom(held, min(inner, self.without_sines_squared(inner), key=_terms))
        if isinstance(held, Power):
            return self._sized(parts[0] ** held.exponent)
        operation = next((does for kind, does in OPERATIONS if isinstance(held, kind)), None)
        if operation is None:
            raise TooLongError
        return self._sized(reduce(operation, parts))

    def _sized(self, found: Any) -> Any:
        """Return a rational function unchanged; TooLongError if it has too many terms."""
        if max(len(found.numer), len(found.denom)) > MAX_FRACTION_TERMS:
            raise TooLongError
        return found

    def _atom(self, held: Root | Call | Pi, inner: Any) -> Any:
        """Return the generator of the field of rational functions that stands for a root, sine, cosine or π."""
        function = held.function if isinstance(held, Call) else held.latex() if isinstance(held, Pi) else "sqrt"
        if (function, inner) not in self._met:
            if len(self._met) == len(self._spare):  # one root in two forms, before and after its sine occurred
                raise TooLongError
            index = len(self._atoms)
            self._met[function, inner] = self._spare[len(self._met)]
            self._atoms.append(
                held if isinstance(held, Pi) else held.built_of([min(self.rewritten_forms(inner), key=latex_length)])
            )
            if isinstance(held, Root):
                self._squares[index] = inner
        return self._met[function, inner]

    def reduce_root_squares(self, found: Any) -> Any:
        """Replace the squares of roots in a rational function by their radicands."""
        for index, inside in self._squares.items():
            for side in (found.numer, found.denom):
                if any(monomial[index] > 1 for monomial in side):
                    found = self._rooted(found.numer, index, inside) / self._rooted(found.denom, index, inside)
                    break
        return self._sized(found)

    def without_sines_squared(self, found: Any) -> Any:
        """Replace sin² by 1 − cos² wherever the cosine of the same angle occurs."""
        for (function, inner), sine in self._met.items():
            cosine = self._met.get(("cos", inner))
            if function == "sin" and cosine is not None:
                index = self._spare.index(sine) + len(self._symbols)
                above, below = (self._rooted(side, index, 1 - cosine**2) for side in (found.numer, found.denom))
                found = above / below
        return self._sized(found)

    def _rooted(self, side: Any, place: int, inside: Any) -> Any:
        """Replace the squares of one root in a numerator or denominator by its radicand."""
        total = self._field(0)
        for monomial, part in side.items():
            pairs, left = divmod(monomial[place], 2)
            rest = (*monomial[:place], left, *monomial[place + 1 :])
            total += self._field(side.ring({rest: part})) * inside**pairs
        return total

    # ---- back

    def rewritten_forms(self, found: Any) -> Iterator[Expression]:
        """Yield forms of a rational function: expanded, with common factors in front, and factored."""
        above, below = found.numer, found.denom
        yield ratio(self._sum(above).expression(), self._sum(below).expression())
        top, bottom = (_signed(side) for side in (above, below))
        forms = [[self._sum(side).factored(), self._product(side)] for side in (top[1], bottom[1])]
        for one, other in product(*forms):
            yield _times(top[0] * bottom[0], ratio(one, other))

    def _product(self, side: Any) -> Expression:
        """Return a polynomial as a product of its irreducible factors."""
        factor, parts = _factored(side) if len(side) <= MAX_FACTORED_TERMS else (1, [(side, 1)])
        number, factors = float(factor), list[Expression]()
        for part, power in sorted(parts, key=lambda pair: len(pair[0])):
            sign, plain = _signed(part)
            one = self._gathered(plain)
            factors.append(one if power == 1 else Power(one, power))
            number *= float(sign**power)
        return reduce(multiply_factors, sorted(factors, key=_place), Number(number))

    def _sum(self, side: Any) -> Polynomial:
        """Return an expanded polynomial."""
        terms: dict[Monomial, float] = {}
        for powers, part in side.items():
            monomial = tuple((atom, power) for atom, power in zip(self._atoms, powers, strict=False) if power)
            terms[tuple(sorted(monomial, key=atom_sort_key))] = float(part)
        return Polynomial(dict(sorted(terms.items(), key=lambda term: [atom_sort_key(atom) for atom in term[0]])))

    def _gathered(self, side: Any) -> Expression:
        """Return a polynomial with the terms of one symbol, sine or root collected, where that is shorter."""
        polynomial = self._sum(side)
        options = [polynomial.expression()]
        atoms = {atom for monomial in polynomial.terms for atom, power in monomial if power == 1}
        for atom in sorted(atoms, key=lambda expression: expression.latex()):
            inside = Polynomial(
                {tuple(p for p in m if p != (atom, 1)): part for m, part in polynomial.terms.items() if (atom, 1) in m}
            )
            if len(inside.terms) > 1:
                rest = Polynomial({m: part for m, part in polynomial.terms.items() if (atom, 1) not in m})
                options.append(rest.expression() + Product((atom, inside.factored())))
        return min(options, key=latex_length)


def _factored(side: Any) -> tuple[Any, list[tuple[Any, int]]]:
    """Return the numerical factor of a polynomial, and its irreducible factors with their powers.

    The factors of p x + q, of first degree in a symbol x, are those of the greatest common divisor of p and q, and the
    quotient, which is irreducible (Gauss's lemma); that costs far less than Wang's algorithm.
    """
    for index in range(side.ring.ngens):
        powers = {monomial[index] for monomial in side}
        if powers != {0, 1}:
            continue
        parts = [{m: part for m, part in side.items() if m[index] == power} for power in (0, 1)]
        without = side.ring.from_dict(parts[0])
        before = side.ring.from_dict({(*m[:index], 0, *m[index + 1 :]): part for m, part in parts[1].items()})
        common = without.gcd(before)
        if common.is_ground:
            return 1, [(side, 1)]
        number, factors = _factored(common)
        return number, [*factors, (side.exquo(common), 1)]
    return side.factor_list()


def _terms(rational: Any) -> int:
    """Return the number of terms in the numerator and denominator of a rational function."""
    return len(rational.numer) + len(rational.denom)


def _functions(expression: Expression) -> Iterator[str]:
    """Yield the LaTeX of the roots and sines in a formula."""
    if isinstance(expression, Root | Call | Pi):
        yield expression.latex()
    for part in expression.parts:
        yield from _functions(part)


def _place(factor: Expression) -> tuple[int, str]:
    """Return the sort key of a factor: numbers, symbols, sums, roots, sines."""
    base = factor.base if isinstance(factor, Power) else factor
    return (6, "") if isinstance(base, Sum) else atom_sort_key((base, 1))


def _signed(side: Any) -> tuple[int, Any]:
    """Return the common or prevailing sign of a polynomial, and the polynomial without it."""
    negative = sum(part < 0 for part in side.values())
    return (-1, -side) if 2 * negative > len(side) else (1, side)


def _times(sign: int, expression: Expression) -> Expression:
    """Return a formula times a sign, 1 or −1."""
    return expression if sign > 0 else -expression if expression != ONE else Number(-1.0)

"""Polynomials in symbols: sums of products with like terms combined."""

import math
from collections.abc import Collection, Iterable, Mapping
from functools import lru_cache
from itertools import product
from typing import Self

from sim2reason.base.records import record
from sim2reason.solutions.algebra.expressions import (
    ZERO,
    Expression,
    Number,
    Quotient,
    Scalar,
    Symbol,
    Values,
    multiply_factors,
    sum_terms,
)
from sim2reason.solutions.algebra.functions import Call, Power, Root

COEFFICIENT_ATOL = 1e-12  # smaller coefficients count as zero
LETTER_RANKS = {
    r"\mu": 0,
    "m": 1,
    "M": 1,
    "g": 3,
    "a": 4,
    "T": 4,
    "N": 4,
    "v": 5,
    "t": 6,
}  # sort keys of letters; others 2
Monomial = tuple[tuple[Expression, int], ...]  # atoms and their exponents, in written order


@record()
class Polynomial:
    """A sum of coefficients times powers of atoms; an atom is a symbol, a root, or the sine or cosine of a symbol."""

    terms: Mapping[Monomial, float]

    @classmethod
    def from_expression(cls, atom: Expression | float) -> Self:
        """Return a symbol, function, root or number as a polynomial."""
        if isinstance(atom, Expression):
            return cls({((atom, 1),): 1.0})
        return cls({(): float(atom)} if atom else {})

    def __add__(self, other: "Polynomial") -> "Polynomial":
        """Return the sum."""
        return total((self, other))

    def __sub__(self, other: "Polynomial") -> "Polynomial":
        """Return the difference."""
        return total((self, other.scale(-1.0)))

    def __mul__(self, other: "Polynomial") -> "Polynomial":
        """Return the product, with sin² + cos² of one angle replaced by 1."""
        if (factor := self.number) is not None:
            return other.scale(factor)
        if (factor := other.number) is not None:
            return self.scale(factor)
        terms: dict[Monomial, float] = {}
        for one, a in self.terms.items():
            for two, b in other.terms.items():
                joined = _joined(one, two)
                terms[joined] = terms.get(joined, 0.0) + a * b
        return Polynomial(_cleaned(terms))

    def scale(self, factor: float) -> "Polynomial":
        """Return the polynomial times a number."""
        if factor == 1.0:
            return self
        return Polynomial({monomial: factor * part for monomial, part in self.terms.items()} if factor else {})

    def __bool__(self) -> bool:
        """Return whether the polynomial is not zero."""
        return bool(self.terms)

    @property
    def number(self) -> float | None:
        """Return the number to which the polynomial is equal; None for other polynomials."""
        if not self.terms:
            return 0.0
        return self.terms.get(()) if len(self.terms) == 1 else None

    @property
    def symbol(self) -> Symbol | None:
        """Return the symbol to which the polynomial is equal up to its sign; None for other polynomials."""
        if len(self.terms) != 1:
            return None
        (monomial, part), *_ = self.terms.items()
        plain = len(monomial) == 1 and monomial[0][1] == 1 and abs(part) == 1.0
        atom = monomial[0][0] if plain else None
        return atom if isinstance(atom, Symbol) else None

    def coefficient(self, name: str) -> "Polynomial":
        """Return the coefficient of the first power of a symbol."""
        atom = (Symbol(name), 1)
        return Polynomial(
            {tuple(p for p in monomial if p != atom): part for monomial, part in self.terms.items() if atom in monomial}
        )

    def terms_without(self, names: Collection[str]) -> "Polynomial":
        """Return the terms that contain none of some symbols."""
        return Polynomial({m: part for m, part in self.terms.items() if not _holds(m, names)})

    def holding(self, names: Collection[str]) -> "Polynomial":
        """Return the terms that contain one of some symbols."""
        return Polynomial({m: part for m, part in self.terms.items() if _holds(m, names)})

    def substitute(self, values: Mapping[str, "Polynomial"]) -> "Polynomial":
        """Substitute polynomials for symbols that occur in first powers."""
        if not any(_holds(monomial, values) for monomial in self.terms):
            return self
        parts: list[Polynomial] = []
        for monomial, part in self.terms.items():
            if not _holds(monomial, values):
                parts.append(Polynomial({monomial: part}))
                continue
            term = Polynomial({(): part})
            for atom, power in monomial:
                inner = values.get(atom.name) if isinstance(atom, Symbol) and power == 1 else None
                term = term * (inner if inner is not None else Polynomial({((atom, power),): 1.0}))
            parts.append(term)
        return total(parts)

    def names(self) -> set[str]:
        """Return the names of all symbols, also those in arguments of functions."""
        return {name for monomial in self.terms for atom, _ in monomial for name in atom.names}

    def value(self, at: Values) -> float:
        """Evaluate the polynomial directly; its value equals that of `expression` to the last digit."""
        result = sum((_term_value(monomial, part, at) for monomial, part in self.terms.items()), 0.0)
        assert not isinstance(result, complex)
        return result

    def expression(self) -> Expression:
        """Return the polynomial as a formula, term by term."""
        return sum_terms(*(term_expression(monomial, part) for monomial, part in self.terms.items()))

    def factored(self) -> Expression:
        """Return the polynomial as a formula with common factors in front: m g (sin θ − µ cos θ)."""
        if len(self.terms) < 2:
            return self.expression()
        shared = common_monomial(list(self.terms))
        if not shared:
            return self.expression()
        if all(part < 0.0 for part in self.terms.values()):
            return -self.scale(-1.0).factored()
        rest = Polynomial({_less(monomial, shared): part for monomial, part in self.terms.items()})
        inner, outer = rest.expression(), term_expression(shared, 1.0)
        trailing = isinstance(shared[-1][0], Call)
        return multiply_factors(inner, outer) if trailing and len(shared) == 1 else multiply_factors(outer, inner)

    def collected(self, names: Iterable[str]) -> Expression:
        """Return the polynomial as a formula with its terms collected by symbols: (m + M) a."""
        left = self
        expression: Expression = ZERO
        for name in names:
            before = left.coefficient(name)
            if before:
                expression = sum_terms(expression, _times(before, Symbol(name)))
                left = left.terms_without((name,))
        return sum_terms(expression, left.expression())


NIL = Polynomial({})


def total(parts: Iterable[Polynomial]) -> Polynomial:
    """Return the sum of polynomials."""
    first, *others = [*parts] or [NIL]
    terms = dict(first.terms)
    for part in others:
        for monomial, factor in part.terms.items():
            terms[monomial] = terms.get(monomial, 0.0) + factor
    return Polynomial(_cleaned(terms))


def term_expression(monomial: Monomial, part: float) -> Expression:
    """Return a term, a coefficient times a monomial, as a formula."""
    above, below = list[Expression]([Number(part)]), list[Expression]()
    for atom, power in monomial:
        (above if power > 0 else below).append(atom if abs(power) == 1 else Power(atom, abs(power)))
    numerator = multiply_factors(*above)
    return Quotient(numerator, multiply_factors(*below)) if below else numerator


def _term_value(monomial: Monomial, part: float, at: Values) -> Scalar:
    """Return the value of a term, a coefficient times a monomial."""
    above: Scalar = part
    below: Scalar = 1.0
    for atom, power in monomial:
        value = atom.value(at)
        if power > 0:
            above = above * (value if power == 1 else value**power)
        else:
            below = below * (value if power == -1 else value**-power)
    return above / below


def _times(before: Polynomial, last: Symbol) -> Expression:
    """Return a polynomial times a symbol as a formula, with the symbol last."""
    if len(before.terms) == 1:
        (monomial, part), *_ = before.terms.items()
        return term_expression(_joined(monomial, ((last, 1),)), part)
    if all(part < 0.0 for part in before.terms.values()):
        return -multiply_factors(before.scale(-1.0).expression(), last)
    return multiply_factors(before.expression(), last)


def atom_sort_key(part: tuple[Expression, int]) -> tuple[int, str]:
    """Return the sort key of an atom in a product: µ, masses, others, g, unknowns, roots, functions."""
    name = part[0].latex()
    if isinstance(part[0], Root):
        return 8, name
    if isinstance(part[0], Call):
        return 9, name
    return LETTER_RANKS.get(name.partition("_")[0], 2), name


@lru_cache(maxsize=8192)
def _joined(one: Monomial, two: Monomial) -> Monomial:
    """Return the product of two monomials, cached because laws multiply the same ones for each unknown."""
    if not one or not two:
        return one or two
    powers: dict[Expression, int] = dict(one)
    for atom, power in two:
        powers[atom] = powers.get(atom, 0) + power
    return tuple(sorted(((atom, power) for atom, power in powers.items() if power), key=atom_sort_key))


def _holds(monomial: Monomial, names: Collection[str]) -> bool:
    """Return whether a monomial contains one of some symbols."""
    return any(isinstance(atom, Symbol) and atom.name in names for atom, _ in monomial)


def _cleaned(terms: dict[Monomial, float]) -> dict[Monomial, float]:
    """Remove terms that cancel, and replace sin² + cos² by 1."""
    kept = _without_nothing(terms)
    if len(kept) < 2:
        return kept
    waiting = [monomial for monomial in kept if _squared_sine(monomial) is not None][::-1]
    if not waiting:
        return kept
    while waiting:
        monomial = waiting.pop()
        sine = _squared_sine(monomial)
        if sine is None or monomial not in kept:  # the partner of an earlier one
            continue
        part = kept[monomial]
        rest = tuple(pair for pair in monomial if pair[0] != sine)
        partner = _joined(rest, ((Call("cos", sine.argument), 2),))
        if abs(kept.get(partner, 0.0) - part) <= COEFFICIENT_ATOL and partner in kept:
            del kept[monomial], kept[partner]
            kept[rest] = kept.get(rest, 0.0) + part
            waiting.insert(0, rest)  # may pair with terms in sines and cosines of another angle
    return _without_nothing(kept)


def _without_nothing(terms: dict[Monomial, float]) -> dict[Monomial, float]:
    """Remove terms that cancel; return the same object if none does, which saves hashing all terms again."""
    for part in terms.values():
        if -COEFFICIENT_ATOL <= part <= COEFFICIENT_ATOL:
            break
    else:
        return terms
    return {monomial: part for monomial, part in terms.items() if abs(part) > COEFFICIENT_ATOL}


def _squared_sine(monomial: Monomial) -> Call | None:
    """Return the first squared sine in a monomial."""
    for atom, power in monomial:
        if power == 2 and isinstance(atom, Call) and atom.function == "sin":
            return atom
    return None


def divide_by_term(polynomial: Polynomial, monomial: Monomial, part: float) -> Polynomial | None:
    """Divide a polynomial by a single term; return None if a term is not divisible."""
    quotient_terms: dict[Monomial, float] = {}
    for term, factor in polynomial.terms.items():
        powers = dict(term)
        for atom, power in monomial:
            powers[atom] = powers.get(atom, 0) - power
        if any(power < 0 for power in powers.values()):
            return None
        quotient_terms[tuple((atom, power) for atom, power in powers.items() if power)] = factor / part
    return Polynomial(quotient_terms)


def common_monomial(monomials: list[Monomial]) -> Monomial:
    """Return the common factors of all monomials in their lowest powers; empty if there are no monomials."""
    common = dict(monomials[0]) if monomials else {}
    for monomial in monomials[1:]:
        powers = dict(monomial)
        common = {atom: min(power, powers[atom]) for atom, power in common.items() if atom in powers}
    return tuple(sorted(common.items(), key=atom_sort_key))


def _less(monomial: Monomial, shared: Monomial) -> Monomial:
    """Return a monomial divided by one of its divisors."""
    powers = dict(monomial)
    for atom, power in shared:
        powers[atom] -= power
    return tuple((atom, power) for atom, power in powers.items() if power)


def balance(forces: Polynomial) -> tuple[Expression, Expression]:
    """Return both sides of the equation forces = 0: its positive terms, and its negative terms negated."""
    positive = Polynomial({m: part for m, part in forces.terms.items() if part > 0.0})
    negative = Polynomial({m: -part for m, part in forces.terms.items() if part < 0.0})
    return positive.expression(), negative.expression()


MAX_ROOT_TERMS = 5  # terms of the root, at most


def square_root(inside: Polynomial, at: Mapping[str, float]) -> Polynomial | None:
    """Return the square root of a polynomial, positive for the known values `at`; None if it is no perfect square."""
    plain = [(m, part) for m, part in inside.terms.items() if part > 0.0 and all(power % 2 == 0 for _, power in m)]
    if not 1 <= len(plain) <= MAX_ROOT_TERMS:
        return None
    roots = [Polynomial({tuple((atom, power // 2) for atom, power in m): math.sqrt(part)}) for m, part in plain]
    for signs in product((1.0, -1.0), repeat=len(roots) - 1):
        candidate = total(root.scale(sign) for root, sign in zip(roots, (1.0, *signs), strict=True))
        if not (candidate * candidate - inside):
            return candidate if candidate.value(at) > 0.0 else candidate.scale(-1.0)
    return None

"""Fractions of polynomials, without what both of their sides share."""

from math import gcd

from sim2reason.solutions.algebra.expressions import Expression, Number, Quotient, multiplied
from sim2reason.solutions.algebra.polynomials import Polynomial

WHOLE = 1e-12  # by how much a factor may differ from an integer


def over(above: Polynomial, below: Polynomial, *, grouped: bool = False) -> Expression:
    """Divide two polynomials and cancel common factors; with `grouped`, put a common number in front of a sum."""
    if below.number is None:
        above, below = _cancelled(above, below)
        above, below = quotient(above, below) or (above, below)
    if below.number is not None:
        above = above.scaled(1.0 / below.number)
        shared = _shared_number([*above.terms.values()]) if grouped else 1.0
        return multiplied(Number(shared), above.scaled(1.0 / shared).factored())
    if all(part < 0.0 for part in below.terms.values()):
        above, below = above.scaled(-1.0), below.scaled(-1.0)
    shared = _common_number([*above.terms.values(), *below.terms.values()])
    above, below = above.scaled(1.0 / shared), below.scaled(1.0 / shared)
    return Quotient(above.factored(), below.factored())


def _common_number(factors: list[float]) -> float:
    """Return the greatest integer by which all factors can be divided; one where they are no integers."""
    whole = [round(factor) for factor in factors]
    if any(abs(factor - number) > WHOLE for factor, number in zip(factors, whole, strict=True)):
        return 1.0
    return float(gcd(*whole)) or 1.0


def _shared_number(factors: list[float]) -> float:
    """Return the smallest coefficient by magnitude if it divides all others, else 1."""
    least = min(map(abs, factors), default=1.0)
    whole = len(factors) > 1 and all(abs(factor / least - round(factor / least)) <= WHOLE for factor in factors)
    return least if whole else 1.0


def quotient(above: Polynomial, below: Polynomial) -> tuple[Polynomial, Polynomial] | None:
    """A fraction of two sums, one of which is the other times a single term, without that sum; else None."""
    for whole, part in ((above, below), (below, above)):
        if not whole.terms or len(whole.terms) != len(part.terms):
            continue
        (monomial, factor), *_ = part.terms.items()
        for term, value in whole.terms.items():
            powers = dict(term)
            for atom, power in monomial:
                powers[atom] = powers.get(atom, 0) - power
            ratio = Polynomial({tuple((atom, power) for atom, power in powers.items() if power): value / factor})
            if min(powers.values(), default=0) >= 0 and not ratio * part - whole:
                one = Polynomial.of(1.0)
                return (ratio, one) if whole is above else (one, ratio)
    return None


def _cancelled(above: Polynomial, below: Polynomial) -> tuple[Polynomial, Polynomial]:
    """A fraction without the atoms that all terms of both share."""
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


def _lowered(held: Polynomial, atom: Expression, power: int) -> Polynomial:
    found = dict[tuple[tuple[Expression, int], ...], float]()
    for monomial, part in held.terms.items():
        powers = dict(monomial)
        powers[atom] -= power
        found[tuple((a, p) for a, p in powers.items() if p)] = part
    return Polynomial(found)

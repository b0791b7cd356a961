"""Formulas for numbers of a mechanism that are sums: a total mass times others, or two products."""

from collections.abc import Sequence
from itertools import combinations, combinations_with_replacement
from math import prod
from typing import NamedTuple

import numpy as np

from sim2reason.scenes.dsl.state import Array
from sim2reason.solutions.algebra.polynomials import Polynomial, total

COINCIDENCE_RTOL = 1e-10  # relative tolerance, far below the distance of two numbers that agree by chance
COMMON_COEFFICIENTS = frozenset(
    sign * whole / part for sign in (1, -1) for whole in (1, 2, 3) for part in (1, 2, 3, 4, 5, 6, 12)
)
"""Coefficients of products in a sum, as in the moment of inertia of a tube, ½ m (R² + r²)."""
MAX_FACTORS = 3  # largest number of factors of a product
MAX_PRODUCTS = 600  # largest number of products whose pairs are tried
PROPORTIONAL_RTOL = 1e-6  # relative tolerance within which products in mechanism and twin are proportional


class LabelledNumber(NamedTuple):
    """A number with its formula and its values in a mechanism and in its twin, which has slightly other numbers."""

    here: float
    there: float
    name: Polynomial


def sum_of_products(
    here: float, there: float, masses: Sequence[LabelledNumber], atoms: Sequence[LabelledNumber]
) -> Polynomial | None:
    """Return a number, with its value `there` in the twin, as a sum of products; None if it is none.

    `masses` may be added up before they are multiplied by two `atoms`, the numbers of the text.
    """
    products = [*_products(atoms)]
    polynomial = _of_totals(here, there, masses, [product for product in products if len(product) < MAX_FACTORS])
    return polynomial if polynomial is not None else _of_pairs(here, there, products)


def _products(atoms: Sequence[LabelledNumber]) -> list[tuple[LabelledNumber, ...]]:
    products: list[tuple[LabelledNumber, ...]] = []
    for size in range(1, MAX_FACTORS + 1):
        more = [*combinations_with_replacement(atoms, size)]
        if len(products) + len(more) > MAX_PRODUCTS:
            break
        products += more
    return products


def _of_totals(
    here: float, there: float, masses: Sequence[LabelledNumber], products: Sequence[tuple[LabelledNumber, ...]]
) -> Polynomial | None:
    """Return a number as a sum of masses times a product of at most two numbers; None if it is none."""
    ones, others = _values([*products])
    for size in range(2, len(masses) + 1):
        for subset in combinations(masses, size):
            mass, twin = sum(one.here for one in subset), sum(one.there for one in subset)
            ratios = here / (mass * ones), there / (twin * others)
            fits = (np.abs(np.abs(ratios[0]) - 1.0) < COINCIDENCE_RTOL) & (
                np.abs(ratios[1] - ratios[0]) < COINCIDENCE_RTOL
            )
            if fits.any():
                number = int(np.argmax(fits))
                return (total(one.name for one in subset) * _product(products[number])).scale(
                    float(np.sign(ratios[0][number]))
                )
    return None


def _of_pairs(here: float, there: float, products: Sequence[tuple[LabelledNumber, ...]]) -> Polynomial | None:
    """Return a number as a sum of two products with simple coefficients; None if it is none."""
    ones, others = _values(products)
    det = ones[:, None] * others[None, :] - ones[None, :] * others[:, None]
    near = np.abs(det) <= PROPORTIONAL_RTOL * np.abs(ones[:, None] * others[None, :])
    with np.errstate(all="ignore"):
        first = (here * others[None, :] - there * ones[None, :]) / det
        second = (ones[:, None] * there - others[:, None] * here) / det
    first, second = _nearest(first), _nearest(second)
    for one, other in np.argwhere(~near & np.isfinite(first) & np.isfinite(second)).tolist():
        weights = [float(part[one, other]) for part in (first, second)]
        pair = products[one], products[other]
        value = sum(w * prod(atom.here for atom in factors) for w, factors in zip(weights, pair, strict=True))
        twin = sum(w * prod(atom.there for atom in factors) for w, factors in zip(weights, pair, strict=True))
        if abs(value - here) <= COINCIDENCE_RTOL * abs(here) and abs(twin - there) <= COINCIDENCE_RTOL * abs(there):
            return _product(pair[0]).scale(weights[0]) + _product(pair[1]).scale(weights[1])
    return None


def _nearest(values: Array) -> Array:
    """Round each value, (n, n), to the nearest common coefficient such as 1/2; NaN where none agrees with it."""
    common = np.array(sorted(COMMON_COEFFICIENTS))
    after = np.clip(np.searchsorted(common, values), 1, len(common) - 1)
    above, below = common[after], common[after - 1]
    nearest = np.where(np.abs(values - above) < np.abs(values - below), above, below)
    return np.where(np.abs(values - nearest) < PROPORTIONAL_RTOL * np.abs(values), nearest, np.nan)


def _values(products: Sequence[tuple[LabelledNumber, ...]]) -> tuple[Array, Array]:
    here = np.array([prod(atom.here for atom in factors) for factors in products])
    return here, np.array([prod(atom.there for atom in factors) for factors in products])


def _product(factors: tuple[LabelledNumber, ...]) -> Polynomial:
    product = Polynomial.from_expression(1.0)
    for atom in factors:
        product = product * atom.name
    return product

"""Tests of sums of products that are found from two values each."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.writing.number_sums import LabelledNumber, sum_of_products

VALUES = {"m_A": 2.3, "m_B": 3.1, "m_C": 1.7, "R": 0.21, "r": 0.07, "g": 9.8, "s": math.sin(0.6)}
MASSES = ("m_A", "m_B", "m_C")


def atoms(seed: int) -> dict[str, LabelledNumber]:
    rng = np.random.default_rng(seed)
    return {
        name: LabelledNumber(x, x * (1.0 + 1e-3 * rng.uniform(0.2, 1.0)), named(name)) for name, x in VALUES.items()
    }


def named(name: str) -> Polynomial:
    return Polynomial.from_expression(Symbol(name))


def found(held: dict[str, LabelledNumber], polynomial: Polynomial) -> Polynomial | None:
    here = polynomial.value({name: part.here for name, part in held.items()})
    there = polynomial.value({name: part.there for name, part in held.items()})
    return sum_of_products(here, there, [held[name] for name in MASSES], list(held.values()))


@given(st.integers(0, 50), st.sets(st.sampled_from(MASSES), min_size=2), st.sampled_from((1.0, -1.0)))
def test_a_total_mass_times_two_numbers_is_found(seed: int, masses: set[str], sign: float) -> None:
    total = sum((named(name) for name in sorted(masses)), Polynomial({}))
    sought = (total * named("g") * named("s")).scale(sign)
    read = found(atoms(seed), sought)
    assert read is not None
    assert not read - sought


@given(st.integers(0, 50), st.sampled_from((0.5, 1.0, -1.0)), st.sampled_from((0.5, 0.25, 1.0)))
def test_a_sum_of_two_products_is_found(seed: int, one: float, other: float) -> None:
    """An example is ½ m (R² + r²) for a tube."""
    mass, outer, inner = (named(name) for name in ("m_A", "R", "r"))
    sought = (mass * outer * outer).scale(one) + (mass * inner * inner).scale(other)
    read = found(atoms(seed), sought)
    assert read is not None
    assert read.value(VALUES) == pytest.approx(sought.value(VALUES), rel=1e-9)


def test_a_number_that_is_no_sum_is_none() -> None:
    held = list(atoms(1).values())
    assert sum_of_products(1.234567, 1.2345671, held[:3], held) is None

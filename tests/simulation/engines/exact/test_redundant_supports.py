"""Tests of nonnegative least squares, against a search over all sets of unknowns."""

from itertools import combinations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.exact.redundant_supports import nonnegative


def best(matrix: Array, right: Array) -> float:
    """Return the least |A x − b| over x ≥ 0, by ordinary least squares over every subset of columns."""
    columns = matrix.shape[1]
    found = float(np.linalg.norm(right))
    for count in range(1, columns + 1):
        for chosen in combinations(range(columns), count):
            x = np.linalg.lstsq(matrix[:, chosen], right, rcond=None)[0]
            if (x >= -1e-12).all():
                found = min(found, float(np.linalg.norm(matrix[:, chosen] @ x - right)))
    return found


@settings(max_examples=60)
@given(seed=st.integers(0, 10**6), rows=st.integers(1, 4), columns=st.integers(1, 6))
def test_nothing_comes_nearer(seed: int, rows: int, columns: int) -> None:
    rng = np.random.default_rng(seed)
    matrix, right = rng.integers(-3, 4, (rows, columns)).astype(float), rng.integers(-3, 4, rows).astype(float)
    x, residual = nonnegative(matrix, right)
    assert (x >= 0.0).all()
    assert np.linalg.norm(matrix @ x - right) == pytest.approx(best(matrix, right), abs=1e-9)
    assert residual == pytest.approx(float(np.abs(matrix @ x - right).max()), abs=1e-12)


def test_a_table_on_four_legs_can_stand() -> None:
    """Three equations have four unknown forces; the load is off-centre, but between the legs."""
    places = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
    matrix = np.vstack([np.ones(4), places.T])
    x, residual = nonnegative(matrix, np.array([1.0, 0.9, 0.9]))
    assert residual <= 1e-12
    assert x.sum() == pytest.approx(1.0)
    _, residual = nonnegative(matrix, np.array([1.0, 1.1, 0.0]))  # beyond the edge it tips
    assert residual > 1e-3

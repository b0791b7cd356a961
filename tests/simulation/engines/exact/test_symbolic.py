"""Tests of symbolic elimination, against NumPy."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sim2reason.scenes.dsl.vectors import Number
from sim2reason.simulation.engines.exact.linear import solve_symbolic
from sim2reason.simulation.engines.exact.tape import Tape


def systems(seed: int, n: int, rows: int) -> np.ndarray:
    """Return a random system M, Jᵀ, F over J, 0, target of shape (n + rows, n + rows + 1)."""
    rng = np.random.default_rng(seed)
    root, jacobian = rng.normal(size=(n, n)), rng.normal(size=(rows, n)) * (rng.random((rows, n)) < 0.7)
    jacobian[np.arange(rows), np.arange(rows)] += 2.0
    top = np.hstack([root @ root.T + n * np.eye(n), jacobian.T])
    bottom = np.hstack([jacobian, np.zeros((rows, rows))])
    return np.hstack([np.vstack([top, bottom]), rng.normal(size=(n + rows, 1))])


def recorded(matrix: np.ndarray) -> tuple[Tape, list[list[Number]]]:
    """Return a matrix on a tape, each nonzero entry as its multiple of t = 1."""
    tape = Tape(["t"])
    tape.stand([1.0])
    t = tape.inputs["t"]
    return tape, [[float(entry) * t if entry else 0.0 for entry in row] for row in matrix.tolist()]


@settings(max_examples=40)
@given(seed=st.integers(0, 10**6), n=st.integers(1, 6), share=st.integers(0, 3))
def test_it_solves_what_numpy_solves(seed: int, n: int, share: int) -> None:
    rows = min(share, n)
    matrix = systems(seed, n, rows)
    tape, equations = recorded(matrix)
    found = solve_symbolic(equations, n, list(range(rows)), [])
    wanted = np.linalg.solve(matrix[:, :-1], matrix[:, -1])
    values = tape.code([*found.x, *found.rows.values()])(math)(1.0, ())
    assert values == pytest.approx(wanted, rel=1e-8, abs=1e-8)
    assert not found.free
    assert len(found.pivots) == n + rows


def test_a_row_that_says_the_same_again_is_left_free() -> None:
    matrix = systems(1, 3, 1)
    row = matrix[3].copy()
    doubled = np.zeros((5, 6))
    doubled[:4, :4], doubled[:4, 5] = matrix[:, :4], matrix[:, 4]
    doubled[:3, 4] = doubled[:3, 3]
    doubled[4, :3], doubled[4, 5] = row[:3], row[4]
    tape, equations = recorded(doubled)
    found = solve_symbolic(equations, 3, [0, 1], [])
    wanted = np.linalg.solve(matrix[:, :-1], matrix[:, -1])
    values = tape.code([*found.x, found.rows[0] + found.rows[1]])(math)(1.0, ())
    assert values == pytest.approx(wanted, rel=1e-9)
    assert found.free


def test_nothing_is_nothing() -> None:
    assert solve_symbolic([], 0, [], []).x == []

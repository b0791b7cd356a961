"""Tests of vectors and tensors of any numeric type, against NumPy."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim2reason.scenes.dsl.vectors import (
    Tensor,
    Vector,
    add_triples,
    apply_tensor,
    cross,
    dot,
    scale_triple,
    subtract_triples,
)

NUMBER = st.floats(-1e3, 1e3)
VECTOR = st.tuples(NUMBER, NUMBER, NUMBER)


@given(a=VECTOR, b=VECTOR, factor=NUMBER)
def test_they_are_what_numpy_says(a: Vector, b: Vector, factor: float) -> None:
    assert dot(a, b) == pytest.approx(float(np.dot(a, b)), abs=1e-6)
    assert cross(a, b) == pytest.approx(np.cross(a, b), abs=1e-6)
    assert add_triples(a, b) == pytest.approx(np.add(a, b))
    assert subtract_triples(a, b) == pytest.approx(np.subtract(a, b))
    assert scale_triple(factor, a) == pytest.approx(np.multiply(factor, a))


@given(tensor=st.tuples(*[NUMBER] * 6), vector=VECTOR)
def test_a_tensor_applied_is_a_matrix_times_a_vector(tensor: Tensor, vector: Vector) -> None:
    xx, yy, zz, xy, xz, yz = tensor
    matrix = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    assert apply_tensor(tensor, vector) == pytest.approx(matrix @ vector, abs=1e-6)

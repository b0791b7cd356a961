"""Tests of the search for a root in a bracket."""

from math import cos, pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim2reason.simulation.engines.exact.crossings import bracketed_root


@given(root=st.floats(0.001, 0.999), slope=st.floats(1e-9, 1e9), bend=st.floats(-0.9, 0.9))
def test_a_root_is_found_to_the_last_digits(root: float, slope: float, bend: float) -> None:
    def function(x: float) -> float:
        return slope * (root - x) * (1.0 + bend * x)

    assert bracketed_root(function, 0.0, 1.0) == pytest.approx(root, abs=1e-15, rel=1e-15)


@given(root=st.floats(0.01, 0.99), power=st.sampled_from([3, 5, 9]))
def test_a_flat_root_is_bracketed(root: float, power: int) -> None:
    found = bracketed_root(lambda x: (root - x) ** power, 0.0, 1.0)
    assert abs(root - found) ** power < 1e-15


def test_ends() -> None:
    assert bracketed_root(lambda x: -1.0 - x, 0.2, 0.7) == 0.2
    assert bracketed_root(lambda x: 1.0 - x, 0.3, 0.3) == 0.3
    assert bracketed_root(lambda x: 0.5 - x, 0.0, 0.5) == 0.5


def test_few_calls_are_needed() -> None:
    calls: list[float] = []

    def function(x: float) -> float:
        calls.append(x)
        return cos(x)

    assert bracketed_root(function, 0.0, 3.0) == pytest.approx(pi / 2.0, rel=1e-15)
    assert len(calls) < 20


def test_a_jump_is_found_too() -> None:
    assert bracketed_root(lambda x: 1.0 if x < 0.3 else -5.0, 0.0, 1.0) == pytest.approx(0.3, abs=1e-15)

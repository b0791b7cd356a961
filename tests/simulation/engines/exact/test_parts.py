"""Tests of the exact engine's numerical parts: linear systems, least squares, roots."""

from math import inf, sqrt

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from sim2reason.scenes.dsl.vectors import scale, unit
from sim2reason.simulation.engines.exact.glide import Approach, crossing, stopping_time
from sim2reason.simulation.engines.exact.linear import solve
from sim2reason.simulation.engines.exact.redundant_supports import nonnegative

seeds = st.integers(0, 2**32 - 1)


@given(seed=seeds, size=st.integers(1, 9))
def test_regular_systems(seed: int, size: int) -> None:
    rng = np.random.default_rng(seed)
    matrix, right = rng.normal(size=(size, size)) + 3.0 * np.eye(size), rng.normal(size=size)
    found = solve(np.column_stack([matrix, right]).tolist())
    assert found.consistent
    assert found.nulls == []
    assert matrix @ found.x == pytest.approx(right, abs=1e-9)


@given(seed=seeds, size=st.integers(2, 8), rank=st.integers(1, 7))
def test_singular_systems(seed: int, size: int, rank: int) -> None:
    rng = np.random.default_rng(seed)
    rank = min(rank, size - 1)
    matrix = rng.integers(-3, 4, (size, rank)) @ rng.integers(-3, 4, (rank, size)).astype(float)
    right = matrix @ rng.integers(-3, 4, size)
    found = solve(np.column_stack([matrix, right]).tolist())
    assert found.consistent
    assert len(found.nulls) == size - np.linalg.matrix_rank(matrix)
    assert matrix @ found.x == pytest.approx(right, abs=1e-8)
    for null in found.nulls:
        assert matrix @ null == pytest.approx(np.zeros(size), abs=1e-8)


def test_a_contradiction() -> None:
    assert not solve([[1.0, 1.0, 1.0], [1.0, 1.0, 2.0]]).consistent
    assert not solve([[0.0, 3.0]]).consistent
    assert solve([]).x == []


@given(seed=seeds, rows=st.integers(1, 6), columns=st.integers(1, 8))
@example(seed=4, rows=4, columns=8)  # two unknowns that stay positive have to be given up and taken again
@example(seed=2, rows=6, columns=8)
def test_least_squares_without_negative_unknowns(seed: int, rows: int, columns: int) -> None:
    """The result satisfies the Karush–Kuhn–Tucker conditions: x ≥ 0, no positive gain, none where x > 0."""
    rng = np.random.default_rng(seed)
    matrix, right = rng.normal(size=(rows, columns)), rng.normal(size=rows)
    x, residual = nonnegative(matrix, right)
    gain = matrix.T @ (right - matrix @ x)
    assert (x >= 0.0).all()
    assert (gain <= 1e-9).all()
    assert x @ gain == pytest.approx(0.0, abs=1e-9)
    assert residual == pytest.approx(np.abs(right - matrix @ x).max())


@pytest.mark.parametrize(
    ("margin", "time"),
    [
        ((1.0, -1.0, 0.0), 1.0),
        ((1.0, 0.0, -2.0), 1.0),
        ((1.0, 1.0, -4.0), 1.0),
        ((1.0, -3.0, 4.0), 0.5),
        ((1.0, 1.0, 1.0), inf),
        ((1.0, 0.0, 0.0), inf),
        ((1.0, -1.0, 1.0), inf),
        ((0.0, -1.0, 9.0), 0.0),
        ((0.0, 0.0, -1.0), 0.0),
        ((0.0, 0.0, 0.0), inf),
        ((0.0, 2.0, -1.0), 4.0),
        ((-1e-12, 2.0, 1.0), inf),
        ((1.0, -1.0, 1e-18), 1.0),
        ((1e-6, -1e3, 1e-3), 1e-9),
    ],
)
def test_when_a_margin_is_used_up(margin: tuple[float, float, float], time: float) -> None:
    assert crossing(*margin) == pytest.approx(time, rel=1e-12)


def test_when_a_speed_passes_zero() -> None:
    assert stopping_time(2.0, -4.0) == 0.5
    assert stopping_time(2.0, 4.0) == stopping_time(0.0, -1.0) == stopping_time(1.0, 0.0) == inf


@settings(max_examples=300)
@given(seed=seeds)
@example(seed=15997)  # the hit comes after 978 s
def test_the_first_hit_among_all_times(seed: int) -> None:
    """A fine scan of the distance finds no earlier hit, for straight and curved paths, also from contact."""
    rng = np.random.default_rng(seed)
    apart, velocity, acceleration = rng.uniform(-3.0, 3.0, (3, 3))
    if rng.random() < 0.3:
        velocity, acceleration = velocity[0] * apart, acceleration[0] * apart
    if rng.random() < 0.3:
        acceleration = np.zeros(3)
    size = float(np.linalg.norm(apart))
    touching = rng.random() < 0.3
    near = Approach(
        tuple(apart), tuple(velocity), tuple(acceleration), size if touching else rng.uniform(0.1, 1.0) * size
    )
    hit = near.hit()
    t = np.linspace(0.0, min(hit, 20.0), 4001)[1:-1, None]
    gaps = np.linalg.norm(apart + velocity * t + acceleration * t**2 / 2.0, axis=1) - near.distance
    assert gaps.size == 0 or gaps.min() > -1e-9
    if 0.0 < hit < inf:
        end = apart + velocity * hit + acceleration * hit**2 / 2.0
        speed = float(np.linalg.norm(velocity + acceleration * hit))  # times are right to 1e-12, however late
        assert np.linalg.norm(end) == pytest.approx(near.distance, rel=1e-9, abs=1e-12 * speed * hit)
    if hit == 0.0:
        assert touching
        assert near.rate < 0.0


@pytest.mark.parametrize(
    ("speed", "pull", "time"),
    [(2.0, 0.0, 0.5), (1.0, 2.0, (sqrt(5.0) - 1.0) / 2.0), (0.0, 2.0, 1.0), (-1.0, 2.0, (sqrt(5.0) + 1.0) / 2.0)],
)
def test_points_hit_each_other_head_on_in_any_direction(speed: float, pull: float, time: float) -> None:
    """Points 1 m apart meet when v t + a t²/2 = 1 m; the square of their distance has a double root there."""
    rng = np.random.default_rng(3)
    for x, y, z in [(1.0, 0.0, 0.0), *rng.normal(size=(20, 3))]:
        direction = unit((float(x), float(y), float(z)))
        near = Approach(direction, scale(-speed, direction), scale(-pull, direction), 0.0)
        assert near.hit() == pytest.approx(time, rel=1e-14)


def test_points_that_pass_each_other_do_not_hit() -> None:
    """At a millionth of a radian they pass at 1 µm, farther than 0.5 µm, and 2 µm would be a hit."""
    assert Approach((1.0, 0.0, 0.0), (-2.0, 2e-6, 0.0), (0.0, 0.0, 0.0), 0.5e-6).hit() == inf
    assert Approach((1.0, 0.0, 0.0), (-2.0, 2e-6, 0.0), (0.0, 0.0, 0.0), 2e-6).hit() == pytest.approx(0.5, abs=1e-6)


def test_the_second_derivative_of_a_gap() -> None:
    """Circular motion at r with speed v has r̈ = v²/r."""
    assert Approach((2.0, 0.0, 0.0), (0.0, 3.0, 0.0), (0.0, 0.0, 0.0), 1.0).second == pytest.approx(4.5)

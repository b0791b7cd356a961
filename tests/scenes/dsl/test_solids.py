"""Tests of solids that are rotated, moved, joined and cut, against sums over point clouds."""

from math import nextafter

import numpy as np
import pytest
from numpy.typing import NDArray

from quadrature import Cloud, block, column, lens, moments
from sim2reason.scenes.dsl import solids
from sim2reason.scenes.dsl.solids import TENSOR_INDICES, Axes, Solid, axes_along, compose_axes

CLOSE = 1e-10


def rotation(rng: np.random.Generator) -> tuple[Axes, NDArray[np.float64]]:
    """Return random axes, and the same as the columns of a matrix."""
    matrix, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    matrix *= np.linalg.det(matrix)
    x, y, z = ((float(c[0]), float(c[1]), float(c[2])) for c in matrix.T)
    return (x, y, z), matrix


def check(found: Solid, cloud: Cloud) -> None:
    size, center, second = moments(cloud)
    assert found.size == pytest.approx(size, rel=CLOSE)
    assert found.center == pytest.approx(center.tolist(), abs=CLOSE)
    assert found.second == pytest.approx([float(second[i, j]) for i, j in TENSOR_INDICES], abs=CLOSE * abs(size))


@pytest.mark.parametrize("seed", range(6))
def test_turned_moved_joined_and_cut(seed: int) -> None:
    """The parallel-axis theorem and signed sums hold for any orientation and position."""
    rng = np.random.default_rng(seed)
    axes, matrix = rotation(rng)
    by = (float(rng.normal()), float(rng.normal()), float(rng.normal()))
    one, two = solids.box(0.4, 0.6, 0.9), solids.prism(6, 0.1, 0.2)
    (p, u), (q, w) = block(0.4, 0.6, 0.9), column(6, 0.1, 0.2)
    check(one.turned(axes).moved(by), (p @ matrix.T + by, u))
    check(one.moved(by).turned(axes), ((p + by) @ matrix.T, u))
    check(one + two.turned(axes).moved(by), (np.concatenate([p, q @ matrix.T + by]), np.concatenate([u, w])))
    check(one - two.turned(axes), (np.concatenate([p, q @ matrix.T]), np.concatenate([u, -w])))


@pytest.mark.parametrize("seed", range(4))
def test_two_turns_are_one(seed: int) -> None:
    rng = np.random.default_rng(seed)
    (first, one), (second, two) = rotation(rng), rotation(rng)
    turned = np.array(compose_axes(first, second)).T
    assert turned == pytest.approx(two @ one)


@pytest.mark.parametrize("axis", [(1.0, 0.0, 0.0), (0.0, -1.0, 0.0), (0.6, 0.0, 0.8), (0.0, 0.6, -0.8)])
def test_axes_along_are_axes(axis: tuple[float, float, float]) -> None:
    axes = np.array(axes_along(axis))
    assert axes @ axes.T == pytest.approx(np.eye(3))
    assert np.linalg.det(axes) == pytest.approx(1.0)
    assert tuple(axes[2]) == pytest.approx(axis)


@pytest.mark.parametrize(
    ("radius", "other", "distance"),
    [(1.0, 0.5, 0.8), (1.0, 0.9, 0.2), (0.5, 1.0, 0.8), (1.0, 0.3, 0.5), (0.3, 1.0, 0.5)],
)
def test_what_two_balls_share(radius: float, other: float, distance: float) -> None:
    """Two balls intersect in a lens of two caps, or in the smaller ball if the larger one contains it."""
    check(solids.lens(radius, other, distance), lens(radius, other, distance))


def test_balls_that_are_apart_share_nothing() -> None:
    assert solids.lens(0.3, 0.3, 0.7).size == 0.0
    whole = solids.ball(1.0) - solids.lens(1.0, 0.3, 2.0)
    assert whole == solids.ball(1.0)


def test_balls_that_touch_within_rounding_share_nothing() -> None:
    radius, other = 0.084, 0.0339
    assert solids.segment(radius, 0.0) == solids.NOTHING
    for distance in (radius + other, nextafter(radius + other, 0.0), nextafter(radius + other, 1.0)):
        assert solids.lens(radius, other, distance).size <= 1e-15

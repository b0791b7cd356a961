"""Tests of the MuJoCo engine's own integrator and of its interpolation between steps."""

from math import cos, log2, sin

import numpy as np
import pytest

from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.mujoco.integration import (
    MAX_STEP_RATIO,
    MIN_STEP_RATIO,
    SUBSTEP_SEQUENCE,
    Knot,
    Quintic,
    extrapolate_step,
    interpolate_knots,
)


def swing(time: float, y: Array) -> Array:
    """Return the rates of ẍ = −x + sin 2t; from x = 0, ẋ = 0 the solution is x = ⅔ sin t − ⅓ sin 2t."""
    return np.array([y[1], -y[0] + sin(2.0 * time)])


def wanted(time: float) -> Array:
    return np.array([2.0 * sin(time) - sin(2.0 * time), 2.0 * cos(time) - 2.0 * cos(2.0 * time)]) / 3.0


def missed(h: float, tolerance: float) -> float:
    y = wanted(1.0)
    found = extrapolate_step(swing, 1.0, y, swing(1.0, y), h, tolerance)
    return float(np.abs(found.values - wanted(1.0 + h)).max())


def test_all_columns_together_are_of_order_ten() -> None:
    assert 9.0 < log2(missed(1.0, 1e-16) / missed(0.5, 1e-16)) < 12.5


def test_a_step_stops_at_the_column_that_is_near_enough() -> None:
    calls: list[float] = []

    def counted(time: float, y: Array) -> Array:
        calls.append(time)
        return swing(time, y)

    y = wanted(1.0)
    easy = extrapolate_step(counted, 1.0, y, swing(1.0, y), 0.05, 1e-7)
    assert easy.error <= 1.0
    assert len(calls) < sum(SUBSTEP_SEQUENCE)
    assert easy.factor == MAX_STEP_RATIO


def test_a_step_that_is_too_long_says_so() -> None:
    y = wanted(1.0)
    hard = extrapolate_step(swing, 1.0, y, swing(1.0, y), 6.0, 1e-7)
    assert hard.error > 1.0
    assert MIN_STEP_RATIO <= hard.factor < 1.0


def test_the_curve_between_two_knots_is_exact_for_quintics() -> None:
    polynomial = np.polynomial.Polynomial([0.3, -1.0, 0.5, 2.0, -0.7, 0.2])
    slope, bend = polynomial.deriv(), polynomial.deriv(2)
    knots = [Knot(t, np.array([polynomial(t), slope(t)]), np.array([slope(t), bend(t)])) for t in (0.4, 1.1)]
    times = np.linspace(0.4, 1.1, 8)
    curve = Quintic(knots[0], knots[1])
    found = np.array([np.concatenate(curve.at(time)) for time in times])
    assert found[:, 0] == pytest.approx(polynomial(times), rel=1e-13)
    assert found[:, 1] == pytest.approx(slope(times), rel=1e-12)
    assert (np.concatenate(Quintic(knots[0], knots[0]).at(0.4)) == knots[0].values).all()


def test_the_curve_through_four_knots_is_exact_to_the_eleventh_power() -> None:
    polynomial = np.polynomial.Polynomial([0.3, -1.0, 0.5, 2.0, -0.7, 0.2, 0.1, -0.3, 0.4, 0.1, -0.2, 0.05])
    slope, bend = polynomial.deriv(), polynomial.deriv(2)
    at = (0.1, 0.4, 0.6, 1.1)
    knots = [Knot(t, np.array([polynomial(t), slope(t)]), np.array([slope(t), bend(t)])) for t in at]
    times = np.linspace(0.1, 1.1, 9)
    found = interpolate_knots(knots, times)
    assert found[:, 0] == pytest.approx(polynomial(times), rel=1e-10)
    assert found[:, 1] == pytest.approx(slope(times), rel=1e-9)

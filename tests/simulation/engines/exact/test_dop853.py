"""Tests of the integrator of the exact engine, on equations with known solutions."""

from math import cos, log2, sin

import pytest

from sim2reason.simulation.engines.exact import dop853

Values = dop853.Values
TOLERANCE = (1e-13, 1e-11)


def swing(time: float, y: Values) -> Values:
    """Return the rates of ẍ = −x + sin 2t; from x = 0, ẋ = 0 the solution is x = ⅔ sin t − ⅓ sin 2t."""
    return (y[1], -y[0] + sin(2.0 * time))


def wanted(time: float) -> tuple[float, float]:
    return (2.0 * sin(time) - sin(2.0 * time)) / 3.0, (2.0 * cos(time) - 2.0 * cos(2.0 * time)) / 3.0


def followed(steps: int, until: float = 2.0) -> Values:
    h, y = until / steps, (0.0, 0.0)
    for number in range(steps):
        y = dop853.advance(swing, number * h, y, swing(number * h, y), h, TOLERANCE).values
    return y


def test_steps_are_of_order_eight() -> None:
    errors = [abs(followed(steps)[0] - wanted(2.0)[0]) for steps in (4, 8)]
    assert 7.0 < log2(errors[0] / errors[1]) < 9.5


def test_between_the_ends_of_a_step_the_order_is_seven() -> None:
    def missed(h: float) -> float:
        y = wanted(1.0)
        step = dop853.advance(swing, 1.0, y, swing(1.0, y), h, TOLERANCE)
        polynomial = dop853.dense(swing, 1.0, y, h, step.values, step.stages)
        return max(abs(dop853.interpolated(y, polynomial, x)[0] - wanted(1.0 + x * h)[0]) for x in (0.2, 0.5, 0.7))

    assert 7.0 < log2(missed(1.2) / missed(0.6)) < 9.5


def test_the_ends_of_a_step_are_met_exactly() -> None:
    y = wanted(1.0)
    step = dop853.advance(swing, 1.0, y, swing(1.0, y), 0.3, TOLERANCE)
    polynomial = dop853.dense(swing, 1.0, y, 0.3, step.values, step.stages)
    assert dop853.interpolated(y, polynomial, 0.0) == y
    assert dop853.interpolated(y, polynomial, 1.0) == pytest.approx(step.values, rel=1e-15)
    for x in (0.0, 0.37, 1.0):
        both = tuple(dop853.interpolated_one(*each, x) for each in zip(y, polynomial, strict=True))
        assert dop853.interpolated(y, polynomial, x) == both
    assert step.stages[-1] == pytest.approx(swing(1.3, step.values), rel=1e-15)


def test_the_estimate_of_an_error_is_near_or_above_the_error() -> None:
    y = wanted(1.0)
    step = dop853.advance(swing, 1.0, y, swing(1.0, y), 1.0, (1e-9, 1e-9))
    error = max(abs(a - b) for a, b in zip(step.values, wanted(2.0), strict=True))
    assert error <= step.error * 2e-9


def test_the_next_step_is_longer_or_shorter_within_bounds() -> None:
    assert dop853.step_ratio(0.0) == dop853.MAX_STEP_RATIO
    assert dop853.step_ratio(1e-30) == dop853.MAX_STEP_RATIO
    assert dop853.step_ratio(1e30) == dop853.MIN_STEP_RATIO
    assert dop853.step_ratio(1.0) == pytest.approx(dop853.SAFETY)


def test_a_first_step_is_accepted_and_not_timid() -> None:
    h = dop853.first_step(swing, 0.0, (0.3, 0.1), swing(0.0, (0.3, 0.1)), TOLERANCE)
    error = dop853.advance(swing, 0.0, (0.3, 0.1), swing(0.0, (0.3, 0.1)), h, TOLERANCE).error
    assert error <= 1.0
    assert h > 1e-3


def test_nothing_to_integrate_is_no_error() -> None:
    assert dop853.advance(lambda _t, _y: (), 0.0, (), (), 0.5, TOLERANCE).values == ()

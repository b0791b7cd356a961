"""Tests of measures: how numbers are rounded, drawn and printed with their units."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim2reason.scenes.dsl.measures import Measure, Range, join_unit, show_unit
from sim2reason.scenes.dsl.units import UnitError

MASS, ANGLE, FRICTION = Measure("mass", "kg", "m"), Measure("angle", "deg", "a", 0), Measure("friction", "", "µ", 2)


@pytest.mark.parametrize(
    ("measure", "value", "said"),
    [
        (MASS, 2.0, "2.0 kg"),
        (MASS, 0.66, "0.66 kg"),
        (MASS, 14.0, "14 kg"),
        (MASS, 120.0, "120 kg"),
        (MASS, 2.345, "2.345 kg"),  # not rounded in a file: said in full
        (ANGLE, 30.0, "30°"),
        (FRICTION, 0.2, "0.20"),
        (FRICTION, 0.0, "0"),
        (Measure("velocity", "m/s", "v", 2), -1.5, "−1.50 m/s"),
        (Measure("velocity", "m/s", "v", 2), 12.34, "12.3 m/s"),
    ],
)
def test_how_numbers_are_spoken(measure: Measure, value: float, said: str) -> None:
    assert measure.say(measure.round(value) if value == 12.34 else value) == said


@given(st.floats(1e-3, 9e3))
def test_a_rounded_number_is_said_exactly(value: float) -> None:
    rounded = MASS.round(value)
    assert float(MASS.say(rounded).split()[0]) == rounded
    assert rounded == pytest.approx(value, rel=0.051)


@given(st.integers(0, 2**32 - 1), st.floats(0.1, 5.0), st.floats(0.0, 20.0))
def test_draws_stay_in_their_range(seed: int, low: float, width: float) -> None:
    drawn = MASS.draw(np.random.default_rng(seed), low, low + width)
    assert low <= drawn <= low + width


def test_units_come_from_the_one_table() -> None:
    assert show_unit("m/s^2") == "m/s²"
    assert join_unit("30", "deg") == "30°"
    assert join_unit("3", "kg m/s") == "3 kg·m/s"
    with pytest.raises(UnitError):
        Measure("speed", "furlong/fortnight", "v")


@pytest.mark.parametrize(("low", "high"), [(2.0, 1.0), (0.0, float("inf")), (float("nan"), 1.0)])
def test_a_range_that_is_none_is_refused(low: float, high: float) -> None:
    with pytest.raises(ValueError, match="not a range"):
        Range(low, high)

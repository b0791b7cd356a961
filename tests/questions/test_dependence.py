"""The number of a scene at which an answer has a given value, however little the answer changes with it."""

from math import exp

import pytest

from sim2reason.questions.dependence import Dependence

ROOT = 3.0


class Weak(Dependence):
    """An answer that goes with a small power of the number; as well known as numbers are."""

    def __init__(self, power: float) -> None:
        self.power = power

    def __call__(self, value: float) -> float | None:
        return (value / ROOT) ** self.power * exp(1.0)


@pytest.mark.parametrize("power", [0.05, -0.05, 1.0])
def test_a_weak_dependence_leaves_the_number_as_well_known(power: float) -> None:
    for away in (0.01, -0.008, 0.005, 0.002, -0.001, 0.0003):
        found = Weak(power).solved(exp(1.0), ROOT * (1.0 + away))
        assert found == pytest.approx(ROOT, rel=1e-13 / abs(power))

"""Phases of constant acceleration without integration, against closed forms."""

from math import cos, radians, sin

import pytest

from sim2reason.questions.need import ELEMENTARY
from sim2reason.solutions.solve import solve_prompt
from sim2reason.testing.solutions.faults import faults

SLABS = (
    "Slab A (15 kg) lies on a rough, fixed plane inclined at 38° to the horizontal and carries slab B of mass 17 kg. "
    "The coefficients of static and of kinetic friction on this plane are both 0.30. Static and kinetic friction "
    "between A and B have the same coefficient, 0.31. At t = 0 B has a velocity of 4.7 m/s, directed up the slope, and "
    "all else is at rest. What is the time from t = 0 until slab A first begins to slip? There is ample room to move. "
    "Here g = 9.8 m/s². Give your answer in s, to three significant figures, inside \\boxed{}."
)


def test_a_slab_slips_when_the_one_on_it_has_come_to_rest() -> None:
    """B is slowed down by g (sin θ + µ cos θ); its weight is one of the numbers that the equations add up."""
    found, setting = solve_prompt(SLABS)
    assert found.strategy == "phase by phase", found.reason
    slowed = 9.8 * (sin(radians(38)) + 0.31 * cos(radians(38)))
    assert found.answer == pytest.approx(4.7 / slowed, rel=1e-9)
    assert found.derived
    assert found.needs <= ELEMENTARY
    assert setting.answer is not None
    assert not faults(found, setting.answer), found.text
    assert "numerical" not in found.text

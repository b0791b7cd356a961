"""Phases of constant acceleration without integration, against closed forms."""

from math import cos, radians, sin

import pytest

from sim2reason.questions import Query
from sim2reason.questions.moments.away import Away
from sim2reason.questions.need import ELEMENTARY
from sim2reason.scene_files import loads
from sim2reason.solutions import STRATEGIES, by
from sim2reason.solutions.solve import solve_prompt
from sim2reason.testing.solutions.faults import faults
from worked import asked

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


STICKING_PUCKS = """scene:
  name: scene
  entities:
  - name: table
    type: TwoDCollisionPlane
    parameters:
      table: {tilt: 29.0}
      radius: 0.3
      pucks:
      - {mass: 7.6, x: 1.42, y: 1.22, vx: 0.5, vy: -0.63}
      - {mass: 8.9, x: -0.45, y: -0.26, vx: 4.2, vy: 2.36}
      - {mass: 8.4, x: 0.34, y: -1.48, vx: 1.66, vy: 1.71}
      - {mass: 9.6, x: 0.82, y: 0.18, vx: 2.66, vy: 1.24}
      restitution: 0.0
  world: {gravity: 9.8}
"""


def test_what_has_no_numbers_in_the_text_is_refused_in_words() -> None:
    setting = asked(loads(STICKING_PUCKS), Query("time_to_event", None, Away("table.pucks.1", 6.9)))
    found = by(STRATEGIES["phase by phase"], setting)
    assert found.answer is None
    assert "no numbers" in found.reason

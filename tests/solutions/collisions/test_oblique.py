"""Tests of oblique collisions: discs with impact parameter b and distance d of the centres at contact."""

from math import sqrt

import pytest

from sim2reason.questions import Query, Target
from sim2reason.questions.moments.contacts import Collided
from sim2reason.scenes.bodies.blocks import Puck, Table
from sim2reason.scenes.entities.two_d_collision_plane import TwoDCollisionPlane
from worked import answer

SPEED, APART, RADIUS, BOUNCE = 2.013, 1.0, 0.1, 0.6


def pucks(aside: float) -> TwoDCollisionPlane:
    """Build a puck of 1 kg that moves along (0.6, 0.8), and one of 2 kg at rest."""
    one = Puck(mass=1.0, x=0.0, y=0.0, vx=0.6 * SPEED, vy=0.8 * SPEED)
    other = Puck(mass=2.0, x=0.6 * APART - 0.8 * aside, y=0.8 * APART + 0.6 * aside, vx=0.0, vy=0.0)
    return TwoDCollisionPlane(table=Table(), radius=RADIUS, pucks=(one, other), restitution=BOUNCE)


@pytest.mark.parametrize("aside", [0.1, 0.199])
def test_five_digits_are_enough_even_where_they_hardly_touch(aside: float) -> None:
    """The time is t = (X − √(d² − b²))/v, and the puck at rest gets (1 + e) m v n/(m + M).

    Kleppner and Kolenkow, § 4.14.
    """
    deep, entity = sqrt(4.0 * RADIUS**2 - aside**2), pucks(aside)
    moment = Collided("table.pucks.0 & table.pucks.1")
    time = answer("table", entity, Query("time_to_event", None, moment))
    assert time == pytest.approx((APART - deep) / SPEED, rel=1e-9)
    after = Query("event", Target("velocity", "table.pucks.1"), Collided("table.pucks.0 & table.pucks.1", after=True))
    expected = (1.0 + BOUNCE) * SPEED / 3.0 * deep / (2.0 * RADIUS)
    assert answer("table", entity, after) == pytest.approx(expected, rel=1e-9)

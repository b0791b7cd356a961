"""Tests of extreme values of quantities of a pendulum against energy and circular motion."""

import re
from math import cos, radians, sqrt

import pytest

from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.times import WholeMotion
from sim2reason.scenes.bodies.oscillators import Ball, LightRod
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import Pendulum
from sim2reason.solutions import Solution
from worked import derived

G, LENGTH = 9.8, 1.4


def extreme(functional: str, angle: float, speed: float, of: str = "swing.bob") -> Solution:
    entity = Pendulum(bob=Ball(mass=0.32), hanger=LightRod(length=LENGTH), angle=angle, speed=speed)
    query = StretchQuery("extremum", None, WholeMotion(), functional, of)
    found = derived(Scene(entities=(Named(name="swing", entity=entity),)), query)
    assert found.strategy == "energy and circular motion"
    return found


def turning(angle: float, speed: float) -> float:
    """Return the cosine of the angle of the turning point."""
    return cos(radians(angle)) - speed**2 / (2.0 * G * LENGTH)


def test_a_small_swing_is_accelerated_most_where_it_turns_back() -> None:
    cosine = turning(11.0, 0.76)
    found = extreme("greatest acceleration", 11.0, 0.76)
    assert found.answer == pytest.approx(G * sqrt(1.0 - cosine**2), rel=1e-9)
    assert "at one end of the range: as the comparison below shows, at the turning points." in found.text
    (other,) = (float(r.right.value(found.values).real) for r in found.relations if r.role == "verified")
    assert other == pytest.approx(2.0 * G * (1.0 - cosine), rel=1e-9)
    assert re.search(r"At the lowest point the acceleration is \$a_.* = .*\$, less than \$a\$\.", found.text)


def test_a_large_swing_is_accelerated_most_at_the_lowest_point() -> None:
    """For amplitudes above arccos 3/5, v²/ℓ at the lowest point exceeds g sin φ at the turning point."""
    cosine = turning(11.0, 4.1)
    assert cosine < 0.6
    found = extreme("greatest acceleration", 11.0, 4.1)
    assert found.answer == pytest.approx(2.0 * G * (1.0 - cosine), rel=1e-9)
    assert "at one end of the range: as the comparison below shows, at the lowest point." in found.text
    (other,) = (float(r.right.value(found.values).real) for r in found.relations if r.role == "verified")
    assert other == pytest.approx(G * sqrt(1.0 - cosine**2), rel=1e-9)
    assert re.search(r"At a turning point the acceleration is \$a_.* = .*\$, less than \$a\$\.", found.text)


def test_the_text_says_where_the_speed_is_greatest() -> None:
    found = extreme("greatest speed", 50.0, 1.0)
    assert found.answer == pytest.approx(sqrt(1.0 + 2.0 * G * LENGTH * (1.0 - cos(radians(50.0)))), rel=1e-9)
    assert "By conservation of energy, the speed is greatest at the lowest point." in found.text


def test_a_force_is_greatest_where_speed_and_weight_along_the_rod_are() -> None:
    text = extreme("greatest rod force", 50.0, 1.0, of="swing.hanger").text
    assert "because the speed and the component of the weight along the rod" in text

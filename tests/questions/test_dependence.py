"""Tests of the number at which an answer has a given value, even for a weak dependence."""

from math import exp, inf, log

import numpy as np
import pytest

from sim2reason.questions import Query, SimulatedScene, Target
from sim2reason.questions.dependence import AnswerFunction
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.contacts import Collided
from sim2reason.questions.moments.distances import Farthest
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.study import EXACT_STEP_ERROR
from sim2reason.scenes.bodies.space import LevelGround, Rocket
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.space import RocketEntity
from sim2reason.scenes.files import loads

ROOT = 3.0


class Weak(AnswerFunction):
    """Answer that varies as a small power of the number, with the same relative accuracy."""

    def __init__(self, power: float) -> None:
        self.power = power

    def __call__(self, value: float) -> float | None:
        return (value / ROOT) ** self.power * exp(1.0)


@pytest.mark.parametrize("power", [0.05, -0.05, 1.0])
def test_a_weak_dependence_leaves_the_number_as_well_known(power: float) -> None:
    for away in (0.01, -0.008, 0.005, 0.002, -0.001, 0.0003):
        found = Weak(power).solve_from(exp(1.0), ROOT * (1.0 + away))
        assert found == pytest.approx(ROOT, rel=1e-13 / abs(power))


@pytest.mark.parametrize(("time", "height"), [(50.0, None), (100.0, 5150.0)])
def test_what_has_come_down_lies_there(time: float, height: float | None) -> None:
    """A rocket is back on the ground after 75 s, and has travelled twice its greatest height, of 5150 m.

    At burn-out h = u t_b − u (m_1/r) ln(m_0/m_1) − g t_b²/2 and v = u ln(m_0/m_1) − g t_b; it rises by v²/2g more.
    """
    mass, dry, exhaust, rate, g = 574.0, 220.0, 440.0, 22.0, 9.8
    entity = RocketEntity(rocket=Rocket(mass=mass, dry=dry), place=LevelGround(), exhaust=0.44, rate=rate)
    scene = Scene(entities=(Named(name="rocket", entity=entity),))
    study = SimulatedScene.of(scene, np.array([0.0, 20.0]))
    query = StretchQuery("sum", None, AtTime(time), "distance travelled", "rocket.rocket")
    burnt = (mass - dry) / rate
    speed = exhaust * log(mass / dry) - g * burnt
    top = exhaust * (burnt - dry / rate * log(mass / dry)) - 0.5 * g * burnt**2 + speed**2 / (2.0 * g)
    found = AnswerFunction(query, study, "rocket.rocket.mass")(mass)
    assert found is not None
    if height is None:
        assert found < 2.0 * top
    else:
        assert found == pytest.approx(2.0 * top, rel=1e-5)
        assert top == pytest.approx(height, rel=1e-3)


TRACK = """
scene:
  entities:
  - name: t
    type: ComplexCollisionPlane
    parameters:
      track: {}
      gliders: [{kind: glider, mass: 1.0, x: 0.0, v: 2.0}, {kind: glider, mass: 2.0, x: 0.8, v: 0.0}]
      restitution: 0.5
"""


def test_an_event_comes_though_it_did_not_at_a_value_nearby() -> None:
    """A cart at v reaches another 0.8 m ahead after 0.8 m/v; for one at 1 mm/s no motion is followed so long."""
    scene = loads(TRACK)
    study = SimulatedScene.of(scene, np.array([0.0, scene.horizon]))
    query = Query("time_to_event", None, Collided("t.gliders.0 & t.gliders.1"))
    answer = AnswerFunction(query, study, "t.gliders.0.v")
    assert [answer(0.001), answer(0.5)] == [inf, pytest.approx(1.6)]


PLANETS = """
scene:
  name: scene
  entities:
  - name: system
    type: SolarSystem
    parameters:
      star: {mass: 0.89}
      planets:
      - {kind: heavy_planet, mass: 0.23, x: 0.5, y: -0.36, vx: 3.58, vy: 6.67}
      - {kind: heavy_planet, mass: 0.34, x: -0.7, y: -1.07, vx: 5.05, vy: -1.91}
"""


def test_what_goes_round_may_overtake_what_flies_off() -> None:
    """Planet B escapes from a star of 0.343 solar masses while A orbits it; they are farthest apart after 7.4 yr."""
    study = SimulatedScene.of(loads(PLANETS), np.array([0.0, 0.3]))
    pair = Farthest("system.planets.0 & system.planets.1")
    query = Query("event", Target("kinetic energy", "system.planets.0"), pair)
    dependence = AnswerFunction(query, study, "system.star.mass", EXACT_STEP_ERROR)
    assert dependence(0.89) == pytest.approx(9.2, rel=1e-3)
    assert dependence(0.343) == pytest.approx(9.2, rel=0.02)

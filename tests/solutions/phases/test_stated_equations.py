"""Tests of the equations of motion that integrations state in the symbols of the text, and of refused cases."""

from math import cos, radians, sqrt

import numpy as np
import pytest

from sim2reason.questions import Query, Target
from sim2reason.questions.moments.times import AtTime
from sim2reason.scenes.bodies.blocks import LongPrism
from sim2reason.scenes.bodies.simple_machines import Incline
from sim2reason.scenes.bodies.space import AirlessPlanet, HeavyPlanet, Rocket, Star
from sim2reason.scenes.dsl.entity import Entity, Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.rolling import TumblingPrism
from sim2reason.scenes.entities.space import RocketEntity, SolarSystem
from sim2reason.solutions import STRATEGIES, ProblemContext, solve_with
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.checking import recompute
from sim2reason.solutions.data import as_data
from sim2reason.solutions.laws.equations_of_motion import EquationsOfMotion
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import faults
from worked import asked

PLANETS = (
    HeavyPlanet(mass=0.5, x=0.4, y=0.1, vx=-4.0, vy=10.0),
    HeavyPlanet(mass=0.7, x=0.4, y=0.7, vx=-8.0, vy=3.5),
)


def scene(name: str, entity: Entity) -> Scene:
    return Scene(entities=(Named(name=name, entity=entity),))


def text_of(setting: ProblemContext) -> str:
    """Return the text of the solution by integration after checking its answer, its data and the text itself."""
    found = solve_with(STRATEGIES["integration"], setting)
    assert found.answer is not None, found.reason
    assert setting.answer is not None
    assert not faults(found, setting.answer)
    assert recompute(as_data(found)).answer == pytest.approx(setting.answer, rel=1e-8)
    reading = read(found.text)
    assert not reading.unread
    assert not reading.broken, reading.broken
    assert "integrated numerically" in found.text
    return found.text


def test_planets_that_attract_each_other_are_told_with_the_constant_of_gravitation() -> None:
    system = SolarSystem(star=Star(mass=1.8), planets=PLANETS)
    query = Query("state", Target("velocity", "system.planets.0"), AtTime(0.03))
    text = text_of(asked(scene("system", system), query))
    assert "G = 4 \\pi^{2}" in text
    assert "M m_A G" in text
    assert "m_A m_B G" in text


@pytest.fixture
def launch() -> ProblemContext:
    planet = AirlessPlanet(radius=1800.0, gravity=4.7)
    rocket = RocketEntity(rocket=Rocket(mass=1000.0, dry=200.0), place=planet, exhaust=4.0, rate=2.5)
    return asked(scene("rocket", rocket), Query("state", Target("velocity", "rocket.rocket"), AtTime(200.0)))


def test_a_rocket_on_a_planet_has_its_own_gravity_in_its_equation(launch: ProblemContext) -> None:
    text = text_of(launch)
    assert "R^{2} g_0" in text
    assert "from its starting point" in text


def test_laws_in_which_something_has_no_value_are_refused(
    launch: ProblemContext, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(EquationsOfMotion, "load", lambda *_: Polynomial.from_expression(Symbol("z")))
    assert "no number for z" in solve_with(STRATEGIES["integration"], launch).reason


@pytest.fixture
def tumbling() -> ProblemContext:
    prism = TumblingPrism(prism=LongPrism(mass=5.0, shape="hexagonal", radius=0.1), plane=Incline(angle=0.0), rate=6.0)
    query = Query("state", Target("angular velocity", "prism.prism"), AtTime(0.1))
    return asked(scene("prism", prism), query)


def test_an_initial_rate_that_the_text_does_not_give_is_refused(tumbling: ProblemContext) -> None:
    """The initial velocity of the prism's centre is ω R in a direction that the text doesn't give."""
    found = solve_with(STRATEGIES["integration"], tumbling)
    assert found.answer is None
    assert "initial rate 0.519615" in found.reason  # ω R cos 30°


def test_a_prism_turns_about_its_edge_as_a_pendulum_upside_down(tumbling: ProblemContext) -> None:
    """From the upright position θ″ = (m g R/I) sin θ with I = (5/12 + 1) m R²; energy gives the angular velocity."""
    state = tumbling.study.trace.sample(np.array([0.1]))
    turned = abs(float(state.q[0, 2]))
    rise = 0.1 * (cos(radians(30.0) - turned) - cos(radians(30.0)))
    expected = sqrt(36.0 - 2.0 * 9.8 * rise / (0.01 * 17.0 / 12.0))
    assert tumbling.answer == pytest.approx(expected, rel=1e-9)

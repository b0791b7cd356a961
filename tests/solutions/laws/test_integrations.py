"""Integrations: what no strategy derives has its equations at least, in the symbols of the text where it can."""

from collections.abc import Iterator
from dataclasses import replace
from math import cos, radians, sqrt

import numpy as np
import pytest

from sim2reason.bodies.incline import Incline
from sim2reason.bodies.polygonal_prism import LongPrism
from sim2reason.bodies.rocket import AirlessPlanet, Rocket
from sim2reason.bodies.star import HeavyPlanet, Star
from sim2reason.datasets.item_search import ItemSearch
from sim2reason.datasets.request import Request
from sim2reason.dsl.entity import Entity, Named
from sim2reason.dsl.scene import Scene
from sim2reason.entities.rocket_entity import RocketEntity
from sim2reason.entities.solar_system import SolarSystem
from sim2reason.entities.tumbling_prism import TumblingPrism
from sim2reason.questions import Query, StatedResult, Target
from sim2reason.questions.moments.at_time import AtTime
from sim2reason.questions.moments.orbited import Orbited
from sim2reason.questions.moments.went_taut import WentTaut
from sim2reason.recipes import Difficulty
from sim2reason.solutions import STRATEGIES, Setting, by
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.laws.equations_of_motion import EquationsOfMotion
from sim2reason.solutions.reverse import forward
from sim2reason.testing.solutions.faults import faults
from sim2reason.testing.solutions.reading import read
from worked import asked

PLANETS = (
    HeavyPlanet(mass=0.5, x=0.4, y=0.1, vx=-4.0, vy=10.0),
    HeavyPlanet(mass=0.7, x=0.4, y=0.7, vx=-8.0, vy=3.5),
)
PAIR = "system.planets.0 & system.star"


def scene(name: str, entity: Entity) -> Scene:
    return Scene(entities=(Named(name=name, entity=entity),))


def text_of(setting: Setting) -> str:
    """What integration tells, every check passed, its text alone included."""
    found = by(STRATEGIES["integration"], setting)
    assert found.answer is not None, found.reason
    assert setting.answer is not None
    assert not faults(found, setting.answer)
    reading = read(found.text)
    assert not reading.unread
    assert not reading.broken, reading.broken
    assert "numerical integration" in found.text
    return found.text


def test_planets_that_attract_each_other_are_told_with_the_constant_of_gravitation() -> None:
    system = SolarSystem(star=Star(mass=1.8), planets=PLANETS)
    setting = asked(scene("system", system), Query("time_to_event", None, Orbited(PAIR, 90)))
    text = text_of(replace(setting, unknown="system.star.mass", stated=StatedResult("0.05", "yr")))
    assert "G = 4 \\pi^{2}" in text
    assert "M m_A G" in text
    assert "other values of $M$" in text
    assert "hang on" not in text


def test_a_rocket_on_a_planet_has_its_own_gravity_in_its_equation() -> None:
    planet = AirlessPlanet(radius=1800.0, gravity=4.7)
    rocket = RocketEntity(rocket=Rocket(mass=1000.0, dry=200.0), place=planet, exhaust=4.0, rate=2.5)
    setting = asked(scene("rocket", rocket), Query("state", Target("velocity", "rocket.rocket"), AtTime(200.0)))
    text = text_of(setting)
    assert "R^{2} g_0" in text
    assert "from its starting point" in text


def test_laws_in_which_something_has_no_value_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    planet = AirlessPlanet(radius=1800.0, gravity=4.7)
    rocket = RocketEntity(rocket=Rocket(mass=1000.0, dry=200.0), place=planet, exhaust=4.0, rate=2.5)
    setting = asked(scene("rocket", rocket), Query("state", Target("velocity", "rocket.rocket"), AtTime(200.0)))
    monkeypatch.setattr(EquationsOfMotion, "load", lambda *_: Polynomial.of(Symbol("z")))
    assert "no number for z" in by(STRATEGIES["integration"], setting).reason


@pytest.fixture
def tumbling() -> Setting:
    prism = TumblingPrism(prism=LongPrism(mass=5.0, shape="hexagonal", radius=0.1), plane=Incline(angle=0.0), rate=6.0)
    query = Query("state", Target("angular velocity", "prism.prism"), AtTime(0.1))
    return asked(scene("prism", prism), query)


def test_a_prism_that_stands_on_an_edge_is_pressed_and_held_there(tumbling: Setting) -> None:
    text = text_of(tumbling)
    assert "It stands on an edge, on which the plane presses with $N$ and which friction $f$ holds." in text
    assert "off the plane" in text


def test_a_prism_turns_about_its_edge_as_a_pendulum_upside_down(tumbling: Setting) -> None:
    """θ″ = (m g R/I) sin θ from the upright, I = (5/12 + 1) m R²: by energy at the angle that it has then."""
    state = tumbling.study.trace.sample(np.array([0.1]))
    turned = abs(float(state.q[0, 2]))
    rise = 0.1 * (cos(radians(30.0) - turned) - cos(radians(30.0)))
    expected = sqrt(36.0 - 2.0 * 9.8 * rise / (0.01 * 17.0 / 12.0))
    assert tumbling.answer == pytest.approx(expected, rel=1e-9)


def drawn(recipe: str, difficulty: Difficulty, mode: str, count: int) -> Iterator[Setting]:
    for index in range(count):
        found = ItemSearch(Request(recipe, difficulty, mode, 703, index)).found()
        if found is not None:
            yield forward(found.setting)


@pytest.mark.parametrize(("recipe", "difficulty"), [("mixed", "medium"), ("mixed", "easy")])
def test_what_symbols_make_too_long_or_have_no_twin_is_told_in_numbers(recipe: str, difficulty: Difficulty) -> None:
    found = (setting for setting in drawn(recipe, difficulty, "reverse", 80) if in_numbers(setting))
    assert text_of(next(found))


def in_numbers(setting: Setting) -> bool:
    return "in them that hang on" in by(STRATEGIES["integration"], setting).text


def test_a_moment_at_which_a_string_becomes_taut_has_the_equations_of_one_of_its_sides() -> None:
    """Two motions of one scene may have the event a last digit apart."""
    found = (setting for setting in drawn("pendulum", "hard", "numeric", 80) if becomes_taut(setting))
    assert text_of(next(found))


def becomes_taut(setting: Setting) -> bool:
    moment = setting.query.moment
    return isinstance(moment, WentTaut) and any(event.kind in moment.kinds for event in setting.motion.events)

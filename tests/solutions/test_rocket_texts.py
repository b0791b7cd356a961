"""Solutions about rockets write the velocity as a function of time before they integrate it."""

import re

import numpy as np
import pytest

from sim2reason.bodies.rocket import DeepSpace, LevelGround, Rocket, StartingPlace
from sim2reason.dsl.entity import Named
from sim2reason.dsl.scene import Scene
from sim2reason.entities.rocket_entity import RocketEntity
from sim2reason.questions import Query, Target
from sim2reason.questions.moments.at_time import AtTime
from sim2reason.questions.moments.burned_out import BurnedOut
from sim2reason.questions.moments.moved import Moved
from sim2reason.questions.moments.stopped import Stopped
from sim2reason.solutions import Solution, solve
from sim2reason.testing.solutions.faults import faults
from sim2reason.testing.solutions.reading import read
from worked import asked

VELOCITY = re.compile(r"its velocity at the time \$\\tau\$ after [a-z -]+ is \$([^$]*)\$")
UPPER = re.compile(r"integrated from 0 to \$([^$]*)\$, \$(s(?:_\{\\text\{out\}\})?) = ")
HEAVY, LIGHT = 20.0, 9.0  # kg/s: of these rates of burning the first lifts the rocket at once


def flight(place: StartingPlace, rate: float, moment: object, quantity: str = "displacement") -> Solution:
    rocket = RocketEntity(rocket=Rocket(mass=700.0, dry=300.0), place=place, exhaust=0.6, rate=rate)
    scene = Scene(entities=(Named(name="e", entity=rocket),))
    (body,) = (body.name for body in scene.mechanism.bodies if body.coordinates)
    made = moment(body) if isinstance(moment, type) else moment
    kind = "state" if isinstance(made, AtTime) else "event"
    setting = asked(scene, Query(kind, Target(quantity, body), made))  # type: ignore[arg-type]
    found = solve(setting)
    assert found.answer is not None, found.reason
    assert setting.answer is not None
    assert not faults(found, setting.answer), found.text
    assert not read(found.text).broken
    return found


@pytest.mark.parametrize("place", [DeepSpace(), LevelGround()])
@pytest.mark.parametrize("rate", [HEAVY, LIGHT])
@pytest.mark.parametrize("moment", [BurnedOut, AtTime(46.0)])
def test_a_distance_is_the_integral_of_the_velocity_that_is_written(
    place: StartingPlace, rate: float, moment: object
) -> None:
    """By Gauss and Legendre, from the text alone."""
    found = flight(place, rate, moment)
    (velocity,), ((until, name),) = VELOCITY.findall(found.text), UPPER.findall(found.text)
    end = read(f"$y = {until}$", found.values).values["y"]
    places, weights = np.polynomial.legendre.leggauss(40)
    speeds = [
        read(f"$y = {velocity}$", {**found.values, r"\tau": 0.5 * end * (1.0 + place)}).values["y"]
        for place in places.tolist()
    ]
    assert 0.5 * end * float(weights @ speeds) == pytest.approx(found.values[name], rel=1e-9)


def test_how_high_a_rocket_comes_does_not_take_how_long_it_falls_free() -> None:
    """Nor when it lifts off."""
    found = flight(LevelGround(), LIGHT, Stopped)
    assert r"t_{\text{off}}" not in found.text
    assert r"t_{\text{lift}}" not in found.text


def test_the_time_of_a_distance_comes_from_the_integral_of_the_velocity() -> None:
    rocket = RocketEntity(rocket=Rocket(mass=700.0, dry=300.0), place=DeepSpace(), exhaust=0.6, rate=HEAVY)
    scene = Scene(entities=(Named(name="e", entity=rocket),))
    (body,) = (body.name for body in scene.mechanism.bodies if body.coordinates)
    found = solve(asked(scene, Query("time_to_event", None, Moved(body, 1000.0))))
    assert VELOCITY.search(found.text)
    assert found.text.index("its velocity") < found.text.index("By integration")

"""Tests of rocket solutions, which write the velocity as a function of time before integrating it."""

import re
from dataclasses import replace
from itertools import product

import numpy as np
import pytest

from sim2reason.questions import Query, StatedResult, Target
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.times import AtTime, BurnedOut
from sim2reason.questions.moments.turning_points import Stopped
from sim2reason.scenes.bodies.space import DeepSpace, LevelGround, Rocket, StartingPlace
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.space import RocketEntity
from sim2reason.solutions import Solution, solve
from sim2reason.solutions.solve import solve_prompt
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import faults
from worked import asked

VELOCITY = re.compile(r"the velocity of the probe with the engine on is \$([^$]*)\$ at the time \$\\tau\$ after")
UPPER = re.compile(r"\\int_0\^\{(.*?)\} .*? So the distance covered(?: by burnout)? is \$(s(?:_\{\\text\{out\}\})?) = ")
MASSES = re.compile(
    r"becomes \$(?P<factor>.*?) \\int_\{(?P<low>.*?)\}\^\{(?P<high>m[^ ]*)\} (?P<log>.*?)"
    r"\\,\\mathrm\{d\}x(?P<fallen>[^$]*)\$; "
    r"the antiderivative of \$(?P<again>[^$]*)\$ is \$(?P<primitive>[^$]*)\$"
)
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


FLIGHTS = product((DeepSpace(), LevelGround()), (HEAVY, LIGHT), (BurnedOut, AtTime(46.0)))
each_flight = pytest.mark.parametrize(("place", "rate", "moment"), list(FLIGHTS))


@each_flight
def test_a_distance_is_the_integral_of_the_velocity_that_is_written(
    place: StartingPlace, rate: float, moment: object
) -> None:
    """Gauss-Legendre quadrature of the velocity in the text gives the distance in the text."""
    found = flight(place, rate, moment)
    (velocity,), ((until, name),) = VELOCITY.findall(found.text), UPPER.findall(found.text)
    end = read(f"$y = {until}$", found.values).values["y"]
    places, weights = np.polynomial.legendre.leggauss(40)
    speeds = [
        read(f"$y = {velocity}$", {**found.values, r"\tau": 0.5 * end * (1.0 + place)}).values["y"]
        for place in places.tolist()
    ]
    assert 0.5 * end * float(weights @ speeds) == pytest.approx(found.values[name], rel=1e-9)


@each_flight
def test_the_integral_over_the_mass_is_displayed_with_its_antiderivative(
    place: StartingPlace, rate: float, moment: object
) -> None:
    """The displayed integral equals the distance and the difference of the displayed antiderivative."""
    found = flight(place, rate, moment)
    (_, name), held = UPPER.findall(found.text)[0], MASSES.search(found.text)
    assert held is not None, found.text

    def value(formula: str, x: float = 1.0) -> float:
        return read(f"$y = {formula}$", {**found.values, "x": x}).values["y"]

    low, high = value(held["low"]), value(held["high"])
    primitive = value(held["primitive"], high) - value(held["primitive"], low)
    places, weights = np.polynomial.legendre.leggauss(40)
    middle, half = 0.5 * (low + high), 0.5 * (high - low)
    logs = [value(held["log"], middle + half * place) for place in places.tolist()]
    assert held["log"] == held["again"]
    assert half * float(weights @ logs) == pytest.approx(primitive, rel=1e-9)
    fallen = value("0" + held["fallen"]) if held["fallen"] else 0.0
    assert value(held["factor"]) * primitive + fallen == pytest.approx(found.values[name], rel=1e-9)


@pytest.mark.parametrize(("place", "words"), [(DeepSpace(), ""), (LevelGround(), ", with gravity")])
def test_the_velocity_at_burnout_is_named(place: StartingPlace, words: str) -> None:
    found = flight(place, HEAVY, AtTime(46.0))
    assert rf"By the rocket equation{words}, the velocity at burnout is $v_{{\text{{out}}}} = " in found.text
    assert r"So the distance covered by burnout is $s_{\text{out}} = " in found.text


def test_how_high_a_rocket_comes_does_not_take_how_long_it_falls_free() -> None:
    """The time of liftoff isn't needed either."""
    found = flight(LevelGround(), LIGHT, Stopped)
    assert r"t_{\text{off}}" not in found.text
    assert r"t_{\text{lift}}" not in found.text


def test_the_time_of_a_distance_comes_from_the_integral_of_the_velocity() -> None:
    rocket = RocketEntity(rocket=Rocket(mass=700.0, dry=300.0), place=DeepSpace(), exhaust=0.6, rate=HEAVY)
    scene = Scene(entities=(Named(name="e", entity=rocket),))
    (body,) = (body.name for body in scene.mechanism.bodies if body.coordinates)
    found = solve(asked(scene, Query("time_to_event", None, Moved(body, 1000.0))))
    assert VELOCITY.search(found.text)
    assert found.text.index("the velocity of the probe") < found.text.index("By integration")


def test_a_rocket_has_a_name_where_it_waits_and_comes_to_rest_only_after_burnout() -> None:
    rocket = RocketEntity(rocket=Rocket(mass=700.0, dry=300.0), place=LevelGround(), exhaust=0.6, rate=LIGHT)
    scene = Scene(entities=(Named(name="e", entity=rocket),))
    (body,) = (body.name for body in scene.mechanism.bodies if body.coordinates)
    text = solve(asked(scene, Query("time_to_event", None, Stopped(body)))).text
    assert "As $m_0 > m_{\\text{lift}}$, the thrust is less than the weight at first" in text
    assert "the probe stays on the ground until its mass has fallen to this value" in text
    assert "the thrust exceeds the weight, so the speed grows and the probe can come to rest only after burnout" in text


@pytest.mark.parametrize("place", [DeepSpace(), LevelGround()])
def test_a_far_distance_is_covered_after_burnout(place: StartingPlace) -> None:
    rocket = RocketEntity(rocket=Rocket(mass=700.0, dry=300.0), place=place, exhaust=0.6, rate=HEAVY)
    scene = Scene(entities=(Named(name="e", entity=rocket),))
    (body,) = (body.name for body in scene.mechanism.bodies if body.coordinates)
    high = flight(place, HEAVY, BurnedOut).answer
    assert high is not None
    found = solve(asked(scene, Query("time_to_event", None, Moved(body, 1.2 * high))))
    assert r"As $d > s_{\text{out}}$, the probe covers this distance only after burnout." in found.text
    assert any(relation.role == "exceeds" and relation.left.latex() == "d" for relation in found.relations)
    assert ("The earlier of the two times, on the way up," in found.text) == isinstance(place, LevelGround)


def test_what_is_assumed_of_an_unknown_rocket_is_verified_in_the_end() -> None:
    """The empty mass of a rocket follows from its speed after burnout."""
    rocket = RocketEntity(rocket=Rocket(mass=700.0, dry=300.0), place=LevelGround(), exhaust=0.6, rate=LIGHT)
    scene = Scene(entities=(Named(name="e", entity=rocket),))
    (body,) = (body.name for body in scene.mechanism.bodies if body.coordinates)
    setting = asked(scene, Query("state", Target("velocity", body), AtTime(46.0)))
    assert setting.answer is not None
    stated = StatedResult(repr(setting.answer), "m/s")
    found = solve(replace(setting, unknown="e.rocket.dry", stated=stated))
    assert "Assume that at $t$ no fuel is left and that the probe is moving up." in found.text
    assert found.text.index("With the given $v$") < found.text.index("so at $t$ the engine is off.")
    assert any(r.role == "exceeds" and r.left.latex() == "t" for r in found.relations)


def unknown(place: StartingPlace, path: str, query: Query, unit: str) -> Solution:
    rocket = RocketEntity(rocket=Rocket(mass=700.0, dry=300.0), place=place, exhaust=0.6, rate=LIGHT)
    setting = asked(Scene(entities=(Named(name="e", entity=rocket),)), query)
    assert setting.answer is not None
    found = solve(replace(setting, unknown=path, stated=StatedResult(repr(setting.answer), unit)))
    assert found.answer is not None, found.reason
    assert not faults(found, found.answer), found.text
    return found


def test_a_rocket_of_unknown_mass_that_waits_could_not_rise_from_the_start() -> None:
    found = unknown(LevelGround(), "e.rocket.mass", Query("time_to_event", None, Stopped("e.rocket")), "s")
    assert r"Assume that $m_0 > m_{\text{lift}}$; then the thrust is less than the weight at first" in found.text
    assert r"Indeed $m_0 > m_{\text{lift}}$, as was assumed." in found.text
    assert r"If the probe rose from the start, $m_0$ would be at most $m_{\text{lift}}$" in found.text
    larger = [(r.left.latex(), r.right.latex()) for r in found.relations if r.role == "exceeds"]
    assert ("m_0", r"m_{\text{lift}}") in larger
    assert "t" in [left for left, _ in larger]


def test_the_distance_of_a_rocket_in_deep_space_has_no_other_sign() -> None:
    query = Query("state", Target("displacement", "e.rocket"), AtTime(46.0))
    assert "Only a magnitude" not in unknown(DeepSpace(), "e.exhaust", query, "m").text


def test_a_rocket_that_falls_is_shown_to_be_still_in_the_air() -> None:
    """The height is the integral of u ln(m/m(t)) − g t up to burnout and after it."""
    found = flight(LevelGround(), HEAVY, AtTime(60.0), "velocity")
    assert found.values["v"] < 0.0
    u, rate, burnt = 600.0, HEAVY, (700.0 - 300.0) / HEAVY
    log = np.log(700.0 / 300.0)
    high = u * burnt - u * 300.0 / rate * log + u * log * (60.0 - burnt) - 0.5 * 9.8 * 60.0**2
    assert "is falling then, but it is still in the air" in found.text
    assert found.values["h"] == pytest.approx(high, rel=1e-9)


def test_an_empty_mass_with_which_it_would_never_rise_is_excluded() -> None:
    prompt = (
        r"A probe, whose mass is $m_0$ with its fuel and $m_1$ without, stands upright on level ground in "
        r"a uniform gravitational field, without air. From t = 0 on the probe burns fuel at a rate of "
        r"$\mu$, ejecting the gas backwards at speed $u$ relative to itself, until none is left. Here g = "
        r"9.8 m/s². Determine the mass $m_1$ so that the speed of the probe at the time t = 360 s is 3240 "
        r"m/s. Use $m_0$ = 1320 kg, $\mu$ = 3.9 kg/s and $u$ = 3.0 km/s. State the answer in kg to three "
        r"significant figures, inside \boxed{}."
    )
    found, _ = solve_prompt(prompt)
    assert "If the probe moved down at this speed, its empty mass would be $m_{1,\\text{down}} = " in found.text
    assert "= 1205.4\\ \\text{kg}$, more than the mass $m_{\\text{lift}}$" in found.text


def test_a_rate_of_burning_with_which_the_engine_would_still_be_on_is_excluded() -> None:
    prompt = (
        r"A probe of mass 707 kg (139 kg without its fuel) is at rest in deep space, far from all other "
        r"bodies. Suppose that its engine, started at t = 0, ejects gas backwards at speed 0.95 km/s "
        r"relative to the probe and burns fuel at a rate of $\mu$ until none is left. At the instant t = "
        r"100 s, the distance between the probe and its starting point is 76000 m. What is the burn rate "
        r"$\mu$? Give your answer in kg/s, to three significant figures, inside \boxed{}."
    )
    found, _ = solve_prompt(prompt)
    assert "If the engine were still on at $t$, $\\mu$ would be at most" in found.text
    assert "57185\\ \\text{m}$ from its start, less than $s$." in found.text

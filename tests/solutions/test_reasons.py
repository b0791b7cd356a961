"""Tests of the reasons for the choice of a root, a sign or an extreme value."""

import re
from math import cos, radians, sqrt

import pytest

from joined_entities import pivot, scene
from plain_scenes import row
from sim2reason.questions import Query, StatedResult, Target
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.angles import Orbited
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.strings import WentTaut
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.moments.turning_points import Stopped
from sim2reason.scenes.bodies.blocks import Carriage
from sim2reason.scenes.bodies.oscillators import Ball, Cord, LightRod
from sim2reason.scenes.bodies.round_bodies import Hoop
from sim2reason.scenes.bodies.simple_machines import Incline
from sim2reason.scenes.bodies.space import Planet, Star
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import LightRodPendulum, Pendulum, SliderMass
from sim2reason.scenes.entities.rolling import RollingEntity, Rough, Spinning
from sim2reason.scenes.entities.space import SolarSystem
from sim2reason.solutions import ProblemContext, Solution, solve, solve_prompt
from sim2reason.testing.solution_verification import faults
from worked import asked, derived

G, LENGTH, MASS, FAST = 9.8, 0.8, 0.5, 5.5
CART, BALL = "cart.carriage", "it.bob"
STAR_AND_PLANET = "system.planets.0 & system.star"


def only(name: str, entity: object) -> Scene:
    return Scene(entities=(Named(name=name, entity=entity),))  # type: ignore[arg-type]


def swinging(angle: float = 50.0) -> Scene:
    """Return a scene with a ball on a light rod that hangs from a carriage."""
    rod = LightRodPendulum(bob=Ball(mass=1.4), rod=LightRod(length=0.9), angle=angle)
    return scene({"cart": SliderMass(carriage=Carriage(mass=3.2)), "it": rod}, pivot("cart.pivot", "it.base"))


def reverse(made: Scene, query: Query, path: str, digits: str, unit: str) -> Solution:
    """Return the checked solution for one unknown number with the result given."""
    plain = asked(made, query)
    unknown = next(p.path for p in made.parameters if p.path.endswith(path))
    stated = StatedResult(digits, unit)
    setting = ProblemContext(plain.scene, plain.words, plain.symbols, plain.study, query, unknown, stated)
    found = solve(setting)
    assert setting.answer is not None
    assert not faults(found, setting.answer, 1e-6), found.text
    return found


def test_a_string_goes_slack_at_a_height_that_is_reached() -> None:
    """y = (v² − 2gℓ)/3g is between 0 and ℓ for 2gℓ < v² < 5gℓ; the flight has a time variable of its own."""
    pendulum = Pendulum(bob=Ball(mass=MASS), hanger=Cord(length=LENGTH), angle=0.0, speed=FAST)
    query = Query("event", Target("momentum", "pendulum.bob"), WentTaut("pendulum.hanger"))
    found = derived(only("pendulum", pendulum), query)
    assert found.values[r"y_{\text{s}}"] == pytest.approx((FAST**2 - 2.0 * G * LENGTH) / (3.0 * G))
    assert r"As $0 < y_{\text{s}} < \ell$, the" in found.text
    assert "Let $x$ and $y$ be counted from the fixed point" in found.text
    assert "with the square" not in found.text
    assert "t" not in found.values


def test_a_carriage_is_fastest_where_the_rod_hangs_whatever_the_angle_at_which_it_began() -> None:
    """The formula for the speed is the reason: a rod that starts above its axle pushes at first."""
    query = StretchQuery("extremum", None, Stopped(CART), "greatest speed", CART)
    found = derived(swinging(), query)
    fall = 2.0 * 0.9 * G * (1.0 - cos(radians(50.0)))
    assert found.answer == pytest.approx(1.4 * sqrt(fall / (4.6 * 3.2)))
    speed = r"\frac{\cos^{2} \varphi\,\left(\cos\varphi - \cos\theta\right)}{M + m \sin^{2} \varphi}"
    assert f"proportional to ${speed}$." in found.text
    assert r"The numerator is greatest, and the denominator least, at $\varphi = 0$." in found.text
    assert "moves the opposite way." in found.text
    assert "in the opposite direction" not in found.text


def test_an_angle_is_the_arcsine_as_the_rod_rises_no_higher_than_at_first() -> None:
    found = derived(swinging(), Query("event", Target("displacement", BALL), Moved(CART, 0.1)))
    assert r"It rises no higher than at the start, so $|\phi| \le \theta < 90^\circ$." in found.text
    assert "so the displacement of the" not in found.text  # it is the given distance


def test_with_friction_the_first_swing_is_the_fastest() -> None:
    """The first swing is about the point µmg/k before the natural length: its greatest speed is ω (s − µmg/k)."""
    made, rate, shift = row((2.0,), (50.0,), "left", strain=0.3, friction=0.1), 5.0, 0.1 * 2.0 * G / 50.0
    query = StretchQuery("extremum", None, AtTime(1.5), "greatest speed", "row.carts.0")
    found = derived(made, query)
    assert found.answer == pytest.approx(rate * (0.3 - shift))
    assert ("Friction makes each swing smaller" in found.text) == (found.strategy == "energy")
    assert found.strategy == "energy"
    assert "starts to move to the left" in found.text


def test_a_planet_that_approaches_comes_nearest_within_half_a_turn() -> None:
    sky = SolarSystem(star=Star(mass=1.0), planets=(Planet(x=0.64, y=-0.27, vx=2.16, vy=6.76),))
    half = Orbited(STAR_AND_PLANET, 180)
    near = derived(only("system", sky), StretchQuery("extremum", None, half, "least distance", STAR_AND_PLANET))
    assert "The planet at first approaches ($x v_x + y v_y < 0$), so within half a turn" in near.text
    fast = derived(only("system", sky), StretchQuery("extremum", None, half, "greatest speed", "system.planets.0"))
    assert "the speed is greatest at the least distance" in fast.text


def test_another_root_may_be_later_than_the_end() -> None:
    """A hoop spinning at ω rolls from t = Rω/2µg on, and s = ½µg t (2T − t) has two roots t, one after T."""
    radius, friction, spin, end = 0.15, 0.46, 8.6, 0.68
    hoop = RollingEntity(
        body=Hoop(mass=2.0, radius=radius), plane=Incline(angle=0.0), grip=Rough(friction=friction),
        start=Spinning(spin=spin, way="to the right"),
    )  # fmt: skip
    made = only("lane", hoop)
    body = next(held.name for held in made.mechanism.bodies if held.mass)
    time = radius * spin / (2.0 * friction * G)
    far = 0.5 * friction * G * time * (2.0 * end - time)
    found = reverse(made, Query("state", Target("displacement", body), AtTime(end)), "radius", f"{far!r}", "m")
    assert f"The other root, ${2.0 * end - time:.4f}" in found.text
    assert r"\ \text{s}$, is later than $t" in found.text


PLANKS = (
    "Plank A (2.6 kg) is on top of plank B (4.3 kg), which lies on a rough, fixed plane inclined at 33° to the "
    "horizontal. Static and kinetic friction on this plane have the same coefficient, 0.32. Static and kinetic "
    "friction between B and A have the same coefficient, 0.23. At t = 0 A is moving up the slope at speed $v$, and all "
    "else is at rest. There is ample room to move. At the instant t = 1.6 s, the speed of plank B is 2.96 m/s. Find "
    "the speed $v$. Take g = 9.8 m/s². Write the answer in m/s, to three significant figures, in \\boxed{}."
)
SPRUNG = (
    "A crate of mass 2.9 kg lies on a smooth horizontal table, on which x points to the right and y away from you. A "
    "light spring with a stiffness of 27 N/m and a natural length of 0.69 m ties the crate to a fixed point at (0 m, "
    "0 m). Initially the crate is at the point (0.51 m, −0.35 m). The crate is given the velocity (−0.36 m/s, 0.52 "
    "m/s) at t = 0. Calculate the greatest kinetic energy of the crate between t = 0 and the moment when the spring "
    "first reaches its maximum extension. State the answer in J to three significant figures, inside \\boxed{}."
)


def test_what_slides_on_a_plank_on_a_slope_moves_up_and_down_the_slope() -> None:
    """The text doesn't mention the face of a plank."""
    text = solve_prompt(PLANKS)[0].text
    assert "the face" not in text
    assert "up the slope" in text


def test_all_energy_is_kinetic_at_a_natural_length_that_is_passed() -> None:
    found = solve_prompt(SPRUNG)[0]
    assert "The kinetic energy is greatest where the spring stores no energy, at its natural length." in found.text
    assert re.search(
        r"passes that length, as it is compressed at first, \$\\ell_?\w* < \\ell_0\$, and stretched in the end\.",
        found.text,
    )
    assert any(relation.role == "exceeds" for relation in found.relations)

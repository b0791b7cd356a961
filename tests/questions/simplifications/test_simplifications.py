"""Tests that each slip has the result that textbooks state, and applies to a scene of the catalogue."""

from collections.abc import Callable, Iterable
from math import log, log10, radians, sin, sqrt

import numpy as np
import pytest

from motions import rod_pendulum
from plain_scenes import G, atwood, half_atwood, massive, ramp, table
from sim2reason.errors import SceneError
from sim2reason.generation.item_search import generator
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions import Query, SimulatedScene, Target
from sim2reason.questions.difficulty import DIFFICULTIES, Difficulty
from sim2reason.questions.moments.distances import Away
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.simplifications import MISCONCEPTIONS
from sim2reason.scenes.bodies.space import HeavyPlanet, Star
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.space import SolarSystem

BLOCK, OTHER = "one.system.blocks.0", "other.system.blocks.0"
ASKED = Query("state", Target("acceleration", BLOCK))  # at no moment: of all the motion


def studied(scene: Scene, until: float = 1.0) -> SimulatedScene:
    return SimulatedScene.of(scene, np.linspace(0.0, until, 41))


def size(name: str, scene: Scene, quantity: str, body: str, time: float = 0.0, about: str | None = None) -> float:
    """Return the magnitude of a quantity with the first slip of a name, or the one about a subject."""
    study, slip = studied(scene), MISCONCEPTIONS[name]
    subjects = list(slip.subjects(ASKED, study))
    assert about is None or about in subjects
    found = slip.simplified(study, about if about is not None else subjects[0], 1.0)
    assert found is not None
    return Target(quantity, body).value(found.trace.sample(np.array([time])))


def test_a_body_held_leaves_what_the_other_does_alone() -> None:
    """A block tied to a block that is held hangs at rest."""
    assert size("body held", atwood(), "acceleration", BLOCK, about=OTHER) == pytest.approx(0.0, abs=1e-12)


def test_bodies_held_for_different_reasons_share_a_motion() -> None:
    study, subject = first_of("box", DIFFICULTIES, "fixed carrier", "acceleration")
    found = [MISCONCEPTIONS[name].simplified(study, subject, 0.5) for name in ("fixed carrier", "body held")]
    assert found[0] is not None
    assert found[0] is found[1]


def test_without_the_other_body_a_block_falls_freely() -> None:
    assert size("body left out", atwood(), "acceleration", BLOCK, about=OTHER) == pytest.approx(G, rel=1e-5)


def test_a_light_pulley() -> None:
    """The acceleration of an Atwood machine is (m₁ − m₂)g/(m₁ + m₂)."""
    assert size("massless pulley", massive(2.0), "acceleration", BLOCK) == pytest.approx(G / 5.0, rel=1e-5)


def test_no_friction() -> None:
    found = size("no friction", ramp(friction=0.2), "acceleration", "ramp.blocks.0")
    assert found == pytest.approx(G * sin(radians(30.0)))


def test_from_rest() -> None:
    assert size("from rest", ramp(speed=3.0), "velocity", "ramp.blocks.0", 1.0) == pytest.approx(4.9)


def test_weight_left_out() -> None:
    assert size("gravity left out", half_atwood(), "acceleration", "ramp.blocks.0") == pytest.approx(0.0, abs=1e-4)


@pytest.mark.parametrize(
    ("name", "speed"), [("elastic collisions", 2.0 / 3.0), ("perfectly inelastic collisions", 2.0 / 3.0)]
)
def test_collisions_of_another_kind(name: str, speed: float) -> None:
    """The velocity is (m₁ − e m₂)v/(m₁ + m₂), for m₂ = 2m₁: −v/3 for e = 1, v/3 for e = 0."""
    assert size(name, table(), "velocity", "table.pucks.0", 0.9) == pytest.approx(speed)


@pytest.mark.parametrize("name", ["no collisions", "no events"])
def test_what_happens_is_overlooked(name: str) -> None:
    assert size(name, table(), "velocity", "table.pucks.0", 0.9) == pytest.approx(2.0)


def test_the_later_root() -> None:
    """On a smooth slope s = v²/4a is passed at v/a·(1 ∓ √½), up and down."""
    study = studied(ramp(speed=3.0), 2.0)
    moment = Away("ramp.blocks.0", 3.0**2 / (4 * 4.9))
    later = MISCONCEPTIONS["later root"]
    assert list(later.subjects(Query("time_to_event", None, moment), study)) == [""]
    assert not list(later.subjects(Query("state", None, AtTime(1.0)), study))
    found = later.simplified(study, "", 2.0)
    assert found is not None
    assert study.time(moment) == pytest.approx(3.0 / 4.9 * (1.0 - sqrt(0.5)))
    assert found.time(moment) == pytest.approx(3.0 / 4.9 * (1.0 + sqrt(0.5)))


def first_of(
    recipe: str, difficulties: Iterable[Difficulty], name: str, quantity: str = "acceleration"
) -> tuple[SimulatedScene, str]:
    """Return the first drawn scene of a recipe to which a slip applies, and the subject of the slip."""
    for index in range(100):
        for difficulty in difficulties:
            try:
                scene = RECIPES[recipe](difficulty, generator("slips", recipe, difficulty, index))
                study = SimulatedScene.of(scene, np.linspace(0.0, scene.horizon, 11))
            except SceneError:
                continue
            asked = Query("state", Target(quantity, BLOCK))
            if subjects := list(MISCONCEPTIONS[name].subjects(asked, study)):
                return study, subjects[0]
    raise AssertionError(f"{name} applies to nothing that {recipe} draws")


def test_a_rocket_that_keeps_its_mass() -> None:
    """With a constant mass in empty space v = F t/m, not u ln(m/(m − μt))."""
    study, subject = first_of("rocket", ["easy"], "constant mass")
    burn, time = study.mechanism.burns[0], 0.5 * study.mechanism.burns[0].until
    mass = study.mechanism.body[burn.body].mass
    found = MISCONCEPTIONS["constant mass"].simplified(study, subject, time)
    assert found is not None
    speed = Target("velocity", burn.body)
    assert speed.value(found.trace.sample(np.array([time]))) == pytest.approx(
        burn.rate * burn.exhaust * time / mass, rel=1e-5
    )
    left = mass - burn.rate * time
    assert speed.value(study.trace.sample(np.array([time]))) == pytest.approx(burn.exhaust * log(mass / left))


@pytest.mark.parametrize(
    ("name", "difficulty", "expected"),
    [
        ("fuel left out", "easy", lambda ratio, _: 1.0 / ratio - 1.0),
        ("common logarithm", "easy", lambda ratio, _: -log10(ratio)),
        ("fuel mass for empty mass", "easy", lambda ratio, _: -log(max(ratio, 1.0 - ratio))),
        ("weight along the thrust", "medium", lambda ratio, gt: -log(ratio) + gt),
    ],
)
def test_slips_about_rockets(name: str, difficulty: Difficulty, expected: Callable[..., float]) -> None:
    """The result is the speed at burn-out over the exhaust speed, from the rocket equation with the slip.

    `ratio` is the mass without fuel over the mass at the start, `gt` the speed lost to weight over the exhaust speed.
    """
    study, subject = first_of("rocket", [difficulty], name)
    burn = study.mechanism.burns[0]
    mass, end = study.mechanism.body[burn.body].mass, burn.until
    found = MISCONCEPTIONS[name].simplified(study, subject, 1.01 * end)
    assert found is not None
    speed = Target("velocity", burn.body).value(found.trace.sample(np.array([end])))
    ratio, weight = 1.0 - burn.rate * end / mass, G * end / burn.exhaust
    assert speed / burn.exhaust == pytest.approx(expected(ratio, weight), rel=1e-5)


def two_planets() -> Scene:
    """Build two planets that attract each other and move about a star of one solar mass."""
    planets = (
        HeavyPlanet(mass=1e-3, x=1.0, y=0.0, vx=0.0, vy=6.28),
        HeavyPlanet(mass=5e-4, x=2.0, y=0.0, vx=0.0, vy=4.44),
    )
    return Scene(entities=(Named(name="system", entity=SolarSystem(star=Star(mass=1.0), planets=planets)),))


MADE = {"no friction": ramp(friction=0.2), "no mutual attraction": two_planets()}
"""Scenes for what applies to none that is drawn, or to the whole of it."""


@pytest.mark.parametrize("name", MISCONCEPTIONS)
def test_each_applies_to_something_and_can_be_solved(name: str) -> None:
    where = {
        "constant mass": "rocket",
        "common logarithm": "rocket",
        "fuel left out": "rocket",
        "fuel mass for empty mass": "rocket",
        "weight along the thrust": "rocket",
        "from rest": "chain",
        "elastic collisions": "collision",
        "perfectly inelastic collisions": "collision",
        "no collisions": "collision",
        "no events": "collision",
        "fixed carrier": "box",
        "force left out": "electromagnetic",
        "hand left out": "incline",
        "length as extension": "springs",
        "spring left out": "springs",
        "no damping": "chain",
        "later root": "pendulum",
        "small angle": "pendulum",
        "no slip": "rolling",
        "point mass": "rotation",
        "taut strings": "pendulum",
        "uniform gravity": "rocket",
        "circular orbit": "orbital",
        "uniform angular speed": "orbital",
        "constant orbital speed": "orbital",
        "circular orbit speed": "orbital",
        "centripetal acceleration": "orbital",
        "half forgotten": "incline",
        "mean velocity": "incline",
        "weight as normal force": "hybrid",
        "friction on one body left out": "hybrid",
        "own inertia left out": "rotation",
        "parallel axis forgotten": "rotation",
        "centre of mass not displaced": "rotation",
        "body taken as a thin rod": "rotation",
        "body taken as a thin disc": "rotation",
        "wall taken as thin": "rolling",
        "hole left out": "rolling",
        "hole left out of the inertia": "rolling",
        "hole left out of the inertia about the centre": "rolling",
        "sine for cosine": "incline",
    }
    if name == "later root":
        return  # it hangs on what is asked
    if name in MADE:
        study, subject = studied(MADE[name]), ""
    else:
        quantity = "velocity" if "speed" in name else "acceleration"
        study, subject = first_of(where.get(name, "pulley"), DIFFICULTIES, name, quantity)
    slip = MISCONCEPTIONS[name]
    slip.reason.format(subject="the block")
    found = slip.simplified(study, subject, study.scene.horizon)
    assert found is None or found.trace.mechanism.coordinates


def test_gravity_that_is_the_same_everywhere() -> None:
    """The field stays at its initial value, g on the surface of the planet."""
    study, subject = first_of("rocket", ["hard"], "uniform gravity")
    found = MISCONCEPTIONS["uniform gravity"].simplified(study, subject, study.scene.horizon)
    assert found is not None
    planet = study.scene.entities[0].entity
    given = next(p.value for p in study.scene.parameters if p.measure.unit == "m/s^2" and p.path.startswith("rocket"))
    assert given is not None, planet
    assert -found.mechanism.gravity[0] == pytest.approx(given, rel=1e-9)


def test_a_wide_swing_taken_as_small() -> None:
    """Released at θ₀, a uniform rod that hangs from its end swings as θ₀ cos ωt with ω² = 3g/2ℓ."""
    study, _ = rod_pendulum(60.0).told()
    slip = MISCONCEPTIONS["small angle"]
    assert list(slip.subjects(ASKED, study)) == [""]
    found = slip.simplified(study, "", 1.0)
    assert found is not None
    times = np.linspace(0.0, 1.0, 11)
    swung = 1.0 - np.cos(sqrt(1.5 * G / 1.2) * times)  # from θ₀ on, in θ₀
    assert np.abs(found.trace.sample(times).q[:, 0]) == pytest.approx(radians(60.0) * swung, rel=1e-9, abs=1e-12)


def test_a_motion_is_read_differently_once() -> None:
    """Filters and the item share the result, so that equilibrium and modes are computed once."""
    study, slip = studied(rod_pendulum()), MISCONCEPTIONS["small angle"]
    assert list(slip.subjects(ASKED, study)) == [""]
    first = slip.simplified(study, "", 1.0)
    assert first is not None
    assert slip.simplified(study, "", 2.0) is first

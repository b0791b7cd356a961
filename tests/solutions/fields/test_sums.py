"""Tests of work, impulse and drag up to an instant in fields against closed forms, and of inverse problems."""

from dataclasses import replace
from math import acos, cos, exp, pi, sin, sqrt

import pytest

from sim2reason.questions import Query, StatedResult, Target
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.distances import Away
from sim2reason.questions.moments.reached import Reached
from sim2reason.questions.moments.times import AtTime
from sim2reason.scenes.bodies.charges import ChargedBead, Launched
from sim2reason.scenes.bodies.space import Planet, Star
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.fields import LinearDrag, UniformElectric, UniformMagnetic
from sim2reason.scenes.entities.particles import EmEntity
from sim2reason.scenes.entities.space import SolarSystem
from sim2reason.scenes.entities.varying_fields import GrowingElectric
from sim2reason.simulation.quantities.subjects import Sense
from sim2reason.solutions import ProblemContext, Solution, solve
from sim2reason.solutions.reverse import forward
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import faults
from worked import answer, asked

BEAD = "fields.particle"
MASS, CHARGE, SPEED = 2.0, 3.0, 2.0
B, FIELD, DRAG = 0.8, 1.1, 0.5
TIME = 1.3
MAGNETIC = UniformMagnetic(strength=B, way="positive z")
ELECTRIC = UniformElectric(strength=FIELD, way="positive y")


def fields(**acting: object) -> EmEntity:
    particle, start = ChargedBead(mass=2.0, charge=3.0, sign="positive"), Launched(speed=SPEED, angle=0.0)
    return EmEntity(particle=particle, start=start, **acting)  # type: ignore[arg-type]


def summed(functional: str, moment: Moment, **acting: object) -> float:
    return answer("fields", fields(**acting), StretchQuery("sum", None, moment, functional, BEAD))


def test_a_uniform_field_gains_kinetic_energy() -> None:
    """The work of the field is W = q E y with y = a t²/2."""
    fallen = 0.5 * CHARGE * FIELD / MASS * TIME**2
    found = summed("work of an electric field", AtTime(TIME), electric=ELECTRIC)
    assert found == pytest.approx(CHARGE * FIELD * fallen)


def test_with_a_magnetic_field_the_work_is_that_along_the_drift() -> None:
    """With the drift u = E/B against x, the displacement along the field is y = −(v + u)(1 − cos Ωt)/Ω."""
    turns, drift = CHARGE * B / MASS, -FIELD / B
    electric = UniformElectric(strength=FIELD, way="negative y")
    rise = -(SPEED - drift) * (1.0 - cos(turns * TIME)) / turns
    found = summed("work of an electric field", AtTime(TIME), magnetic=MAGNETIC, electric=electric)
    assert found == pytest.approx(CHARGE * FIELD * abs(rise))


def test_a_field_that_grows_does_the_work_that_is_gained() -> None:
    """The work of the growing field is the kinetic energy gained, with v_y = q (E t + j t²/2)/m."""
    field = GrowingElectric(strength=FIELD, way="positive y", trend="increases", growth=0.4)
    speed = CHARGE / MASS * (FIELD * TIME + 0.2 * TIME**2)
    found = summed("work of an electric field", AtTime(TIME), electric=field)
    assert found == pytest.approx(0.5 * MASS * speed**2)


def test_a_medium_takes_energy_from_what_goes_round() -> None:
    """The speed is v = v₀ exp(−bt/m) with any magnetic field, which does no work."""
    found = summed("energy lost to drag", AtTime(TIME), magnetic=MAGNETIC, medium=LinearDrag(coefficient=0.5))
    assert found == pytest.approx(0.5 * MASS * SPEED**2 * (1.0 - exp(-2.0 * DRAG / MASS * TIME)))


def test_the_impulse_is_the_chord_of_the_velocities() -> None:
    """A magnetic field turns the velocity by Ωt, so the impulse is m times the chord between the two velocities."""
    found = summed("impulse of the net force", AtTime(TIME), magnetic=MAGNETIC)
    assert found == pytest.approx(2.0 * MASS * SPEED * abs(sin(0.5 * CHARGE * B / MASS * TIME)))


# ---- roots that hang on what is unknown


def found_back(setting: ProblemContext) -> Solution:
    solution = solve(setting)
    assert setting.answer is not None
    assert solution.derived, solution.reason
    assert not faults(solution, setting.answer)
    assert not read(solution.text).broken
    return solution


def test_a_speed_from_an_impulse_up_to_a_distance() -> None:
    """J = q E t and (v t)² + (q E t²/2m)² = d² give v = √((d/t)² − (q E t/2m)²)."""
    impulse, distance = 4.0, 3.0
    time = impulse / (CHARGE * FIELD)
    speed = sqrt((distance / time) ** 2 - (0.5 * impulse / MASS) ** 2)
    entity = fields(electric=ELECTRIC).model_copy(update={"start": Launched(speed=speed, angle=0.0)})
    query = StretchQuery("sum", None, Away(BEAD, distance), "impulse of the net force", BEAD)
    setting = asked(Scene(entities=(Named(name="fields", entity=entity),)), query)
    found = found_back(replace(setting, unknown="fields.start.speed", stated=StatedResult("4", "uN*s")))
    assert found.answer == pytest.approx(speed)


def test_the_time_at_which_a_planet_is_accelerated_so_far() -> None:
    """A circular orbit of 1 au about one solar mass has x″ = −4π² cos 2πt, first 20 au/yr² at arccos(−20/4π²)/2π."""
    planet = Planet(x=1.0, y=0.0, vx=0.0, vy=2.0 * pi)
    scene = Scene(entities=(Named(name="system", entity=SolarSystem(star=Star(mass=1.0), planets=(planet,))),))
    target = Target("acceleration", "system.planets.0", Sense("to the right", (1.0, 0.0, 0.0), axis="x"))
    query = Query("time_to_event", None, Reached(target, StatedResult("20", "au/yr^2")))
    found = found_back(forward(asked(scene, query)))
    assert found.answer == pytest.approx(acos(-20.0 / (4.0 * pi**2)) / (2.0 * pi))

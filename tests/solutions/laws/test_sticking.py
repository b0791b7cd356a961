"""Tests of what follows when a body stops slipping: it rolls, or friction is too weak for that."""

from math import cos, radians, sin

import pytest

from sim2reason.questions import Query, Target
from sim2reason.questions.moments.distances import Moved
from sim2reason.scenes.bodies.round_bodies import Pipe
from sim2reason.scenes.bodies.simple_machines import Incline
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.rolling import RollingEntity, Rough, Spinning
from sim2reason.solutions import Solution, solve
from sim2reason.testing.solution_verification import faults
from worked import asked, solution_text

ANGLE, DISTANCE, SPIN, RADIUS, MASS = 42.0, 3.4, 16.0, 0.1, 2.0
LIMIT = 0.45020  # tan 42°/2: with less friction no pipe rolls down this slope


def pipe_that_spins(friction: float) -> Solution:
    """Return the solution for the speed after a distance of a pipe set spinning as if rolling down the slope."""
    pipe = RollingEntity(
        body=Pipe(mass=MASS, radius=RADIUS),
        plane=Incline(angle=ANGLE),
        grip=Rough(friction=friction),
        start=Spinning(spin=SPIN, way="down the slope"),
    )
    scene = Scene(entities=(Named(name="lane", entity=pipe),))
    (body,) = (body.name for body in scene.mechanism.bodies if body.mass)
    setting = asked(scene, Query("event", Target("velocity", body), Moved(body, DISTANCE)))
    found = solve(setting)
    assert found.strategy == "constant acceleration"
    assert setting.answer is not None
    assert not faults(found, setting.answer), found.text
    return found


def test_what_cannot_roll_has_a_point_of_contact_at_rest_for_an_instant() -> None:
    """Rolling needs the friction ½ m g sin θ, more than µ m g cos θ, so slipping goes on with friction reversed."""
    friction, slope = 0.39, radians(ANGLE)
    found = pipe_that_spins(friction)
    assert "begins to roll" not in found.text
    assert "The point of contact of the tube is momentarily at rest when" in found.text
    rolling, needed, most = (held for step in found.steps for held in step.relations if held.role == "verified")
    assert rolling.right.value(found.values) == pytest.approx(0.5 * 9.8 * sin(slope))
    assert needed.right.value(found.values) == pytest.approx(0.5 * MASS * 9.8 * sin(slope))
    assert most.right.value(found.values) == pytest.approx(friction * MASS * 9.8 * cos(slope))
    early, late = 9.8 * (sin(slope) + friction * cos(slope)), 9.8 * (sin(slope) - friction * cos(slope))
    time = SPIN * RADIUS / (early + friction * 9.8 * cos(slope))
    expected = ((early * time) ** 2 + 2.0 * late * (DISTANCE - 0.5 * early * time**2)) ** 0.5
    assert found.answer == pytest.approx(expected, rel=1e-8)


@pytest.mark.parametrize(("friction", "rolls"), [(LIMIT - 0.001, False), (LIMIT + 0.001, True)])
def test_it_begins_to_roll_only_with_the_friction_for_it(friction: float, rolls: bool) -> None:
    assert ("begins to roll without slipping" in pipe_that_spins(friction).text) == rolls


def test_a_body_that_slips_later_does_not_slip_in_the_first_phase_only() -> None:
    text = solution_text("incline-hard-choice-301922-0")
    assert "In this phase plank B does not slip: the friction required, $f_B = " in text
    assert "Plank B then has the acceleration $a_B = " in text
    assert r"1.3954\ \text{m/s}^2$ down the slope. Even against friction" in text

"""Tests of checked assumptions about the motion: fuel, thrust, flights, friction, and other roots."""

import re
from math import cos, radians, sin

import pytest

from plain_scenes import row
from sim2reason.questions import Query, StatedResult, Target
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.times import AtTime
from sim2reason.scenes.bodies.blocks import Slab
from sim2reason.scenes.bodies.oscillators import Ball
from sim2reason.scenes.bodies.simple_machines import Plane
from sim2reason.scenes.bodies.space import LevelGround, Rocket
from sim2reason.scenes.dsl.entity import Entity, Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.particles import Projectile
from sim2reason.scenes.entities.space import RocketEntity
from sim2reason.scenes.entities.stacked_mass_plane import StackedMassPlane
from sim2reason.solutions import ProblemContext, Solution, solve
from sim2reason.solutions.algebra.expressions import Number, Symbol
from sim2reason.solutions.algebra.functions import Power
from sim2reason.solutions.algebra.root_finding import other_solutions
from sim2reason.testing.solution_verification import faults
from worked import asked, solution_text

G = 9.8


def solved(setting: ProblemContext) -> Solution:
    found = solve(setting)
    assert found.answer is not None, found.reason
    assert setting.answer is not None
    assert not faults(found, setting.answer), found.text
    return found


def verified(found: Solution) -> dict[str, float]:
    """Return the values of the relations that are only verified, by symbol."""
    held = (relation for relation in found.relations if relation.role == "verified")
    return {relation.left.latex(): float(relation.right.value(found.values).real) for relation in held}


def scene(entity: Entity) -> Scene:
    return Scene(entities=(Named(name="e", entity=entity),))


def test_a_rocket_rises_if_its_thrust_is_larger_than_its_weight_and_has_burned_out_by_a_time() -> None:
    rocket = scene(RocketEntity(rocket=Rocket(mass=700.0, dry=300.0), place=LevelGround(), exhaust=1.0, rate=16.0))
    (body,) = (body.name for body in rocket.mechanism.bodies)
    found = solved(asked(rocket, Query("state", Target("velocity", body), AtTime(31.0))))
    seen = verified(found)
    assert seen[r"t_{\text{out}}"] == pytest.approx(25.0)
    assert seen[r"F_{\text{thrust}}"] == pytest.approx(16000.0)
    assert seen[r"F_{\text{weight}}"] == pytest.approx(700.0 * G)
    assert "so at $t$ the engine is off" in found.text


def test_a_ball_that_bounced_is_still_in_the_air() -> None:
    """The next landing would be 2 v/g after leaving the ground at v."""
    thrown = scene(Projectile(ball=Ball(mass=0.5), height=2.0, speed=3.0, angle=20.0, restitution=0.6))
    (ball,) = (body.name for body in thrown.mechanism.bodies)
    found = solved(asked(thrown, Query("state", Target("kinetic energy", ball), AtTime(1.0))))
    flight = verified(found)[r"t_{\text{flight}}"]
    assert flight == pytest.approx(2.0 * found.values["v'_y"] / G, rel=1e-3)
    assert flight > found.values["t_2"] > 0.0
    assert "still in the air at $t$" in found.text


def test_a_slab_below_a_sliding_one_stays_at_rest() -> None:
    """Static friction balances its weight component along the slope and the friction of the slab sliding on it."""
    slabs = StackedMassPlane(
        plane=Plane(angle=30.0, friction=0.9), lower=Slab(mass=3.0), upper=Slab(mass=1.0), friction=0.4, speed=2.0
    )
    stack, slope = scene(slabs), radians(30.0)
    upper = [body.name for body in stack.mechanism.bodies][1]
    found = solved(asked(stack, Query("state", Target("velocity", upper), AtTime(0.1))))
    seen = verified(found)
    friction = 0.4 * G * cos(slope)
    assert seen["f_A"] == pytest.approx(4.0 * G * sin(slope) - G * sin(slope) - friction)
    assert seen[r"f_{\text{max},A}"] == pytest.approx(0.9 * 4.0 * G * cos(slope))


def test_another_root_is_named_that_the_question_excludes() -> None:
    """v² = u² + 2 g d sin θ has the roots ±u; x² + x = 6 has the other root −3."""
    x = Symbol("x")
    assert other_solutions("x", Power(x, 2) + x, Number(6.0), {"x": 2.0}) == [pytest.approx(-3.0)]
    assert other_solutions("x", Number(2.0) * x, Number(6.0), {"x": 3.0}) == []


def test_a_reverse_problem_says_why_the_other_root_does_not_count() -> None:
    """The initial extension of the spring follows from the path of a struck cart by a quadratic equation."""
    carts = row((1.2,), (107.0, 151.0), "both", strain=0.09, speed=0.93, at=1)
    cart = next(body.name for body in carts.mechanism.bodies if body.mass)
    query = StretchQuery("sum", None, AtTime(0.54), "distance travelled", cart)
    plain = asked(carts, query)
    path = next(held.path for held in carts.parameters if held.path.endswith("strain.by"))
    stated = StatedResult(f"{plain.answer!r}", "m")
    found = solved(ProblemContext(plain.scene, plain.words, plain.symbols, plain.study, query, path, stated))
    assert found.answer == pytest.approx(0.09, rel=1e-6)
    assert re.search(r"The other root, \$-\d\.\d+\\ \\text\{m\}\$, would take a negative \$d\$\.", found.text)


def test_an_answer_that_is_an_absolute_value_is_not_called_by_the_component() -> None:
    """The friction on the block may act up or down the slope, and the question asks for its magnitude."""
    text = solution_text("hybrid-medium-symbolic-301928-0")
    assert r"Answer: $\left|f_A\right| = \boxed{\frac{g \left|2\,m_A \sin\theta - m_B\right|}{2}}$" in text

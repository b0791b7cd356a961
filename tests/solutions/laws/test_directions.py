"""Tests of assumed directions: bodies that start to slide against friction, and strings between them."""

from dataclasses import replace
from math import cos, radians, sin

import pytest

from plain_scenes import ramp
from sim2reason.questions import Query, StatedResult, Target
from sim2reason.questions.moments.times import AtTime
from sim2reason.scenes.bodies.blocks import Block, Slab
from sim2reason.scenes.bodies.round_bodies import Hoop
from sim2reason.scenes.bodies.simple_machines import Incline, Plane, Prism
from sim2reason.scenes.dsl.entity import Entity, Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.rolling import RollingEntity, Rough
from sim2reason.scenes.entities.slopes import MassPrismPlane
from sim2reason.scenes.entities.stacked_mass_plane import StackedMassPlane
from sim2reason.solutions import ProblemContext, Solution, solve
from sim2reason.solutions.solve import solve_prompt
from sim2reason.testing.solution_verification import faults
from worked import asked, solution_text

G = 9.8


def solved(setting: ProblemContext) -> Solution:
    found = solve(setting)
    assert found.answer is not None, found.reason
    assert setting.answer is not None
    assert not faults(found, setting.answer, 1e-6), found.text
    return found


def scene(entity: Entity) -> Scene:
    return Scene(entities=(Named(name="e", entity=entity),))


def speed(place: Scene, body: int, time: float) -> ProblemContext:
    return asked(place, Query("state", Target("velocity", place.mechanism.bodies[body].name), AtTime(time)))


def test_a_block_slides_as_friction_can_not_hold_it() -> None:
    found = solved(speed(ramp(angle=40.0, friction=0.3), 0, 1.0))
    assert found.values["f"] == pytest.approx(2.0 * G * sin(radians(40.0)))
    assert found.values[r"f_{\text{max}}"] == pytest.approx(0.3 * 2.0 * G * cos(radians(40.0)))
    assert "Friction acts on the block up the slope." in found.text
    assert "To stay at rest, the block would need the friction" in found.text
    assert any(relation.role == "exceeds" for relation in found.relations)


def test_a_hoop_slips_as_rolling_would_need_more_friction() -> None:
    """Rolling without slipping needs friction of half of m g sin θ; see Kleppner and Kolenkow, example 6.16."""
    slope = Incline(angle=31.0)
    hoop = scene(RollingEntity(body=Hoop(mass=4.1, radius=0.11), plane=slope, grip=Rough(friction=0.18)))
    found = solved(speed(hoop, 0, 1.3))
    assert found.values["f"] == pytest.approx(0.5 * 4.1 * G * sin(radians(31.0)))
    assert "Rolling without slipping, the hoop would move like a mass of $2\\,m$" in found.text
    assert found.text.count("so it slips") == 1


def test_a_block_whose_friction_is_unknown_is_assumed_to_slide_back_which_is_verified() -> None:
    place = ramp(angle=54.0, friction=0.22, speed=3.9)
    setting = speed(place, 0, 1.2)
    assert setting.answer is not None
    path = next(path for path in setting.lexicon.givens if path.endswith("friction"))
    found = solved(replace(setting, unknown=path, stated=StatedResult(repr(setting.answer), "m/s")))
    order = ["Assume that the block slips in the opposite direction", r"so $\mu = ", "more than $f_"]
    assert [*map(found.text.find, order)] == sorted(map(found.text.find, order))
    assert found.text.find(order[0]) > 0


def test_a_launched_block_needs_no_argument() -> None:
    found = solved(speed(ramp(angle=40.0, friction=0.3, speed=3.0), 0, 0.1))
    assert "Friction acts on the block down the slope." in found.text
    assert all(relation.role != "exceeds" for relation in found.relations)


def test_a_slab_that_is_dragged_down_slides_as_its_acceleration_shows() -> None:
    """Slab B is launched up slab A, which slides down; B then slides down on A, as A is accelerated less."""
    stack = StackedMassPlane(
        plane=Plane(angle=48.0, friction=0.2), lower=Slab(mass=6.5), upper=Slab(mass=7.6), friction=0.15, speed=3.6
    )
    found = solved(speed(scene(stack), 1, 0.8))
    assert "Even against friction the relative acceleration" in found.text
    assert "so board B slides down the slope on board A" in found.text
    a = found.values[r"a_{\text{rel}}"]
    below = G * sin(radians(48.0)) + G * cos(radians(48.0)) * (0.15 * 7.6 - 0.2 * 14.1) / 6.5
    assert a == pytest.approx(G * (sin(radians(48.0)) - 0.15 * cos(radians(48.0))) - below)


def test_an_unknown_coefficient_is_compared_when_it_is_known() -> None:
    place = ramp(angle=40.0, friction=0.3)
    plain = speed(place, 0, 1.0)
    path = next(held.path for held in place.parameters if held.path.endswith("friction"))
    stated = StatedResult(f"{plain.answer!r}", "m/s")
    found = solved(ProblemContext(place, plain.words, plain.symbols, plain.study, plain.query, path, stated))
    assert found.text.index("With the given") < found.text.index("To stay at rest, the block would need")


def test_a_false_assumption_is_refused() -> None:
    """The relations of the solution include the comparison that excludes the false assumption."""
    found = solved(speed(ramp(angle=40.0, friction=0.3), 0, 1.0))
    (held,) = (relation for relation in found.relations if relation.role == "exceeds")
    assert float(held.left.value(found.values).real) > float(held.right.value(found.values).real)


def test_bodies_on_two_faces_slide_one_up_and_one_down() -> None:
    """The blocks on the two faces have the same acceleration along the string but move in different directions."""
    entity = MassPrismPlane(
        prism=Prism(mass=4.7, left=39.0, right=63.0, friction=0.2),
        left_blocks=(Block(mass=8.0),),
        right_blocks=(Block(mass=9.8),),
    )
    place = scene(entity)
    found = solved(speed(place, 0, 0.5))
    assert "so block A slides up the face on the prism and block B slides down the face on the prism." in found.text


def test_friction_in_a_stack_is_that_of_the_surface_beneath() -> None:
    """A board that carries another one has friction on both faces; only one of these forces is reversed."""
    text = solution_text("incline-hard-reverse-301915-0")
    assert "From the surface beneath, friction acts on boards A and C up the slope." in text
    said = "relative to board B from then on, and the friction between them is reversed."
    assert said in text


def test_what_slides_on_a_body_still_does_when_that_stops_sliding() -> None:
    """The relative speed of C and B has changed from v to v + (a_B + a_C) t by then, so C still slides on B."""
    prompt = (
        r"Slab A of mass 8.6 kg lies on a smooth, fixed plane inclined at 62° to the horizontal and "
        r"carries slab B (12 kg). On B lies slab C (3.7 kg). Between A and B the coefficient of friction, "
        r"static and kinetic, is 0.24. Between B and C the coefficient of friction, static and kinetic, "
        r"is 0.24. At t = 0 B has a velocity of 1.8 m/s, directed up the slope, and all else is at rest. "
        r"No body reaches an edge. Here g = 9.8 m/s². What is the distance between slab B "
        r"and its starting point relative to the ground when it first stops sliding on slab A? Give your "
        r"answer in m, to three significant figures, inside \boxed{}."
    )
    found, _ = solve_prompt(prompt)
    at = found.values
    left = at["v"] + (at["a_B"] + at["a_C"]) * at["t"]
    assert left > 0.0
    assert at["u_{BC}"] == pytest.approx(left, rel=1e-9)
    assert "After the time $t$, slab C still slides on slab B, as their relative speed is $u_{BC} = " in found.text


def test_a_direction_is_not_shown_by_an_acceleration_that_a_given_speed_fixes() -> None:
    """Without friction, (7.1 + 2.8) · 9.8 sin 60° − 24 = 60.02 N accelerates 9.9 kg down the slope by 6.063 m/s²."""
    text = solution_text("pulley-hard-reverse-301926-1")
    assert "Without friction the acceleration would be $a_" in text
    assert r"6.0628\ \text{m/s}^2$, which is positive; friction can only reduce it, so crates A and B slide" in text
    assert "Even against friction" not in text


def test_the_direction_of_bodies_is_shown_whose_acceleration_a_string_gives() -> None:
    text = solution_text("hybrid-hard-reverse-301931-0")
    assert r"Even against friction the acceleration $a_C = a_P + a_A = 2.6095\ \text{m/s}^2$ is positive" in text


def test_what_rolls_without_a_limit_of_friction_is_no_surface_that_could_be_smooth() -> None:
    """A ring whose contact has no coefficient of friction rolls beside a block that slides."""
    text = solution_text("mixed-hard-reverse-77-21")
    assert "friction can only reduce it" not in text
    assert r"\boxed{" in text

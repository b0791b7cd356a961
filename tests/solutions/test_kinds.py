"""Tests of sums, limiting cases, reverse questions and integrations, against closed forms and by sampling."""

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from math import atan, cos, degrees, radians, sin, sqrt

import pytest

from plain_scenes import G, atwood, ramp
from sim2reason.errors import SceneError, SimulationError, UnsupportedError
from sim2reason.generation.item_search import generator
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.generation.recipes import RECIPES, find_difficulty
from sim2reason.questions import MODES, Query, StatedResult, Target
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.kinds.threshold import ThresholdQuery
from sim2reason.questions.moments.distances import Away
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.outcomes.sliding import Slides
from sim2reason.scenes.bodies.oscillators import Ball
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.particles import Projectile
from sim2reason.solutions import STRATEGIES, ProblemContext, Solution, solve, solve_with
from sim2reason.solutions.checking import recompute
from sim2reason.solutions.data import as_data
from sim2reason.solutions.reverse import forward
from sim2reason.solutions.solution import RELATION_RTOL
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import RTOL_BY_KIND, faults
from worked import asked

TIME = 0.5


def solved(setting: ProblemContext) -> Solution:
    found = solve(setting)
    assert found.answer is not None, found.reason
    answer = forward(setting).answer
    assert answer is not None
    assert not faults(found, answer, RTOL_BY_KIND.get(setting.query.kind, RELATION_RTOL)), found.text
    assert not read(found.text).broken
    return found


def summed(scene: Scene, functional: str, name: str) -> float:
    found = solved(asked(scene, StretchQuery("sum", None, AtTime(TIME), functional, name)))
    assert found.answer is not None
    return found.answer


def block(scene: Scene) -> str:
    return next(body.name for body in scene.mechanism.bodies if body.coordinates)


def mass(scene: Scene) -> float:
    return scene.mechanism.body[block(scene)].mass


def test_the_heat_of_friction_is_friction_times_path() -> None:
    """The heat is µ m g cos θ · ½ g (sin θ − µ cos θ) t²."""
    scene, slope = ramp(angle=40.0, friction=0.2), radians(40.0)
    path = 0.5 * G * (sin(slope) - 0.2 * cos(slope)) * TIME**2
    found = summed(scene, "energy dissipated by friction", block(scene))
    assert found == pytest.approx(0.2 * mass(scene) * G * cos(slope) * path, rel=1e-9)


def test_a_path_up_and_down_is_counted_to_and_fro() -> None:
    """The path is v²/2a up, and then down for the rest of the time; a = g sin θ both ways on a smooth slope."""
    scene, slowing = ramp(angle=40.0, friction=0.0, speed=1.5), G * sin(radians(40.0))
    up = 1.5 / slowing
    assert up < TIME
    expected = 1.5**2 / (2.0 * slowing) + 0.5 * slowing * (TIME - up) ** 2
    assert summed(scene, "distance travelled", block(scene)) == pytest.approx(expected, rel=1e-9)


def test_the_impulse_of_a_tension_is_tension_times_time() -> None:
    scene = atwood(3.0, 2.0)
    line = scene.mechanism.strings[0].name
    assert summed(scene, "impulse of a tension", line) == pytest.approx(2.0 * 3.0 * 2.0 * G / 5.0 * TIME, rel=1e-9)


def reverse(scene: Scene, unknown: str, digits: str, query: Query) -> ProblemContext:
    plain = asked(scene, query)
    return ProblemContext(
        plain.scene, plain.words, plain.symbols, plain.study, query, unknown, StatedResult(digits, "m/s")
    )


def path_of(scene: Scene, noun: str) -> str:
    return next(p.path for p in scene.parameters if p.path.endswith(noun))


def test_a_friction_is_found_from_a_speed() -> None:
    """v = g (sin θ − µ cos θ) t, so µ = tan θ − v/(g t cos θ), the value in the simulated scene."""
    slope = radians(40.0)
    friction = (sin(slope) - 2.0 / (G * TIME)) / cos(slope)
    scene = ramp(angle=40.0, friction=friction)
    query = Query("state", Target("velocity", block(scene)), AtTime(TIME))
    found = solved(reverse(scene, path_of(scene, "friction"), "2.0", query))
    assert found.answer == pytest.approx(friction, rel=1e-9)
    assert found.goal == r"\mu"
    assert found.derived
    assert f"{friction:.4f}"[:5] not in found.text.partition("So ")[0]  # not known before it is found


def test_an_angle_is_found_from_a_speed() -> None:
    """v = g t sin θ on a smooth slope."""
    angle = degrees(atan(0.75))
    scene = ramp(angle=angle, friction=0.0)
    query = Query("state", Target("velocity", block(scene)), AtTime(TIME))
    found = solved(reverse(scene, path_of(scene, "angle"), f"{G * TIME * 0.6:.12g}", query))
    assert found.answer == pytest.approx(angle, rel=1e-9)


def test_a_block_slips_from_tan_of_the_angle_on() -> None:
    scene = ramp(angle=30.0, friction=0.3)
    plain = asked(scene, Query("state", Target("velocity", block(scene)), AtTime(TIME)))
    unknown = path_of(scene, "angle")
    query = ThresholdQuery("threshold", None, None, Slides(block(scene)), unknown, "deg")
    found = solved(ProblemContext(plain.scene, plain.words, plain.symbols, plain.study, query, unknown))
    assert found.strategy == "limiting case"
    assert found.answer == pytest.approx(degrees(atan(0.3)), rel=1e-9)


def drawn(recipe: str, kind: str, mode: str, count: int) -> Iterator[ProblemContext]:
    for index in range(count):
        rng = generator("kinds", recipe, kind, mode, index)
        try:
            search = QuestionSearch(RECIPES[recipe](find_difficulty(("easy", "medium", "hard")[index % 3]), rng), index)
            found = search.ask(MODES[mode], rng, Counter[str](), kind)
        except (SceneError, SimulationError, UnsupportedError):
            continue
        if found is not None:
            yield found.setting


@pytest.mark.parametrize("recipe", ["pulley", "incline", "hybrid", "box"])
@pytest.mark.parametrize(("kind", "mode"), [("sum", "numeric"), ("state", "reverse")])
def test_drawn_problems_are_derived_without_a_fault(recipe: str, kind: str, mode: str) -> None:
    for setting in drawn(recipe, kind, mode, 4):
        assert solved(setting).derived


@pytest.mark.parametrize(
    ("recipe", "kind"), [("springs", "time_to_event"), ("chain", "state"), ("pendulum", "time_to_event")]
)
def test_an_integration_says_that_it_is_one_and_states_all_that_leads_to_its_answer(recipe: str, kind: str) -> None:
    written = 0
    for setting in drawn(recipe, kind, "numeric", 4):
        found = solve_with(STRATEGIES["integration"], setting)
        if found.answer is None:
            assert found.reason
            continue
        written += 1
        assert not found.derived
        assert "integrated numerically" in found.text
        phases = [step.integration for step in found.steps if step.integration is not None]
        assert phases
        for phase in phases:
            assert phase.equations
            assert phase.coordinates
            moving = {phase.time, *phase.unknowns, *(name for c in phase.coordinates for name in (c.place, c.rate))}
            assert moving & {*phase.until.expression.symbols()}
        assert setting.answer is not None
        assert not faults(found, setting.answer)
        assert recompute(as_data(found)).answer == pytest.approx(setting.answer, rel=1e-8)
        assert not read(found.text).broken
        assert faults(_without_a_law(found), setting.answer)
    assert written


def _without_a_law(solution: Solution) -> Solution:
    """Return a solution whose last integrated phase lacks its last equation of motion."""
    last = [step for step in solution.steps if step.integration is not None][-1]
    assert last.integration is not None
    less = replace(last.integration, equations=last.integration.equations[:-1])
    steps = (replace(step, integration=less) if step is last else step for step in solution.steps)
    return replace(solution, steps=tuple(steps))


def test_a_number_that_hardly_changes_what_is_given_is_weighed_by_how_much_it_does() -> None:
    """A ball launched horizontally bounces and is at distance d when D(h, T) = x² + y² − d² = 0.

    dT/dh = −D_h/D_T, and that times h/T is 18 %.
    """
    speed, restitution, distance, height = 4.9, 0.52, 3.5, 1.4

    def over(h: float, time: float) -> float:
        since = time - sqrt(2.0 * h / G)
        y = -h + restitution * sqrt(2.0 * G * h) * since - 0.5 * G * since**2
        return (speed * time) ** 2 + y**2 - distance**2

    throw = Projectile(ball=Ball(mass=0.9), height=height, speed=speed, angle=0.0, restitution=restitution)
    scene = Scene(entities=(Named(name="throw", entity=throw),))
    plain = asked(scene, Query("time_to_event", None, Away("throw.ball", distance)))
    time, step = plain.answer or 0.0, 1e-5
    assert over(height, time) == pytest.approx(0.0, abs=1e-8)
    slope = (over(height - step, time) - over(height + step, time)) / (
        over(height, time + step) - over(height, time - step)
    )

    solution = solved(replace(plain, unknown="throw.height", stated=StatedResult(f"{time:.12g}", "s")))
    assert solution.condition_number == pytest.approx(abs(slope) * height / time, rel=1e-6)
    known = height * (1.0 + 0.5 * RELATION_RTOL / solution.condition_number)
    assert not faults(solution, known)
    assert faults(replace(solution, condition_number=1.0), known)

"""Tests of the greatest and least values over a whole motion, against closed forms."""

from math import pi, radians, sin, sqrt
from pathlib import Path

import pytest

from plain_scenes import G, atwood, ramp
from sim2reason.datasets.scene_questions import SolvedProblem, solve
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import load, loads
from sim2reason.solutions.solve import ANSWER_RTOL

SCENES = Path(__file__).parents[1] / "data" / "ordinary_scenes"
SLIDING = ramp(angle=0.0, friction=0.05, speed=5.0)
FAR, LATE = 25.0 / (0.1 * G), 5.0 / (0.05 * G)


def scene(kind: str, parameters: str) -> Scene:
    """Return a scene with one entity."""
    return loads(f"scene: {{entities: [{{name: it, type: {kind}, parameters: {{{parameters}}}}}]}}")


THROWN = scene("Projectile", "ball: {mass: 1.0}, height: 0.0, speed: 20.0, angle: 45.0")
ROCKET = "rocket: {mass: 2970000, dry: 822000}, exhaust: 2.58, rate: 13000"
RISING = scene("RocketEntity", f"{ROCKET}, place: {{kind: level_ground}}")
FREE = scene("RocketEntity", f"{ROCKET}, place: {{kind: deep_space}}")
SATELLITE = scene(
    "SolarSystem", "star: {mass: 3.003e-6}, planets: [{kind: planet, x: 4.5e-5, y: 0.0, vx: 0.0, vy: 1.62}]"
)
HELD = scene(
    "AnchoredSpring", "support: ceiling, block: {mass: 0.001}, spring: {stiffness: 100000, length: 0.5}, start: 0.5"
)


def solved(found: SolvedProblem) -> float:
    """Return the answer of a worked solution, which has to agree with the simulated one."""
    assert found.solution.answer is not None, found.reason
    assert found.answer == pytest.approx(found.solution.answer, rel=ANSWER_RTOL)
    assert found.reason == ""
    return found.solution.answer


@pytest.mark.parametrize("when", ["stopped", ""])
def test_a_value_that_is_greatest_at_the_end_is_the_answer_of_a_solution(when: str) -> None:
    """A block slides v²/(2 μ g) on a floor, and is farthest away when it stops."""
    assert solved(solve(SLIDING, find="greatest displacement", when=when)) == pytest.approx(FAR, rel=1e-9)


def test_the_greatest_height_of_a_rocket_is_that_of_its_solution() -> None:
    """The greatest height is reached where the rocket is at rest."""
    found = solve(RISING, question="What is the greatest height that the rocket reaches?")
    assert solved(found) == pytest.approx(229533.223134, rel=1e-9)


@pytest.mark.parametrize("find", ["greatest distance", "least distance", "greatest speed"])
def test_extremes_of_an_orbit_at_its_start_or_half_way(find: str) -> None:
    """Conservation of energy and angular momentum gives both apsides, to nine digits at a radius of 5e-5 au."""
    mu, start, speed = 4.0 * pi**2 * 3.003e-6, 4.5e-5, 1.62
    near = 1.0 / (mu / (0.5 * start**2 * speed**2) - 1.0 / start)  # both ends have h²/(2 r²) − μ/r in common
    expected = {"greatest distance": start, "least distance": near, "greatest speed": start * speed / near}[find]
    found = solve(SATELLITE, find=find, of="planet" if "speed" in find else "")
    assert solved(found) == pytest.approx(expected, rel=1e-9)
    assert found.answer == pytest.approx(expected, rel=1e-9)
    assert "repeats itself every" in found.over


def test_a_crumb_on_a_stiff_spring_keeps_its_phase() -> None:
    """The velocity is (g/ω) sin ωt, even after 10⁴ rad of oscillations of 0.1 μm."""
    found = solve(HELD, find="velocity", when="1 s")
    assert solved(found) == pytest.approx(abs(G / 1e4 * sin(1e4)), rel=1e-7)
    assert found.answer == pytest.approx(abs(G / 1e4 * sin(1e4)), rel=1e-7)


@pytest.mark.parametrize(
    ("held", "find", "value", "over"),
    [
        (SLIDING, "greatest displacement", FAR, f"to rest at {LATE:.6g} s"),
        (SLIDING, "greatest speed", 5.0, f"to rest at {LATE:.6g} s"),
        (THROWN, "greatest height", (20.0 * sin(radians(45.0))) ** 2 / (2.0 * G), "where its description ends"),
        (THROWN, "least speed", 20.0 * sqrt(0.5), "to 2.88615 s, where its description ends"),
    ],
)
def test_without_a_moment_it_is_taken_over_the_whole_motion(held: Scene, find: str, value: float, over: str) -> None:
    """The result states the interval over which the extremum is taken."""
    found = solve(held, find=find)
    assert found.answer == pytest.approx(value, rel=1e-9)
    assert over in found.over


@pytest.mark.parametrize(
    ("held", "question", "over"),
    [
        (SLIDING, "What is the greatest speed of the block?", f"to rest at {LATE:.6g} s"),
        (FREE, "What is the greatest speed of the rocket?", "which is uniform from 165.231 s on"),
    ],
)
def test_a_sentence_means_the_same_motion(held: Scene, question: str, over: str) -> None:
    """A question in words without an interval is read as one about the whole motion."""
    found = solve(held, question=question)
    assert found.read_as.endswith("in the motion that follows?")
    assert over in found.over


def test_a_motion_that_only_unsaid_lengths_end_has_no_greatest_speed() -> None:
    """The speed of two blocks on a string of unstated length has no bound, but their string's tension has."""
    held = atwood()
    assert "leaves open how far it can go" in solve(held, find="greatest speed", of="block A").reason
    assert solve(held, find="greatest tension").answer is not None


def test_a_sum_has_no_whole_motion() -> None:
    """A count of bounces needs an interval, since a bouncing ball has no last bounce."""
    held = load(SCENES / "bounce.yaml")
    assert solve(held, find="number of bounces").answer is None


def test_an_impact_makes_an_acceleration_infinite() -> None:
    """There is no greatest acceleration over an interval that includes a bounce."""
    held = load(SCENES / "bounce.yaml")
    assert solve(held, find="greatest acceleration", when="1 s").answer == pytest.approx(G)
    assert solve(held, find="greatest acceleration", when="1.5 s").answer is None


def test_why_there_is_no_worked_solution_is_told() -> None:
    """`solve` gives the same reason as the solution itself."""
    found = solve(load(SCENES / "bounce.yaml"), find="greatest acceleration", when="1 s")
    assert found.solution.answer is None
    assert found.reason == found.solution.reason != ""

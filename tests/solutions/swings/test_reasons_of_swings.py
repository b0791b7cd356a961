"""Tests of reasons in solutions for swings, arms and carriages, and of the bodies that are named."""

import pytest

from plain_scenes import arm
from sim2reason.questions.phrasing import PeriodQuery
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions import solve_prompt
from worked import derived, solution_text


def carrier(m: Mechanism) -> str:
    return m.coordinates[0].body


def test_small_oscillations_begin_with_the_equation_of_motion() -> None:
    scene = arm()
    text = derived(scene, PeriodQuery("period", small=True, of=(carrier(scene.mechanism),))).text
    assert r"the torque of gravity is $-m d g \sin\varphi$, nearly $-m d g \varphi$" in text
    assert text.index(r"\sin\varphi") < text.index("the oscillation is harmonic with the angular frequency")


def test_the_thrust_of_a_rod_is_no_greater_than_its_tension() -> None:
    text = solution_text("pendulum-easy-symbolic-301914-1")
    assert "Where the rod pushes, its thrust is at most the weight" in text


def test_where_a_string_goes_slack_its_angle_is_defined_and_the_speed_is_found_once() -> None:
    text = solution_text("pendulum-hard-symbolic-301914-0")
    assert r"Let $\phi$ be the angle of the string with the downward vertical" in text
    assert "the component of gravity along the string alone is the centripetal" in text
    assert r"make the angle $\phi$, so by the law of cosines" in text
    assert "v_1" not in text


def test_the_energy_of_a_ball_on_a_carriage_gives_the_cosine_without_squaring() -> None:
    text = solution_text("pendulum-hard-reverse-301914-0")
    assert r"By conservation of momentum, the ball has the velocity $\frac{M V}{m}$" in text
    assert r"\cos^{2}" not in text
    assert "10^{12}" not in text


@pytest.mark.parametrize("mode", ["numeric", "symbolic"])
def test_velocities_on_a_carriage_are_those_of_one_moment(mode: str) -> None:
    text = solution_text(f"mixed-medium-{mode}-301914-1")
    assert "When the ball is at the lowest point, let" in text or "At this moment, let" in text
    assert "moves the opposite way" in text


def test_the_kinetic_energy_of_one_body_on_an_arm_names_it() -> None:
    text = solution_text("rotation-medium-numeric-301914-0")
    assert "The kinetic energy of sphere B, which turns about the axle, is" in text


def test_a_limit_says_how_the_energy_changes_with_the_number_that_is_limited() -> None:
    text = solution_text("rotation-hard-reverse-301914-1")
    assert r"Near the limiting case $K$ increases when $\theta$ increases." in text
    assert "By conservation of energy, the kinetic energy at the highest point" in text


def test_the_velocity_at_the_top_of_a_flight_is_the_horizontal_one_of_its_beginning() -> None:
    text = solution_text("pendulum-hard-choice-301923-0")
    assert "the horizontal velocity stays $v_x$, and the vertical one is zero at the highest point." in text


def test_a_ball_on_a_string_is_not_said_to_swing_to_and_fro() -> None:
    """With k = 0.74 the string would go slack on the other side, above the horizontal."""
    text = solution_text("pendulum-easy-multipart-301924-4")
    assert "As $k < 1$, the energy does not suffice to reach the top of the circle." in text


@pytest.mark.parametrize(
    ("speed", "said"),
    [
        ("4.7", "As $v_1^{2} < 2\\,g \\ell$, the string never becomes horizontal and stays taut."),
        ("9.7", "As $v_1^{2} > 5\\,g \\ell$, the string is taut even at the highest point."),
    ],
)
def test_the_string_of_the_greatest_tension_is_shown_to_stay_taut(speed: str, said: str) -> None:
    prompt = (
        "From a fixed point a small ball (1.4 kg) hangs on a light, inextensible string of length 1.6 m. To begin "
        "with, the string is taut and makes an angle of 21° with the downward vertical. At t = 0 the ball starts "
        f"moving downwards along its arc at speed {speed} m/s. The acceleration due to gravity is g = 9.8 m/s². In the "
        "motion that follows, what is the greatest tension in the string? State the answer in N to three "
        "significant figures, inside \\boxed{}."
    )
    found = solve_prompt(prompt)[0]
    assert said in found.text
    assert any(step.kind == "verify" and step.relations[0].role == "exceeds" for step in found.steps)


def test_a_pull_accelerates_the_common_centre_of_mass() -> None:
    """The carriage and the body that swings on it have different accelerations."""
    text = solution_text("mixed-hard-numeric-301929-0")
    assert "gives the common centre of mass the acceleration" in text
    assert "the work of the pull and of the inertial forces" in text


def test_a_prism_is_described_without_letters_that_the_problem_uses() -> None:
    """The letter a denotes an acceleration in this problem, so the side of the prism is not called a."""
    text = solution_text("rolling-hard-reverse-301929-0")
    assert "the squares of the two sides that meet there" in text
    assert "sides $a$" not in text

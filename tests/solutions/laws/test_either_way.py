"""Tests of symbolic problems in which the numbers decide the direction of motion."""

import pytest

from worked import solution_text


def test_the_time_for_a_distance_takes_the_magnitude_of_an_acceleration_of_either_sign() -> None:
    text = solution_text("incline-hard-symbolic-301917-3")
    law, root = r"$d = \tfrac{1}{2} \left|a_B\right| t^{2}$", r"$t = \sqrt{\frac{2\,d}{\left|a_B\right|}}$"
    assert f"{law}, so {root}, whichever way board B moves." in text
    assert r"So the magnitude of the displacement of block D is $s_{D,1} = \left|s_D\right|$." in text


def test_the_sign_that_an_assumption_fixes_is_said() -> None:
    text = solution_text("incline-medium-symbolic-301917-2")
    assert "$v_A$ is negative under the assumption made, so the magnitude of the velocity of board A is" in text
    assert r"$v_{A,1} = -v_A$" in text


def test_components_that_have_names_are_said_to_be_horizontal_or_vertical() -> None:
    text = solution_text("box-medium-symbolic-301917-4")
    assert "has the components $d$ horizontally and $s_B$ vertically." in text
    assert r"\left|a_M\right|" in text


@pytest.mark.parametrize(
    ("problem", "told"),
    [
        ("pulley-hard-symbolic-301926-1", r"$v_B = \sqrt{2\,a_B d}$, as $a_B > 0$ under the assumption made."),
        ("rolling-medium-symbolic-301932-1", r"$t = \sqrt{\frac{2\,d}{a}}$, as $a > 0$ under the assumption made."),
    ],
)
def test_an_assumption_about_another_body_or_the_slip_fixes_a_sign(problem: str, told: str) -> None:
    text = solution_text(problem)
    assert told in text
    assert r"\left|" not in text
    assert "whichever way" not in text

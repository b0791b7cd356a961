"""Problems in symbols in which the numbers decide which way something moves."""

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

"""Tests of the given numbers of integrated motions."""

from worked import solution_text


def test_an_angle_at_which_a_motion_ends_is_given_in_degrees() -> None:
    text = solution_text("mixed-medium-reverse-301924-1")
    assert r"$\beta = 20^\circ$" in text
    assert r"until $\left|\varphi_A\right| = \beta$, gives $t_1 = 0.42000\ \text{s}$" in text

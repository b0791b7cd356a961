"""Tests of later parts that need one equation only, thanks to results of earlier parts."""

from worked import solution_text


def test_a_tension_follows_from_one_law_once_an_acceleration_is_known() -> None:
    text = solution_text("pulley-easy-multipart-301917-2")
    later = text.partition("\n\n(b) ")[2]
    assert r"From (3), $T_1 = m_B \left(g + a_B\right) = 9.0986\ \text{N}$." in later
    assert "a_C" not in later


def test_an_acceleration_follows_from_that_of_the_string() -> None:
    text = solution_text("pulley-medium-multipart-301917-0")
    later = text.partition("\n\n(c) ")[2]
    assert r"As in part (a), $a_A = \tfrac{1}{2} a_B = 0.75385\ \text{m/s}^2$." in later
    assert "(1)" not in later
    assert r"$T_1 = \tfrac{1}{2} m_A \left(2\,g + a_B\right)" in text


def test_a_displacement_at_constant_velocity_takes_the_whole_time() -> None:
    text = solution_text("projectile-medium-multipart-301917-1")
    assert r"The velocity along x is constant, so at $t_4$ the displacement is $s_x = v \cos\theta\,t_4" in text

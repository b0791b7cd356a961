"""Tests of pulleys, slopes and prisms: each equation is written once, and other roots are excluded."""

import pytest

from worked import solution_text


def test_bodies_that_rest_share_a_sentence_and_a_quadratic_is_written_with_its_other_root() -> None:
    text = solution_text("box-hard-choice-301914-2")
    assert "Blocks A, B, C and D stay at rest relative to the prism." in text
    assert text.count("at rest relative to the prism") == 1
    assert "this gives, in SI units, $6.0041\\,m_C^{2} + 103.08\\,m_C = 2232.3$" in text
    assert "The other root, $-29.691\\ \\text{kg}$, is negative." in text


@pytest.mark.parametrize(
    ("problem", "told"),
    [
        ("box-easy-reverse-301914-0", r"(2) + (3): (4) $m_B g = \left(m_A + m_B\right) a_A - m_A a_M$."),
        ("pulley-medium-symbolic-301914-0", r"(1) + 2·(3), with (2): (5) $2\,m_B g - m_A g \sin\theta = "),
    ],
)
def test_no_equation_is_copied_in_the_order_of_the_unknowns(problem: str, told: str) -> None:
    text = solution_text(problem)
    assert told in text
    assert "With numbers for the coefficients" not in text


def test_a_normal_force_that_the_weight_gives_is_told_once() -> None:
    assert solution_text("hybrid-medium-symbolic-301914-0").count(r"$N_{\text{block}} = m g \cos\theta$") == 1


def test_a_sine_and_a_cosine_make_a_single_sine_and_the_other_angle_is_excluded() -> None:
    text = solution_text("hybrid-medium-reverse-301914-0")
    assert r"The left side is a multiple of $\sin\left(\theta - \arctan\mu\right)$, so" in text
    assert r"The other solution, $160.67^\circ$, is more than $90^\circ$." in text


def test_parts_write_no_equation_that_they_do_not_use() -> None:
    text = solution_text("pulley-hard-multipart-301914-1")
    *_, third, fourth = text.split("\n\n(")
    assert "17.050" not in text
    assert third.count("In numbers") == 1
    assert "(2) + (3)" not in fourth


def test_an_acceleration_bound_to_another_keeps_its_name_and_all_tensions_are_checked() -> None:
    text = solution_text("hybrid-hard-numeric-301932-1")
    assert r"the acceleration $a_A = 2\,a_D = 1.3288\ \text{m/s}^2$ is positive" in text
    assert "The strings stay taut, as the tension $T_{BC} = " in text
    assert r"$T_2 = m_B g + T_{BC} - 2\,m_B a_D = 154.18\ \text{N}$ are positive." in text


def test_what_leads_to_a_formula_that_the_text_has_is_not_told_after_the_answer() -> None:
    text = solution_text("pulley-medium-symbolic-301932-0")
    assert "Inserting $v_A$ and $a_A$ into the equation for $K_A$ gives" in text
    assert "In terms of the given quantities" not in text


def test_numbers_put_in_for_known_quantities_are_called_so() -> None:
    """Equations with numbers as coefficients are announced as such, and have one order of the unknowns."""
    text = solution_text("pulley-medium-reverse-301928-0")
    assert r"With numbers for the coefficients: (5) $17.0\,a_A - 7.4\,a_B = 2\,m_C g - m_A g \sin\theta$." in text


def test_a_string_on_a_pulley_with_mass_does_not_slip_and_the_sense_of_turning_is_told() -> None:
    """The sign of a_P in a_C = a_P + a_A has a meaning only if the text states the positive sense of rotation."""
    text = solution_text("hybrid-hard-reverse-301931-0")
    assert "does not stretch, nor does it slip on pulley P: $a_C = a_P + a_A$." in text
    assert "positive when the part of the string between crate A and pulley P runs onto pulley P;" in text

"""Tests of the reason for the sign of a quantity given by its magnitude, if no formula shows that sign."""

from worked import solution_text


def test_a_sign_that_was_chosen_is_told_to_be_supposed_and_the_other_one_is_excluded() -> None:
    """The displacement of the puck depends on the unknown mass, so its direction isn't known at first."""
    text = solution_text("collision-hard-reverse-301926-0")
    assert "$s_{A,3} = -s_{A,2}$, supposing that this is positive." in text
    other = r"the formula would give $-2.3529\ \text{kg}$ or $-3.1287\ \text{kg}$ for $m_C$, both negative."
    assert f"Only a magnitude is given; with $-s_{{A,3}}$ in place of $s_{{A,3}}$, {other}" in text


def test_a_root_that_no_value_of_the_unknown_gives_is_told() -> None:
    """With v'_B = v_A the pucks wouldn't collide; motion back up the slope would need a negative sine."""
    text = solution_text("collision-hard-reverse-301926-0")
    assert "No positive $m_C$ gives the other root, $-0.21000\\ \\text{m/s}$." in text
    text = solution_text("collision-hard-reverse-301930-0")
    assert "No $\\theta$ between $0^\\circ$ and $90^\\circ$ gives the other root, $1.8382\\ \\text{m/s}$." in text


def test_an_angle_with_the_opposite_sign_at_which_friction_would_hold_is_excluded() -> None:
    text = solution_text("springs-hard-reverse-301927-0")
    told = "with the opposite sign, for which $\\theta$ would be $29.646^\\circ$, "
    assert told in text
    assert "would not be greater than $\\mu m g \\cos\\theta$." in text.partition(told)[2]


def test_the_equation_for_the_unknown_is_more_than_its_answer() -> None:
    text = solution_text("collision-hard-reverse-301929-0")
    assert "gives, in SI units, $r_{x,B} = 5.1026\\,e_2 - 1.0334$, so $e_2 = 0.53961$." in text


def test_an_equation_is_in_symbols_or_in_numbers() -> None:
    text = solution_text("chain-medium-reverse-301930-0")
    equation = text.partition("gives, in SI units, ")[2].partition(", so ")[0]
    assert "142.00\\,d - 92.186\\,d" in equation
    assert "k_1" not in equation

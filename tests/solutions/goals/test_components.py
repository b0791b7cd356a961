"""Tests of vector components: each is positive in the direction that was stated when its name was introduced."""

from worked import solution_text


def test_a_velocity_is_told_in_the_direction_in_which_it_counts_as_positive() -> None:
    """The box moves to the left and B down, but the text states components to the right and upward."""
    text = solution_text("box-medium-reverse-301919-4")
    assert "displacement of the box to the right and $x_B$ be the displacement of block B upward" in text
    assert "relative to the ground has the components $v_M$ to the right and $v_B$ upward." in text


def test_a_string_under_a_pulley_is_not_tied_to_it() -> None:
    text = solution_text("hybrid-medium-numeric-disc-pulley")
    assert "in the part of the string between pulley P and its fixed end" in text
    assert "tied to pulley P" not in text


def test_a_string_that_passes_a_pulley_is_tied_to_the_body_at_its_end() -> None:
    text = solution_text("pulley-medium-choice-4711-0")
    assert "$T_2$ in the string tied to crate A" in text
    assert "moving pulley P changes the two parts beside it equally" in text


def test_the_angular_velocity_counts_in_the_sense_in_which_the_angular_acceleration_does() -> None:
    text = solution_text("rolling-easy-reverse-301921-0")
    assert "its radius times its angular acceleration is $a$, too" in text
    assert "As its radius times its angular velocity is $v_1$, the energy of rotation" in text


def test_the_energy_that_friction_on_a_rolling_body_dissipates_takes_the_slip_of_its_point_of_contact() -> None:
    text = solution_text("rolling-hard-numeric-301921-2")
    assert "dissipates, which is the friction times the distance that the point of contact slips, is $Q = " in text


def test_the_tension_whose_impulse_is_asked_for_is_named() -> None:
    """The tension is named again, since the preceding sentence verifies the tension of another string."""
    text = solution_text("pulley-medium-numeric-301928-0")
    assert r"The impulse of the tension in the string between crate A and crate B is $J = T_1\,t" in text


def test_the_motion_that_a_bounce_slows_down_is_perpendicular_to_the_ground() -> None:
    text = solution_text("projectile-hard-multipart-301929-0")
    assert "The motion perpendicular to the surface keeps $e^2$ of its energy" in text


def test_components_are_told_again_in_a_later_part() -> None:
    """In part (b) the components are stated again, since the subscript of $a_A$ refers to another crate."""
    part = solution_text("box-medium-multipart-301932-1").partition("\n\n(b) ")[2].partition("\n\n(c) ")[0]
    told = "The acceleration of crate B relative to the ground has the components $a_M$ to the left and $a_A$ downward."
    assert told in part


def test_a_stretch_that_is_a_displacement_is_told_to_be_that() -> None:
    assert "Spring 1 is stretched by $x_A$." in solution_text("chain-medium-multipart-301932-0")

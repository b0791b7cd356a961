"""Tests of sentences in worked solutions that must hold in every problem in which they are written."""

from worked import solution_text


def test_static_friction_of_either_sense_is_counted_in_one_direction() -> None:
    text = solution_text("hybrid-medium-symbolic-301928-0")
    assert "The static friction $f_A$ on block A is counted as positive up the slope." in text
    assert r"\left|f_A\right| = \boxed{" in text


def test_friction_that_dissipates_is_between_two_bodies_of_a_stack() -> None:
    """Friction acts on both faces of board B, so the text has to name the other board."""
    text = solution_text("incline-hard-multipart-301930-0")
    assert "The energy that friction between board B and board A dissipates is $Q = " in text
    assert "Friction acts on board" not in text


def test_a_swing_that_goes_over_the_top_is_told_apart_from_one_that_turns_back() -> None:
    before, after = solution_text("pendulum-hard-choice-301928-0").split("With $v$ doubled", 1)
    assert "turns back on the other side of the vertical" in before
    enough = r"$v_{\text{new}}^{2} > 2\,g \ell \left(1 + \cos\theta\right)$"
    assert f"As {enough}, the ball still moves at the top of the circle." in after


def test_a_string_stays_taut_as_far_as_an_unknown_speed_takes_the_bob() -> None:
    text = solution_text("pendulum-easy-reverse-301932-1")
    assert r"As $\phi_{\text{max}}$ is less than $90^\circ$, the string stays taut until then." in text


def test_of_several_solutions_the_smallest_is_the_first_instant() -> None:
    text = solution_text("orbital-hard-numeric-301926-1")
    assert "The planet is at the distance $d$ from its starting point when" in text
    assert r"The smallest positive solution, found numerically, is $\eta = 1.0541" in text


def test_why_an_acceleration_is_greatest_is_said() -> None:
    text = solution_text("orbital-medium-numeric-301930-0")
    assert "By the inverse-square law, the acceleration is greatest at the least distance." in text


def test_a_velocity_after_half_a_turn_rests_on_no_sine_that_was_not_written() -> None:
    text = solution_text("orbital-medium-choice-301928-0")
    assert "proportional to the sine of the angle turned since the nearest point, so after half a turn it is" in text
    assert "at right angles to it, counted counter-clockwise." in text


def test_an_extension_of_either_sign_is_not_told_as_a_stretch() -> None:
    """At maximum compression the spring isn't *stretched by* anything: its extension is negative."""
    text = solution_text("mixed-medium-reverse-301932-1")
    assert r"The extension of the spring is $\ell + x - \ell_0$." in text

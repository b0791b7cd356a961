"""Tests of the stated reasons why another collision does not come first."""

from worked import solution_text


def test_discs_that_slide_past_each_other_are_said_to_move_apart() -> None:
    """After an inelastic impact there is no relative velocity along the line of centres, which then rotates."""
    text = solution_text("collision-hard-choice-301926-0")
    assert "pucks A and C keep only a relative velocity perpendicular to their line of centres, which" in text

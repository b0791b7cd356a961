"""Reasons why other collisions do not come first."""

from worked import solution_text


def test_discs_that_keep_no_relative_velocity_are_said_not_to_collide_until_another_body_acts_on_one() -> None:
    text = solution_text("collision-hard-multipart-301923-0")
    assert "pucks A and C touch, but keep no relative velocity along their line of centres" in text
    assert "do not collide again before one of them collides with another body" in text

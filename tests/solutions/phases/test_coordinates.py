"""Tests of the names of coordinates in equations of motion."""

from worked import solution_text


def test_along_axes_of_the_text_a_coordinate_is_a_displacement() -> None:
    """A path in a magnetic field turns, so displacements are along x and y, not to the right or left."""
    text = solution_text("electromagnetic-hard-reverse-301931-0")
    assert "Let $x$ be the displacement of the bead along x and $y$ be the displacement of the bead along y;" in text
    assert "to the right" not in text

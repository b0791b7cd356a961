"""Tests that a sign is dropped only if a sentence calls the quantity a magnitude."""

import pytest

from sim2reason.solutions.writing.notation import magnitude_words
from worked import solution_text


@pytest.mark.parametrize(
    ("said", "quantity", "expected"),
    [
        ("The momentum is", "momentum", "The magnitude of the momentum is"),
        (
            "Relative to the ground, the velocity is",
            "velocity",
            "Relative to the ground, the magnitude of the velocity is",
        ),
        ("By Newton's second law,", "net force", "The magnitude of the net force is"),
        ("The kinetic energy is", "kinetic energy", "The kinetic energy is"),
    ],
)
def test_a_vector_is_called_by_its_magnitude(said: str, quantity: str, expected: str) -> None:
    assert magnitude_words(said, quantity) == expected


def test_an_acceleration_whose_sign_is_dropped_is_a_magnitude() -> None:
    text = solution_text("pendulum-hard-multipart-301922-0")
    assert r"Relative to the ground, the magnitude of the acceleration is $a = -a_{\text{c}}" in text


def test_the_torque_on_a_cylinder_with_a_hole_is_about_its_centre_of_mass() -> None:
    text = solution_text("rolling-medium-reverse-301922-1")
    assert r"The magnitude of the torque about the centre of mass is $M = -I_0\,\alpha$." in text


def test_a_momentum_that_an_unknown_makes_positive_is_a_magnitude() -> None:
    text = solution_text("collision-medium-reverse-301923-2")
    assert "The magnitude of the momentum of cart A is $p_A = -m_A v'_A$, supposing that this is positive." in text

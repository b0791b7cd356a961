"""Tests of charges on which a force component is zero, and of velocities that follow from a displacement."""

from sim2reason.solutions import solve_prompt
from sim2reason.testing.solution_text import read

CROSSED = """There is a uniform magnetic field of strength $B$ in the positive z direction. An electric field is \
everywhere parallel to the x axis; at x = 0 it has magnitude $E$ and points in the negative x direction, and its x \
component decreases with x at a rate of $k$. At t = 0 a small ball (mass $m$) that \
carries a negative charge of magnitude $q$ is at the origin of the x-y plane, moving at speed $v$ in a \
direction at an angle $\\theta$ counter-clockwise from the positive x direction. No gravity acts here. \
Calculate the work that the electric field does on the ball between t = 0 and t = 1.5 s. Let $B$ = 0.84 \
T, $E$ = 0.48 N/C, $k$ = 0.75 N/(C·m), $m$ = 3.1 mg, $q$ = 4.4 µC, $v$ = 2.3 m/s and $\\theta$ = 50°. \
Give your answer in µJ, to three significant figures, inside \\boxed{}."""
GROWING = """An electric field is everywhere parallel to the y axis; at y = 0 it has magnitude $E$ and points in the \
positive y direction, and its y component increases with y at a rate of 0.63 N/(C·m). At t = 0, a \
small bead (4.1 mg) that carries a positive charge of 1.8 µC is released from rest at the origin of the \
x-y plane. No gravity acts here. Calculate $E$ if the distance between the bead and \
its starting point at t = 1.8 s is 0.54 m. State the answer in N/C to three significant figures, inside \
\\boxed{}."""


def text_of(prompt: str) -> str:
    """Return the worked solution of a problem after checking all of its numbers."""
    found = solve_prompt(prompt)[0]
    assert found.answer is not None, found.reason
    assert not read(found.text).broken
    return found.text


def test_only_a_component_of_the_net_force_is_zero_at_the_centre_of_an_oscillation() -> None:
    text = text_of(CROSSED)
    assert "The x component of the net force is zero at x equal to $x_c" in text
    assert "The force is zero" not in text


def test_the_displacement_along_the_field_stands_by_itself() -> None:
    text = text_of(CROSSED)
    assert "gives the displacement of the ball along x, $s_x = " in text
    assert r"$v_y = v \sin\theta - \Omega s_x" in text


def test_a_growing_field_is_said_to_change_with_the_place() -> None:
    text = text_of(GROWING)
    assert "Away from the origin this component changes with y at the rate $k_1" in text
    assert "The equation along y is linear; apart from a constant its solutions are exponentials" in text

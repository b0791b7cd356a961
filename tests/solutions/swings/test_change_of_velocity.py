"""Tests of the velocities between which a momentum changes, and of the side on which a ball turns back."""

from sim2reason.solutions import solve_prompt
from sim2reason.testing.solution_text import read

SLACK = """In this problem g = 9.8 m/s². A light, inextensible string of length 1.9 m joins a small ball (0.23 kg) \
to a fixed point. To begin with, the ball hangs straight down. At t = 0 the ball is set moving \
horizontally at speed 7.8 m/s. If the string goes slack and becomes taut again, the velocity along it is \
lost at that moment. Find the magnitude of the impulse of the net force on the ball between t = 0 and the \
moment when it first reaches the highest point of its path. Write the answer in N·s, to three \
significant figures, in \\boxed{}."""
TURNS = """A light inextensible string of length $\\ell$ joins a small ball (mass $m$) to a fixed point. At the \
start the string is taut and makes an angle of $\\theta$ with the downward vertical. At t = 0 the ball is \
launched downwards along its arc with a speed of $v$. Here g = 9.8 m/s². Determine how far the ball is \
from its starting point at the moment when it first comes to rest. Take $\\ell$ = 1.6 m, $m$ = 0.25 kg, \
$\\theta$ = 51° and $v$ = 3.0 m/s. Give your answer in m, to three significant figures, inside \\boxed{}."""
LOWEST = """From a fixed point a small ball (0.87 kg) hangs on a light, inextensible string of length 0.62 m. To \
begin with, the string is taut and makes an angle of 11° with the downward vertical. At t = 0 the ball is \
set moving downwards along its arc at speed 1.5 m/s. Find the tension in the string when the ball passes \
through the lowest point of its path for the first time. (The free-fall acceleration is g = 9.8 m/s².) \
Write the answer in N, to three significant figures, in \\boxed{}."""
DISC = """A light straight arm can turn without friction in a vertical plane about a fixed horizontal axle. A \
uniform thin disc of radius 0.17 m and mass 5.6 kg is fixed with its centre on the arm, 0.19 m from the \
axle, and its axis along the arm. When the motion begins, the part of the arm from the axle to the disc points 64° \
to the right of the downward vertical. The motion begins from rest. Find the greatest speed of the centre \
of mass of the disc between release and the moment when it first comes to rest again. (The acceleration \
of free fall is g = 9.8 m/s².) Write the answer in m/s, to three significant figures, in \\boxed{}."""


def text_of(prompt: str) -> str:
    """Return the worked solution of a problem after checking all of its numbers."""
    found = solve_prompt(prompt)[0]
    assert found.answer is not None, found.reason
    assert not read(found.text).broken
    return found.text


def test_an_impulse_is_the_magnitude_of_a_change_between_velocities_that_are_said() -> None:
    text = text_of(SLACK)
    assert "The initial velocity is $v$ along x." in text
    assert "the horizontal velocity stays $v_x$, and the vertical one is zero at the highest point." in text
    assert r"The impulse is the change in momentum, of magnitude $J = m \left(v - v_x\right)" in text


def test_a_ball_turns_back_on_the_other_side_with_its_string_taut() -> None:
    text = text_of(TURNS)
    assert "The ball turns back on the other side of the vertical, where all its energy is potential" in text
    assert "As this is less than $90^\\circ$, the string stays taut until then." in text


def test_a_speed_is_introduced_with_its_place() -> None:
    assert "By conservation of energy, the speed $v_1$ at the lowest point is given by" in text_of(LOWEST)


def test_a_line_across_a_disc_is_called_a_diameter_and_energy_is_named_once() -> None:
    text = text_of(DISC)
    assert "parallel to the axle, a diameter of it, is $I_0" in text
    assert "There the angular velocity $\\omega$ is given by" in text
    assert text.count("By conservation of energy") == 1

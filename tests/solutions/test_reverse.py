"""Tests of numbers found from given results: the solved equation, both roots, and the sign of a magnitude."""

from math import sqrt

import pytest

from sim2reason.solutions import Solution
from sim2reason.solutions.solve import solve_prompt
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import faults
from worked import solution_text

TENSION = (
    "On a smooth floor a prism (2.4 kg) with smooth faces at 54° (left) and 32° (right) to the horizontal"
    " is free to slide. On the left face lies crate A of mass 3.3 kg, and on the right face crate B (mass"
    " $m_B$). Across the apex, over a light pulley, a light string joins A to B. Everything is released "
    "from rest with the string taut. What must $m_B$ be if the tension in the string after the release is"
    " to be 15.7 N? (The pulley turns freely, and no body reaches an edge. The acceleration due to "
    "gravity is g = 9.8 m/s².) Give your answer in kg, to three significant figures, inside \\boxed{}."
)
LANDING = (
    "A small ball of mass 2.0 kg is thrown at t = 0 with a speed of 7.8 m/s at an angle of $\\theta$ above"
    " the horizontal from a point 2.5 m above level ground. The ground is smooth, and at each landing the"
    " ball rebounds with 0.74 times its vertical speed. Air resistance is negligible. The free-fall "
    "acceleration is g = 9.8 m/s². The speed of the ball just before it hits the ground for the second "
    "time is 8.54 m/s. Find $\\theta$. Write the answer in degrees, to three significant figures, in "
    "\\boxed{}."
)
ENERGY = (
    "A smooth, fixed plane inclined at an angle $\\theta$ to the horizontal carries a block whose mass is "
    "2.4 kg. The velocity of the block at t = 0 is 0.76 m/s, directed up the slope. In the interval from t = "
    "0 to t = 1.4 s, the magnitude of the change in the block's gravitational potential energy is 63 J. "
    "Find $\\theta$. Let g = 9.8 m/s². Give your answer in degrees, to three significant figures, inside "
    "\\boxed{}."
)
TRACK = (
    "On a straight and smooth horizontal track there are two small pucks, named in order of increasing x;"
    " along it x is measured to the right. Puck A (mass $m_A$) is moving with velocity $v_A$ at x = $x_A$"
    " at t = 0. Puck B (mass $m_B$) is moving with velocity $v_B$ at x = $x_B$ at t = 0. The coefficient "
    "of restitution of every collision is $e$. Use $m_A$ = 3.6 kg, $v_A$ = 2.84 m/s, $x_A$ = −1.52 m, "
    "$m_B$ = 2.5 kg, $v_B$ = −1.64 m/s and $x_B$ = 1.11 m. At the time t = 2.8 s, the distance between "
    "puck A and its starting point is 0.72 m. What is $e$? Write the final answer, to three significant "
    "figures, in \\boxed{}."
)
FRICTION = (
    "A stationary plane inclined at an angle $\\theta$ to the horizontal carries a uniform thin disc A of "
    "radius $R_A$ and mass $m_A$, which can roll straight up or down the slope. There is no slipping."
    " From the axle of A a light string runs up the slope, passes over a pulley fixed in place (a uniform"
    " disc of mass $M$) and runs straight down to block B of mass $m_B$. The bodies are released from "
    "rest with the string taut. The axle is frictionless, no string slips on "
    "the pulley, and no body reaches it. Let g = 9.8 m/s². The magnitude of the friction force exerted on"
    " disc A by the plane after the release is 1.86 N. Find the angle $\\theta$. Data: $R_A$ = 0.099 m, "
    "$m_A$ = 1.1 kg, $M$ = 0.97 kg and $m_B$ = 2.2 kg. Give your answer in degrees, to three significant "
    "figures, inside \\boxed{}."
)
CRATE = (
    "On a fixed smooth plane inclined at 26° to the horizontal lies a crate whose mass is 0.59 kg. The "
    "crate is launched up the slope at t = 0 with a speed of 1.2 m/s. Here g = 9.8 m/s². Find the total "
    "distance that the crate travels between t = 0 and t = 0.54 s. Give your answer in m, to three "
    "significant figures, inside \\boxed{}."
)
LAUNCHED = (
    "Description: On a smooth, fixed plane inclined at 39° to the horizontal lies a crate of mass 0.82 "
    "kg. The crate is launched up the slope at t = 0 with a speed of $v$. Use g = 9.8 m/s².\n\n"
    "Question: The time from t = 0 until the crate has moved 1.8 m is 0.58 s. Find $v$. State the answer "
    "in m/s to three significant figures, inside \\boxed{}."
)


def solved(prompt: str) -> Solution:
    found, setting = solve_prompt(prompt)
    assert found.answer is not None, found.reason
    assert setting.answer is not None
    assert not faults(found, setting.answer, 1e-6), found.text
    assert not read(found.text).broken
    return found


@pytest.mark.parametrize(
    ("prompt", "said"),
    [
        (
            TENSION,
            "Inserting $a_A$ and $a_M$ into the equation for $T$, with the given $T$, gives, in SI units, $11.533",
        ),
        (TENSION, r"The other root, $-10.208\ \text{kg}$, is negative, but $m_B$ is positive."),
        (LANDING, r"$v_y$ and $t$ into the equation for $v_1$ gives $v_1 = \sqrt{v^{2} \cos^{2} \theta"),
        (
            LANDING,
            r"for the given $v_1$, with $\cos^{2} \theta = \tfrac{1}{2} \left(1 + \cos\left(2\,\theta\right)\right)$",
        ),
        (ENERGY, r"\sin^{2} \theta - m g v t \sin\theta = U$"),
    ],
    ids=["in numbers", "other root", "put together", "double angle", "in a sine"],
)
def test_the_equation_that_is_solved_is_written(prompt: str, said: str) -> None:
    assert said in solved(prompt).text


@pytest.mark.parametrize(
    ("prompt", "reason"),
    [
        (TRACK, r"the formula would give $1.134"),
        (FRICTION, r"there would be no angle $\theta$, as its sine would be $3.3"),
        (ENERGY, r"would not be real, as what stands under the square root would be negative"),
    ],
    ids=["restitution", "sine", "root"],
)
def test_the_opposite_sign_of_a_given_magnitude_is_excluded(prompt: str, reason: str) -> None:
    found = solved(prompt)
    assert "Only a magnitude is given; with $-" in found.text
    assert reason in found.text
    assert any(relation.role == "exceeds" for relation in found.relations)


def test_that_a_body_has_turned_back_is_shown() -> None:
    found = solved(CRATE)
    assert r"after $t_{\text{turn}} = -\frac{v}{a} = 0.27933\ \text{s}$, which is less than $t$" in found.text
    assert any(relation.role == "exceeds" for relation in found.relations)


def test_that_a_body_has_not_turned_back_is_shown() -> None:
    found = solved(LAUNCHED)
    assert "and still positive, so the crate is there for the first time" in found.text
    assert found.text.index("still positive") > found.text.index("With the given $t$")


HALTED = (
    "A rough, fixed plane inclined at 60° to the horizontal carries a block (mass $m$). The block is joined to a stop "
    "at the foot of the slope by a light spring with a stiffness of 365 N/m and a natural length of 0.54 m. The "
    "coefficients of static and of kinetic friction on this plane are both 0.31. The initial length of the spring is "
    "0.56 m. The motion starts from rest. The magnitude of the change in the block's gravitational potential energy "
    "between release and the moment when it comes to rest for good is 0.82 J. What is $m$? Use g = 9.8 m/s². State "
    "the answer in kg to three significant figures, inside \\boxed{}."
)
PRISM = (
    "A prism of mass $M$ with smooth faces rising at 28° on the left and 31° on the right is free to slide on a smooth "
    "floor. On the left face lies crate A of mass 1.6 kg, and on the right face crate B of mass 0.86 kg. Over a light "
    "pulley at the apex a light string runs from A to B. Friction at the pulley is negligible, and no body reaches "
    "an edge. Take g = 9.8 m/s². Given that the motion starts from rest with the string taut, calculate the mass "
    "$M$ if the prism takes 0.660 s to move 0.29 m, counted from release. State the answer in kg to three significant "
    "figures, inside \\boxed{}."
)


def test_formulas_put_into_each_other_stand_in_symbols_where_these_are_short() -> None:
    text = solve_prompt(HALTED)[0].text
    assert r"$x_1$ and $x_0$ into the equation for $U$ gives $U = \frac{8\,\mu m^{2} g^{2}" in text
    assert "in numbers" not in text


def test_the_opposite_of_a_magnitude_is_not_excluded_where_its_sign_is_seen() -> None:
    assert "would not be real" not in solve_prompt(HALTED)[0].text


def test_a_quotient_of_numbers_has_its_equation_before_it() -> None:
    text = solve_prompt(PRISM)[0].text
    assert r"In SI units, $a_M = \frac{" in text
    assert r"so $M = \frac{4.5903}{3.2755} = 1.4014\ \text{kg}$." in text


def test_the_other_angle_with_a_sine_is_more_than_a_right_angle() -> None:
    found = solve_prompt(ENERGY)[0]
    assert "The other angle with this sine, $144.10^\\circ$, is more than $90^\\circ$." in found.text
    assert any(r.role == "exceeds" and r.left.latex() == r"\pi - \theta" for r in found.relations)


def test_numbers_whose_difference_is_small_have_guard_digits() -> None:
    """The root of a quadratic in I₀ is the difference of 2.0211 and 1.8131: five digits of each would leave four."""
    text = solution_text("rotation-medium-reverse-72-19")
    assert r"$I_0 = \frac{\sqrt{4.084869} - 1.813135}{7.29} = 0.028528\ \text{kg m}^2$" in text
    assert (sqrt(4.084869) - 1.813135) / 7.29 == pytest.approx(0.028528, rel=2e-5)


def test_a_greatest_value_that_is_given_is_no_function_of_time() -> None:
    """With several modes the derivative vanishes at other instants too, so the equations have several solutions."""
    text = solution_text("chain-hard-reverse-906400-13")
    assert "and $x_{A,1} = 0.038" in text
    assert "Let $x_A$ and $x_B$ be the displacements" in text
    assert "These equations together have the numerical solution $v = 0.69015" in text

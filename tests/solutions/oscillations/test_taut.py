"""Tests of strings that stay taut during oscillations, and of tensions whose maximum is at an end."""

from sim2reason.solutions import solve_prompt
from sim2reason.testing.solution_text import read
from worked import solution_text

HUNG = """On a fixed smooth plane inclined at 18° to the horizontal lies block A (3.5 kg). A light spring with a \
stiffness of 423 N/m and a natural length of 0.90 m leads from A to a stop at the foot of the slope. The \
length of the spring at the start is 0.94 m. A light string tied to block A runs up the slope, passes \
over a light pulley fixed in place and runs straight down to block B (2.1 kg). Everything is held at rest \
with the string taut, and then released. Find the tension in the string 1.8 s after release. The pulley \
turns freely, and no body reaches it. The acceleration due to gravity is g = 9.8 m/s². Give your answer \
in N, to three significant figures, inside \\boxed{}."""


def text_of(prompt: str) -> str:
    """Return the worked solution of a problem after checking all of its numbers."""
    found = solve_prompt(prompt)[0]
    assert found.answer is not None, found.reason
    assert not read(found.text).broken
    return found.text


def test_a_string_is_shown_to_stay_taut_by_the_greatest_acceleration() -> None:
    text = text_of(HUNG)
    assert "The acceleration of block B is at most $a_{\\text{max}} = -\\omega^{2} x_0 = " in text
    assert "less than $g$, so the string between block A and block B stays taut." in text
    assert "Its tension is at least $T_{\\text{min}} = m_B \\left(g - a_{\\text{max}}\\right) = " in text
    assert "Let $T$ be the tension in the string between block A and block B." in text


def test_a_string_along_a_smooth_slope_is_shown_to_stay_taut() -> None:
    """The other body lies on a second slope, so the string carries less than its weight component along it."""
    prompt = HUNG.replace(
        "A light string tied",
        "Another fixed plane of inclination 36° with a smooth surface carries block B (2.1 kg). A light string tied",
    ).replace("runs straight down to block B (2.1 kg)", "reaches B from above, along the slope")
    text = text_of(prompt)
    assert "less than $g \\sin\\theta_2$, so the string between block A and block B stays taut." in text
    assert "at least $T_{\\text{min}} = m_B \\left(g \\sin\\theta_2 - a_{\\text{max}}\\right) = " in text


def test_the_greatest_tension_is_at_an_end_of_the_motion_with_the_reason() -> None:
    text = solution_text("mixed-easy-symbolic-301917-3")
    assert "The tension is therefore greatest at one end of the motion; a comparison of both shows that it is" in text
    assert "The other root, zero, is the start." in text
    assert "each in the direction in which its body moves while $x$ grows, are added up, tensions cancel:" in text


def test_the_greatest_acceleration_is_that_of_the_first_half_oscillation_where_friction_takes_energy() -> None:
    text = solution_text("mixed-hard-numeric-301921-2")
    assert r"is at most $a_{\text{max}} = \omega^{2} x_0 = 6.3632\ \text{m/s}^2$, less than $g$" in text

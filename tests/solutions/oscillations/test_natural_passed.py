"""Tests of the reason why a launched body passes the natural length of a spring."""

from sim2reason.solutions.solve import solve_prompt
from worked import solution_text

STRETCHED = (
    "A crate of mass 2.0 kg lies on a smooth horizontal table, on which x points to the right and y away from you. A "
    "light spring with a stiffness of 40 N/m and a natural length of 0.50 m ties the crate to a fixed point at (0 m, "
    "0 m). Initially the crate is at the point (0.70 m, 0 m). The crate is given the velocity (−0.60 m/s, 0.50 m/s) at "
    "t = 0. Calculate the greatest speed of the crate between t = 0 and the moment when the spring first reaches its "
    "maximum extension. State the answer in m/s to three significant figures, inside \\boxed{}."
)


def test_what_lengthens_at_first_goes_on_to_do_so_as_long_as_it_is_compressed() -> None:
    text = solution_text("springs-medium-multipart-301933-0")
    assert r"it lengthens at first, $x_1\,v_1 + y_1\,v_2 > 0$, and goes on to do so as long as it is compressed" in text
    assert text.count("The speed is greatest where the spring stores no energy") == 2  # in both cases


def test_an_unknown_natural_length_is_assumed_to_be_passed() -> None:
    """With ℓ_0 = 0.713 m the spring would be compressed at first, and the crate fastest at the start."""
    text = solution_text("springs-easy-reverse-301932-1")
    assert r"Assume that $\ell_1 > \ell_0$. Then the spring passes that length" in text
    assert r"If it were compressed at first, it would be fastest at the start, as it shortens then" in text
    assert r"Indeed $\ell_1 > \ell_0$, as was assumed." in text
    assert r"With the other root for $\ell_0$, $0.713" in text
    assert "There all energy is kinetic; as it is conserved, its value is $E = " in text


def test_what_shortens_at_first_does_not_turn_back_before_the_natural_length() -> None:
    """E = 0.61 + 0.8 = 1.41 J exceeds ½ m (h/ℓ_0)² = (0.35/0.5)² = 0.49 J, so the body doesn't turn back."""
    text = solve_prompt(STRETCHED)[0].text
    assert "it shortens at first, $" in text
    assert r"where it is $K_0 = " in text
    assert r"= 0.49000\ \text{J}$; so the spring does not turn back between these." in text

"""Tests of limiting cases without acceleration and of accelerated carriers, against closed forms."""

from math import cos, radians, sin

import pytest

from sim2reason.datasets.items import item
from sim2reason.solutions.solve import solve_prompt
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import faults

BOX = (
    "On a smooth floor a box of mass 9.5 kg with a rough top is free to slide. Its top carries blocks A (6.2 kg) and "
    "B (8.3 kg), with A on the left and a light string between them. Static and kinetic friction on the top have the "
    "same coefficient, $\\mu$. Block C of mass 3.2 kg slides in a smooth vertical guide on the left side of the box; "
    "from it a light string runs up and over a light pulley at the edge to A. Over a light pulley at the right edge a "
    "light string joins B to block D of mass 8.6 kg, which can only slide in a smooth vertical guide on that side of "
    "the box. The system is released from rest with all strings taut. Friction at pulleys is negligible, and there is "
    "ample room to move. Here g = 9.8 m/s². Find the value of $\\mu$ below which block A slips on the box. State the "
    "answer to three significant figures, inside \\boxed{}."
)
PRISM = (
    "A prism of mass 4.6 kg with rough faces rising at 61° on the left and 53° on the right stands on a smooth floor "
    "and is free to slide. On the left face lies block A (3.4 kg), and on the right face block B of mass 2.4 kg. A "
    "light string over a light pulley at the apex joins A to B. On both faces the coefficient of friction, static and "
    "kinetic, is $\\mu$. All bodies are held at rest with the string taut, and let go together. The pulley turns "
    "freely, and no body reaches an edge. Use g = 9.8 m/s². Find the smallest coefficient of friction $\\mu$ "
    "for which block A does not slip on the prism. Give your answer to three significant figures, inside \\boxed{}."
)


def limit(prompt: str, *, rests: bool) -> float:
    found, setting = solve_prompt(prompt)
    assert found.strategy == "limiting case", found.reason
    assert setting.answer is not None
    assert found.answer is not None
    assert not faults(found, setting.answer, 1e-6), found.text
    assert not read(found.text).broken
    assert ("all bodies are still at rest" in found.text) == rests
    return found.answer


def test_blocks_on_a_box_that_still_rests() -> None:
    """The weights that hang on the two sides differ by the friction forces on both blocks."""
    assert limit(BOX, rests=True) == pytest.approx((8.6 - 3.2) / (6.2 + 8.3), rel=1e-9)


def test_blocks_on_a_prism_that_still_rests() -> None:
    alpha, beta = radians(61), radians(53)
    above = 3.4 * sin(alpha) - 2.4 * sin(beta)
    assert limit(PRISM, rests=True) == pytest.approx(above / (3.4 * cos(alpha) + 2.4 * cos(beta)), rel=1e-9)


def test_the_solution_has_no_acceleration_that_is_zero() -> None:
    found, _ = solve_prompt(PRISM)
    assert "a_" not in found.text
    assert len(found.text) < 1000


def test_it_is_said_which_way_a_body_is_about_to_slip_and_what_slips_with_it() -> None:
    found, _ = solve_prompt(PRISM)
    assert "block A is just about to slip down the face: friction on it has its greatest value" in found.text
    assert "and so has the friction on block B, which the taut string makes slip together with it" in found.text


def test_a_modulus_says_what_it_means_for_slipping_either_way() -> None:
    found = item(recipe="pulley", difficulty="hard", mode="symbolic", seed=977, index=0, solutions=True)
    assert found.answer.formula is not None
    assert found.solution is not None
    assert r"\left|" in found.answer.formula.latex
    assert "the other way $\\mu$ has the opposite sign" in found.solution.text

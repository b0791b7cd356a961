"""Tests of the check that strings stay taut under constant accelerations: their tensions are positive."""

import re

from sim2reason.questions.prompt_formats import parse_parts
from sim2reason.solutions import solve, solve_prompt
from sim2reason.solutions.multipart import sequential_solutions
from sim2reason.solutions.solve import setting_of
from sim2reason.testing.solution_text import read
from sim2reason.testing.solution_verification import faults

ATWOOD = r"""A light string is tied to block A of mass 3.9 kg; it runs straight up, passes over a light hanging pulley \
P and runs straight down to block B of mass 2.9 kg. Block C of mass 3.4 kg hangs from another light \
string, which passes over a light fixed pulley Q and runs straight down to the axle of P. All bodies are \
held at rest with all strings taut, and let go together. Calculate the distance between block C and its \
starting point when block B has moved 0.84 m. The pulleys are frictionless, and every string is long \
enough. Here g = 9.8 m/s². Write the answer in m, to three significant figures, in \boxed{}."""

ROW = r"""Blocks A (8.2 kg) and B (6.0 kg) lie on a fixed smooth plane inclined at an angle $\theta$ to the \
horizontal, with A lower down and a light string between them. Block C of mass 4.0 kg is tied by a light \
string to the axle of a light hanging pulley P. A third light string tied to block B runs up the slope, \
passes over a light pulley Q fixed in place, goes straight down, under P and straight up again and ends \
at a fixed hook. All bodies are released from rest with all strings taut. Block B takes 0.563 s to move 1.1 \
m, counted from release. Find the angle $\theta$. Friction at pulleys is negligible, and no body reaches \
a pulley. Take g = 9.8 m/s². Write the answer in degrees, to three significant figures, in \boxed{}."""


PARTS = ATWOOD.partition("Calculate")[0].replace("\\\n", "") + (
    "The pulleys are frictionless, and every string is long enough. Here g = 9.8 m/s².\n\n(a) How long after "
    "release has block B moved 0.84 m?\n(b) What is the distance between block C and its starting point at that "
    "moment?\n\nGive all answers together in one box, as in \\boxed{(a) …; (b) …}: (a) in s and (b) in m, to three "
    "significant figures."
)


def solved(prompt: str) -> str:
    """Return the text of a solution after checking its numbers and its tension checks."""
    found = solve_prompt(prompt.replace("\\\n", ""))[0]
    assert found.answer is not None, found.reason
    assert not faults(found, found.answer)
    assert not read(found.text).broken
    taut = [r for s in found.steps if s.kind == "tension check" for r in s.relations if r.role == "exceeds"]
    assert all(relation.right.latex() == "0" for relation in taut)
    return found.text


def test_the_tensions_that_cancel_are_stated_after_the_accelerations() -> None:
    text = solved(ATWOOD)
    told = re.search(
        r"The strings stay taut, as \$T_1 = [^$]* = 22\.05\d\\ \\text\{N\}\$ and \$T_2 = 2\\,T_1 = 44\.10\d"
        r"\\ \\text\{N\}\$ are positive\.",
        text,
    )
    assert told is not None, text
    assert text.index("$a_B = ") < told.start() < text.index("When block B has moved")


def test_a_string_within_a_row_of_blocks_has_a_tension_of_its_own() -> None:
    """The tension of the inner string cancels, and is computed once the unknown angle has been found."""
    text = solved(ROW)
    assert "The strings stay taut, as the tension $T_{AB} = m_A" in text
    assert "in the string between block A and block B, $T_1 = " in text
    assert text.index("= 64.0") < text.index("The strings stay taut")


def test_a_later_part_does_not_say_again_that_strings_stay_taut() -> None:
    """The combined solution has the tension check in its first part only; each part solved alone has its own."""
    settings = [*map(setting_of, parse_parts(PARTS))]
    alone = [solve(setting) for setting in settings]
    whole = sequential_solutions(settings, alone, whole=True)
    assert ["tension check" in [step.kind for step in found.steps] for found in alone] == [True, True]
    assert ["tension check" in [step.kind for step in found.steps] for found in whole] == [True, False]
    assert all(found.answer is not None for found in whole)

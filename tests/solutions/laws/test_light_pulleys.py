"""Tests of strings round a movable pulley, and of numerical eliminations that are written out."""

import re

import pytest

from sim2reason.solutions import solve_prompt

PULLEYS = """On a rough, fixed plane inclined at 26° to the horizontal lies block A of mass 5.2 kg. On this plane the \
coefficient of friction, static and kinetic, is 0.31. On another fixed plane of inclination 63° with a rough \
surface lies block B of mass 9.8 kg. On this plane the coefficient of friction, static \
and kinetic, is 0.37. Block C of mass 8.0 kg hangs from a light string, which passes over a light hanging \
pulley P, goes straight down and round a light pulley Q fixed in place and reaches B from above, along \
the slope. A second light string is tied to block A; it runs up the slope, passes over a light fixed \
pulley R and runs straight down to the axle of P. The bodies are released from rest with all \
strings taut. Pulleys turn without friction, and no body reaches a pulley. The \
free-fall acceleration is g = 9.8 m/s². How long after release is the kinetic energy of block A 17.0 J for the \
first time? Give your answer in s, to three significant figures, inside \
\\boxed{}."""

SUM = re.compile(r"\((\d)\) \+ ([\d.]+)·\((\d)\): \((\d)\) \$([\d.]+)\\,a_A = ([\d.]+)\$")


def test_a_string_is_said_to_change_on_both_sides_of_a_pulley_that_moves() -> None:
    text = solve_prompt(PULLEYS)[0].text
    said = "does not stretch, and moving pulley P changes the two parts beside it equally: "
    assert said + r"$a_B = 2\,a_A - a_C$." in text


def test_printed_numbers_of_an_elimination_lead_to_the_printed_result() -> None:
    text = solve_prompt(PULLEYS)[0].text
    assert "In numbers: (5)" in text
    _, ratio, _, _, before, right = SUM.search(text).groups()  # type: ignore[union-attr]
    rights = [float(x) for x in re.findall(r"a_C = ([\d.]+)\$|a_A = ([\d.]+)\$", text)[0] if x]
    other = float(re.search(r"\(6\) \$[^=]*= ([\d.]+)\$", text)[1])  # type: ignore[index]
    assert other + float(ratio) * rights[0] == pytest.approx(float(right), rel=1e-6)
    assert float(right) / float(before) == pytest.approx(4.9175, rel=1e-5)


def test_a_balance_is_not_cited_where_its_tension_cancels() -> None:
    assert "(3) − (4): " in solve_prompt(PULLEYS)[0].text

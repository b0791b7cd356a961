"""Tests of the reason why the opposite sign of a value given by its magnitude leads to no answer."""

from math import pi

import pytest

from sim2reason.solutions.algebra.expressions import Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import Call, Root
from sim2reason.solutions.opposite_sign import exclude_opposite_sign
from sim2reason.solutions.writing.steps import SolutionBuilder
from worked import solution_text

F, M = Symbol("F"), Symbol("m")


def said(formula: Expression, value: float) -> str:
    """Return the sentence about −F for a formula for m in terms of the given magnitude F = 2."""
    book = SolutionBuilder()
    book.set_value("F", 2.0)
    book.set_value("m", value)
    step = book.begin_step("solve")
    exclude_opposite_sign(book, step, "F", [("m", formula)])
    step.close()
    return book.steps[-1].text if book.steps else ""


@pytest.mark.parametrize(
    ("shift", "told"),
    [(-3.0, "the formula would give $-2.0000$ or $-4.0000$ for $m$, both negative."), (0.5, "")],
)
def test_both_roots_are_looked_at(shift: float, told: str) -> None:
    """√(3 + F) + c is √5 + c for F, and c ± 1 for −F."""
    text = said(Root(Number(3.0) + F) + Number(shift), abs(5.0**0.5 + shift))
    assert text.endswith(told)
    assert bool(text) is bool(told)


def test_the_unknown_of_a_quadratic_equation_would_be_negative() -> None:
    text = solution_text("hybrid-hard-reverse-301931-0")
    assert "Only a magnitude is given; with $-F_" in text
    assert r"the formula would give $-0.69916\ \text{kg}$ or $-31.797\ \text{kg}$ for $M_P$, both negative." in text


def test_a_sine_of_another_angle_is_not_that_of_the_unknown() -> None:
    """In m = arcsin(1 − F) + 2 the sine 1 − F is that of m − 2, not of m; for −F it would be 3."""
    text = said(Call("arcsin", Number(1.0) - F) + Number(2.0), 2.0 - 0.5 * pi)
    assert text.endswith("there would be no angle $m$, as the sine would be $3.0000$.")

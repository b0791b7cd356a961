"""Tests of the search for values of an unknown at which a formula has a given value."""

from math import pi, radians, sin

import pytest

from sim2reason.solutions.algebra.evaluated import Chain
from sim2reason.solutions.algebra.expressions import Number, Symbol
from sim2reason.solutions.algebra.functions import Call
from sim2reason.solutions.algebra.root_finding import range_text, values_with
from sim2reason.solutions.writing.notation import DEGREES
from sim2reason.solutions.writing.steps import SolutionBuilder

X = Symbol("x")


def book(value: float, name: str = "x", unit: str = "") -> SolutionBuilder:
    found = SolutionBuilder()
    found.set_value(name, value, unit)
    return found


def test_both_values_with_which_a_sum_of_two_powers_is_zero_are_found() -> None:
    """The equation 1/x + x = 5/2 has the roots ½ and 2; for −5/2 there is no positive root."""
    chain = Chain((("y", Number(1.0) / X), ("z", Symbol("y") + X)))
    assert values_with(chain, 2.5, "x", book(2.0)) == pytest.approx([0.5, 2.0])
    assert values_with(chain, -2.5, "x", book(2.0)) == []
    assert range_text("x", book(2.0)) == "positive $x$"


def test_a_pole_is_no_value() -> None:
    """The function 1/(x − 1) changes sign at 1, but is never zero."""
    assert values_with(Chain((("y", Number(1.0) / (X - Number(1.0))),)), 0.0, "x", book(2.0)) == []


def test_angles_and_coefficients_of_restitution_have_bounds() -> None:
    """A slope has 2 sin x = 1 at 30°, and not at 150°, which is no angle of a slope; e² = 2.25 needs e = 1.5."""
    found = values_with(Chain((("y", Number(2.0) * Call("sin", X)),)), 1.0, "x", book(0.3, unit=DEGREES))
    assert found == pytest.approx([radians(30.0)])
    assert sin(found[0]) < sin(0.5 * pi)
    assert range_text("x", book(0.3, unit=DEGREES)) == "$x$ between $0^\\circ$ and $90^\\circ$"
    e = Symbol("e")
    assert values_with(Chain((("y", e * e),)), 2.25, "e", book(0.5, "e")) == []
    assert range_text("e", book(0.5, "e")) == "$e$ between 0 and 1"

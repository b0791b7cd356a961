"""Tests of the search for affine expressions on a tape, and of their coefficients."""

from fractions import Fraction

import pytest

from sim2reason.scenes.dsl.vectors import Number
from sim2reason.simulation.engines.exact.affine import LinearEquations, linear_equations
from sim2reason.simulation.engines.exact.tape import Symbol, Tape


def inputs() -> tuple[Tape, Symbol, Symbol, Symbol]:
    """Return a tape of the time, a coordinate and its rate."""
    tape = Tape(["t", "q0", "v0"])
    return tape, *tape.inputs.values()  # type: ignore[return-value]


def found(tape: Tape, acceleration: Number, margin: Number = 1.0) -> LinearEquations | None:
    """Return the affine coefficients found for a tape with one acceleration and one event margin."""
    return linear_equations(tape, [acceleration], [margin])


def test_sums_and_multiples_are_affine() -> None:
    """The example is a spring, a dashpot and a constant force."""
    tape, _, q, v = inputs()
    linear = found(tape, (3.0 - 4.0 * (q - 0.25) - v) / 2.0, 1.0 - q)
    assert linear is not None
    assert (linear.base, linear.slopes) == ([Fraction(2)], [[Fraction(-2), Fraction(-1, 2)]])
    assert linear.margins.tolist() == [[-1.0, 0.0]]
    assert linear.damped
    assert linear.accelerations([1.0, 2.0]).tolist() == [-1.0]


def test_no_digit_is_lost_beside_a_large_number() -> None:
    """In floating point 1e17 + 1 − 1e17 differs from 1."""
    tape, _, q, _ = inputs()
    linear = found(tape, (1e17 * q + q) - 1e17 * q)
    assert linear is not None
    assert linear.slopes == [[Fraction(1), Fraction(0)]]


@pytest.mark.parametrize("kind", ["product", "quotient", "root", "sine", "time"])
def test_what_bends_or_changes_with_time_is_not(kind: str) -> None:
    """Products and functions of unknowns and forces that depend on time are not affine."""
    tape, t, q, v = inputs()
    numbers = {"product": q * v, "quotient": 1.0 / q, "root": tape.sqrt(q), "sine": tape.sin(q), "time": q + t}
    assert found(tape, numbers[kind]) is None
    assert found(tape, q, numbers[kind]) is None


def test_what_cancels_has_no_part_in_it() -> None:
    """A difference of equal terms in time cancels."""
    tape, t, q, _ = inputs()
    linear = found(tape, (q + t) - t)
    assert linear is not None
    assert not linear.damped

"""Tests of units on the left of a bare value: converted or refused, never ignored."""

import pytest

from sim2reason.grading import Outcome, number


def boxed(answer: str, reference: float, unit: str | None) -> Outcome:
    return number(rf"\boxed{{{answer}}}", reference, unit).outcome


@pytest.mark.parametrize(
    "left",
    [
        r"\text{Speed (km/h): }",
        r"\text{Speed [km/h]: }",
        r"\text{Speed in km/h: }",
        r"\text{Speed (in km/h): }",
        r"\text{Speed in kilometres per hour} = ",
        r"\text{Speed in km/h of block A} = ",
    ],
)
def test_it_is_converted(left: str) -> None:
    assert boxed(f"{left}36", 10, "m/s") == Outcome.CORRECT
    assert boxed(f"{left}36", 36, "m/s") == Outcome.WRONG
    assert boxed(f"{left}36", 36, "m/s^2") == Outcome.WRONG_UNIT
    assert boxed(f"{left}36", 36, None) == Outcome.CORRECT
    assert boxed(rf"{left}36\text{{ m/s}}", 36, "m/s") == Outcome.CORRECT


@pytest.mark.parametrize(
    "left",
    [
        r"v\ [\text{cm/s}^2] = ",
        r"a (\text{cm/s}^2) = ",
        r"a/(\text{cm/s}^2) = ",
        r"a\text{ in cm/s}^2 = ",
        r"\text{acceleration in cm/s}^2 = ",
        r"a\text{ cm/s}^2 = ",
        r"a\text{ m/s} = ",
        r"a/\text{g} = ",
        r"a\% = ",
        r"a^\circ = ",
        r"\text{Acceleration (m/s) in cm/s}^2 = ",
    ],
)
def test_it_is_never_ignored(left: str) -> None:
    assert boxed(f"{left}9.8", 9.8, "m/s^2") != Outcome.CORRECT


@pytest.mark.parametrize(
    ("left", "unit"),
    [
        (r"v\ (\text{m/s}) = ", "m/s"),
        (r"v\,[\text{m/s}] = ", "m/s"),
        (r"\text{Angle in degrees: }", "deg"),
        (r"\text{Current (A): }", "A"),
        (r"\text{Force on block (A): }", "N"),
        (r"\text{Tension in the second string} = ", "N"),
        (r"\text{Tension in string A} = ", "N"),
        (r"\text{Force in A} = ", "N"),
        (r"v(t) = ", "m/s"),
        (r"v(2\text{ s}) = ", "m/s"),
        (r"|\vec{\mathrm{F}}| = ", "m/s"),
        (r"\Delta\text{T} = ", "s"),
        (r"\Delta \mathrm{h} = ", "m"),
        (r"\text{Acceleration (block A): }", "m/s^2"),
        (r"T_{\text{A}} = ", "N"),
    ],
)
def test_what_is_the_asked_unit_or_none_changes_nothing(left: str, unit: str) -> None:
    assert boxed(f"{left}9.8", 9.8, unit) == Outcome.CORRECT


def test_only_a_single_number_is_followed_by_smaller_units() -> None:
    """6 h 5 min are 21900 s; of a product, it is unclear what the minutes are added to."""
    assert boxed(r"6\text{ h }5\text{ min}", 21900, "s") == Outcome.CORRECT
    assert boxed(r"-6\text{ h }5\text{ min}", -21900, "s") == Outcome.CORRECT
    assert boxed(r"2 \cdot 3\text{ h }5\text{ min}", 21900, "s") != Outcome.CORRECT
    assert boxed(r"12/2\text{ h }5\text{ min}", 21900, "s") != Outcome.CORRECT


def test_what_overflows_on_the_way_has_no_value() -> None:
    """1/(2 · 10³⁰⁸) is a number, but not one that is computed with floats; nor is it taken for zero."""
    assert boxed("1/(10^{307} + 10^{307})", 0.0, None) != Outcome.UNREADABLE
    assert boxed("1 + 1/(10^{308} + 10^{308})", 1.0, None) == Outcome.WRONG

"""Tests of units in the spellings of models."""

import math

import pytest

from sim2reason.grading.units import expand_siunitx, parse_answer_unit
from sim2reason.scenes.dsl.units import UnitError, parse_unit


@pytest.mark.parametrize(
    ("text", "same"),
    [
        ("newton-seconds", "N*s"),
        ("kg-m/s", "kg*m/s"),
        (r"\text{kg.m/s}", "kg*m/s"),
        ("Kg", "kg"),
        ("[m/s]", "m/s"),
        ("sec.", "s"),
        (r"\textbf{m/s}", "m/s"),
        (r"\mathsf{m/s^2}", "m/s^2"),
        (r"\text{m/s}^\text{2}", "m/s^2"),
        ("m/s2", "m/s^2"),
        ("kg m s-2", "N"),
        (r"\text{kg}\bullet\text{m/s}", "kg*m/s"),
        ("newton(s)", "N"),
        (r"M_\odot", "Msun"),
        (r"\mathrm{M_{sun}}", "Msun"),
        (r"M_{\text{sun}}", "Msun"),
        (r"\text{M}_{\odot}", "Msun"),
        (r"\text{solar masses}", "Msun"),
        (r"\mathrm{M_{sun}\,au^2/yr^2}", "Msun*au^2/yr^2"),
    ],
)
def test_spellings(text: str, same: str) -> None:
    asked = parse_unit(same)
    found = parse_answer_unit(text, asked)
    assert (found.factor, found.dimension) == (pytest.approx(asked.factor), asked.dimension)


@pytest.mark.parametrize(
    ("text", "asked", "factor"),
    [
        ("ms^{-1}", "m/s", 1.0),
        ("ms^{-1}", "1/s", 1000.0),
        ("ms^{-2}", "m/s^2", 1.0),
        ("ms", "s", 1e-3),
        (r"kg\,ms^{-1}", "kg*m/s", 1.0),
        ("rpm", "rad/s", math.tau / 60),
        ("rev/s", "rad/s", math.tau),
        ("revolutions per minute", "rad/s", math.tau / 60),
    ],
)
def test_the_asked_dimension_decides(text: str, asked: str, factor: float) -> None:
    unit = parse_unit(asked)
    assert parse_answer_unit(text, unit).factor_to(unit) == pytest.approx(factor)


TURNED = [
    *["rev^2", "rpm^2", r"\text{rpm}^2", r"\text{rev}^2/\text{s}^2", "rev²", "(rev/s)^2", "rev^{-1}", "m rev^{-1}"],
    *[r"\mathrm{rev}^{2}", "rpm squared", "turns**2", r"\frac{m}{rev}", "J/(kg rpm)"],
]


@pytest.mark.parametrize(
    "text", ["furlong", "m 1", "1 m", "m/rev", "rev rev", *TURNED, "", "m..s", "kg--m", "°C", "apples"]
)
def test_what_is_no_unit(text: str) -> None:
    with pytest.raises(UnitError):
        parse_answer_unit(text or "?", None)


@pytest.mark.parametrize(
    ("macros", "same"),
    [
        (r"\meter\per\second\squared", "m/s^2"),
        (r"\metre\per\square\second", "m/s^2"),
        (r"\kilo\gram\meter\per\second", "kg*m/s"),
        (r"\kilogram\metre\squared\per\second\squared", "J"),
        (r"\m\tothe{3}", "m^3"),
        (r"\newton\metre", "J"),
        ("kg.m/s", "kg*m/s"),
        (r"\radian\per\second", "rad/s"),
    ],
)
def test_macros(macros: str, same: str) -> None:
    found, asked = parse_answer_unit(expand_siunitx(rf"\unit{{{macros}}}"), None), parse_unit(same)
    assert (found.factor, found.dimension) == (pytest.approx(asked.factor), asked.dimension)

"""Tests of siunitx macros: every prefix, power and division belongs to one unit; others are refused."""

import pytest

from sim2reason.grading import Outcome, number
from sim2reason.scenes.dsl.units import parse_unit


@pytest.mark.parametrize(
    ("unit", "same"),
    [
        (r"m\per s^2", "m/s^2"),
        (r"\metre\per\second^2", "m/s^2"),
        (r"\metre\per\second^{2}", "m/s^2"),
        (r"\m/\s^2", "m/s^2"),
        (r"m.s^{-2}", "m/s^2"),
        ("m s-2", "m/s^2"),
        (r"m\,s^{-2}", "m/s^2"),
        (r"J/(kg.K)", "J/(kg*K)"),
        (r"J/(kg\cdot K)", "J/(kg*K)"),
        ("N~m", "N*m"),
        ("1/s", "1/s"),
        (r"\kilo N", "kN"),
        (r"\kilo m", "km"),
        (r"\centi m \per s^2", "cm/s^2"),
        (r"\milli g", "mg"),
        (r"\micro\metre", "um"),
        (r"N\per m", "N/m"),
        (r"N\per\square m", "N/m^2"),
        (r"\square m", "m^2"),
        (r"\cubic\centi m", "cm^3"),
        (r"\per m", "1/m"),
        (r"m\per s\squared", "m/s^2"),
        (r"\raiseto{3}\metre", "m^3"),
        (r"m²", "m^2"),
        (r"\%", "%"),
    ],
)
def test_units_of_macros_and_letters(unit: str, same: str) -> None:
    asked = parse_unit(same)
    score = number(rf"\boxed{{\SI{{5}}{{{unit}}}}}", 5.0, same)
    assert score.reward, score.why
    wrong = "kg" if asked.dimension != parse_unit("kg").dimension else "m"
    assert number(rf"\boxed{{\SI{{5}}{{{unit}}}}}", 5.0, wrong).outcome == Outcome.WRONG_UNIT


@pytest.mark.parametrize(
    "unit",
    [
        r"m\per",
        r"\meter\kilo",
        r"\meter\square",
        r"\squared\meter",
        r"\meter{2}",
        r"\kilo{2}\meter",
        r"\tothe{2}\meter",
        r"\raiseto\meter",
        r"\meter\tothe",
        r"\meter\per\squared",
        r"\kilo\mega\meter",
        r"\kilo\square\meter",
        r"\per\per\meter",
        r"\square\cubic\meter",
        r"\square m^2",
        r"m^2\squared",
        r"\per/\meter",
        r"\kilo/\meter",
        r"\centi d",
        r"\milli in",
        r"\meter\\\second",
        r"^2",
        "m^",
        "m{2}",
    ],
)
def test_what_belongs_to_no_unit_is_unreadable(unit: str) -> None:
    for asked in ("m", "m^2", "1/m", "m*s", None):
        assert number(rf"\boxed{{\SI{{5}}{{{unit}}}}}", 5.0, asked).outcome == Outcome.UNREADABLE

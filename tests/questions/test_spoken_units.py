"""Tests that texts in other units state the same numbers exactly, and are read back."""

from decimal import Decimal

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim2reason.errors import UnknownNameError
from sim2reason.questions.spoken_units import CGS, MIXED, SI, SYSTEMS, SpokenUnits, in_si, spoken_in, system_named
from sim2reason.scenes.dsl.units import parse_unit

TEXT = (
    "Block A (2.6 kg) is 0.080 m above B and moves at −2.3 m/s; k = 120 N/m, b = 0.30 N·s/m, F = 5.2 N, g = 9.8 m/s². "
    "After 1.2 s, at 30°, with 3.0 rad/s, I = 0.12 kg·m² and E = 4.1 J, it is 2.0 m away."
)


def test_centimetre_gram_second() -> None:
    """The factors are 1 N = 10⁵ dyn, 1 J = 10⁷ erg, 1 N/m = 10³ dyn/cm, 1 kg m² = 10⁷ g cm².

    Source: NIST SP 811, appendix B.8.
    """
    assert spoken_in(CGS, TEXT) == (
        "Block A (2600 g) is 8.0 cm above B and moves at −230 cm/s; k = 1.20×10⁵ dyn/cm, b = 300 dyn·s/cm, "
        "F = 5.2×10⁵ dyn, g = 980 cm/s². After 1.2 s, at 30°, with 3.0 rad/s, I = 1.2×10⁶ g·cm² and E = 4.1×10⁷ erg, "
        "it is 200 cm away."
    )


def test_only_lengths_masses_and_speeds_are_mixed_in() -> None:
    """The speed is converted as 2.3 m/s · 3600 s/h / (1000 m/km) = 8.28 km/h."""
    said = spoken_in(MIXED, TEXT)
    assert "A (2600 g) is 8.0 cm above B and moves at −8.28 km/h; k = 120 N/m" in said
    assert "g = 9.8 m/s²" in said
    assert "it is 200 cm away" in said


def test_prefixes_are_those_of_no_other_system() -> None:
    """The factors are 1 km/s = 10⁵ cm/s and 1 mN s/m = 10⁻³ · 10⁵ dyn/(10² cm/s) = 1 dyn s/cm."""
    text = "gas at 0.97 km/s and 23 kg/s, R = 1500 km, b = 0.0085 mN·s/m"
    said = "gas at 97000 cm/s and 23000 g/s, R = 1.500×10⁸ cm, b = 0.0085 dyn·s/cm"
    assert spoken_in(CGS, text) == said
    assert in_si(said)[1] == "gas at 970 m/s and 23 kg/s, R = 1500 km, b = 0.0000085 N·s/m"


ROCKET = "A rocket of 1170 kg, in a hall of 12 m, burns 23 kg/s at 0.97 km/s; how fast is it at the end?"


@pytest.mark.parametrize(
    ("text", "asked", "said"),
    [
        (ROCKET, (4.0, "m/s"), ROCKET),
        ("A cart of 2.0 kg meets a wall 1.2 m away.", (3.0, "m"), "A cart of 2000 g meets a wall 120 cm away."),
        ("A cart of 2.0 kg falls 1.2 m.", (68000.0, "m"), "A cart of 2000 g falls 1.2 m."),
        ("| A | $m$ (kg) |\n| --- | --- |\n| B | 170 |", (1.0, "m"), "| A | $m$ (kg) |\n| --- | --- |\n| B | 170 |"),
    ],
)
def test_units_are_mixed_in_where_a_text_would(text: str, asked: tuple[float, str], said: str) -> None:
    """Texts have no 1.17×10⁶ g beside 23 kg/s, no km/h beside km/s, and no distance of 6.8×10⁶ cm."""
    assert spoken_in(MIXED.suited_to(text, asked), text) == said


def test_tables_have_their_units_in_the_headings() -> None:
    table = "| ball | $m$ (kg) | $v$ (m/s) | $\\mu$ |\n| --- | --- | --- | --- |\n| A | 1.2 | −0.50 | 0.30 |\n\nMore."
    assert spoken_in(CGS, table) == table.replace("kg", "g").replace("1.2", "1200").replace("−0.50", "−50").replace(
        "m/s", "cm/s"
    )
    assert in_si(spoken_in(MIXED, table))[1] == table


@pytest.mark.parametrize(
    "text", ["a field of 1.5 N/C over 3 collisions", "a bead of 2.1 g", "1.2 au/yr", "40 %", "3.5 T"]
)
def test_what_no_system_says_otherwise_stays(text: str) -> None:
    assert spoken_in(CGS, text) == text
    assert spoken_in(SI, TEXT) == TEXT
    assert in_si(text)[0] == text


@pytest.mark.parametrize("system", [CGS, MIXED])
@pytest.mark.parametrize(
    "unit",
    ["m", "kg", "m/s", "N", "J", "N/m", "N s", "kg m/s", "N*s/m", "kg m^2", "m/s^2", "W", "N m", "km/s", "mN s/m"],
)
def test_factors_are_those_of_the_table_of_units(system: SpokenUnits, unit: str) -> None:
    """The grader, which has its own table of units, must find the same amount."""
    other, factor = system.spelled(unit)
    assert parse_unit(unit).factor_to(parse_unit(other)) == pytest.approx(float(factor), rel=1e-14)


@given(
    st.sampled_from([CGS, MIXED]), st.integers(10, 999), st.integers(-4, 2), st.sampled_from(["m", "kg", "m/s", "N"])
)
def test_a_number_comes_back_to_the_last_digit(system: SpokenUnits, digits: int, power: int, unit: str) -> None:
    said = f"{Decimal(digits).scaleb(power):f} {unit}"
    told = f"It is {spoken_in(system, said)}."
    itself, restored = in_si(told)[0], in_si(told)[:2][-1]  # only itself where the system says it as the SI does
    assert itself == told
    number, _, of = restored.removeprefix("It is ").removesuffix(".").partition(" ")
    assert of in (unit, "km")
    assert Decimal(number) * (1000 if of == "km" else 1) == Decimal(digits).scaleb(power)


def test_grams_are_tried_before_the_units_of_small_particles() -> None:
    """Grams in a cgs text are read as grams, then as kilograms, and only then as milligrams."""
    assert in_si("A bead of 0.10 g is 2.0 cm away.") == (
        "A bead of 0.10 g is 2.0 cm away.",
        "A bead of 0.00010 kg is 0.020 m away.",
        "A bead of 0.10 g is 0.020 m away.",
        "A bead of 100 mg is 0.020 m away.",
    )


def test_an_unknown_system_is_told_with_those_there_are() -> None:
    assert [system_named(name) for name in SYSTEMS] == [SI, CGS, MIXED]
    with pytest.raises(UnknownNameError, match="there are: SI, cgs, mixed"):
        system_named("fps")

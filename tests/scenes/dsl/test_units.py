"""Tests of the table of units: spelling, dimension, display."""

import pytest

from sim2reason.scenes.dsl import unit_text, units
from sim2reason.scenes.dsl.units import UnitError, parse_unit


@pytest.mark.parametrize(
    ("text", "name", "display"),
    [
        ("", "", ""),
        ("m/s^2", "m/s^2", "m/s²"),
        ("m s^{-2}", "m/s^2", "m/s²"),
        ("m/s/s", "m/s^2", "m/s²"),
        (r"\text{m}/\text{s}^2", "m/s^2", "m/s²"),
        (r"\frac{\text{m}}{\text{s}^2}", "m/s^2", "m/s²"),
        (r"\mathrm{N\,m}", "N*m", "N·m"),
        ("Nm", "N*m", "N·m"),
        (r"{\rm m\,s}^{-2}", "m/s^2", "m/s²"),
        (r"\frac{\frac{m}{s}}{s}", "m/s^2", "m/s²"),
        ("kgm^2", "kg*m^2", "kg·m²"),
        ("Nm^{-1}", "N/m", "N/m"),
        ("kg·m²", "kg*m^2", "kg·m²"),
        ("kg*m/s", "kg*m/s", "kg·m/s"),
        ("J/(kg K)", "J/(kg*K)", "J/(kg·K)"),
        ("s⁻¹", "1/s", "1/s"),
        ("rad/s", "rad/s", "rad/s"),
        ("deg", "deg", "°"),
        (r"^{\circ}", "deg", "°"),
        (r"\%", "%", "%"),
        (r"\mu\mathrm{m}", "um", "µm"),
        (r"\Omega", "ohm", "ohm"),
        ("metres per second squared", "m/s^2", "m/s²"),
        ("Newtons", "N", "N"),
        (r"\left(\text{m/s}\right)^2", "m^2/s^2", "m²/s²"),
    ],
)
def test_spellings(text: str, name: str, display: str) -> None:
    unit = parse_unit(text)
    assert (unit.name, unit.display) == (name, display)
    assert parse_unit(unit.name) == unit, "a canonical name names itself"
    assert parse_unit(unit.display).factor == unit.factor, "what is shown can be read"


@pytest.mark.parametrize(
    "text",
    [
        "J/kg K",
        "1/Nm",
        "m/s·kg",
        "m2",
        "furlong",
        "x",
        "°C",
        r"^\circ\mathrm{C}",
        "m^2^3",
        "m^99",
        "1",
        "2 m",
        "m/",
        "()",
        "(m",
        "m)",
        "/",
        "mm" * 200,
        "(" * 40 + "m" + ")" * 40,
        "MIN",
        "Metres" * 2,
        "KG",
        "m_1",
        "m'",
        "м",
    ],
)
def test_what_is_no_unit(text: str) -> None:
    with pytest.raises(UnitError):
        parse_unit(text)


@pytest.mark.parametrize(
    ("stated", "asked", "factor"),
    [
        ("km/h", "m/s", 1 / 3.6),
        ("g", "kg", 1e-3),
        ("eV", "J", 1.602176634e-19),
        ("au", "m", 1.495978707e11),
        ("yr", "d", 365.25),
        ("L", "m^3", 1e-3),
        ("N*m", "J", 1),
        ("deg", "rad", 0.017453292519943295),
        ("1/s", "rad/s", 1),
        ("1/s", "Hz", 1),
        ("%", "", 0.01),
        ("Hz", "rad/s", None),
        ("rad/s", "Hz", None),
        ("rad", "", None),
        ("", "rad", None),
        ("m", "s", None),
        ("min", "m", None),
    ],
)
def test_conversions(stated: str, asked: str, factor: float | None) -> None:
    found = parse_unit(stated).factor_to(parse_unit(asked))
    assert found == (None if factor is None else pytest.approx(factor, rel=1e-12))


def test_quantities_as_printed() -> None:
    assert parse_unit("m/s^2").quantity("9.8") == "9.8 m/s²"
    assert parse_unit("deg").quantity("30") == "30°"
    assert parse_unit("").quantity("0.4") == "0.4"


def test_no_two_units_share_a_symbol() -> None:
    symbols = [prefix + symbol for symbol, *_ in units._PREFIXED for prefix in units._PREFIXES]
    symbols += [symbol for symbol, *_ in units._PLAIN]
    assert len(symbols) == len(set(symbols))


def test_no_unit_looks_like_two_run_together() -> None:
    assert not [word for word in units._WORDS if unit_text._RUN_TOGETHER.fullmatch(word)]

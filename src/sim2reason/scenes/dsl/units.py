"""The table of units: reading of usual spellings, checks of dimensions, and canonical display.

Angles and cycles are dimensionless in the SI, yet confusing rad/s with Hz costs a factor 2π, so both are
counted here beside the seven base dimensions; `Unit.factor_to` defines when they may be ignored.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal
from functools import lru_cache
from math import isfinite, pi
from typing import Final, NamedTuple

from sim2reason.scenes.dsl.unit_text import UnitError, factors

__all__ = [
    "ASTRONOMICAL",
    "MINUTE",
    "SI",
    "SYSTEMS",
    "Dimension",
    "Unit",
    "UnitError",
    "UnitSystem",
    "combined",
    "parse_unit",
    "to_coherent_unit",
]


class Dimension(NamedTuple):
    """Exponents of the seven SI base dimensions, and of the plane angle and the cycle."""

    length: int = 0
    mass: int = 0
    time: int = 0
    current: int = 0
    temperature: int = 0
    amount: int = 0
    luminosity: int = 0
    angle: int = 0
    cycle: int = 0

    @property
    def base(self) -> tuple[int, ...]:
        """Return the seven exponents of the SI base dimensions."""
        return tuple(self)[:7]


@dataclass(frozen=True, slots=True)
class Unit:
    """A unit: its canonical ASCII name, its size in SI base units and its dimension."""

    name: str
    factor: float
    dimension: Dimension

    @property
    def display(self) -> str:
        """Return the name as printed: ``m/s^2`` is shown as ``m/s²``, ``deg`` as ``°``."""
        text = re.sub(r"\^(-?\d)", lambda power: power[1].translate(_RAISED), self.name)
        text = re.sub(r"\bdeg\b", "°", text.replace("*", "·"))
        return re.sub(r"\bu(?=[A-Za-z])", "µ", text)

    def quantity(self, number: str) -> str:
        """Return a formatted number with this unit: ``9.8 m/s²``, ``30°``, ``50 %``, ``0.4``."""
        return f"{number}{'' if self.name == 'deg' else ' '}{self.display}".rstrip()

    def factor_to(self, asked: Unit) -> float | None:
        """Return the conversion factor from this unit to `asked`; None if they are incompatible.

        s⁻¹ is compatible with rad/s and with Hz; Hz and rad/s differ by 2π and are incompatible, as is an angle with
        a pure number.
        """
        mine, other = self.dimension, asked.dimension
        plain = mine.angle == mine.cycle == 0
        same_cycle = mine.cycle == other.cycle or plain
        same_angle = mine.angle == other.angle or any(mine.base)
        return self.factor / asked.factor if mine.base == other.base and same_cycle and same_angle else None


_RAISED: Final = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")

_PREFIXES: Final = {
    "": ("", 1.0),
    "Q": ("quetta", 1e30), "R": ("ronna", 1e27), "Y": ("yotta", 1e24), "Z": ("zetta", 1e21), "E": ("exa", 1e18),
    "P": ("peta", 1e15), "T": ("tera", 1e12), "G": ("giga", 1e9), "M": ("mega", 1e6), "k": ("kilo", 1e3),
    "h": ("hecto", 1e2), "da": ("deca", 1e1), "d": ("deci", 1e-1), "c": ("centi", 1e-2), "m": ("milli", 1e-3),
    "u": ("micro", 1e-6), "n": ("nano", 1e-9), "p": ("pico", 1e-12), "f": ("femto", 1e-15), "a": ("atto", 1e-18),
    "z": ("zepto", 1e-21), "y": ("yocto", 1e-24), "r": ("ronto", 1e-27), "q": ("quecto", 1e-30),
}  # fmt: skip

_Entry = tuple[str, str, float, Dimension]
D = Dimension

# symbol, names and further spellings, size in SI base units, dimension
_PREFIXED: Final[tuple[_Entry, ...]] = (
    ("m", "metre meter", 1.0, D(length=1)),
    ("g", "gram gramme", 1e-3, D(mass=1)),
    ("s", "second sec", 1.0, D(time=1)),
    ("A", "ampere amp", 1.0, D(current=1)),
    ("K", "kelvin", 1.0, D(temperature=1)),
    ("mol", "mole", 1.0, D(amount=1)),
    ("cd", "candela", 1.0, D(luminosity=1)),
    ("rad", "radian", 1.0, D(angle=1)),
    ("sr", "steradian", 1.0, D(angle=2)),
    ("Hz", "hertz", 1.0, D(time=-1, cycle=1)),
    ("N", "newton", 1.0, D(length=1, mass=1, time=-2)),
    ("Pa", "pascal", 1.0, D(length=-1, mass=1, time=-2)),
    ("J", "joule", 1.0, D(length=2, mass=1, time=-2)),
    ("W", "watt", 1.0, D(length=2, mass=1, time=-3)),
    ("C", "coulomb", 1.0, D(time=1, current=1)),
    ("V", "volt", 1.0, D(length=2, mass=1, time=-3, current=-1)),
    ("F", "farad", 1.0, D(length=-2, mass=-1, time=4, current=2)),
    ("ohm", "ohm", 1.0, D(length=2, mass=1, time=-3, current=-2)),
    ("S", "siemens", 1.0, D(length=-2, mass=-1, time=3, current=2)),
    ("Wb", "weber", 1.0, D(length=2, mass=1, time=-2, current=-1)),
    ("T", "tesla", 1.0, D(mass=1, time=-2, current=-1)),
    ("H", "henry", 1.0, D(length=2, mass=1, time=-2, current=-2)),
    ("lm", "lumen", 1.0, D(luminosity=1, angle=2)),
    ("lx", "lux", 1.0, D(length=-2, luminosity=1, angle=2)),
    ("Bq", "becquerel", 1.0, D(time=-1, cycle=1)),
    ("Gy", "gray", 1.0, D(length=2, time=-2)),
    ("Sv", "sievert", 1.0, D(length=2, time=-2)),
    ("kat", "katal", 1.0, D(amount=1, time=-1)),
    ("eV", "electronvolt", 1.602176634e-19, D(length=2, mass=1, time=-2)),
    ("L", "l litre liter", 1e-3, D(length=3)),
)
_PLAIN: Final[tuple[_Entry, ...]] = (
    ("%", "percent", 0.01, D()),
    ("deg", "° degree", pi / 180, D(angle=1)),
    ("min", "minute", 60.0, D(time=1)),
    ("h", "hour hr", 3600.0, D(time=1)),
    ("d", "day", 86400.0, D(time=1)),
    ("yr", "year", 365.25 * 86400.0, D(time=1)),
    ("dyn", "dyne", 1e-5, D(length=1, mass=1, time=-2)),
    ("erg", "erg", 1e-7, D(length=2, mass=1, time=-2)),
    ("au", "AU", 1.495978707e11, D(length=1)),
    ("Msun", "solar_mass", 1.98841e30, D(mass=1)),
)
del D


def _words() -> dict[str, Unit]:
    """Return every symbol and name of the table, with prefixes and plurals, and names in lower and upper case."""
    table: dict[str, Unit] = {}
    for entries, prefixes in ((_PREFIXED, _PREFIXES), (_PLAIN, {"": ("", 1.0)})):
        for symbol, names, size, dimension in entries:
            for prefix, (prefix_name, scale) in prefixes.items():
                unit = Unit(prefix + symbol, size * scale, dimension)
                table[unit.name] = unit
                for name in names.split():
                    short = len(name) == 1 or name == "AU"
                    forms = [prefix + name] if short else [f"{prefix_name}{name}", f"{prefix_name}{name}s"]
                    table.update(dict.fromkeys(forms, unit))
                    table.update({form.capitalize(): unit for form in forms if not short})
    return table


_WORDS: Final = _words()
_COHERENT: Final = {
    prefix + symbol: (symbol, Decimal(repr(scale))) if symbol != "g" else ("kg", Decimal(repr(scale)) / 1000)
    for symbol, _, size, _ in _PREFIXED
    for prefix, (_, scale) in _PREFIXES.items()
    if size == 1.0 or symbol == "g"
}
"""SI units with their prefixes: the same without prefix, and the exact factor; for masses relative to the kilogram."""


def _name(powers: dict[str, int]) -> str:
    def spell(items: list[tuple[str, int]]) -> str:
        return "*".join(word if power == 1 else f"{word}^{power}" for word, power in items)

    above = [(word, power) for word, power in powers.items() if power > 0]
    below = [(word, -power) for word, power in powers.items() if power < 0]
    divisor = spell(below) if len(below) < 2 else f"({spell(below)})"
    return f"{spell(above) or '1'}/{divisor}" if below else spell(above)


@lru_cache(maxsize=1024)
def parse_unit(text: str) -> Unit:
    """Read a unit in LaTeX or plain spelling; the empty text is the pure number.

    Raises `UnitError` for anything outside the table, and for ``a/b c``, which people read in two ways.
    """
    return combined(text, {})


def combined(text: str, further: Mapping[str, Unit]) -> Unit:
    """Return the unit in a text, by this table and `further` units; raise UnitError if unknown or out of range."""
    powers: dict[str, int] = {}
    factor, dimension = 1.0, Dimension()
    for word, power in factors(text):
        unit = _WORDS.get(word) or further.get(word)
        if unit is None:
            raise UnitError(f"{word!r} is not in the table of units")
        powers[unit.name] = powers.get(unit.name, 0) + power
        factor *= unit.factor**power
        dimension = Dimension(*(a + power * b for a, b in zip(dimension, unit.dimension, strict=True)))
    if not isfinite(factor) or factor == 0:
        raise UnitError("a unit beyond the range of floats")
    return Unit(_name(powers), factor, dimension)


@lru_cache(maxsize=1024)
def to_coherent_unit(text: str) -> tuple[str, Decimal]:
    """Return a unit without prefixes and the exact factor: ``km/s`` is 1000 ``m/s``, ``g`` is 0.001 ``kg``."""
    size, bare = Decimal(1), list[str]()
    for word, power in factors(parse_unit(text).name):
        plain, scale = _COHERENT.get(word, (word, Decimal(1)))
        size *= scale**power
        bare.append(f"{plain}^{power}")
    return parse_unit(" ".join(bare)).name, size


@dataclass(frozen=True, slots=True)
class UnitSystem:
    """A coherent system of units of a mechanism and its text.

    `derived` are its names for units of the SI other than metre, kilogram and second, such as ``uN`` for ``N``; without
    any, derived units are spelled as products of the base units.
    """

    name: str
    length: str = "m"
    mass: str = "kg"
    time: str = "s"
    derived: tuple[tuple[str, str], ...] = ()

    @property
    def own(self) -> frozenset[str]:
        """Return the units of this system that are not SI units."""
        return frozenset({self.length, self.mass, self.time, *(name for _, name in self.derived)} - {"m", "kg", "s"})

    def spell(self, unit: str) -> str:
        """Return the unit of this system for the quantity that has `unit` in the SI: ``J`` becomes ``Msun*au^2/yr^2``.

        Units of electric and magnetic fields stay as they are.
        """
        if self.name == SI.name:
            return unit
        d = parse_unit(unit).dimension
        if not (d.length or d.mass or d.time) or d.current:
            return unit
        if self.derived:
            words = {"kg": self.mass, "m": self.length, "s": self.time, **dict(self.derived)}
            return _name({words.get(word, word): power for word, power in factors(parse_unit(unit).name)})
        powers = ((self.mass, d.mass), (self.length, d.length), (self.time, d.time), ("rad", d.angle))
        return _name({word: n for word, n in powers if n})


SI: Final = UnitSystem("SI")
ASTRONOMICAL: Final = UnitSystem("astronomical", "au", "Msun", "yr")
MINUTE: Final = UnitSystem(
    "milligrams and microcoulombs", mass="mg", derived=(("N", "uN"), ("J", "uJ"), ("W", "uW"), ("C", "uC"))
)
"""What suits small charged particles: a charge of 1 uC in 1 N/C feels 1 uN, which accelerates 1 mg by 1 m/s^2."""
SYSTEMS: Final = (SI, ASTRONOMICAL, MINUTE)

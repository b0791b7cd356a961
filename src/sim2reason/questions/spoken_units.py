"""Systems of units in texts: conversion of texts from SI units and back.

Only the text changes. Factors are exact decimals, so that what is said stays what is simulated, to the last digit.
"""

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field, replace
from decimal import Decimal
from functools import cache, lru_cache

from sim2reason.errors import UnknownNameError
from sim2reason.questions.words import KILO, LONG, METRE
from sim2reason.scenes.dsl.measures import show_unit
from sim2reason.scenes.dsl.unit_text import factors
from sim2reason.scenes.dsl.units import MINUTE, UnitError, parse_unit, to_coherent_unit

MINUS = "\N{MINUS SIGN}"
SCIENTIFIC_EXPONENT = 5  # power of ten from which numbers are in scientific notation: 2.6×10⁵
SIGNIFICANT_DIGITS = 12  # significant digits of a converted number
_RAISED, _LOWERED = "⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789"
_DECIMAL = rf"{MINUS}?\d+(?:\.\d+)?(?:×10[{_RAISED}]+)?"
_PRODUCT = "[A-Za-zµΩ²³⁴·]+"
_SAID = re.compile(rf"(?<![\w.,])({_DECIMAL}) ({_PRODUCT}(?:/{_PRODUCT}|/\({_PRODUCT}\))?)(?![\w·/])")
_HEADING = re.compile(r" \(([^()\s]+)\)$")


@dataclass(frozen=True, eq=False)
class SpokenUnits:
    """A system of units for texts: replacements of SI units, each with the size of the SI unit in the replacement.

    `whole` are units as they stand, such as m/s; `words` stand for m, kg, N and J wherever they occur in a unit, with
    prefixes, too.
    """

    name: str
    words: Mapping[str, tuple[str, Decimal]] = field(default_factory=dict[str, tuple[str, Decimal]])
    whole: Mapping[str, tuple[str, Decimal]] = field(default_factory=dict[str, tuple[str, Decimal]])

    @property
    def says_otherwise(self) -> bool:
        """Return whether the system differs from the SI."""
        return bool(self.words or self.whole)

    def spelled(self, unit: str) -> tuple[str, Decimal]:
        """Return the system's unit in place of an SI unit, and the size of the SI unit in the system's unit.

        Electrical units stay as they are, since of those each system has several, and so do those of astronomy.
        """
        parsed = parse_unit(unit)
        if parsed.name in self.whole:
            return self.whole[parsed.name]
        words = {word: self._said_for(word) for word, _ in factors(parsed.name)}
        if parsed.dimension.current or any(other is None and _is_mechanical(word) for word, other in words.items()):
            return unit, Decimal(1)
        name, factor = list[str](), Decimal(1)
        for word, power in factors(parsed.name):
            other, size = words[word] or (word, Decimal(1))
            name.append(f"{other}^{power}")
            factor *= size**power
        spelled = parse_unit(" ".join(name)).name
        return (spelled if spelled != parsed.name else unit), factor

    def _said_for(self, word: str) -> tuple[str, Decimal] | None:
        """Return the replacement of a single unit, which may have a prefix, and its factor; None if there is none."""
        if word in self.words:
            return self.words[word]
        bare, scale = to_coherent_unit(word)
        other = self.words.get(bare)
        return (other[0], other[1] * scale) if other is not None else None

    def suited_to(self, text: str, *more: tuple[float, str]) -> "SpokenUnits":
        """Return the part of the system whose units suit the numbers of a text in SI units and `more` numbers.

        A `whole` unit stays, and all that have its metres or kilograms do, where a number in another would need a power
        of ten, or the text has a second unit for the like of it, as m/s beside km/s.
        """
        if not self.whole:
            return self
        numbers = [*_numbers_in(text), *more]
        odd = (unit for unit, other in self.whole.items() if _is_odd(unit, other, numbers))
        stay = {word for unit in odd for word in _mechanical(unit)}
        return replace(self, whole={unit: other for unit, other in self.whole.items() if not stay & _mechanical(unit)})


def _is_odd(unit: str, other: tuple[str, Decimal], numbers: Iterable[tuple[float, str]]) -> bool:
    """Return whether the other unit is unusual for the text's numbers of this kind."""
    name, factor = other
    alike = [
        (number, number_unit)
        for number, number_unit in numbers
        if parse_unit(number_unit).dimension == parse_unit(unit).dimension
    ]
    if any(parse_unit(number_unit).name not in (unit, name) for _, number_unit in alike):
        return True
    return any(
        abs(number) * float(factor) >= 10.0**SCIENTIFIC_EXPONENT
        for number, number_unit in alike
        if parse_unit(number_unit).name == unit
    )


def _mechanical(unit: str) -> set[str]:
    """Return the units of length and mass, and those derived from them, within a compound unit."""
    return {word for word, _ in factors(unit) if _is_mechanical(word)}


def _is_mechanical(word: str) -> bool:
    """Return whether a unit's dimension involves length or mass."""
    dimension = parse_unit(word).dimension
    return bool(dimension.length or dimension.mass)


SI = SpokenUnits("SI")
CGS = SpokenUnits(
    "cgs",
    words={
        "m": ("cm", Decimal(100)),
        "kg": ("g", Decimal(1000)),
        "N": ("dyn", Decimal(10) ** 5),
        "J": ("erg", Decimal(10) ** 7),
    },
)
MIXED = SpokenUnits(
    "mixed", whole={"m": ("cm", Decimal(100)), "kg": ("g", Decimal(1000)), "m/s": ("km/h", Decimal("3.6"))}
)
_SMALL = SpokenUnits(
    MINUTE.name,
    words={
        "m": (MINUTE.length, Decimal(1)),
        **{word: (own, 1 / to_coherent_unit(own)[1]) for word, own in (("kg", MINUTE.mass), *MINUTE.derived)},
    },
)
SYSTEMS = {system.name: system for system in (SI, CGS, MIXED)}
"""All systems in which a text can speak: the SI; centimetre, gram and second; cm, g and km/h among units of the SI.

The last says them only where a text would: a rocket's mass stays in kilograms.
"""


def system_named(name: str) -> SpokenUnits:
    """Return a system of units by name; UnknownNameError, which lists all systems, for an unknown one."""
    if name not in tuple(SYSTEMS):  # which takes what is no key, too
        raise UnknownNameError(f"no such units: {name!r}; there are: {', '.join(SYSTEMS)}")
    return SYSTEMS[name]


def spoken_in(system: SpokenUnits, text: str) -> str:
    """Return a text with all its SI numbers converted to a system of units."""

    def said(number: str, unit: str) -> tuple[str, str] | None:
        other, factor = _spelled(system, unit)
        return (_written(_number(number) * factor.normalize()), other) if other != unit else None

    return text if not system.says_otherwise else _converted(text, said)


def in_si(text: str) -> tuple[str, ...]:
    """Return the possible readings of a text with its units converted to the SI, the most literal first.

    First comes the text itself, then with its units restored, then the same with its grams kept, since a text in the SI
    may say grams of what is light, and last with milligrams and what goes with them, as a text about a small charged
    particle has it. Long ways are told in kilometres, as questions tell them.
    """

    def said(number: str, unit: str) -> tuple[str, str] | None:
        other, factor = _restored(unit)
        value = _number(number) / factor
        if other == METRE and other != unit and value >= LONG:
            return _plain(value / Decimal(KILO)), "km"
        return (_plain(value), other) if other != unit else None

    def but_grams(number: str, unit: str) -> tuple[str, str] | None:
        return said(number, unit) if unit != "g" else None

    converted = _converted(text, said)
    small = [spoken_in(_SMALL, converted)] if converted != text else []
    return tuple(dict.fromkeys((text, converted, _converted(text, but_grams), *small)))


@lru_cache(maxsize=1024)
def _spelled(system: SpokenUnits, shown: str) -> tuple[str, Decimal]:
    """Return a system's unit for a printed SI unit, and the SI unit's size in that unit; other texts unchanged."""
    try:
        unit, factor = system.spelled(shown)
    except UnitError:
        return shown, Decimal(1)
    return (show_unit(unit), factor) if unit != shown else (shown, factor)


@cache
def _restored(shown: str) -> tuple[str, Decimal]:
    """Return the printed SI unit for a unit of another system, and the size of the SI unit in that unit."""
    try:
        name = parse_unit(shown).name
    except UnitError:
        return shown, Decimal(1)
    for system in SYSTEMS.values():
        for unit, (other, factor) in system.whole.items():
            if name == other:
                return show_unit(unit), factor
    backwards = {other: (word, 1 / size) for word, (other, size) in CGS.words.items()}
    unit, factor = SpokenUnits("back", backwards).spelled(name)
    return (show_unit(unit), 1 / factor) if unit != name else (shown, factor)


UnitConversion = Callable[[str, str], tuple[str, str] | None]
"""What a text says in place of a number with a unit; None if it stays."""


def _converted(text: str, convert: UnitConversion) -> str:
    lines = text.split("\n")
    for index, line in enumerate(lines):
        if not line.startswith("|"):
            lines[index] = _SAID.sub(lambda match: " ".join(convert(match[1], match[2]) or (match[1], match[2])), line)
    for begin, line in enumerate(lines):
        if line.startswith("|") and not (begin and lines[begin - 1].startswith("|")):
            rows = next((k for k in range(begin, len(lines)) if not lines[k].startswith("|")), len(lines))
            lines[begin:rows] = _table(lines[begin:rows], convert)
    return "\n".join(lines)


def _numbers_in(text: str) -> Iterator[tuple[float, str]]:
    """Yield all numbers in a text that have a unit, with their units."""
    numbers = list[tuple[str, str]]()

    def noted(number: str, unit: str) -> tuple[str, str]:
        numbers.append((number, unit))
        return number, unit

    _converted(text, noted)
    for number, unit in numbers:
        with suppress(UnitError):
            yield float(_number(number)), parse_unit(unit).name


def _table(rows: list[str], convert: UnitConversion) -> list[str]:
    """Return a Markdown table with converted numbers and the units in its headings."""
    cells = [row.strip("| ").split(" | ") for row in rows]
    for column, heading in enumerate(cells[0]):
        unit = _HEADING.search(heading)
        if unit is None or (other := convert("1", unit[1])) is None:
            continue
        cells[0][column] = f"{heading[: unit.start()]} ({other[1]})"
        for row in cells[2:]:
            if re.fullmatch(_DECIMAL, row[column]):
                row[column] = (convert(row[column], unit[1]) or (row[column],))[0]
    return [f"| {' | '.join(row)} |" for row in cells]


def _number(text: str) -> Decimal:
    mantissa, _, power = text.replace(MINUS, "-").partition("×10")
    return Decimal(mantissa).scaleb(int(power.translate(str.maketrans(_RAISED, _LOWERED)) or 0))


def _written(value: Decimal) -> str:
    """Return a number with all its digits, in scientific notation if large."""
    if value and value.adjusted() >= SCIENTIFIC_EXPONENT:
        power = str(value.adjusted()).translate(str.maketrans(_LOWERED, _RAISED))
        text = f"{value.scaleb(-value.adjusted()):f}×10{power}"
    else:
        text = f"{value:f}"
    return text.replace("-", MINUS)


def _plain(value: Decimal) -> str:
    """Return a number with at least two significant digits and no further trailing zeros."""
    value = (
        +value.quantize(Decimal(1).scaleb(value.adjusted() - SIGNIFICANT_DIGITS + 1)).normalize() if value else value
    )
    if value and len(value.as_tuple().digits) < 2:
        value = value.quantize(Decimal(1).scaleb(value.adjusted() - 1))
    return f"{value:f}".replace("-", MINUS)

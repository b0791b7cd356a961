"""Numbers with units in ordinary texts, replaced by placeholders and converted to SI units."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal
from functools import lru_cache
from math import isfinite

from sim2reason.scenes.dsl.units import Unit, UnitError, parse_unit

MINUS = "\N{MINUS SIGN}"
KINDS: Mapping[str, str] = {
    "mass": "kg",
    "length": "m",
    "speed": "m/s",
    "angle": "°",
    "accel": "m/s²",
    "stiffness": "N/m",
    "rate": "kg/s",
    "charge": "C",
    "field": "T",
    "time": "s",
    "force": "N",
}
PLAIN, INFINITE = "plain", "infinite"  # kinds of numbers without a unit, and of those too great for a float
SPELLED: Mapping[str, str] = {
    r"solar masse?s?": "Msun",
    r"astronomical units?": "au",
    r"(?:kilometers|kilometres) (?:per|an) hour|kph|kmph": "km/h",
    r"degrees?|deg": "°",
}
DIGITS = 12  # significant digits of a converted number
LEAST_PLAIN, MOST_PLAIN = 1e-6, 1e9  # smaller and greater numbers are written with powers of ten
MOST_WORDS = 5  # of a unit, as in "metres per second per second"
_NUMBER = re.compile(
    rf"(?<![\w.#])([-{MINUS}]?\d{{1,30}}(?:\.\d{{1,30}})?)(?:[eE]([-+{MINUS}]?\d{{1,3}})"
    rf"|\s?[x×*]\s?10\^?([-{MINUS}]?\d{{1,3}}|[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]{{1,4}}))?(?![\d.]\d|[A-Za-z]\d)"
)
_UNIT = re.compile(r"[ -]?([^\s,;()]{1,30}(?: [^\s,;()]{1,30}){0,4})")
_RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


@dataclass(frozen=True, slots=True)
class Amount:
    """A value of a physical quantity, such as a mass or a length, in the SI unit of that quantity."""

    kind: str
    digits: str

    @property
    def value(self) -> float:
        """Return the number in the SI unit of its kind."""
        return float(self.digits.replace(MINUS, "-").replace(" × 10^", "e"))

    def value_in(self, unit: str) -> float:
        """Return the number in another unit of its kind; in the SI unit if `unit` is empty."""
        factor = parse_unit(KINDS[self.kind]).factor_to(parse_unit(unit)) if unit else 1.0
        assert factor is not None
        return self.value * factor

    @property
    def text(self) -> str:
        """Return the number with its unit, as the library writes it."""
        unit = KINDS.get(self.kind, "")
        return f"{self.digits}{'' if unit == '°' else ' '}{unit}".rstrip()


def extract_amounts(text: str) -> tuple[str, tuple[Amount, ...]]:
    """Replace the numbers of a text by placeholders such as `#mass0#`; return the text and the numbers in order."""
    for pattern, short in SPELLED.items():
        text = re.sub(rf"(?<=[\s-])(?:{pattern})\b", short, text)
    found: list[Amount] = []
    parts: list[str] = []
    at = 0
    for number in _NUMBER.finditer(text):
        if number.start() < at:
            continue
        unit, after = _unit(text, number.end())
        amount = _amount(number, unit)
        parts += [text[at : number.start()], f" #{amount.kind}{len(found)}# "]
        found.append(amount)
        at = after
    return "".join((*parts, text[at:])), tuple(found)


def format_amount(value: float) -> str:
    """Format a number as in the library's texts, with at most twelve significant digits."""
    if value and not LEAST_PLAIN <= abs(value) < MOST_PLAIN:
        digits, power = f"{value:.{DIGITS - 1}e}".split("e")
        digits = digits.rstrip("0").rstrip(".")
        return f"{digits} × 10^{int(power)}".replace("-", MINUS)
    return f"{Decimal(f'{value:.{DIGITS}g}'):f}".replace("-", MINUS)


def _amount(number: re.Match[str], unit: str) -> Amount:
    power = (number[2] or number[3] or "0").replace(MINUS, "-").translate(_RAISED)
    digits = number[1].replace(MINUS, "-")
    kind, factor = _kind(unit) if unit else (PLAIN, 1.0)
    if factor == 1.0 and int(power) == 0:
        return Amount(kind, digits.replace("-", MINUS))
    value = float(f"{digits}e{int(power)}") * factor
    return Amount(kind, format_amount(value)) if isfinite(value) else Amount(INFINITE, "")


def _unit(text: str, at: int) -> tuple[str, int]:
    """Return the unit at an index of a text (may be empty), and the index after it."""
    ahead = _UNIT.match(text, at)
    words = ahead[1].split(" ") if ahead else []
    for count in range(min(len(words), MOST_WORDS), 0, -1):
        joined = " ".join(words[:count])
        if count > 1 and not re.search(r"/|\bper\b|⁻|\^-|[a-z]-\d", joined):
            continue  # no product of units with a word that follows by chance
        for unit in dict.fromkeys((joined.rstrip(".:"), joined.partition("-")[0])):
            if unit and _kind(unit)[0] != PLAIN and ahead is not None:
                return unit, ahead.start(1) + len(unit)
    return "", at


@lru_cache(maxsize=512)
def _kind(unit: str) -> tuple[str, float]:
    """Return the physical quantity of a unit, such as mass, and its factor to SI; `PLAIN` and 1 for other words."""
    found = _known(unit)
    for kind, usual in KINDS.items() if found is not None else ():
        factor = found.factor_to(parse_unit(usual)) if found is not None else None
        if factor is not None:
            return kind, float(f"{factor:.15g}")
    return PLAIN, 1.0


def _known(unit: str) -> Unit | None:
    try:
        return parse_unit(re.sub(r"(?<=[a-z])-(?=\d)", "^-", unit))
    except (UnitError, ArithmeticError):
        return None

"""Units as models write them: other spellings, imperial and outdated units, and siunitx commands.

Examples of spellings are ``newton-seconds``, ``kg.m/s``, ``Kg``, ``[m/s]``, ``m/s$^2$``, ``sec.`` and ``rev/min``;
``ms^{-1}`` is per millisecond or metres per second, according to the requested dimension.

Problems, scenes and exports never contain the imperial and outdated units. A pound is a mass, and a pound of force is
``lbf``; ``in`` is read as the preposition, so inches are spelled out.
"""

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Final

from sim2reason.grading.alphabet import SCRIPTS, SWITCHES, alternatives_pattern
from sim2reason.grading.score import Outcome, Refused
from sim2reason.scenes.dsl.units import Unit, UnitError, combined, parse_unit

__all__ = ["FURTHER", "expand_siunitx", "is_unit", "parse_answer_unit"]

_FURTHER_ENTRIES: Final = (  # symbol, further spellings, size, and the unit of our table that it is in
    ("ft", "foot feet", 0.3048, "m"),
    ("inch", "inches", 0.0254, "m"),
    ("yd", "yard yards", 0.9144, "m"),
    ("mi", "mile miles", 1609.344, "m"),
    ("mph", "MPH", 0.44704, "m/s"),
    ("fps", "", 0.3048, "m/s"),
    ("knot", "knots", 1852 / 3600, "m/s"),
    ("lb", "lbs lbm pound pounds", 0.45359237, "kg"),
    ("oz", "ounce ounces", 0.028349523125, "kg"),
    ("slug", "slugs", 14.59390293720636, "kg"),
    ("lbf", "", 4.4482216152605, "N"),
    ("psi", "", 6894.757293168361, "Pa"),
    ("bar", "bars", 1e5, "Pa"),
    ("atm", "atmosphere atmospheres", 101325.0, "Pa"),
    ("cal", "calorie calories", 4.184, "J"),
    ("kcal", "kilocalorie kilocalories", 4184.0, "J"),
    ("angstrom", "angstroms Angstrom", 1e-10, "m"),
    ("cycle", "cycles oscillation oscillations vibration vibrations", 1.0, "Hz*s"),
)
FURTHER: Final[dict[str, Unit]] = {
    word: Unit(symbol, size * parse_unit(unit).factor, parse_unit(unit).dimension)
    for symbol, names, size, unit in _FURTHER_ENTRIES
    for word in (symbol, *names.split())
}
"""Each by all words that spell it."""


_WRAPPERS: Final = rf"\\(?:{alternatives_pattern('open', '{')}|operatorname\*)\s*(?=\{{)"
_SUN: Final = r"(?:\\odot(?![A-Za-z])|\\(?:text|rm)\s*\{?\s*[sS]un\s*\}?|[sS]un)"
_REWRITTEN: Final = tuple(
    (re.compile(pattern), replacement)
    for pattern, replacement in (
        (_WRAPPERS, r"\\text"),
        (rf"(?:\\text\s*\{{\s*M\s*\}}|(?<![A-Za-z])M)\s*(?:_\s*)?(?:\{{\s*{_SUN}\s*\}}|{_SUN})(?![A-Za-z])", " Msun "),
        (r"(?<![A-Za-z])solar[\s~]+mass(?:es)?(?![A-Za-z])", "Msun"),
        (rf"\\(?:{'|'.join((*SWITCHES, 'middle'))})(?![A-Za-z])", " "),
        (r"(?:\^|\*\*)\s*(?:\{\s*)?\\(?:text|mathrm)\s*\{\s*([-−–+]?[0-9])\s*\}(?:\s*\})?", r"^{\1}"),
        (r"(?:\^|\*\*)\s*\(\s*([-−–+]?[0-9])\s*\)", r"^{\1}"),
        (rf"[•∙]|\\(?:{alternatives_pattern('times')})(?![A-Za-z])", "·"),
        (rf"\\(?:{alternatives_pattern('fraction')})(?![A-Za-z])", r"\\frac"),
        (r"\{([^{}]{1,40})\\over(?![A-Za-z])([^{}]{1,40})\}", r"\\frac{\1}{\2}"),
        (r"(?:\\left\s*|\\big[lr]?\s*)?\[", "("),
        (r"(?:\\right\s*|\\big[lr]?\s*)?\]", ")"),
        (r"(?<=[A-Za-z]{3})\(s\)", "s"),
        (r"(?<=[A-Za-z0-9}])\s?[-‐‑]\s?(?=[A-Za-z])", "·"),
        (r"(?<=[A-Za-z0-9}])\.\s?(?=[A-Za-z\\])", "·"),
        (r"[.\s]+\Z|\.(?=\s*\}*\s*\Z)", ""),
        (r"(?<=[A-Za-z])(-?[1-4])(?![0-9])", r"^{\1}"),
        (r"(?<![A-Za-z])K[gG]s?(?![A-Za-z])|(?<![A-Za-z])kgs(?![A-Za-z])", "kg"),
        (r"(?<![A-Za-z])(sec|min|hr)s?\.", r"\1"),
        (r"(?<![A-Za-z])(min|deg|rad|yr)s(?![A-Za-z])", r"\1"),
        (r"(?<![A-Za-z])K(?=(?:J|N|W|V|Pa|Hz|eV|m)(?![A-Za-z]))", "k"),
        (r"(?<![A-Za-z])kmph(?![A-Za-z])|(?<![A-Za-z])kph(?![A-Za-z])", "km/h"),
        (r"\A((?:[\s~({]|\\[ ,;:!]|\\text(?![A-Za-z]))*)in(?=[\s~\\]+[^\s~\\(){}])", r"\1 "),
    )
)
_STRAY: Final = re.compile(r"(?:^|[\s}·*])1(?!\s*[/}])")
_TURNS: Final = re.compile(r"(?<![A-Za-z\\])(?:rpm|RPM|rps|revs?|revolutions?|rotations?|turns?)(?![A-Za-z])")
_TURNING: Final = {"rpm": "rad/min", "RPM": "rad/min", "rps": "rad/s"}
_SPLIT: Final = re.compile(r"(?<![A-Za-z\\])(kg|k?N|k?J|g)?(m)?(s)(?![A-Za-z])|(?<![A-Za-z\\])(kg|g)(m)(?![A-Za-z])")


@lru_cache(maxsize=1024)
def parse_answer_unit(text: str, asked: Unit | None) -> Unit:
    """Return the unit that `text` denotes; if ambiguous, the one comparable with `asked`.

    Raises `UnitError` if it is not a unit.
    """
    if _STRAY.search(text):
        raise UnitError("a number stands among units")
    first: Unit | None = None
    problem = UnitError(f"{text.strip()!r} is no unit")
    for spelling in _spellings(text):
        try:
            unit = _read(spelling)
        except UnitError as error:
            problem = error
            continue
        first = first or unit
        if asked is None or not asked.name or unit.factor_to(asked) is not None:
            return unit
    if first is None:
        raise problem
    return first


def _spellings(text: str) -> Iterator[str]:
    """Yield spellings of a unit: unchanged, as in the unit table, and with adjacent metres and seconds separated."""
    yield text
    plain = text
    for pattern, replacement in _REWRITTEN:
        plain = pattern.sub(replacement, plain)
    if plain != text:
        yield plain
    separated = _SPLIT.sub(lambda run: " ".join(part for part in run.groups() if part), plain)
    if separated != plain:
        yield separated


def _read(text: str) -> Unit:
    """Return a unit of the table, or one with a turn (2π rad) to the first power."""
    turns = _TURNS.findall(text)
    if not turns:
        return combined(text, FURTHER)
    radian, degree = (parse_unit(_TURNS.sub(angle, text)).factor for angle in ("rad", "deg"))
    if len(turns) > 1 or not math.isclose(radian, degree * math.degrees(1)):
        raise UnitError(f"{turns[0]!r} must stand alone, above the line and without a power")
    unit = parse_unit(_TURNS.sub(lambda turn: _TURNING.get(turn[0], "rad"), text))
    return replace(unit, name=unit.name.replace("rad", "rev", 1), factor=unit.factor * math.tau)


def is_unit(text: str) -> bool:
    """Return whether `text` is a unit."""
    try:
        parse_answer_unit(text, None)
    except UnitError:
        return False
    return True


_ARGUMENT: Final = r"\s*\{((?:[^{}]|\{[^{}]*\}){0,200}+)\}"
_OPTIONS: Final = r"(?:\s*\[[^\[\]{}]{0,80}\])?"
_QUANTITY: Final = re.compile(rf"\\(?:SI|qty){_OPTIONS}{_ARGUMENT}{_ARGUMENT}")
_ONE: Final = re.compile(rf"\\(?P<name>si|unit|num|ang|pu){_OPTIONS}{_ARGUMENT}")
_CALLED: Final = re.compile(r"\\(?:SI|si|qty|num|unit|ang|pu)(?![A-Za-z])")
_NUMBER: Final = re.compile(r"\s*+[-−+]?+ ?[0-9.][0-9. ]*+(?:(?:[eE]|x ?10\^|\\times ?10\^)\{?[-−+]?[0-9]++\}?)?\s*+")
_MACRO: Final = re.compile(
    r"\\(?P<name>[A-Za-z]+)\s*(?:\{\s*(?P<argument>-?[0-9]+)\s*\})?|\\(?P<space>[ ,;:])"
    r"|\^\s*(?P<power>\{\s*[-−+]?[0-9]+\s*\}|[-−+]?[0-9]+)|(?P<word>[A-Za-zµΩ]+)(?P<raised>[-−]?[1-9](?![0-9])|⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]{1,2})?|(?P<sign>[^\\A-Za-zµΩ^]+|\\%|\^|\\)"
)
_NAMES: Final = "yocto zepto atto femto pico nano micro milli centi deci deca hecto kilo mega giga tera peta exa"
_LETTERS: Final = "y z a f p n u m c d da h k M G T P E"
_PREFIXES: Final[dict[str, str]] = dict(zip(_NAMES.split(), _LETTERS.split(), strict=True))
_RAISED_AFTER: Final = {"squared": "2", "cubed": "3"}
_RAISED_BEFORE: Final = {"square": "2", "cubic": "3"}
_CHEMICAL_POWER: Final = re.compile(r"(?<=[A-Za-z])\^?\{?([-−+]?[0-9]{1,2})\}?")
_LONG: Final = (
    "meter metre gram second newton joule watt pascal hertz radian coulomb volt kelvin ampere tesla liter mole"
)
_SHORT: Final = "m m g s N J W Pa Hz rad C V K A T L mol"
_SYMBOLS: Final = dict(zip(_LONG.split(), _SHORT.split(), strict=True)) | {"electronvolt": "eV", "litre": "L"}
_NAMED: Final = {"degree": "deg", "percent": "%", "degreeCelsius": "°C", "celsius": "°C", "astronomicalunit": "au"}


def expand_siunitx(content: str) -> str:
    """Return `content` with siunitx commands expanded; Refused (unreadable) for commas or uncertainties."""
    if _CALLED.search(content) is None:
        return content
    content = _QUANTITY.sub(lambda match: rf"{_number(match[1])}\ \text{{{_unit(match[2])}}}", content)
    return _ONE.sub(_alone, content)


def _alone(match: re.Match[str]) -> str:
    argument = match[2]
    match match["name"]:
        case "num":
            return _number(argument)
        case "ang":
            return f"{_number(argument)}°"
        case "pu":
            digits, unit = _split(argument)
            unit = _CHEMICAL_POWER.sub(r"^{\1}", unit).replace("//", "/")
            return rf"{_number(digits)}\ \text{{{unit}}}"
        case _:
            return rf"\text{{{_unit(argument)}}}"


def _number(text: str) -> str:
    if _NUMBER.fullmatch(text) is None:
        raise Refused(Outcome.UNREADABLE, f"{text[:40]!r} is not one plain number")
    return text.replace("x", r"\times")


def _split(text: str) -> tuple[str, str]:
    r"""Return the number and the unit of a ``\\pu`` command."""
    match = _NUMBER.match(text)
    return (text[: match.end()], text[match.end() :]) if match else (text, "")


def _unit(text: str) -> str:
    r"""Return a unit written in siunitx macros, letters or both; ``\\per`` applies only to the next factor."""
    unit = _Unit()
    for match in _MACRO.finditer(text):
        name, argument = match["name"] or "", match["argument"] or ""
        if match["power"]:
            unit.raise_last(match["power"].strip("{ }"))
        elif match["word"]:
            unit.add(match["word"])
            unit.raise_last((match["raised"] or "").translate(SCRIPTS).replace("−", "-"))
        elif match["sign"]:
            unit.separate(match["sign"])
        elif name in {"cdot", "times"} and not argument:
            unit.separate("·")
        elif name:
            unit.macro(name, argument)
    unit.refuse_pending("at the end of a unit")
    return " ".join(unit.factors)


@dataclass(slots=True)
class _Unit:
    """A unit under construction: the factors so far, and the prefix, power and division of the next one."""

    factors: list[str] = field(default_factory=list[str])
    prefix: str = ""
    power: str = ""
    divides: bool = False

    def macro(self, name: str, argument: str) -> None:
        takes = name in {"raiseto", "tothe"}
        if takes != bool(argument):
            raise _misplaced_error(rf"\{name}{{{argument}}}")
        if name in _RAISED_AFTER or name == "tothe":
            self.raise_last(_RAISED_AFTER.get(name, argument))
        elif name == "per" or name in _PREFIXES or name in _RAISED_BEFORE or takes:
            twice = self.divides if name == "per" else self.power if name not in _PREFIXES else ""
            if self.prefix or twice:
                raise _misplaced_error(rf"\{name}")
            self.divides = self.divides or name == "per"
            self.prefix = _PREFIXES.get(name, "")
            self.power = _RAISED_BEFORE.get(name, argument) or self.power
        else:
            word = _NAMED.get(name, name)
            self.add(_SYMBOLS.get(word, word) if self.prefix else word)

    def add(self, word: str) -> None:
        """Add a unit with its pending prefix, power and division."""
        symbol = _prefixed(self.prefix, word) if self.prefix else word
        self.factors.append(_powered(symbol + ("^{-1}" if self.divides else ""), self.power))
        self.prefix, self.power, self.divides = "", "", False

    def raise_last(self, power: str) -> None:
        self.refuse_pending("before a power")
        last = self.factors[-1] if self.factors else "?"
        if power and not (last[-1].isalpha() or last.endswith("^{-1}")):
            raise _misplaced_error(f"the power {power}")
        self.factors[-1] = _powered(last, power)

    def separate(self, sign: str) -> None:
        """Add a separator between two units, such as a dot or slash."""
        if "\\" in sign.replace(r"\%", ""):
            raise _misplaced_error("a backslash")
        if sign.strip():
            self.refuse_pending(f"before {sign.strip()!r}")
            self.factors.append(sign.strip().replace(".", "·").replace("~", "·"))

    def refuse_pending(self, where: str) -> None:
        if self.prefix or self.power or self.divides:
            raise _misplaced_error(f"a prefix, a power or a division {where}")


def _misplaced_error(what: str) -> Refused:
    return Refused(Outcome.UNREADABLE, f"{what} cannot be placed in a unit")


def _prefixed(prefix: str, word: str) -> str:
    """Return a symbol with its prefix unless that is another unit: a centiday is not a candela."""
    try:
        if parse_unit(prefix + word).dimension == parse_unit(word).dimension:
            return prefix + word
    except UnitError as error:
        raise _misplaced_error(f"the prefix of {word!r}") from error
    raise _misplaced_error(f"the prefix of {word!r}")


def _powered(factor: str, power: str) -> str:
    if not power:
        return factor
    word, minus, _ = factor.partition("^{-1}")
    return f"{word}^{{{'-' if minus else ''}{power}}}"

r"""Expansion of siunitx commands and mhchem's ``\pu``: ``\qty{9.8}{\meter\per\second\squared}``."""

import re
from dataclasses import dataclass, field
from typing import Final

from sim2reason.grading.alphabet import SCRIPTS
from sim2reason.grading.score import Outcome, Refused
from sim2reason.scenes.dsl.units import UnitError, parse_unit

__all__ = ["expanded"]

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


def expanded(content: str) -> str:
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
    found = _NUMBER.match(text)
    return (text[: found.end()], text[found.end() :]) if found else (text, "")


def _unit(text: str) -> str:
    r"""Return a unit written in siunitx macros, letters or both; ``\\per`` applies only to the next factor."""
    unit = _Unit()
    for found in _MACRO.finditer(text):
        name, argument = found["name"] or "", found["argument"] or ""
        if found["power"]:
            unit.raise_last(found["power"].strip("{ }"))
        elif found["word"]:
            unit.add(found["word"])
            unit.raise_last((found["raised"] or "").translate(SCRIPTS).replace("−", "-"))
        elif found["sign"]:
            unit.separate(found["sign"])
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
            raise _misplaced(rf"\{name}{{{argument}}}")
        if name in _RAISED_AFTER or name == "tothe":
            self.raise_last(_RAISED_AFTER.get(name, argument))
        elif name == "per" or name in _PREFIXES or name in _RAISED_BEFORE or takes:
            twice = self.divides if name == "per" else self.power if name not in _PREFIXES else ""
            if self.prefix or twice:
                raise _misplaced(rf"\{name}")
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
            raise _misplaced(f"the power {power}")
        self.factors[-1] = _powered(last, power)

    def separate(self, sign: str) -> None:
        """Add a separator between two units, such as a dot or slash."""
        if "\\" in sign.replace(r"\%", ""):
            raise _misplaced("a backslash")
        if sign.strip():
            self.refuse_pending(f"before {sign.strip()!r}")
            self.factors.append(sign.strip().replace(".", "·").replace("~", "·"))

    def refuse_pending(self, where: str) -> None:
        if self.prefix or self.power or self.divides:
            raise _misplaced(f"a prefix, a power or a division {where}")


def _misplaced(what: str) -> Refused:
    return Refused(Outcome.UNREADABLE, f"{what} cannot be placed in a unit")


def _prefixed(prefix: str, word: str) -> str:
    """Return a symbol with its prefix unless that is another unit: a centiday is not a candela."""
    try:
        if parse_unit(prefix + word).dimension == parse_unit(word).dimension:
            return prefix + word
    except UnitError as error:
        raise _misplaced(f"the prefix of {word!r}") from error
    raise _misplaced(f"the prefix of {word!r}")


def _powered(factor: str, power: str) -> str:
    if not power:
        return factor
    word, minus, _ = factor.partition("^{-1}")
    return f"{word}^{{{'-' if minus else ''}{power}}}"

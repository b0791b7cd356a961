"""Names of the quantities behind symbols, and conversion of numbers for formulas."""

import re
from collections.abc import Mapping
from dataclasses import replace
from decimal import Decimal
from functools import cache

from sim2reason.scenes.dsl.body import BODIES
from sim2reason.scenes.dsl.measures import join_unit
from sim2reason.scenes.dsl.model import field_types
from sim2reason.scenes.dsl.unit_text import factors
from sim2reason.scenes.dsl.units import SYSTEMS, coherent, parse_unit
from sim2reason.text.prose.description import Description

DIGITS = 12  # significant digits of a converted number
MINUS = "\N{MINUS SIGN}"
DEGREES, RADIANS = "deg", "rad"


@cache
def factor(unit: str) -> float:
    """Return the factor from a stated unit to the unit in formulas: 1 except for degrees and kilometres.

    Units of other coherent systems, such as those of astronomy, are unchanged.
    """
    own = frozenset[str]().union(*(system.own for system in SYSTEMS))
    return 1.0 if own & {word for word, _ in factors(unit)} else parse_unit(unit).factor


@cache
def formula_unit(unit: str) -> str:
    """Return the unit that formulas use for a stated unit: ``rad`` for ``deg``, ``m/s`` for ``km/s``."""
    if factor(unit) == 1.0:
        return unit
    words = ((RADIANS if word == DEGREES else word, power) for word, power in factors(unit))
    return coherent(" ".join(f"{word}^{power}" for word, power in words))[0]


def stated_value(number: float, unit: str) -> str:
    """Return the text of a number from a formula in its stated unit: 30° for 0.5236 rad, 2.5 kg."""
    if unit == RADIANS:
        number, unit = number / factor(DEGREES), DEGREES
    plain = format(Decimal(f"{number:.{DIGITS}g}"), "f")  # no text has exponents
    return join_unit(plain.replace("-", MINUS), unit)


NOUNS = (
    (r"\b(?:in a direction|points) ", "deg", "at an angle ", ""),
    (r"\bat ", "deg", "an angle ", ""),
    (r"(?<!of )", "m", "a height ", r" above\b"),
    (r"(?<!of )", "m", "a distance ", r" (?:from|beyond)\b"),
)
"""What stands before a symbol, of which unit, the noun that is put in between, and what stands after the symbol."""


def with_names(marked: Description) -> Description:
    """Return a symbolic text in which each bare symbol follows the name of its quantity."""
    parameters = {parameter.path: parameter for parameter in marked.scene.parameters}
    units = {marked.symbols[path]: p.measure.unit for path, p in parameters.items() if path in marked.symbols}
    names = {
        f"(${symbol}$)": f"({parameters[path].measure.name} ${symbol}$)"
        for path in marked.told
        if (symbol := marked.symbols.get(path)) and path in parameters
        if path.rpartition(".")[0] in marked.scene.bodies
    }

    def named(sentence: str) -> str:
        for alone, told in names.items():
            sentence = sentence.replace(alone, told)
        return sentence if sentence.lstrip().startswith("|") else _with_nouns(sentence, units)

    roles = {named(sentence): role for sentence, role in marked.roles.items()}
    return replace(marked, sentences=tuple(map(named, marked.sentences)), roles=roles)


def without_names(text: str) -> str:
    """Return a text as it was before `with_names`."""
    for before, _, noun, after in NOUNS:
        text = re.sub(rf"({before}){noun}(?=\$[^$]+\${after})", r"\1", text)
    return _named().sub(r"(\1)", text)


def _with_nouns(sentence: str, units: Mapping[str, str]) -> str:
    for before, unit, noun, after in NOUNS:
        for symbol, of in units.items():
            if parse_unit(of).dimension == parse_unit(unit).dimension:
                sentence = re.sub(
                    rf"({before})(?=\${re.escape(symbol)}\${after})", lambda found, n=noun: f"{found[1]}{n}", sentence
                )
    return sentence


@cache
def _named() -> re.Pattern[str]:
    """Return the pattern of a symbol in brackets after the name of a quantity."""
    held = (kind for body in BODIES.values() for kind in field_types(body).values())
    names = {kind.measure.name for kind in held if kind.measure is not None}
    return re.compile(rf"\((?:{'|'.join(map(re.escape, sorted(names)))}) (\$[^$]+\$)\)")

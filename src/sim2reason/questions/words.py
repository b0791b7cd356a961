"""Words of questions: names of numbers, and numbers in words and digits."""

import re
from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from decimal import Decimal
from functools import cache
from math import floor, isclose, log10
from typing import Self

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.questions.unknown import Unknown, unknowns
from sim2reason.scenes.dsl.measures import join_unit
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.model import Parameter
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.structure import may_reverse
from sim2reason.scenes.dsl.units import UnitSystem
from sim2reason.simulation.quantities.subjects import Subject

OF_BODIES = frozenset({"mass", "radius", "length", "height", "stiffness", "hole radius", "inner radius", "pulley mass"})
"""What is said of a body: *the radius of the disc*."""
OF_SCENES = {
    "coefficient of friction": "the coefficient of friction",
    "coefficient of static friction": "the coefficient of static friction",
    "coefficient of kinetic friction": "the coefficient of kinetic friction",
    "coefficient of restitution": "the coefficient of restitution",
    "force": "the applied force",
    "speed": "the initial speed",
    "height": "the initial height",
    "exhaust speed": "the exhaust speed",
    "burn rate": "the burn rate",
    "magnetic field": "the magnetic field",
    "electric field": "the electric field",
    "elevation": "the launch angle",
}
"""What a text says once, by the name of its measure or by its noun."""
CHARGE = "magnitude of the charge"
SLOPES = frozenset({"plane", "slope", "incline"})


def named_numbers(scene: Scene, mentions: Mapping[str, str]) -> Mapping[str, str]:
    """Return the unique phrases for numbers, by address; ambiguous ones are left out."""
    phrases = {
        parameter.path: phrase
        for parameter in scene.parameters
        if parameter.value and not parameter.hidden and (phrase := _phrase(scene, parameter, mentions))
    }
    count = Counter(phrases.values())
    return {path: phrase for path, phrase in phrases.items() if count[phrase] == 1}


def _phrase(scene: Scene, parameter: Parameter, mentions: Mapping[str, str]) -> str:
    measure, owner = parameter.measure, parameter.path.rpartition(".")[0]
    noun, mention = measure.noun, mentions.get(owner, "") if owner in scene.bodies else ""
    if mention and noun in OF_BODIES:
        return f"the {noun.removeprefix('pulley ')} of {mention}"
    if mention and noun == CHARGE:
        return f"the charge of {mention}"
    if mention.removeprefix("the ") in SLOPES and measure.name in ("angle", "tilt"):
        return f"the angle of inclination of {mention}"
    return "" if owner == "world" else OF_SCENES.get(measure.name, OF_SCENES.get(noun, ""))


@dataclass(frozen=True, slots=True)
class OwnSymbol:
    """A question's own number: a noun with its article, its symbol and its value."""

    noun: str
    symbol: str
    value: float

    @property
    def text(self) -> str:
        """Return the symbol between dollar signs."""
        return f"${self.symbol}$"


DIGITS_PATTERN = r"\d{1,20}"  # digits of a number before or after its point: as many as a float in full can need
ROUND_DIGITS = (1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 7, 8, 9)  # leading digits of round numbers
EQUAL_NUMBER_RTOL = 1e-13  # relative: numbers that differ by less are equal
METRE, LONG, KILO = "m", 1e4, 1e3  # the SI unit of length, and the length from which numbers are in kilometres
QUESTION_SYMBOLS = {
    "s": ("a time", ("t", "t_1", "t_2")),
    "m": ("a distance", ("d", "s", "D")),
    "deg": ("an angle", (r"\alpha", r"\beta", r"\gamma")),
}
"""By the SI unit of a number of a question's own: its noun, and the symbols that it may have."""


def symbol_for(value: float, unit: str, taken: Collection[str]) -> OwnSymbol | None:
    """Return an unused symbol for a question's own number; None if there is none for its unit."""
    noun, options = QUESTION_SYMBOLS.get(unit, ("", ()))
    free = next((option for option in options if option not in taken), None)
    return OwnSymbol(noun, free, value) if free is not None else None


def spoken_of(symbol: str, text: str, units: UnitSystem) -> tuple[str, OwnSymbol] | None:
    """Return the number for a symbol, from its text with a unit, and the SI unit; None if it can have no symbol."""
    for unit, (noun, options) in QUESTION_SYMBOLS.items():
        shown = join_unit("", units.spell(unit))
        if symbol in options and text.endswith(shown):
            return unit, OwnSymbol(noun, symbol, float(text.removesuffix(shown)))
    return None


def format_number(value: float, unit: str) -> str:
    """Return a number with all its digits, at least two, and its unit; lengths from 10 km on are in kilometres."""
    if unit == METRE and value >= LONG:
        return join_unit(format_all_digits(value / KILO), "km")
    return join_unit(format_all_digits(value), unit)


def numbers_in_text(text: str, unit: str) -> list[float]:
    """Return the numbers with a given unit in a text."""
    numbers = [float(number) for number in _number(unit).findall(text)]
    if unit == METRE:
        numbers += [float(Decimal(number) * int(KILO)) for number in _number("km").findall(text)]
    return numbers


@cache
def _number(unit: str) -> re.Pattern[str]:
    """Return a pattern for a number as `format_number` writes it: the degree sign follows without a space."""
    shown = join_unit("", unit)
    return re.compile(rf"({DIGITS_PATTERN}(?:\.{DIGITS_PATTERN})?){re.escape(shown)}(?![\w/])")


ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth")


def ordinal_word(number: int) -> str:
    """Return an ordinal number in words: *first*."""
    return ORDINALS[number - 1]


def numbers_of(text: str) -> list[int]:
    """Return the numbers of the ordinals in a text; 1 if there are none."""
    return [number for number, word in enumerate(ORDINALS, start=1) if re.search(rf"\b{word}\b", text)] or [1]


def two_digits(value: float) -> str:
    """Return a positive number with two significant digits, never in scientific notation."""
    rounded = float(f"{value:.1e}")
    places = max(0, 1 - int(np.floor(np.log10(rounded))))
    return f"{rounded:.{places}f}"


def format_all_digits(value: float) -> str:
    """Return a positive number with all its significant digits, at least two, and never in scientific notation."""
    two = two_digits(value)
    return two if isclose(float(two), value, rel_tol=EQUAL_NUMBER_RTOL) else f"{Decimal(f'{value:.15g}').normalize():f}"


def rounded_as_written(value: float) -> float:
    """Return a positive number rounded as it is written."""
    return float(two_digits(value))


def round_number(value: float, smallest: float, most: float) -> float:
    """Return the round number nearest to a positive one, such as 0.4, 1.5 or 25, between two bounds.

    Where none does, the number is returned with two significant digits.
    """
    tens = floor(log10(value))
    candidates = [
        float(f"{mantissa}e{exponent}") for exponent in (tens - 1, tens, tens + 1) for mantissa in ROUND_DIGITS
    ]
    fitting = [number for number in candidates if smallest <= number <= most]
    return min(fitting, key=lambda number: abs(log10(number / value)), default=rounded_as_written(value))


@dataclass(frozen=True, eq=False)
class Words:
    """The phrases for bodies, the initial state, and the given numbers of a text."""

    mechanism: Mechanism
    mentions: Mapping[str, str]  # by address
    released: bool  # from rest; else the text counts time from t = 0
    stated_paths: frozenset[str] = frozenset()  # the paths of all numbers that the text says, or speaks of as unknown
    unknowns: Sequence[Unknown] = ()  # the numbers that it leaves unknown, or could
    symbols: Mapping[str, str] = field(default_factory=dict[str, str])  # by address, those of all numbers, if known
    symbolic: bool = False  # whether it has those in place of numbers
    own: Mapping[str, OwnSymbol] = field(default_factory=dict[str, OwnSymbol])  # of a question's numbers, by SI unit
    named: Mapping[str, str] = field(default_factory=dict[str, str])  # phrases for numbers of the scene, by address
    _called: dict[str, Mapping[str, str]] = field(default_factory=dict[str, Mapping[str, str]], repr=False)

    @classmethod
    def of(
        cls,
        scene: Scene,
        mentions: Mapping[str, str],
        unknown: Mapping[str, str] | None = None,
        symbols: Mapping[str, str] | None = None,
    ) -> Self:
        """Return the words of a text about a scene, with phrases for bodies in `mentions`.

        `unknown` has the symbol of each number that it leaves unknown, or could; `symbols` those that all would have.
        """
        stated_paths = frozenset(p.path for p in scene.parameters if p.value is not None and not p.hidden)
        offered = unknowns(scene, mentions, unknown or {})
        named = named_numbers(scene, mentions)
        return cls(scene.mechanism, mentions, scene.starts_from_rest, stated_paths, offered, symbols or {}, named=named)

    def in_symbols(self, own: Mapping[str, OwnSymbol]) -> Self:
        """Return words with symbols in place of the text's numbers; `own` has the symbols of the question's numbers."""
        unknowns = [
            unknown.with_symbol(self.symbols[unknown.path]) for unknown in self.unknowns if unknown.path in self.symbols
        ]
        return replace(self, symbolic=True, own=own, unknowns=unknowns)

    @cached_property
    def turns_back(self) -> bool:
        """Return whether a body may turn back: one with an initial velocity, a collision or a varying force."""
        return may_reverse(self.mechanism)

    @property
    def since(self) -> str:
        """Return the phrase for the start of time in the text."""
        return "release" if self.released else "t = 0"

    def say(self, value: float, unit: str) -> str:
        """Return the text of a question's own number: 0.80 s, or its symbol."""
        own = self.own.get(unit)
        return own.text if own is not None else format_number(value, self.units.spell(unit))

    def amount(self, value: float, unit: str) -> str:
        """Return the text of a question's own number, with a noun before a symbol: 0.80 s, or *a time $t$*."""
        own = self.own.get(unit)
        return f"{own.noun} {own.text}" if own is not None else self.say(value, unit)

    def find_numbers(self, text: str, unit: str) -> list[float]:
        """Return the values of a question's own numbers in a text."""
        own = self.own.get(unit)
        if own is None:
            return numbers_in_text(text, self.units.spell(unit))
        return [own.value] if own.text in text else []

    @property
    def units(self) -> UnitSystem:
        """Return the units of the text."""
        return self.mechanism.units

    def subject_phrases(self, of: Subject) -> Mapping[str, str]:
        """Return the phrases for subjects of one kind, by name."""
        phrases = self._called.get(of.name)
        if phrases is None:
            phrases = self._called[of.name] = of.phrases(self.mechanism, self.mentions)
        return phrases

    def fills(self, of: Subject, name: str) -> dict[str, str]:
        """Return the texts of further placeholders in phrases about one subject, by placeholder."""
        return of.fills(self.mechanism, name, self.mentions)

"""Which symbol stands for which number of a mechanism, found by a *generic twin*.

Every number that the text says gets another value, and the mechanism is built again: a number of the mechanism that is
a mass in both, or the sine of an angle in both, is that mass or sine. Entities need not say what they do with numbers.
"""

import math
from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import reduce
from itertools import combinations_with_replacement
from math import comb
from operator import mul
from typing import cast

import numpy as np

from sim2reason.base.lazy import cached_property
from sim2reason.base.record import record
from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.measures import FAINT, VAST
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.model import Parameter
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.template import Word
from sim2reason.solutions.algebra.digits import EXACT, SIMPLE, in_full
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.functions import Call
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.writing.number_sums import Named, sum_of_products
from sim2reason.solutions.writing.unit_latex import latex
from sim2reason.text.prose.symbol_names import factor

SHIFT = 1e-3  # by how much, at most, numbers of the twin differ
SAME = 1e-10  # relative: far less than two numbers can agree by chance
TINY = 1e-9  # of what a text says: less belongs to atoms
TRIES, ALIKE = 24, 4  # draws of numbers; of these, the first, in which all grow or all shrink
LARGEST = 10_000  # the largest numerator of a number that is no accident
TERMS = 2500  # products of several numbers that are tried


class UnreadError(Exception):
    """A number of the mechanism that is no simple function of what the text says."""


@record(slots=True)
class StatedNumber:
    """A number that the text says: its symbol, its value and unit as said, and its value in the mechanism."""

    symbol: str
    parameter: Parameter
    value: float  # as the mechanism counts: angles in radians

    @property
    def latex(self) -> str:
        """The number as it is said, with its unit."""
        measure, value = self.parameter.measure, self.parameter.value or 0.0
        if self.value != value and not self.angle:  # in the units that formulas need
            plain = f"{self.value:.12f}".rstrip("0").rstrip(".")
            return (plain if float(plain) == self.value else in_full(self.value)) + self.counted_unit
        text = f"{value:.{measure.places(value)}f}"
        if abs(float(text) - value) > EXACT * abs(value) or not FAINT <= abs(value) < VAST:
            text = in_full(value)
        return text + self.unit

    @property
    def unit(self) -> str:
        """Its unit, in LaTeX."""
        return latex(self.parameter.measure.unit)

    @property
    def counted_unit(self) -> str:
        """Return the unit in which formulas count it, in LaTeX: without the prefix that the text may use."""
        unit = self.parameter.measure.unit
        if self.scale == 1.0 or self.angle:
            return self.unit
        return latex("kg" if unit == "g" else unit[1:])

    @property
    def scale(self) -> float:
        """Return the factor by which a number of the text is multiplied where formulas count it."""
        return factor(self.parameter.measure.unit)

    @property
    def angle(self) -> bool:
        """Return whether it is an angle in degrees."""
        return self.parameter.measure.unit == "deg"


@record(slots=True)
class Both:
    """One number of a mechanism and of its twin."""

    here: float
    there: float

    def __mul__(self, other: "Both") -> "Both":
        """Return both products."""
        return Both(self.here * other.here, self.there * other.there)

    def __truediv__(self, other: "Both") -> "Both":
        """Return both quotients."""
        return Both(self.here / other.here, self.there / other.there)

    def __sub__(self, other: "Both") -> "Both":
        """Return both differences."""
        return Both(self.here - other.here, self.there - other.there)


class Lexicon:
    """A scene, its mechanism and its twin's, and what their numbers are called."""

    def __init__(self, scene: Scene, symbols: Mapping[str, str]) -> None:
        """`symbols` are those of the text, by address. UnreadError if no twin can be built."""
        self.scene, self.mechanism = scene, scene.mechanism
        self.givens = {
            p.path: StatedNumber(symbols[p.path], p, _counted(p, p.value))
            for p in scene.parameters
            if p.value is not None and p.path in symbols
        }
        self._twin = self._built()
        self._read: dict[Both, Polynomial] = {}
        self._sums: dict[Both, Polynomial | None] = {}

    @property
    def twin(self) -> Mechanism:
        """The mechanism of the twin."""
        return self._twin[0]

    def _built(self) -> tuple[Mechanism, dict[str, float]]:
        """Return the twin and its numbers, those of the mechanism's own count."""
        for attempt in range(TRIES):
            rng = np.random.default_rng(attempt)
            side = -SHIFT if attempt % 2 == 0 else SHIFT
            mixed = attempt >= ALIKE  # what touches may need one number to grow and another one to shrink
            values = {
                path: given.parameter.value
                * (1.0 + side * rng.uniform(0.2, 1.0) * (rng.choice((-1.0, 1.0)) if mixed else 1.0))
                for path, given in self.givens.items()
                if given.parameter.value and not (given.angle and _is_word(self.scene, given.parameter))
            }
            try:
                twin = self.scene.having_all(values).mechanism
            except (SceneError, ValueError):
                continue
            if len(twin.coordinates) == len(self.mechanism.coordinates):
                counted = {path: _counted(self.givens[path].parameter, value) for path, value in values.items()}
                return twin, counted
        raise UnreadError("no scene like this one, with other numbers, could be built")

    @cached_property
    def _atoms(self) -> list[tuple[Both, Polynomial]]:
        found: list[tuple[Both, Polynomial]] = []
        for path, there in self._twin[1].items():
            given, symbol = self.givens[path], Symbol(self.givens[path].symbol)
            if given.angle:
                found.append((Both(math.sin(given.value), math.sin(there)), Polynomial.of(Call("sin", symbol))))
                found.append((Both(math.cos(given.value), math.cos(there)), Polynomial.of(Call("cos", symbol))))
            found.append((Both(given.value, there), Polynomial.of(symbol)))
        return [*found, *self._attracting()]

    def _attracting(self) -> list[tuple[Both, Polynomial]]:
        """Return the constant of gravitation; with a planet's g the mass is g R²/G, so that it cancels."""
        pulls = self.mechanism.attractions
        if not pulls:
            return []
        size, name = pulls[0].constant, Symbol("G")
        inverse = Both(1.0 / size, 1.0 / size), Polynomial({((name, -1),): 1.0})
        return [(Both(size, size), Polynomial.of(name)), *([] if self.constant is not None else [inverse])]

    @cached_property
    def constant(self) -> float | None:
        """The constant of gravitation, where the text says the masses of all that attracts."""
        pulls, heavy = self.mechanism.attractions, [given.value for given in self.givens.values()]
        return pulls[0].constant if pulls and self.mechanism.body[pulls[0].b].mass in heavy else None

    @property
    def lengths(self) -> list[Both]:
        """Return the lengths that the text states, in the mechanism and in its twin."""
        there = self._twin[1]
        return [
            Both(given.value, there[path])
            for path, given in self.givens.items()
            if given.parameter.measure.unit == "m" and path in there
        ]

    def of(self, number: Callable[[Mechanism], float]) -> Polynomial:
        """Return a formula for a number of the mechanism, as `read` does."""
        return self.read(Both(float(number(self.mechanism)), float(number(self.twin))))

    def read(self, number: Both) -> Polynomial:
        """Return a number as 0, a simple fraction, or one times a given number, a product of two or a sum of such."""
        known = self._read.get(number)
        if known is None:
            known = self._read[number] = self._searched(number)
        return known

    @cached_property
    def _nothing(self) -> float:
        """Return the size below which a number counts as zero; less than usual if some given numbers are tiny."""
        least = min((abs(given.value) for given in self.givens.values() if given.value), default=1.0)
        return SAME if least >= TINY else SAME * least**2

    def _searched(self, number: Both) -> Polynomial:
        if any(number.here == number.there == pull.constant for pull in self.mechanism.attractions):
            return Polynomial.of(Symbol("G"))  # far smaller, in the SI, than what rounding leaves of other numbers
        if abs(number.here) < self._nothing and abs(number.there) < self._nothing:
            return NIL
        plain = _factor(number, Both(1.0, 1.0))
        if plain is not None:
            return Polynomial.of(plain)
        for atom, name in self._atoms:
            factor = _factor(number, atom)
            if factor is not None:
                return name.scaled(factor)
        return self._of_two(number)

    def _of_two(self, number: Both) -> Polynomial:
        for (one, name), (two, other) in combinations_with_replacement(self._atoms, 2):
            factor = _factor(number, one * two)
            if factor is not None:
                return (name * other).scaled(factor)
        lengths = [(atom, name) for atom, name in self._atoms if name.symbol is not None]
        for one, name in lengths:
            for sign in (1.0, -1.0):
                rest = number - Both(sign * one.here, sign * one.there)
                for two, other in (*lengths, (Both(1.0, 1.0), None)):
                    factor = _factor(rest, two)
                    if factor is not None:
                        return name.scaled(sign) + (other or Polynomial.of(1.0)).scaled(factor)
        return self._of_several(number)

    def _of_several(self, number: Both) -> Polynomial:
        """Return a product of three or four, such as m g R² of a planet."""
        for size in (3, 4):
            if comb(len(self._atoms) + size - 1, size) > TERMS:
                break
            for held in combinations_with_replacement(self._atoms, size):
                factor = _factor(number, reduce(mul, (atom for atom, _ in held)))
                if factor is not None:
                    return reduce(mul, (name for _, name in held)).scaled(factor)
        found = self._of_sums(number)
        if found is None:
            raise UnreadError(f"{number.here:.6g} is no simple function of the numbers in the text")
        return found

    def _of_sums(self, number: Both) -> Polynomial | None:
        """Return a number as a total mass times others or a sum of two products; kept, since the search is slow."""
        if number not in self._sums:
            atoms = [Named(atom.here, atom.there, name) for atom, name in self._atoms]
            masses = [Symbol(g.symbol) for g in self.givens.values() if g.counted_unit == latex("kg")]
            heavy = [held for held in atoms if held.name.symbol in masses]
            self._sums[number] = sum_of_products(number.here, number.there, heavy, atoms)
        return self._sums[number]


def _counted(parameter: Parameter, value: float) -> float:
    """In the mechanism's own count: that of the text, but for degrees, kilometres and other such parts."""
    return value * factor(parameter.measure.unit)


def _is_word(scene: Scene, parameter: Parameter) -> bool:
    """Return whether a word states the value of a parameter, as *straight up* states 90°, so that it is fixed."""
    owner, _, name = parameter.path.rpartition(".")
    words = cast("Mapping[str, Word]", getattr(cast("object", scene.value(owner)), "words", {}))
    return any(word.parameter == name and parameter.value in word.special for word in words.values())


def _factor(number: Both, atom: Both) -> float | None:
    """Return the simple fraction by which a number is an atom, in both mechanisms; None for none."""
    if atom.here == 0.0 or atom.there == 0.0:
        return None
    here, there = number.here / atom.here, number.there / atom.there
    if abs(here - there) > SAME * abs(here):
        return None
    fraction = Fraction(here).limit_denominator(SIMPLE)
    simple = float(fraction) if abs(fraction.numerator) <= LARGEST else 0.0
    return simple if simple and abs(simple - here) <= SAME * abs(here) else None

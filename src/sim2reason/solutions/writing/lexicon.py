"""Formulas for the numbers of a mechanism, found by comparison with its twin: the same scene with other parameters.

Each number that the text states is perturbed, and the mechanism is built again: a number of the mechanism that equals a
mass in both, or the sine of an angle in both, is that mass or sine. Entities need not declare how they use parameters.
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

from sim2reason.base.records import cached_property, record
from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.measures import MIN_PLAIN_NUMBER, VAST
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.model import Parameter
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.template import Word
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.functions import Call
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.algebra.rounded_numbers import MAX_SIMPLE_DENOMINATOR, SIMPLE_FRACTION_RTOL, full_latex
from sim2reason.solutions.writing.notation import latex
from sim2reason.solutions.writing.number_sums import LabelledNumber, sum_of_products
from sim2reason.text.prose.description import formula_unit_factor

MAX_PERTURBATION = 1e-3  # largest relative change of a number of the twin
COINCIDENCE_RTOL = 1e-10  # relative tolerance, far below the distance of two numbers that agree by chance
ATOMIC_SIZE = 1e-9  # size below which stated numbers are of atomic scale
MAX_DRAWS, ALIKE = 24, 4  # random draws of the twin's numbers; in the first few, all grow or all shrink
MAX_NUMERATOR = 10_000  # largest numerator of a fraction that is not a coincidence
MAX_PRODUCTS = 2500  # largest number of products of several numbers that are tried


class UnreadError(Exception):
    """An error for a number of the mechanism that is not a simple function of the numbers in the text."""


@record(slots=True)
class StatedNumber:
    """A number in the text: its symbol, its parameter with value and unit, and its value in the mechanism."""

    symbol: str
    parameter: Parameter
    value: float  # in the units of the mechanism: angles in radians

    @property
    def latex(self) -> str:
        """Return the number as the text states it, with its unit, in LaTeX."""
        measure, value = self.parameter.measure, self.parameter.value or 0.0
        if self.value != value and not self.angle:  # in the units that formulas need
            plain = f"{self.value:.12f}".rstrip("0").rstrip(".")
            return (plain if float(plain) == self.value else full_latex(self.value)) + self.counted_unit
        text = f"{value:.{measure.places(value)}f}"
        if abs(float(text) - value) > SIMPLE_FRACTION_RTOL * abs(value) or not MIN_PLAIN_NUMBER <= abs(value) < VAST:
            text = full_latex(value)
        return text + self.unit

    @property
    def unit(self) -> str:
        """Return the unit in the text, in LaTeX."""
        return latex(self.parameter.measure.unit)

    @property
    def counted_unit(self) -> str:
        """Return the unit that formulas use, in LaTeX: without the prefix that the text may use."""
        unit = self.parameter.measure.unit
        if self.scale == 1.0 or self.angle:
            return self.unit
        return latex("kg" if unit == "g" else unit[1:])

    @property
    def scale(self) -> float:
        """Return the factor that converts the number in the text to the unit without prefix that formulas use."""
        return formula_unit_factor(self.parameter.measure.unit)

    @property
    def angle(self) -> bool:
        """Return whether the number is an angle in degrees."""
        return self.parameter.measure.unit == "deg"


@record(slots=True)
class DualValue:
    """The values of one number in a mechanism and in its twin, which has slightly different numbers."""

    value: float
    twin_value: float

    def __mul__(self, other: "DualValue") -> "DualValue":
        """Return the product of two numbers, in the mechanism and in its twin."""
        return DualValue(self.value * other.value, self.twin_value * other.twin_value)

    def __truediv__(self, other: "DualValue") -> "DualValue":
        """Return the quotient of two numbers, in the mechanism and in its twin."""
        return DualValue(self.value / other.value, self.twin_value / other.twin_value)

    def __sub__(self, other: "DualValue") -> "DualValue":
        """Return the difference of two numbers, in the mechanism and in its twin."""
        return DualValue(self.value - other.value, self.twin_value - other.twin_value)


class Lexicon:
    """The symbols of a scene's stated numbers, and formulas for all numbers of its mechanism."""

    def __init__(self, scene: Scene, symbols: Mapping[str, str]) -> None:
        """Take the text's `symbols` by address, and build a twin; raise UnreadError if none can be built."""
        self.scene, self.mechanism = scene, scene.mechanism
        self.givens = {
            p.path: StatedNumber(symbols[p.path], p, _counted(p, p.value))
            for p in scene.parameters
            if p.value is not None and p.path in symbols
        }
        self._twin = self._built()
        self._read: dict[DualValue, Polynomial] = {}
        self._sums: dict[DualValue, Polynomial | None] = {}

    @property
    def twin(self) -> Mechanism:
        """Return the mechanism of the twin: the same scene with slightly different numbers."""
        return self._twin[0]

    def _built(self) -> tuple[Mechanism, dict[str, float]]:
        """Return the mechanism of the twin and its stated numbers by path, in the units of the mechanism."""
        for attempt in range(MAX_DRAWS):
            rng = np.random.default_rng(attempt)
            side = -MAX_PERTURBATION if attempt % 2 == 0 else MAX_PERTURBATION
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
    def _atoms(self) -> list[tuple[DualValue, Polynomial]]:
        atoms: list[tuple[DualValue, Polynomial]] = []
        for path, there in self._twin[1].items():
            given, symbol = self.givens[path], Symbol(self.givens[path].symbol)
            if given.angle:
                atoms.append(
                    (DualValue(math.sin(given.value), math.sin(there)), Polynomial.from_expression(Call("sin", symbol)))
                )
                atoms.append(
                    (DualValue(math.cos(given.value), math.cos(there)), Polynomial.from_expression(Call("cos", symbol)))
                )
            atoms.append((DualValue(given.value, there), Polynomial.from_expression(symbol)))
        return [*atoms, *self._attracting()]

    def _attracting(self) -> list[tuple[DualValue, Polynomial]]:
        """Return (value, symbol) of the gravitational constant G; also of 1/G if masses follow from g as g R²/G."""
        pulls = self.mechanism.attractions
        if not pulls:
            return []
        size, name = pulls[0].constant, Symbol("G")
        inverse = DualValue(1.0 / size, 1.0 / size), Polynomial({((name, -1),): 1.0})
        return [
            (DualValue(size, size), Polynomial.from_expression(name)),
            *([] if self.constant is not None else [inverse]),
        ]

    @cached_property
    def constant(self) -> float | None:
        """Return the gravitational constant if the text states the masses of attracting bodies, else None."""
        pulls, heavy = self.mechanism.attractions, [given.value for given in self.givens.values()]
        return pulls[0].constant if pulls and self.mechanism.body[pulls[0].b].mass in heavy else None

    @property
    def lengths(self) -> list[DualValue]:
        """Return the lengths that the text states, in the mechanism and in its twin."""
        there = self._twin[1]
        return [
            DualValue(given.value, there[path])
            for path, given in self.givens.items()
            if given.parameter.measure.unit == "m" and path in there
        ]

    def formula_for(self, number: Callable[[Mechanism], float]) -> Polynomial:
        """Return a formula, in the text's symbols, for a number that a function computes from the mechanism."""
        return self.read(DualValue(float(number(self.mechanism)), float(number(self.twin))))

    def read(self, number: DualValue) -> Polynomial:
        """Return a formula in the given numbers for a number of the mechanism, with its value in the twin."""
        known = self._read.get(number)
        if known is None:
            known = self._read[number] = self._searched(number)
        return known

    @cached_property
    def _nothing(self) -> float:
        """Return the size below which a number of the mechanism counts as zero; smaller if given numbers are tiny."""
        smallest = min((abs(given.value) for given in self.givens.values() if given.value), default=1.0)
        return COINCIDENCE_RTOL if smallest >= ATOMIC_SIZE else COINCIDENCE_RTOL * smallest**2

    def _searched(self, number: DualValue) -> Polynomial:
        if any(number.value == number.twin_value == pull.constant for pull in self.mechanism.attractions):
            return Polynomial.from_expression(
                Symbol("G")
            )  # far smaller, in the SI, than what rounding leaves of other numbers
        if abs(number.value) < self._nothing and abs(number.twin_value) < self._nothing:
            return NIL
        plain = _factor(number, DualValue(1.0, 1.0))
        if plain is not None:
            return Polynomial.from_expression(plain)
        for atom, name in self._atoms:
            factor = _factor(number, atom)
            if factor is not None:
                return name.scale(factor)
        return self._of_two(number)

    def _of_two(self, number: DualValue) -> Polynomial:
        for (one, name), (two, other) in combinations_with_replacement(self._atoms, 2):
            factor = _factor(number, one * two)
            if factor is not None:
                return (name * other).scale(factor)
        lengths = [(atom, name) for atom, name in self._atoms if name.symbol is not None]
        for one, name in lengths:
            for sign in (1.0, -1.0):
                rest = number - DualValue(sign * one.value, sign * one.twin_value)
                for two, other in (*lengths, (DualValue(1.0, 1.0), None)):
                    factor = _factor(rest, two)
                    if factor is not None:
                        return name.scale(sign) + (other or Polynomial.from_expression(1.0)).scale(factor)
        return self._of_several(number)

    def _of_several(self, number: DualValue) -> Polynomial:
        """Return a number as a product of three or four given numbers, such as m g R², or as a sum of products."""
        for size in (3, 4):
            if comb(len(self._atoms) + size - 1, size) > MAX_PRODUCTS:
                break
            for factors in combinations_with_replacement(self._atoms, size):
                factor = _factor(number, reduce(mul, (atom for atom, _ in factors)))
                if factor is not None:
                    return reduce(mul, (name for _, name in factors)).scale(factor)
        polynomial = self._of_sums(number)
        if polynomial is None:
            raise UnreadError(f"{number.value:.6g} is no simple function of the numbers in the text")
        return polynomial

    def _of_sums(self, number: DualValue) -> Polynomial | None:
        """Return a number, cached, as a total mass times other numbers or a sum of two products; None if neither."""
        if number not in self._sums:
            atoms = [LabelledNumber(atom.value, atom.twin_value, name) for atom, name in self._atoms]
            masses = [Symbol(g.symbol) for g in self.givens.values() if g.counted_unit == latex("kg")]
            heavy = [candidate for candidate in atoms if candidate.name.symbol in masses]
            self._sums[number] = sum_of_products(number.value, number.twin_value, heavy, atoms)
        return self._sums[number]


def _counted(parameter: Parameter, value: float) -> float:
    """Convert a value in the text to the units of the mechanism: SI without prefixes, angles in radians."""
    return value * formula_unit_factor(parameter.measure.unit)


def _is_word(scene: Scene, parameter: Parameter) -> bool:
    """Return whether a word states the value of a parameter, as *straight up* states 90°, so that it is fixed."""
    owner, _, name = parameter.path.rpartition(".")
    words = cast("Mapping[str, Word]", getattr(cast("object", scene.value(owner)), "words", {}))
    return any(word.parameter == name and parameter.value in word.special for word in words.values())


def _factor(number: DualValue, atom: DualValue) -> float | None:
    """Return the simple fraction number / atom if it is the same in mechanism and twin; None if there is none."""
    if atom.value == 0.0 or atom.twin_value == 0.0:
        return None
    here, there = number.value / atom.value, number.twin_value / atom.twin_value
    if abs(here - there) > COINCIDENCE_RTOL * abs(here):
        return None
    fraction = Fraction(here).limit_denominator(MAX_SIMPLE_DENOMINATOR)
    simple = float(fraction) if abs(fraction.numerator) <= MAX_NUMERATOR else 0.0
    return simple if simple and abs(simple - here) <= COINCIDENCE_RTOL * abs(here) else None

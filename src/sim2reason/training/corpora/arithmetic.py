"""Corpora of arithmetic solutions and of drills.

Problems may have other numbers, solved by their formulas, and solutions may have planted errors.
"""

import re
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from math import copysign, degrees, isclose, isfinite, log, radians
from typing import Annotated, Final

import numpy as np
from annotated_types import Ge, Le
from pydantic import Field, field_validator

from sim2reason.generation.certified import worked_solution
from sim2reason.generation.item_search import ItemSearch, generator
from sim2reason.generation.make import build_item
from sim2reason.generation.request import Request
from sim2reason.solutions.algebra.expressions import Expression, Number, Product, Sum
from sim2reason.solutions.algebra.functions import Call
from sim2reason.solutions.solution import Solution
from sim2reason.training.corpora import CORPORA, Corpus, Row
from sim2reason.training.corpora.operations import Definitions, arithmetic, definitions, format_number, given_values
from sim2reason.training.corpora.rows import drawn_rows
from sim2reason.training.sources.problems import Fresh, fingerprint

__all__ = ["SLIPS", "Arithmetic", "Drills", "add_slips", "renumbered"]

Changes = Callable[[Expression], Iterator[Expression]]
"""All ways in which a formula, apart from its parts, is changed by one slip."""


def _function(expression: Expression) -> Iterator[Expression]:
    """Yield the expression with sine and cosine exchanged."""
    match expression:
        case Call("sin", angle):
            yield Call("cos", angle)
        case Call("cos", angle):
            yield Call("sin", angle)
        case _:
            pass


def _factor(expression: Expression) -> Iterator[Expression]:
    """Yield the expression without its numeric factor, such as one half."""
    match expression:
        case Product((Number(x), *rest)) if abs(x) != 1.0:
            yield Number(1.0 if x > 0.0 else -1.0) * expression.built_of(rest)
        case _:
            pass


def _sign(expression: Expression) -> Iterator[Expression]:
    """Yield the expression with the sign of one term changed."""
    match expression:
        case Sum(terms):
            for index in range(1, len(terms)):
                yield expression.built_of([-term if n == index else term for n, term in enumerate(terms)])
        case _:
            pass


def _term(expression: Expression) -> Iterator[Expression]:
    """Yield the expression without one term."""
    match expression:
        case Sum(terms):
            for index in range(len(terms)):
                yield expression.built_of([term for n, term in enumerate(terms) if n != index])
        case _:
            pass


SLIPS: Final[Mapping[str, Changes]] = {"factor": _factor, "function": _function, "sign": _sign, "term": _term}
"""The kinds of slips by name."""


def add_slips(formulas: Definitions, shares: Mapping[str, float], rng: np.random.Generator) -> Definitions:
    """Return the formulas of a solution with random errors, each kind of error with its own probability."""
    for kind, share in sorted(shares.items()):
        wrong = rng.random() < share
        ways = [(name, variant) for name, formula in formulas.items() for variant in _anywhere(formula, SLIPS[kind])]
        if wrong and ways:
            name, variant = ways[int(rng.integers(len(ways)))]
            formulas = {**formulas, name: variant}
    return formulas


def _anywhere(expression: Expression, changes: Changes) -> Iterator[Expression]:
    """Yield the variants of a formula with one error, in itself or in one of its parts."""
    yield from changes(expression)
    for index, part in enumerate(expression.parts):
        for changed in _anywhere(part, changes):
            yield expression.built_of([changed if n == index else other for n, other in enumerate(expression.parts)])


WIDEST: Final = log(2.5)  # logarithm of the largest factor on a number
MAX_ANGLE: Final = 85.0  # degrees
MAX_DRAWS: Final = 6
CONSTANTS: Final = frozenset({"g", "G"})  # constants of nature, which stay unchanged
Place = tuple[tuple[int, int], str]
"""Where a number stands in a text, and how."""
_NUMBER = re.compile(r"(?<![\w.,])\d+(?:\.\d+)?(?![\w]*[.,]?\d)")


def renumbered(prompt: str, solution: Solution, rng: np.random.Generator) -> tuple[str, Solution] | None:
    """Return a prompt and its solution with other numbers; None if no numbers keep the signs of all results.

    Only numbers that the prompt states once, in the digits of the problem, are changed.
    """
    for _ in range(MAX_DRAWS):
        text, numbers = _changed(prompt, solution, rng)
        values = _values(solution, numbers)
        if values is not None:
            assert solution.answer is not None
            answer = values[solution.goal] * solution.answer / solution.values[solution.goal]
            return text, replace(solution, values=values, answer=answer)
    return None


def _changed(prompt: str, solution: Solution, rng: np.random.Generator) -> tuple[str, dict[str, float]]:
    """Return the prompt with other numbers, and the new given values."""
    places = [(matches.span(), matches.group()) for matches in _NUMBER.finditer(prompt)]
    numbers, changes = dict(given_values(solution)), list[Place]()
    for name, value in numbers.items():
        magnitude, matches = abs(value), _positions(places, abs(value))
        if angle := not matches:
            magnitude = degrees(magnitude)
            matches = _positions(places, magnitude)
        if name in CONSTANTS or len(matches) != 1 or not value:
            continue
        span, text = matches[0]
        new = _like(text, magnitude * float(np.exp(rng.uniform(-WIDEST, WIDEST))))
        if float(new) == 0.0 or (angle and float(new) > MAX_ANGLE):
            continue
        changes.append((span, new))
        numbers[name] = copysign(radians(float(new)) if angle else float(new), value)
    for (start, end), new in sorted(changes, reverse=True):
        prompt = prompt[:start] + new + prompt[end:]
    return prompt, numbers


def _positions(places: list[Place], value: float) -> list[Place]:
    """Return the positions in a text at which a given number occurs."""
    return [(span, text) for span, text in places if isclose(float(text), value, rel_tol=1e-9)]


def _like(text: str, value: float) -> str:
    """Return a number with as many significant digits as a text."""
    digits = len(text.replace(".", "").lstrip("0")) or 1
    rounded = float(f"{value:.{digits - 1}e}")
    decimals = max(0, digits - 1 - int(np.floor(np.log10(rounded))))
    return f"{rounded:.{decimals}f}"


def _values(solution: Solution, numbers: Mapping[str, float]) -> dict[str, float] | None:
    """Return the results of a solution's formulas for other numbers; None if a sign changes or one is undefined."""
    values = dict(numbers)
    for name, formula in definitions(solution).items():
        try:
            value = formula.value(values)
        except (ArithmeticError, ValueError):
            return None
        if isinstance(value, complex) or not isfinite(value) or value * solution.values[name] <= 0.0:
            return None
        values[name] = value
    return values if solution.goal in values else None


Share = Annotated[float, Ge(0.0), Le(1.0)]


@CORPORA.register("arithmetic")
class Arithmetic(Corpus):
    """Arithmetic solutions of problems generated from a seed, optionally with planted errors."""

    problems: Fresh
    """What is drawn, as a source of prompts has it; of another seed than those that are trained or evaluated on."""
    items: Annotated[int, Ge(1), Le(10**7)] = 1000
    """How many problems are drawn."""
    rows_each: Annotated[int, Ge(1), Le(1000)] = 1
    """Rows of each problem: the first with its own numbers, the others with other numbers, and slips of their own.

    Problems with other numbers are no more certified, nor has any filter seen them.
    """
    slips: dict[str, Share] = Field(default_factory=dict[str, Share])
    """How often a solution has each kind of slip, where there is place for it."""
    workers: Annotated[int, Ge(1), Le(1024)] = 1
    """Processes that make the problems; they never change which."""

    @field_validator("slips")
    @classmethod
    def _known(cls, value: dict[str, float]) -> dict[str, float]:
        for name in value:
            if name not in SLIPS:
                raise ValueError(f"no such slip: {name!r}; there are: {', '.join(SLIPS)}")
        return value

    def rows(self, left_out: Counter[str]) -> Iterator[Row]:
        """Yield the rows of the problems in order, without those whose solution is not arithmetic."""
        return drawn_rows(self.problems, self.rows_of, self.items, self.workers, left_out, "no arithmetic")

    def rows_of(self, request: Request) -> list[Row] | None:
        """Return the prompts and arithmetic solutions of one problem and its variants; None if no problem is found."""
        certified = ItemSearch(request).find()
        if certified is None:
            return None
        item = build_item(request, certified)
        solution = worked_solution(request, certified)
        rows = list[Row]()
        for number in range(self.rows_each):
            rng = generator("corpus", request.id, number)
            prompt, variant = (number and renumbered(item.prompt, solution, rng)) or (item.prompt, solution)
            right, text = arithmetic(variant), arithmetic(variant, self._slips(rng))
            if text:
                known = fingerprint(item) if variant is solution else ""
                rows.append(Row(prompt, text, _answer(text) == _answer(right), known))
        return rows

    def _slips(self, rng: np.random.Generator) -> Callable[[Definitions], Definitions]:
        return lambda held: add_slips(held, self.slips, rng)


def _answer(text: str) -> str:
    """Return the content of the box."""
    return text.rpartition("\n")[2]


PROMPT = "Operations:"
SHARES = {"*": 0.5, "+": 0.1, "-": 0.1, "/": 0.3}


@CORPORA.register("drills")
class Drills(Corpus):
    """Single operations with three-digit results, written as in arithmetic solutions, without a problem."""

    seed: Annotated[int, Ge(0)] = 0
    items: Annotated[int, Ge(1), Le(10**7)] = 10_000
    operations: Annotated[int, Ge(1), Le(100)] = 10
    """In one row."""

    def rows(self, left_out: Counter[str]) -> Iterator[Row]:
        """Yield all drills, each as a prompt with its completion."""
        del left_out
        rng = generator("drills", self.seed)
        for _ in range(self.items):
            yield Row(PROMPT, "; ".join(_operation(rng) for _ in range(self.operations)))


def _operation(rng: np.random.Generator) -> str:
    """Return one random operation on numbers of the magnitudes usual in mechanics in SI units."""
    sign = str(rng.choice(list(SHARES), p=list(SHARES.values())))
    first = float(format_number(10.0 ** rng.uniform(-0.8, 1.0)))
    second = float(f"{10.0 ** rng.uniform(-1.2, 1.0):.{2 if sign == '*' else 3}g}")
    result = {"*": first * second, "+": first + second, "-": first - second, "/": first / second}[sign]
    return f"{format_number(first)}{sign}{second:g}={format_number(result)}"

"""Elimination in systems of linear equations: weighted sums in which tensions cancel, then numbers for the rest."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.solutions.algebra.evaluated import NumericFormula
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol, multiply_factors, sum_terms
from sim2reason.solutions.algebra.fractions import (
    CrossElimination,
    NumericEquation,
    SymbolicEquation,
    reduced_quotient,
    signed_term,
)
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial, total
from sim2reason.solutions.setting import join_words
from sim2reason.solutions.writing.steps import SolutionBuilder, StepBuilder, UnsolvedError

WEIGHT_RTOL = 1e-7  # relative: smaller weights count as zero
MAX_FORMULA_LENGTH = 130  # characters of a formula; longer ones are written with numbers


@dataclass(frozen=True)
class Equation:
    """An equation of motion, `forces` = `inertia`; its acceleration, `moves`, gives its weight in sums of equations.

    `told` has the forces as written; `links` has, by name, the labels of the equations that eliminated names from them.
    `key` identifies a sum without a label among the steps of its solution.
    """

    label: str
    forces: Polynomial
    inertia: Polynomial
    moves: Polynomial
    told: Polynomial = NIL
    links: Mapping[str, frozenset[str]] = field(default_factory=dict[str, frozenset[str]])
    key: str = ""

    @cached_property
    def zero(self) -> Polynomial:
        """Return forces minus inertia, which is zero by the equation."""
        return self.forces - self.inertia

    def substitute(self, values: Mapping[str, Polynomial]) -> "Equation":
        """Substitute polynomials for unknowns."""
        forces, inertia, moves = (part.substitute(values) for part in (self.forces, self.inertia, self.moves))
        return Equation(self.label, forces, inertia, moves, self.told or self.forces, self.links)

    @property
    def substituted_labels(self) -> frozenset[str]:
        """Return the labels of equations that were substituted into this one."""
        return frozenset[str]().union(*self.links.values())

    def linked_to(self, labels: Mapping[str, frozenset[str]]) -> "Equation":
        """Return the equation with `links` to the labels of the equations that eliminated unknowns from its forces."""
        gone = self.told.names() - self.forces.names()
        return replace(self, links={name: labels[name] for name in gone if name in labels})


class Elimination:
    """A solver of linear equations for unknowns that writes each step into a solution."""

    def __init__(self, book: SolutionBuilder, units: Mapping[str, str], rests: Sequence[str] = ()) -> None:
        """Take the LaTeX `units` of the unknowns, and as `rests` the labels of the steps that state the equations."""
        self.book, self.units, self._rests = book, units, rests

    def _open(self, kind: str) -> StepBuilder:
        """Begin a step that depends on the steps in which the equations are stated."""
        step = self.book.begin_step(kind)
        for label in self._rests:
            step.rest_on(label)
        return step

    def solve(self, equations: Sequence[Equation], unknowns: Sequence[str], goals: Sequence[str]) -> None:
        """Write the steps that solve equations for all unknowns in `goals`; UnsolvedError if that is impossible."""
        left = set(unknowns)
        for _ in range(len(unknowns) + 1):
            left = {name for name in left if name not in self.book.values}
            wanted = [name for name in goals if name in left]
            if not wanted:
                return
            single = self._single(equations, left, wanted)
            if single is not None:
                self._solve_single(*single)
            else:
                self._solve_system(equations, left, wanted)
        raise UnsolvedError("the equations could not be solved one after the other")

    # ---- one unknown

    def _single(
        self, equations: Sequence[Equation], left: set[str], wanted: Sequence[str]
    ) -> tuple[Equation, str] | None:
        """Return the shortest equation with one unknown, and that unknown; goals come first."""
        candidates = [(e, names[0]) for e in equations if len(names := sorted(e.zero.names() & left)) == 1]
        return min(candidates, key=lambda pair: (pair[1] not in wanted, len(pair[0].zero.terms)), default=None)

    def _solve_single(self, equation: Equation, name: str) -> None:
        """Write the step that solves an equation for its only unknown."""
        step = self._open("solve")
        step.rest_on(equation.key)
        formula = solve_linear(equation.zero, name, grouped=True)
        where = (
            f"From {join_words(sorted({equation.label, *equation.substituted_labels}))}, " if equation.label else "So "
        )
        if len(formula.latex()) <= MAX_FORMULA_LENGTH or self.book.is_hidden(formula):
            step.add_text(f"{where}{step.result(Symbol(name), formula, self.units[name])}.")
        else:
            left, right = (
                self.book.defer_to_number(polynomial.expression()) for polynomial in split_linear(equation.zero, name)
            )
            numbers = step.derived(right, multiply_factors(left, Symbol(name)))
            result = step.result(Symbol(name), self.book.defer_to_number(right / left), self.units[name])
            step.add_text(f"In numbers, {numbers}, so {result}.")
        step.close()

    # ---- several unknowns

    def _solve_system(self, equations: Sequence[Equation], left: set[str], wanted: Sequence[str]) -> None:
        """Write sums of equations in which forces cancel, one for each independent acceleration, and solve them."""
        free = sorted({name for e in equations for name in e.moves.names() if name in left})
        weights = [self._weights(equations, name, left, free) for name in free]
        if not weights or not all(weights):
            self._solve_single(self._isolating_sum(equations, left, wanted[0]), wanted[0])
            return
        sums = (total(e.zero * weight for e, weight in combination) for combination in weights)
        hidden = any(self.book.is_hidden(combination.coefficient(n).expression()) for combination in sums for n in free)
        labelled = len(weights) > 1 and hidden
        combined = [self._sum(combination, free, labelled=labelled) for combination in weights]
        if len(combined) == 1:
            self._solve_single(combined[0], free[0])
            return
        goal = next((name for name in wanted if name in free), free[0])
        ordered = [goal, *(name for name in free if name != goal)]
        (self._in_symbols if hidden else self._in_numbers)(combined, ordered)

    def _isolating_sum(self, equations: Sequence[Equation], left: set[str], goal: str) -> Equation:
        """Return the weighted sum of equations in which only one unknown remains; UnsolvedError if there is none."""
        names = sorted(left)
        known = self.book.values | self.book.observed
        rows = [[e.zero.coefficient(name).value(known) for name in names] for e in equations]
        target = np.array([1.0 if name == goal else 0.0 for name in names])
        weights = np.linalg.lstsq(np.array(rows).T, target, rcond=1e-12)[0]
        smallest = min((abs(w) for w in weights if abs(w) > WEIGHT_RTOL * np.abs(weights).max()), default=1.0)
        integers = [round(float(w) / smallest) for w in weights]
        if any(abs(w / smallest - n) > WEIGHT_RTOL for w, n in zip(weights, integers, strict=True)):
            raise UnsolvedError("no sum of the equations is free of forces")
        weighted = [(e, Polynomial.from_expression(float(n))) for e, n in zip(equations, integers, strict=True) if n]
        combined = self._combined(weighted, [goal])
        if combined.zero.names() & (left - {goal}):
            raise UnsolvedError("no sum of the equations is free of forces")
        return combined

    def _combined(
        self, weighted: Sequence[tuple[Equation, Polynomial]], names: Sequence[str], *, labelled: bool = False
    ) -> Equation:
        """Write a weighted sum of equations as a step and return it."""
        forces = total(e.forces * weight for e, weight in weighted)
        inertia = total(e.inertia * weight for e, weight in weighted)
        step = self._open("combine")
        terms = [_times(weight, e.label) for e, weight in weighted]
        if terms[0].startswith("-"):
            terms.sort(key=lambda part: part.startswith("-"))  # no sum begins with a sign
        how = " + ".join(terms).replace("+ -", "− ")
        left = total(e.told * weight for e, weight in weighted).names()  # names that cancel need no other equation
        links = (labels for e, _ in weighted for name, labels in e.links.items() if name in left)
        among = sorted(frozenset[str]().union(*links))
        how += f", with {join_words(among)}" if among else ""
        label = self.book.labels.next() if labelled else ""
        equation = Equation(label, forces, inertia, NIL, key="" if labelled else f"sum {len(self.book.steps)}")
        law = step.derived(forces.expression(), inertia.collected(names))
        step.add_text(f"{how}: {f'{equation.label} {law}'.strip()}.")
        step.label(equation.label or equation.key)
        step.close()
        return equation

    def _weights(
        self, equations: Sequence[Equation], name: str, left: set[str], free: Sequence[str]
    ) -> list[tuple[Equation, Polynomial]]:
        """Return equations weighted by their accelerations' coefficient of `name`; empty if forces do not cancel."""
        weighted = _whole([(e, weight) for e in equations if (weight := e.moves.coefficient(name))])
        zero = total(e.zero * weight for e, weight in weighted)
        return [] if zero.names() & (left - set(free)) else weighted

    def _sum(self, weighted: Sequence[tuple[Equation, Polynomial]], free: Sequence[str], *, labelled: bool) -> Equation:
        """Return the weighted sum of equations and write it; a single equation is returned unchanged."""
        return weighted[0][0] if len(weighted) == 1 else self._combined(weighted, free, labelled=labelled)

    # ---- in numbers

    def _in_numbers(self, equations: Sequence[Equation], names: Sequence[str]) -> None:
        """Write linear equations with numerical coefficients, then eliminate the unknowns, the first unknown last."""
        numeric: list[NumericEquation] = []
        hidden = any(self.book.is_hidden(equation.zero.terms_without(names).expression()) for equation in equations)
        how = "With numbers for the coefficients: " if hidden else "In numbers: "
        for equation in equations:
            before = {n: self._number(-equation.zero.coefficient(n).expression()) for n in names}
            rest = self._number(equation.zero.terms_without(names).expression())
            kept = {n: part for n, part in before.items() if self.book.value(part)}
            numeric.append(NumericEquation(self.book.labels.next(), kept, rest))
            step = self._open("solve")
            step.rest_on(equation.label or equation.key)
            step.label(numeric[-1].label)
            step.add_text(f"{how}{numeric[-1].label} {step.derived(numeric[-1].sum, rest)}.")
            step.close()
            how = ""
        self._reduce(numeric, list(names))

    def _in_symbols(self, equations: Sequence[Equation], names: Sequence[str]) -> None:
        """Eliminate the unknowns where the coefficients may not be written as numbers."""
        ordered: list[SymbolicEquation] = []
        for equation in equations:
            before = {n: equation.zero.coefficient(n).scale(-1.0) for n in names}
            left = {n: part for n, part in before.items() if part}
            ordered.append(SymbolicEquation(equation.label, left, equation.zero.terms_without(names)))
        CrossElimination(self.book, self.units, self._open).reduce(ordered, names)

    def _number(self, formula: Expression) -> Expression:
        """Return the numerical value of a formula with guard digits; the formula itself if it has unknowns."""
        number = self.book.defer_to_number(formula)
        return replace(number, guarded=True) if isinstance(number, NumericFormula) else number

    def _reduce(self, equations: list[NumericEquation], names: list[str]) -> None:
        """Write the steps of Gaussian elimination of numerical equations."""
        first = names[0]
        if len(names) == 1:
            equation = equations[0]
            step = self._open("solve")
            step.rest_on(equation.label)
            formula = self.book.defer_to_number(equation.right / equation.left[first])
            step.add_text(f"So {step.result(Symbol(first), formula, self.units[first])}.")
            step.close()
            return
        last = names[-1]
        having = [e for e in equations if last in e.left]
        pivot = max(having, key=lambda e: abs(self.book.value(e.left[last])))
        reduced = [self._without(e, pivot, last) if last in e.left else e for e in equations if e is not pivot]
        self._reduce(reduced, names[:-1])
        step = self._open("solve")
        step.rest_on(pivot.label)
        rest = pivot.right if self.book.value(pivot.right) else ZERO
        for name, part in pivot.left.items():
            rest = sum_terms(rest, signed_term(part, name, -1.0)) if name != last else rest
        formula = rest / pivot.left[last]
        step.add_text(f"From {pivot.label}, {step.result(Symbol(last), formula, self.units[last])}.")
        step.close()

    def _without(self, equation: NumericEquation, pivot: NumericEquation, last: str) -> NumericEquation:
        """Return an equation minus the multiple of a pivot equation that eliminates an unknown."""
        ratio = self._number(equation.left[last] / pivot.left[last])
        names = dict.fromkeys((*equation.left, *pivot.left))
        left = {
            name: self._number(equation.left.get(name, ZERO) - multiply_factors(ratio, pivot.left.get(name, ZERO)))
            for name in names
            if name != last
        }
        right = self._number(equation.right - multiply_factors(ratio, pivot.right))
        difference = NumericEquation(self.book.labels.next(), left, right)
        step = self._open("combine")
        step.rest_on(equation.label)
        step.rest_on(pivot.label)
        step.label(difference.label)
        turned = isinstance(ratio, NumericFormula) and ratio.comes_to < 0.0
        sign = "+" if turned else "−"
        size = (-ratio).latex() if isinstance(ratio, NumericFormula) and turned else ratio.latex()
        size = size if isinstance(ratio, NumericFormula) else f"${size}$"
        step.add_text(
            f"{equation.label} {sign} {size}·{pivot.label}: {difference.label} {step.derived(difference.sum, right)}."
        )
        step.close()
        return difference


def _times(weight: Polynomial, label: str) -> str:
    """Return the text of a weight times the label of an equation."""
    number = weight.number
    if number is None:
        return f"${weight.factored().latex()}$·{label}"
    return label if number == 1.0 else f"-{label}" if number == -1.0 else f"{Number(number).latex()}·{label}"


def _whole(weighted: list[tuple[Equation, Polynomial]]) -> list[tuple[Equation, Polynomial]]:
    """Scale numerical weights so that the smallest is 1; other weights are returned unchanged."""
    numbers = [weight.number for _, weight in weighted]
    if not numbers or any(number is None for number in numbers):
        return weighted
    smallest = min((number for number in numbers if number), key=abs)
    return [(e, weight.scale(1.0 / smallest)) for e, weight in weighted]


def split_linear(zero: Polynomial, name: str) -> tuple[Polynomial, Polynomial]:
    """Split an equation zero = 0 into `before` · name = `rest`, with the sign that makes `before` mostly positive."""
    before, rest = zero.coefficient(name), zero.terms_without((name,))
    return (before, rest.scale(-1.0)) if sum(before.terms.values()) > 0.0 else (before.scale(-1.0), rest)


def solve_linear(zero: Polynomial, name: str, *, grouped: bool = False) -> Expression:
    """Solve a linear equation for its only unknown."""
    before, rest = split_linear(zero, name)
    return reduced_quotient(rest, before, grouped=grouped)

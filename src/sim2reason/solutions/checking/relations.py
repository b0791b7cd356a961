"""Relations in stated order: definitions give symbols their values, all others are solved or verified."""

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence

import numpy as np

from sim2reason.solutions.checking.equation import Equation, separated
from sim2reason.solutions.checking.trees import (
    SAMPLES,
    STATED_ROOT_RTOL,
    Tree,
    has_other_root,
    magnitude_bound,
    parts_named,
    value,
)

MAX_ITERATIONS = 200  # iterations
EPS = 4e-16  # relative


def zero(function: Callable[[float], float], one: float, other: float, *, within: float = EPS) -> float:
    """Find a zero of a function between two points by the Anderson-Björck method, bisecting where that is slow.

    The values at both points must differ in sign; `within` is the relative accuracy of the zero. Exceptions of the
    function propagate.
    """
    low, high = function(one), function(other)
    for n in range(MAX_ITERATIONS):
        if not low:
            return one
        if not high or abs(other - one) <= within * max(abs(one), abs(other)):
            return other
        middle = other - high * (other - one) / (high - low) if n % 4 < 3 else 0.5 * (one + other)
        if not min(one, other) < middle < max(one, other):
            middle = 0.5 * (one + other)
        value = function(middle)
        if (value > 0.0) == (high > 0.0):  # the other end stays: reduce its weight
            weight = 1.0 - value / high
            low *= weight if weight > 0.0 else 0.5
        else:
            one, low = other, high
        other, high = middle, value
    return other


NULL_SPACE_ATOL = 1e-9  # largest part of a determined symbol in the null space of the equations
ZERO_COEFFICIENT_RTOL = 1e-13  # relative to its terms: smaller coefficients count as zero
SINGULAR_VALUE_RTOL = 1e-10  # relative: smaller singular values count as zero
STATED_NUMBER_RTOL = 2e-9  # relative: largest difference between a stated number and its formula
UNDEFINED = (ArithmeticError, ValueError, KeyError)


class Relations:
    """The known values, the equations that wait for values, and the faults found so far."""

    def __init__(self, given: Mapping[str, float]) -> None:
        """Take the given values by name."""
        self.values = dict(given)
        self.faults: list[str] = []
        self._missing: dict[Equation, set[str]] = {}  # unknown names of each waiting equation
        self._waiting: dict[str, list[Equation]] = defaultdict(list)  # waiting equations by unknown name

    @property
    def unknown(self) -> list[str]:
        """Return the symbols without values in order of appearance."""
        return list(dict.fromkeys(name for missing in self._missing.values() for name in sorted(missing)))

    def add(self, equation: Equation) -> None:
        """Add a relation: verify it, take a value from it, or keep it until its other symbols have values."""
        if equation.initial_guess is not None and isinstance(equation.left, str):
            self._shoot(equation.left, equation.initial_guess)
            return
        missing = set(equation.names - self.values.keys())
        self._missing[equation] = missing
        for name in missing:
            self._waiting[name].append(equation)
        self._look_at(equation)

    def assign(self, name: str, number: float) -> None:
        """Set the value of a symbol and process the equations that waited for it."""
        self.values[name] = number
        for equation in self._waiting.pop(name, []):
            self._missing[equation].discard(name)
        for equation in [pending for pending, missing in self._missing.items() if len(missing) < 2]:
            self._look_at(equation)

    def _look_at(self, equation: Equation) -> None:
        """Verify a relation without unknowns, or compute its only unknown if the relation defines it."""
        missing = self._missing.get(equation)
        if missing is None or len(missing) > 1:
            return
        if not missing:
            del self._missing[equation]
            self._verify(equation)
            return
        (name,) = missing
        formula = equation.definition(name)
        if formula is None:
            return
        try:
            number = value(formula, self.values)
        except UNDEFINED:
            self._drop(equation)
            self.faults.append(f"has no value: {equation}")
            return
        self._drop(equation)
        self._judge_parts(formula)
        self.assign(name, number)

    def _drop(self, equation: Equation) -> None:
        """Remove an equation from those that wait for values of their symbols."""
        for name in self._missing.pop(equation):
            self._waiting[name].remove(equation)

    def _verify(self, equation: Equation) -> None:
        """Record a fault if a relation does not hold."""
        try:
            good = equation.holds(self.values)
        except UNDEFINED:
            good = False
        if not good:
            self.faults.append(f"does not hold: {equation}")
            return
        self._judge_parts(equation.left)
        self._judge_parts(equation.right)

    def _judge_parts(self, tree: Tree) -> None:
        """Record faults in a tree: numbers that differ from their formulas, and roots that are not unique."""
        for _, inner, number in parts_named(tree, "worked"):
            exact, stated = value(inner, self.values), float(number)  # type: ignore[arg-type]
            if abs(exact - stated) > STATED_NUMBER_RTOL * abs(exact):
                self.faults.append(f"a formula comes to {exact:.9g}, not {stated:.9g}")
        for part in parts_named(tree, "root"):
            if has_other_root(part, self.values):
                self.faults.append(f"the root {part[1]} near {part[3]} is not the only one there")

    # ---- what several relations determine together

    def _shoot(self, name: str, near: float) -> None:
        """Find the value of a symbol near a number for which all waiting relations hold."""
        self.solve_linear()
        if name in self.values:
            if abs(self.values[name] - near) > STATED_ROOT_RTOL * abs(near):
                self.faults.append(f"{name} is {self.values[name]:.6g}, not {near:.6g}")
            return
        chain, verifiable = self._chain(name)
        places = [near * (1.0 + 1.01 * STATED_ROOT_RTOL * (2.0 * n / SAMPLES - 1.0)) for n in range(SAMPLES + 1)]
        try:
            there = [self._along(chain, name, candidate) for candidate in places]
            sharp = [each for each in verifiable if not (each.holds(there[0]) and each.holds(there[-1]))]
            if not sharp:
                self.faults.append(f"no relation determines {name}")
                return
            signs = [sharp[0].excess(at) > 0.0 for at in there]
            turns = [n for n in range(SAMPLES) if signs[n] != signs[n + 1]]
            if len(turns) != 1:
                self.faults.append(f"{len(turns)} values of {name} near {near} fulfil all relations")
                return
            ends = places[turns[0]], places[turns[0] + 1]
            root = zero(lambda number: sharp[0].excess(self._along(chain, name, number)), *ends)
        except UNDEFINED:
            self.faults.append(f"relations have no value for {name} near {near}")
            return
        self.assign(name, root)

    def _along(self, chain: Sequence[tuple[str, Tree]], name: str, number: float) -> dict[str, float]:
        """Return the values of all known symbols for a trial value of one symbol, with those that a chain defines."""
        at = self.values | {name: number}
        for other, formula in chain:
            at[other] = value(formula, at)
        return at

    def _chain(self, name: str) -> tuple[list[tuple[str, Tree]], list[Equation]]:
        """Return the formulas that follow from a symbol's value, and the relations that can then be verified."""
        missing = {equation: names - {name} for equation, names in self._missing.items()}
        chain, verifiable = list[tuple[str, Tree]](), list[Equation]()
        while True:
            verifiable += [equation for equation, names in missing.items() if not names]
            missing = {equation: names for equation, names in missing.items() if names}
            definition = next(_definitions(missing), None)
            if definition is None:
                return chain, verifiable
            equation, other, formula = definition
            del missing[equation]
            chain.append((other, formula))
            for names in missing.values():
                names.discard(other)

    def solve_linear(self) -> None:
        """Solve the waiting equations for the symbols that they determine linearly."""
        while self._missing:
            rows = self._linear_rows()
            solution = _determined(rows) if rows else {}
            if not solution:
                return
            for name, number in solution.items():
                if name not in self.values:
                    self.assign(name, number)

    def _linear_rows(self) -> list[tuple[dict[str, float], float]]:
        """Return the coefficients and the right side of each waiting equation that is linear in its unknowns."""
        rows: list[tuple[dict[str, float], float]] = []
        for equation, missing in self._missing.items():
            if equation.asserts:
                continue
            try:
                parts = separated(["+", equation.left, ["*", -1.0, equation.right]], frozenset(missing))
                row = {name: self._significant(part) for name, part in parts.items()}
            except UNDEFINED:
                continue
            rest = row.pop("", 0.0)
            if any(row.values()):
                rows.append((row, -rest))
        return rows

    def _significant(self, tree: Tree) -> float:
        """Return the value of a coefficient; zero if it is only a rounding error of its terms."""
        number = value(tree, self.values)
        return number if abs(number) > ZERO_COEFFICIENT_RTOL * magnitude_bound(tree, self.values) else 0.0


def _definitions(missing: Mapping[Equation, set[str]]) -> Iterator[tuple[Equation, str, Tree]]:
    """Yield the equations that define their only unknown, with that unknown and its formula."""
    for equation, names in missing.items():
        if len(names) == 1:
            (name,) = names
            formula = equation.definition(name)
            if formula is not None:
                yield equation, name, formula


def _determined(rows: list[tuple[dict[str, float], float]]) -> dict[str, float]:
    """Return the values of the symbols that linear equations determine uniquely."""
    names = sorted({name for row, _ in rows for name in row})
    matrix = np.array([[row.get(name, 0.0) for name in names] for row, _ in rows])
    right = np.array([off for _, off in rows])
    scale = np.abs(matrix).max(axis=1)
    matrix, right = matrix / scale[:, None], right / scale
    columns = np.abs(matrix).max(axis=0)
    columns[columns == 0.0] = 1.0
    left, sizes, ways = np.linalg.svd(matrix / columns, full_matrices=False)
    kept = sizes > SINGULAR_VALUE_RTOL * sizes.max(initial=0.0)
    numbers = ways[kept].T @ ((left[:, kept].T @ right) / sizes[kept]) / columns
    certain = (ways[kept] ** 2).sum(axis=0) > 1.0 - NULL_SPACE_ATOL
    return {name: float(x) for name, x, sure in zip(names, numbers, certain, strict=True) if sure}

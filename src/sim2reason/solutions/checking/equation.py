"""Relations of a solution as trees, and linear equations with time-dependent coefficients."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from sim2reason.solutions.checking.trees import (
    Array,
    EvaluateAll,
    Tree,
    TreeError,
    Values,
    compiled_for_many,
    derivatives,
    largest_term,
    symbols,
    tree_text,
    value,
)

RELATION_RTOL = 1e-9  # relative to the largest term: largest difference of the two sides
ROUNDING_ATOL = 1e-13  # in SI units: largest rounding error of numbers that cancel


@dataclass(frozen=True, eq=False)
class Equation:
    """An equation between two formulas, as prefix trees, with its role in the solution and its symbols."""

    left: Tree
    right: Tree
    role: str
    names: frozenset[str]

    @classmethod
    def from_trees(cls, left: Tree, right: Tree, role: str = "law") -> "Equation":
        """Return the equation between two formulas, given as prefix trees, with the symbols of both."""
        return cls(left, right, role, frozenset(symbols(left)) | frozenset(symbols(right)))

    def __str__(self) -> str:
        """Return both trees on one line."""
        return f"{tree_text(self.left)} = {tree_text(self.right)}"

    @property
    def initial_guess(self) -> float | None:
        """Return the approximate value near which the relation is solved for its symbol; None for other relations."""
        if isinstance(self.right, list) and self.right[0] == "solve":
            return float(self.right[1])  # type: ignore[arg-type]
        return None

    @property
    def asserts(self) -> bool:
        """Return whether the relation only states a symbol's number, to be verified by other relations."""
        return self.role != "law" and not isinstance(self.right, str | list) and isinstance(self.left, str)

    def definition(self, name: str) -> Tree | None:
        """Return the formula of a symbol alone on one side; None if the other side contains it, too."""
        if self.asserts:
            return None
        for side, other in ((self.left, self.right), (self.right, self.left)):
            if side == name:
                return None if name in symbols(other) else other
        return None

    def excess(self, at: Values) -> float:
        """Return the left side minus the right side."""
        return value(self.left, at) - value(self.right, at)

    def holds(self, at: Values) -> bool:
        """Return whether both sides agree relative to their largest term."""
        return (
            abs(self.excess(at))
            <= RELATION_RTOL * max(largest_term(self.left, at), largest_term(self.right, at)) + ROUNDING_ATOL
        )

    def slopes(self, at: Values) -> tuple[float, Mapping[str, float]]:
        """Return left minus right, and its partial derivatives with respect to the symbols."""
        (one, gradient), (other, right) = derivatives(self.left, at), derivatives(self.right, at)
        for name, slope in right.items():
            gradient[name] = gradient.get(name, 0.0) - slope
        return one - other, gradient


CONSISTENCY_RTOL = 1e-8  # relative: largest contradiction of redundant equations
RANK_RTOL = 1e-11  # relative: smaller singular values count as zero
UNDETERMINED = "the equations of motion do not determine accelerations and forces"


def separated(tree: Tree, unknowns: frozenset[str]) -> dict[str, Tree]:
    """Return a linear formula as coefficients by unknown, its rest under the empty name; TreeError if not linear."""
    if isinstance(tree, str) and tree in unknowns:
        return {tree: 1.0}
    if unknowns.isdisjoint(symbols(tree)):
        return {"": tree}
    assert isinstance(tree, list)
    operation, *parts = tree
    if operation == "worked":
        return separated(parts[0], unknowns)
    if operation == "+":
        return _summed([separated(part, unknowns) for part in parts])
    bound = [n for n, part in enumerate(parts) if not unknowns.isdisjoint(symbols(part))]
    if operation == "/" and bound == [0]:
        return {name: ["/", coefficient, parts[1]] for name, coefficient in separated(parts[0], unknowns).items()}
    if operation == "*" and len(bound) == 1:
        rest = [part for n, part in enumerate(parts) if n != bound[0]]
        return {name: ["*", coefficient, *rest] for name, coefficient in separated(parts[bound[0]], unknowns).items()}
    raise TreeError(f"an equation of motion is not linear in {', '.join(sorted(unknowns & {*symbols(tree)}))}")


def _summed(parts: Sequence[Mapping[str, Tree]]) -> dict[str, Tree]:
    """Return the sum of several linear forms."""
    collected: dict[str, list[Tree]] = {}
    for part in parts:
        for name, entry in part.items():
            collected.setdefault(name, []).append(entry)
    return {name: entry[0] if len(entry) == 1 else ["+", *entry] for name, entry in collected.items()}


class LinearSystem:
    """Linear equations for accelerations and forces, solved at several instants at once."""

    def __init__(self, equations: Sequence[Equation], unknowns: Sequence[str]) -> None:
        """Find the coefficients; TreeError if an equation is not linear or there are too few."""
        self.unknowns = tuple(unknowns)
        if len(equations) < len(unknowns):
            raise TreeError(f"{len(equations)} equations for {len(unknowns)} accelerations and forces")
        self._entries: list[tuple[int, int, EvaluateAll]] = []
        self._rests: list[EvaluateAll] = []
        columns, names = {name: number for number, name in enumerate(unknowns)}, frozenset(unknowns)
        for row, equation in enumerate(equations):
            parts = separated(["+", equation.left, ["*", -1.0, equation.right]], names)
            self._rests.append(compiled_for_many(parts.pop("", 0.0)))
            self._entries += [(row, columns[name], compiled_for_many(part)) for name, part in parts.items()]

    def _filled(self, at: Mapping[str, float | Array], count: int) -> tuple[Array, Array]:
        """Return the matrices, (count, rows, unknowns), and the right sides, (count, rows, 1), at several instants."""
        matrix = np.zeros((count, len(self._rests), len(self.unknowns)))
        right = np.zeros((count, len(self._rests), 1))
        for row, column, evaluate in self._entries:
            matrix[:, row, column] = evaluate(at)
        for row, evaluate in enumerate(self._rests):
            right[:, row, 0] = -np.asarray(evaluate(at))
        return matrix, right

    def solve(self, at: Mapping[str, float | Array], count: int) -> dict[str, Array]:
        """Return the unknowns, (count,) each, at several instants; ArithmeticError if they are not determined."""
        matrix, right = self._filled(at, count)
        try:
            if matrix.shape[1] == 1:
                solution = right / matrix
            elif matrix.shape[1] == matrix.shape[2]:
                solution = np.linalg.solve(matrix, right)
            else:
                solution = np.linalg.pinv(matrix, rcond=RANK_RTOL) @ right
        except np.linalg.LinAlgError as error:
            raise ArithmeticError(UNDETERMINED) from error
        return {name: np.asarray(solution[:, number, 0], dtype=np.float64) for number, name in enumerate(self.unknowns)}

    def examine(self, at: Mapping[str, float | Array]) -> None:
        """Raise ArithmeticError unless the equations at one instant have full rank and are consistent."""
        (matrix,), (right,) = self._filled(at, 1)
        if not self.unknowns:
            return
        rows = np.abs(matrix).max(axis=1)
        rows = np.where(rows == 0.0, 1.0, rows)
        matrix, right = matrix / rows[:, None], right[:, 0] / rows
        columns = np.abs(matrix).max(axis=0)
        if not columns.all() or np.linalg.matrix_rank(matrix / columns, tol=RANK_RTOL) < matrix.shape[1]:
            raise ArithmeticError(UNDETERMINED)
        solution: Array = (
            np.asarray(np.linalg.lstsq(matrix / columns, right, rcond=None)[0], dtype=np.float64) / columns
        )
        terms = np.abs(matrix) @ np.abs(solution) + np.abs(right)
        if (np.abs(matrix @ solution - right) > CONSISTENCY_RTOL * terms + ROUNDING_ATOL).any():
            raise ArithmeticError("the equations of motion contradict each other")

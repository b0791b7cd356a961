"""Independent verification of worked solutions: the answer is recomputed from their stated data alone.

The data are JSON values, in which formulas are prefix trees, see `trees`. This package shares no code with the writers
of solutions or with the engines.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from math import isfinite
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from sim2reason.solutions.checking.equation import ROUNDING_ATOL, Equation
from sim2reason.solutions.checking.integration import PhaseError, formulas, integrate
from sim2reason.solutions.checking.relations import UNDEFINED, Relations, zero
from sim2reason.solutions.checking.trees import STATED_ROOT_RTOL, TreeError, check, symbols, tree_text

__all__ = ["Recomputed", "recompute"]


Array: TypeAlias = npt.NDArray[np.float64]


RESIDUAL_RTOL = 1e-8  # relative: largest residual of a row that depends linearly on others
RANK_RTOL = 1e-12  # relative: smaller singular values count as zero
LAW = "law"


def undetermined(
    equations: Sequence[Equation], known: frozenset[str], values: Mapping[str, float], needed: Sequence[str]
) -> Iterator[str]:
    """Yield messages for symbols that the laws do not determine and for relations that do not follow from them.

    Args:
        equations: all relations that hold for the `values`, except those that only verify something.
        known: the names that no law needs to determine.
        values: the values of all names.
        needed: the names that the laws must determine.
    """
    names = sorted({name for equation in equations for name in equation.names} - known)
    place = {name: number for number, name in enumerate(names)}
    sizes = np.array([abs(values[name]) if abs(values[name]) > ROUNDING_ATOL else 1.0 for name in names])
    rows = [_row(equation, values, place, sizes) for equation in equations]
    basis = _basis([row for row, equation in zip(rows, equations, strict=True) if equation.role == LAW], len(names))
    for name in needed:
        if name not in known and (name not in place or not _spanned(basis, np.eye(len(names))[place[name]])):
            yield f"the laws that are told do not determine {name}"
    for row, equation in zip(rows, equations, strict=True):
        if equation.role != LAW and not _spanned(basis, row):
            yield f"does not follow from what is told: {equation}"


def _row(equation: Equation, values: Mapping[str, float], place: Mapping[str, int], sizes: Array) -> Array:
    """Return the gradient of an equation, (n,), for relative changes of the symbols; its largest element is ±1."""
    row = np.zeros(len(place))
    _, slopes = equation.slopes(values)
    for name, slope in slopes.items():
        if name in place:
            row[place[name]] = slope
    row *= sizes
    scale = np.abs(row).max(initial=0.0)
    return row / scale if scale else row


def _basis(rows: Sequence[Array], width: int) -> Array:
    """Return an orthonormal basis of the space that rows span, one basis vector a row."""
    if not rows or not width:
        return np.zeros((0, width))
    _, sizes, ways = np.linalg.svd(np.array(rows), full_matrices=False)
    return ways[sizes > RANK_RTOL * sizes.max(initial=0.0)]


def _spanned(basis: Array, row: Array) -> bool:
    """Return whether a row is a linear combination of basis vectors."""
    return bool(np.abs(row - basis.T @ (basis @ row)).max(initial=0.0) <= RESIDUAL_RTOL * np.abs(row).max(initial=0.0))


@dataclass(frozen=True, slots=True)
class Recomputed:
    """The answer that follows from the data of a solution, in the unit of the question, and the faults of the data.

    `values` has the values of all names that have one.
    """

    answer: float | None
    faults: tuple[str, ...]
    values: Mapping[str, float] = field(default_factory=dict[str, float])

    def agrees(self, answer: float, within: float) -> bool:
        """Return whether there are no faults and the answer agrees with another one `within` a relative tolerance."""
        return not self.faults and self.answer is not None and abs(self.answer - answer) <= within * abs(answer)


UNKNOWN_RTOL = 1e-13  # relative accuracy of the unknown
CONDITION_RTOL = 1e-9  # relative: largest deviation of the result, which excludes a jump at the unknown
TRIAL, CONDITION = "trial", "condition"  # roles of relations


Reader = Callable[[Mapping[str, Any]], Recomputed]


def unknown_by_trial(data: Mapping[str, Any]) -> tuple[str, float] | None:
    """Return the unknown that a solution finds by trial, with its stated value; None if there is none.

    Raises:
        TreeError: there are several.
    """
    trials = _of_role(data, TRIAL)
    if len(trials) > 1:
        raise TreeError("several unknowns are found by trial")
    return trials[0] if trials else None


def _of_role(data: Mapping[str, Any], role: str) -> list[tuple[str, float]]:
    """Return the name on the left and the value on the right of each relation with a given role."""
    relations = [relation for step in data["steps"] for relation in step["relations"] if relation["role"] == role]
    return [(str(relation["left"]), float(relation["right"])) for relation in relations]


def by_trial(data: Mapping[str, Any], unknown: tuple[str, float], read: Reader) -> Recomputed:
    """Recompute a solution whose unknown is found by trial: the value that leads to the given result.

    `read` recomputes the given result from data in which the unknown is given instead.

    Raises:
        TreeError: no result is given, or no value close to the stated one leads to it.
    """
    (name, near), conditions = unknown, _of_role(data, CONDITION)
    if len(conditions) != 1:
        raise TreeError("no single result is given that would determine the unknown")
    result, value = conditions[0]

    def excess(at: float) -> float:
        solution = read(_with(data, name, at, result))
        if result not in solution.values:
            raise TreeError(next(iter(solution.faults), f"{result} has no value"))
        return solution.values[result] - value

    ends = near * (1.0 - 1.01 * STATED_ROOT_RTOL), near * (1.0 + 1.01 * STATED_ROOT_RTOL)
    failed = f"no value of {name} near {near:.6g} leads to {result} = {value:.6g}"
    if (excess(ends[0]) > 0.0) == (excess(ends[1]) > 0.0):
        raise TreeError(failed)
    solution = zero(excess, *ends, within=UNKNOWN_RTOL)
    reached = read(_with(data, name, solution, result))
    if abs(reached.values[result] - value) > CONDITION_RTOL * abs(value):
        raise TreeError(failed)
    goal = str(data["goal"])
    if goal not in reached.values:
        raise TreeError(f"no relation speaks of {goal}")
    return replace(reached, answer=reached.values[goal] * float(data["scale"]))


def _with(data: Mapping[str, Any], name: str, value: float, goal: str) -> dict[str, Any]:
    """Return the data of the forward problem, in which the unknown is given and the result is the goal."""
    steps = [
        {**step, "relations": [held for held in step["relations"] if held["role"] not in (TRIAL, CONDITION)]}
        for step in data["steps"]
    ]
    return {
        **data,
        "steps": steps,
        "givens": {**data["givens"], name: value},
        "goal": goal,
        "scale": 1.0,
        "whole": False,
    }


COMPARISON_ROLE = "exceeds"  # role of relations whose left side is larger than the right one
STATED = "law", "derived", "result", "verified"  # roles of equations
MAX_STEPS = 1000  # most integration steps of one solution
MAX_RELATIONS = 2000  # most relations of one solution
INTEGER_ATOL = 1e-9  # largest difference between a count and an integer


def recompute(data: Mapping[str, Any]) -> Recomputed:
    """Recompute the answer of a solution from its JSON data alone, made by `sim2reason.solutions.data.as_data`.

    Givens and relations are processed in order, and phases are integrated. Every name must follow from what is stated,
    every relation must hold, and the laws must determine the goal. Faults are returned as messages, never raised.
    """
    try:
        unknown = unknown_by_trial(data)
        return _read(data) if unknown is None else by_trial(data, unknown, _read)
    except (TreeError, ArithmeticError, RecursionError) as error:
        return Recomputed(None, (str(error),))
    except (KeyError, TypeError, IndexError, ValueError) as error:
        return Recomputed(None, (f"the data is no solution: {error!r}",))


def _read(data: Mapping[str, Any]) -> Recomputed:
    """Recompute the answer of a solution without an unknown found by trial."""
    return _Recomputation(data).result()


class _Recomputation:
    """The recomputation of one solution, step by step."""

    def __init__(self, data: Mapping[str, Any]) -> None:
        self._data = data
        given = {str(name): float(number) for name, number in data["givens"].items()}
        if not all(map(isfinite, given.values())):
            raise TreeError("a given is no number")
        self._relations, self._steps = Relations(given), MAX_STEPS
        self._equations: list[Equation] = []
        self._compared: list[Equation] = []
        self._given = frozenset(given)
        self._ends: set[str] = set()
        self._needed: list[str] = [str(data["goal"])]

    def result(self) -> Recomputed:
        """Process all steps and return the answer with its faults."""
        known = self._relations
        if sum(len(step["relations"]) for step in self._data["steps"]) > MAX_RELATIONS:
            raise TreeError("there are too many relations")
        for step in self._data["steps"]:
            self._read(step)
        known.solve_linear()
        faults = [*known.faults, *(f"{name} has no value" for name in known.unknown)]
        faults += self._too_small()
        goal = self._needed[0]
        answer = known.values[goal] * float(self._data["scale"]) if goal in known.values else None
        faults += [] if answer is not None or goal in known.unknown else [f"no relation speaks of {goal}"]
        if not faults:
            faults += self._undetermined()
        if answer is not None and self._data["whole"] and abs(answer - round(answer)) > INTEGER_ATOL:
            faults.append(f"a count is {answer:.6g}")
        return Recomputed(answer, tuple(dict.fromkeys(faults)), known.values)

    def _read(self, step: Mapping[str, Any]) -> None:
        """Process the relations of a step, then its integration."""
        for relation in step["relations"]:
            left, right, role = relation["left"], relation["right"], str(relation["role"])
            check(left)
            check(right)
            if role not in (*STATED, COMPARISON_ROLE, TRIAL, CONDITION):
                raise TreeError(f"a relation has the role {role}")
            if role == COMPARISON_ROLE:
                self._compared.append(Equation.from_trees(left, right, role))
            if role in STATED:
                equation = Equation.from_trees(left, right, role)
                self._equations.append(equation)
                self._relations.add(equation)
        if step["integration"] is not None:
            self._integrate(step["integration"])

    def _integrate(self, data: Mapping[str, Any]) -> None:
        """Integrate a phase to its end; the laws must determine its initial values."""
        known = self._relations
        if known.unknown:
            known.solve_linear()
        try:
            ends, taken = integrate(data, known.values, self._steps)
        except PhaseError as error:
            known.faults.append(f"a phase can't be integrated: {error}")
            return
        self._steps -= taken
        used = {name for tree in formulas(data) for name in symbols(tree)}
        self._needed += sorted((used & known.values.keys()) - self._given - self._ends)
        self._ends |= ends.keys()
        for name, number in ends.items():
            if name in known.values:
                known.faults.append(f"{name} has two values")
            else:
                known.assign(name, number)

    def _too_small(self) -> list[str]:
        """Return messages for inequalities that the solution states and that are false."""
        messages: list[str] = []
        for inequality in self._compared:
            try:
                larger = inequality.excess(self._relations.values) > 0.0
            except UNDEFINED:
                larger = False
            messages += (
                [] if larger else [f"isn't larger: {tree_text(inequality.left)} than {tree_text(inequality.right)}"]
            )
        return messages

    def _undetermined(self) -> Sequence[str]:
        """Return messages for symbols and relations that do not follow from the laws that the solution states."""
        stated = [
            equation for equation in self._equations if equation.role != "verified" and equation.initial_guess is None
        ]
        try:
            return [*undetermined(stated, self._given | self._ends, self._relations.values, self._needed)]
        except UNDEFINED as error:
            return [f"a relation has no derivative: {error}"]

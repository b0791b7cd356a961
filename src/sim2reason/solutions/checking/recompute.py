"""Recompute the answer of a worked solution from its data alone."""

from collections.abc import Mapping, Sequence
from math import isfinite
from typing import Any

from sim2reason.solutions.checking.determination import undetermined
from sim2reason.solutions.checking.equation import Equation
from sim2reason.solutions.checking.integration import PhaseError, formulas, integrate
from sim2reason.solutions.checking.recomputed import Recomputed
from sim2reason.solutions.checking.relations import UNDEFINED, Relations
from sim2reason.solutions.checking.trees import TreeError, check, symbols, written
from sim2reason.solutions.checking.trial import CONDITION, TRIAL, by_trial, sought

COMPARED = "exceeds"  # the role of relations whose left side is the larger one
STATED = "law", "derived", "result", "verified"  # the roles of relations that are equations
STEPS = 1000  # of all integrations of a solution together
MOST = 2000  # relations
WHOLE = 1e-9  # how far a count may be from a whole number


def recompute(data: Mapping[str, Any]) -> Recomputed:
    """Work through the data of a solution, see `sim2reason.solutions.data.as_data`, as a reader would.

    Givens, relations in order, phases that are integrated; every name must follow from what is stated, every relation
    must hold, and the laws must determine the goal. Faults are said in words; none are raised.
    """
    try:
        unknown = sought(data)
        return _read(data) if unknown is None else by_trial(data, unknown, _read)
    except (TreeError, ArithmeticError, RecursionError) as error:
        return Recomputed(None, (str(error),))
    except (KeyError, TypeError, IndexError, ValueError) as error:
        return Recomputed(None, (f"the data is no solution: {error!r}",))


def _read(data: Mapping[str, Any]) -> Recomputed:
    return _Reading(data).result()


class _Reading:
    """One solution that is worked through."""

    def __init__(self, data: Mapping[str, Any]) -> None:
        self._data = data
        given = {str(name): float(number) for name, number in data["givens"].items()}
        if not all(map(isfinite, given.values())):
            raise TreeError("a given is no number")
        self._relations, self._steps = Relations(given), STEPS
        self._equations: list[Equation] = []
        self._compared: list[Equation] = []
        self._given = frozenset(given)
        self._ends: set[str] = set()
        self._needed: list[str] = [str(data["goal"])]

    def result(self) -> Recomputed:
        """Work through all steps."""
        known = self._relations
        if sum(len(step["relations"]) for step in self._data["steps"]) > MOST:
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
        if answer is not None and self._data["whole"] and abs(answer - round(answer)) > WHOLE:
            faults.append(f"a count is {answer:.6g}")
        return Recomputed(answer, tuple(dict.fromkeys(faults)), known.values)

    def _read(self, step: Mapping[str, Any]) -> None:
        """One step: its relations, then its integration."""
        for held in step["relations"]:
            left, right, role = held["left"], held["right"], str(held["role"])
            check(left)
            check(right)
            if role not in (*STATED, COMPARED, TRIAL, CONDITION):
                raise TreeError(f"a relation has the role {role}")
            if role == COMPARED:
                self._compared.append(Equation.of(left, right, role))
            if role in STATED:
                equation = Equation.of(left, right, role)
                self._equations.append(equation)
                self._relations.add(equation)
        if step["integration"] is not None:
            self._integrate(step["integration"])

    def _integrate(self, data: Mapping[str, Any]) -> None:
        """Find the end of a phase; the laws must determine what it begins with."""
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
        """Return the stated comparisons that are false, in words."""
        found: list[str] = []
        for held in self._compared:
            try:
                larger = held.excess(self._relations.values) > 0.0
            except UNDEFINED:
                larger = False
            found += [] if larger else [f"isn't larger: {written(held.left)} than {written(held.right)}"]
        return found

    def _undetermined(self) -> Sequence[str]:
        """What does not follow from the laws."""
        stated = [equation for equation in self._equations if equation.role != "verified" and equation.near is None]
        try:
            return [*undetermined(stated, self._given | self._ends, self._relations.values, self._needed)]
        except UNDEFINED as error:
            return [f"a relation has no derivative: {error}"]

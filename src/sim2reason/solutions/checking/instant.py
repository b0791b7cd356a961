"""All symbols of an integrated phase at an instant: what the state, definitions and the equations of motion give."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from sim2reason.solutions.checking.equation import Equation
from sim2reason.solutions.checking.linear import LinearSystem
from sim2reason.solutions.checking.trees import Array, EvaluateAll, TreeError, compiled_for_many


class Instant:
    """The values of all symbols of a phase, brought to one instant after another."""

    def __init__(self, data: Mapping[str, Any], known: Mapping[str, float]) -> None:
        """Separate definitions from equations of motion; TreeError if a symbol has no value."""
        coordinates = data["coordinates"]
        self.time: str = data["time"]
        self.places = [str(held["place"]) for held in coordinates]
        self.rates = [str(held["rate"]) for held in coordinates]
        self.sums = [str(held["name"]) for held in data["accumulated"]]
        unknowns = [*(str(held["acceleration"]) for held in coordinates), *map(str, data["unknowns"])]
        self.names = [self.time, *self.places, *self.rates, *self.sums, *unknowns]
        if len({*self.names}) < len(self.names):
            raise TreeError("a phase has two things of one name")
        if taken := sorted(known.keys() & {*self.names}):
            raise TreeError(f"{', '.join(taken)} has a value already")
        self.at: dict[str, float | Array] = dict(known)
        waiting = [Equation.of(held["left"], held["right"]) for held in data["equations"]]
        self._before = self._definitions(waiting, {*self.names} - {*unknowns})
        extra = self._defined_by_unknowns(waiting, unknowns)
        self._system = LinearSystem(waiting, [*unknowns, *extra])
        self._accelerations = unknowns[: len(coordinates)]
        self.solved = frozenset((*unknowns, *extra))  # the symbols whose values the equations of motion give
        self.names += [*(name for name, _ in self._before), *extra]
        left = {name for equation in waiting for name in equation.names} - known.keys() - {*self.names}
        if left:
            raise TreeError(f"{', '.join(sorted(left))} has no value in the equations of motion")

    def _definitions(self, waiting: list[Equation], state: set[str]) -> list[tuple[str, EvaluateAll]]:
        """The names that equations define by the state alone, in order; those equations wait no more."""
        found, known = list[tuple[str, EvaluateAll]](), state | self.at.keys()
        while True:
            for equation in waiting:
                name = equation.left
                if (
                    isinstance(name, str)
                    and name not in {*self.names}
                    and name not in known
                    and not equation.names - known - {name}
                ):
                    found.append((name, compiled_for_many(equation.right)))
                    known.add(name)
                    waiting.remove(equation)
                    break
            else:
                return found

    def _defined_by_unknowns(self, waiting: Sequence[Equation], unknowns: Sequence[str]) -> list[str]:
        """The further names that equations define by accelerations and forces: they are unknowns as those are."""
        known = {*self.names, *self.at, *(name for name, _ in self._before), *unknowns}
        return [str(e.left) for e in waiting if isinstance(e.left, str) and e.left not in known]

    def move(self, times: Array, states: Array) -> None:
        """Give all symbols but accelerations and forces their values at some times, (m,), in states, (m, n)."""
        self.at[self.time] = times
        self.at.update(zip((*self.places, *self.rates, *self.sums), states.T, strict=True))
        for name, evaluate in self._before:
            self.at[name] = evaluate(self.at)

    def accelerate(self) -> list[Array]:
        """Solve the equations of motion; give back the accelerations."""
        self.at.update(self._system.solve(self.at, len(np.atleast_1d(self.at[self.time]))))
        return [np.asarray(self.at[name]) for name in self._accelerations]

    def examine(self) -> None:
        """Raise ArithmeticError unless the equations of motion determine accelerations and forces at the one time."""
        self._system.examine(self.at)

"""Integration of a phase from its stated equations, initial values and end condition."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import islice, pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.polynomial.chebyshev import chebroots

from sim2reason.solutions.checking.equation import Equation, LinearSystem
from sim2reason.solutions.checking.numerical_methods import COEFFICIENTS, Piece, pieces, state_at, tail
from sim2reason.solutions.checking.relations import zero
from sim2reason.solutions.checking.trees import (
    Array,
    EvaluateAll,
    Tree,
    TreeError,
    check,
    compiled_for_many,
    symbols,
    terms,
    value,
)


class Instant:
    """The values of all symbols of a phase at one or several instants."""

    def __init__(self, data: Mapping[str, Any], known: Mapping[str, float]) -> None:
        """Separate definitions from equations of motion; TreeError if a symbol has no value."""
        coordinates = data["coordinates"]
        self.time: str = data["time"]
        self.places = [str(entry["place"]) for entry in coordinates]
        self.rates = [str(entry["rate"]) for entry in coordinates]
        self.sums = [str(entry["name"]) for entry in data["accumulated"]]
        unknowns = [*(str(entry["acceleration"]) for entry in coordinates), *map(str, data["unknowns"])]
        self.names = [self.time, *self.places, *self.rates, *self.sums, *unknowns]
        if len({*self.names}) < len(self.names):
            raise TreeError("a phase has two things of one name")
        if taken := sorted(known.keys() & {*self.names}):
            raise TreeError(f"{', '.join(taken)} has a value already")
        self.at: dict[str, float | Array] = dict(known)
        waiting = [Equation.from_trees(entry["left"], entry["right"]) for entry in data["equations"]]
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
        """Return symbols with their formulas in terms of the state, in order of evaluation; remove their equations."""
        definitions, known = list[tuple[str, EvaluateAll]](), state | self.at.keys()
        while True:
            for equation in waiting:
                name = equation.left
                if (
                    isinstance(name, str)
                    and name not in {*self.names}
                    and name not in known
                    and not equation.names - known - {name}
                ):
                    definitions.append((name, compiled_for_many(equation.right)))
                    known.add(name)
                    waiting.remove(equation)
                    break
            else:
                return definitions

    def _defined_by_unknowns(self, waiting: Sequence[Equation], unknowns: Sequence[str]) -> list[str]:
        """Return further symbols defined by accelerations and forces, to be solved for together with them."""
        known = {*self.names, *self.at, *(name for name, _ in self._before), *unknowns}
        return [str(e.left) for e in waiting if isinstance(e.left, str) and e.left not in known]

    def move(self, times: Array, states: Array) -> None:
        """Set all symbols except accelerations and forces at several times, (m,), and states, (m, n)."""
        self.at[self.time] = times
        self.at.update(zip((*self.places, *self.rates, *self.sums), states.T, strict=True))
        for name, evaluate in self._before:
            self.at[name] = evaluate(self.at)

    def accelerate(self) -> list[Array]:
        """Solve the equations of motion and return the accelerations."""
        self.at.update(self._system.solve(self.at, len(np.atleast_1d(self.at[self.time]))))
        return [np.asarray(self.at[name]) for name in self._accelerations]

    def examine(self) -> None:
        """Raise ArithmeticError unless the equations of motion determine accelerations and forces at the instant."""
        self._system.examine(self.at)


SMOOTHNESS_RTOL, SMOOTHNESS_ATOL = (
    1e-8,
    1e-14,
)  # largest final Chebyshev coefficients of a condition: relative, absolute
TRIM_RTOL, REAL_ROOT_ATOL = (
    1e-13,
    1e-6,
)  # relative: smallest coefficient that counts; largest imaginary part of a real root
INITIAL_ZERO_RTOL = 1e-9  # relative to the largest coefficient of a condition in the first step: a zero at the start
MIN_ZERO_GAP, MIN_GAP_AFTER_START = (
    1e-9,
    1e-4,
)  # fractions of a step with untrusted signs: between zeros, after one at the start
CONDITION_RTOL = 1e-12  # relative to the largest term of a condition: the sign of smaller values is not trusted
MAX_UNKNOWNS, MAX_OCCURRENCES = 40, 10_000  # most coordinates or unknowns; most occurrences of an event
ENDLESS = "a phase does not come to the end that is stated"


class PhaseError(ValueError):
    """An error raised for a phase that cannot be integrated or does not end; the message has the reason."""


class Sample(NamedTuple):
    """A time, in s, and the value of the end condition at it."""

    time: float
    excess: float


def integrate(data: Mapping[str, Any], known: Mapping[str, float], steps: int) -> tuple[dict[str, float], int]:
    """Integrate a phase; return the values at its end, by the names that later steps use, and the number of steps.

    Args:
        data: the `Integration` of a step as JSON values.
        known: the values of the names known before the phase.
        steps: the largest number of steps.

    Raises:
        PhaseError: something is not stated, the equations do not determine the motion, or it does not end.
    """
    try:
        _check(data)
        with np.errstate(all="ignore"):
            return _Phase(data, known).run(steps)
    except KeyError as error:
        raise PhaseError(f"{error.args[0]} has no value") from error
    except (ArithmeticError, ValueError) as error:
        raise PhaseError(str(error)) from error


def _check(data: Mapping[str, Any]) -> None:
    """Raise TreeError if a phase is too large or contains an invalid tree."""
    if max(len(data[part]) for part in ("coordinates", "unknowns", "equations", "accumulated", "ends")) > MAX_UNKNOWNS:
        raise TreeError("a phase is too large")
    if not data["coordinates"] and not data["accumulated"]:
        raise TreeError("there is nothing to integrate")
    for tree in formulas(data):
        check(tree)


PARTS = {
    "equations": ("left", "right"),
    "coordinates": ("initial_place", "initial_rate"),
    "accumulated": ("rate", "initial"),
}  # fields of a phase that contain formulas


def formulas(data: Mapping[str, Any]) -> Iterator[Tree]:
    """Yield all formulas in the data of a phase, as prefix trees."""
    yield data["begin"]
    yield data["until"]["expression"]
    for part, names in PARTS.items():
        for entry in data[part]:
            yield from (entry[name] for name in names)


class _Phase:
    """The integration of one phase up to its end."""

    def __init__(self, data: Mapping[str, Any], known: Mapping[str, float]) -> None:
        self._instant, self._ends = Instant(data, known), data["ends"]
        coordinates, sums, until = data["coordinates"], data["accumulated"], data["until"]
        starts = [entry["initial_place"] for entry in coordinates] + [entry["initial_rate"] for entry in coordinates]
        starts += [entry["initial"] for entry in sums]
        self._start = np.array([value(tree, known) for tree in starts])
        self._begin = value(data["begin"], known)
        self._flows = [compiled_for_many(entry["rate"]) for entry in sums]
        self._direction, self._occurrence = int(until["direction"]), int(until["occurrence"])
        if not 1 <= self._occurrence <= MAX_OCCURRENCES or self._direction not in (-1, 0, 1):
            raise TreeError("the end of a phase has no such occurrence or direction")
        self._condition = compiled_for_many(until["expression"])
        self._needs_forces = not self._instant.solved.isdisjoint(symbols(until["expression"]))
        self._terms = [compiled_for_many(term) for term in terms(until["expression"])]
        self._held: list[Piece] = []  # the last two pieces

    def _slope(self, times: Array, states: Array) -> Array:
        """Return the time derivatives, (m, n), of coordinates, rates and integrals."""
        instant, count = self._instant, len(self._instant.places)
        instant.move(times, states)
        derivatives = np.empty_like(states)
        derivatives[:, :count] = states[:, count : 2 * count]
        for number, acceleration in enumerate(instant.accelerate()):
            derivatives[:, count + number] = acceleration
        for number, flow in enumerate(self._flows):
            derivatives[:, 2 * count + number] = flow(instant.at)
        return derivatives

    def _excess(self, times: Array, states: Array) -> Array:
        """Return the values of the end condition, (m,), at several instants."""
        self._instant.move(times, states)
        if self._needs_forces:
            self._instant.accelerate()
        return np.asarray(self._condition(self._instant.at)) * np.ones(len(times))

    def _excess_at(self, time: float) -> float:
        return float(self._excess(np.array([time]), self._state(time))[0])

    def _piece(self, time: float) -> Piece:
        """Return the integration step, the last one or the one before it, that contains a time."""
        return self._held[-1] if time >= self._held[-1].begin else self._held[0]

    def _state(self, time: float) -> Array:
        """Return the state at a time in one of the last two integration steps, (1, n)."""
        return self._piece(time).state(time)[None]

    def _fits(self, piece: Piece) -> bool:
        """Return whether the end condition is a polynomial within a step, to the accuracy needed."""
        values = self._excess(piece.times, piece.states)
        return bool(tail(values[:, None])[0] <= SMOOTHNESS_RTOL * np.abs(values).max() + SMOOTHNESS_ATOL)

    def run(self, steps: int) -> tuple[dict[str, float], int]:
        """Integrate until the end condition has crossed zero as often as stated; return end values and step count."""
        count = len(self._instant.places)
        self._slope(np.array([self._begin]), self._start[None])
        self._instant.examine()
        walk = pieces(self._slope, self._begin, self._start, count, self._fits)
        zeros, before = self._occurrence, None
        for taken, piece in enumerate(islice(walk, steps), 1):
            self._held = [*self._held[-1:], piece]
            for sample in self._between_zeros(piece, first=taken == 1):
                if before is not None and (sample.excess > 0.0) != (before.excess > 0.0):
                    zeros -= self._direction in (0, np.sign(sample.excess))
                    if not zeros:
                        return self._found(zero(self._excess_at, before.time, sample.time)), taken
                before = sample
        raise TreeError(ENDLESS)

    def _between_zeros(self, piece: Piece, *, first: bool) -> Iterator[Sample]:
        """Yield one sample of the end condition between every two of its zeros in a step."""
        coefficients = COEFFICIENTS @ self._excess(piece.times, piece.states)
        large = np.abs(coefficients).max()
        if not np.isfinite(large):
            raise TreeError(ENDLESS)
        if not large:
            return
        kept = np.nonzero(np.abs(coefficients) > TRIM_RTOL * large)[0][-1] + 1
        roots = chebroots(coefficients[:kept]) if kept > 1 else np.empty(0)
        inside = np.sort(roots[(np.abs(roots.imag) < REAL_ROOT_ATOL) & (np.abs(roots.real) < 1.0)].real)
        resting = first and abs(self._excess_at(piece.begin)) <= INITIAL_ZERO_RTOL * large
        shortest = MIN_GAP_AFTER_START if resting else MIN_ZERO_GAP
        for one, other in pairwise([-1.0, *map(float, inside), 1.0]):
            time = piece.begin + 0.25 * piece.length * (one + other + 2.0)
            excess = self._excess_at(time)
            if other - one > shortest and abs(excess) > CONDITION_RTOL * self._largest_term():
                yield Sample(time, excess)

    def _largest_term(self) -> float:
        """Return the magnitude of the largest term of the end condition at the last instant evaluated."""
        return max(abs(float(np.ravel(term(self._instant.at))[0])) for term in self._terms)

    def _found(self, time: float) -> dict[str, float]:
        """Return the values at the end of the phase by the names that later steps use."""
        state = state_at(self._slope, self._piece(time), time, len(self._instant.places))
        self._slope(np.array([time]), state[None])
        self._instant.examine()
        return {str(name): float(np.ravel(self._instant.at[str(symbol)])[0]) for symbol, name in self._ends}

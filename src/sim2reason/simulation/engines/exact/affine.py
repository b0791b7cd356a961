"""Detection of recorded results that are affine functions of the inputs, with exact rational coefficients.

The equations of springs along fixed lines, dashpots and constant forces are affine. The result is a proof and is free
of round-off: numerical differences of very unequal numbers, as for a stiff and a soft spring, would lose digits.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.scenes.dsl.state import Array
from sim2reason.scenes.dsl.vectors import Number
from sim2reason.simulation.engines.exact.eigenpairs import Complex, eigenpairs
from sim2reason.simulation.engines.exact.tape import Symbol, Tape

Affine = dict[int, Fraction]
"""Nonzero coefficients by the index of the input; the key −1 holds the constant term."""
CONSTANT_KEY = -1  # key of the constant term
TIME_INDEX = 0  # index of the input that is the time


@dataclass(frozen=True)
class LinearEquations:
    """Accelerations and event functions, affine in the state x = (q, q̇), (2n,): base + slopes · x."""

    base: list[Fraction]  # (n,)
    slopes: list[list[Fraction]]  # (n, 2n)
    margins: Array  # of the event functions, (m, 2n)

    @property
    def damped(self) -> bool:
        """Return whether any acceleration depends on a velocity."""
        n = len(self.base)
        return any(part for row in self.slopes for part in row[n:])

    @cached_property
    def squares(self) -> tuple[Complex, Complex]:
        """Return the squared angular frequencies, 1/s², and the mode shapes of undamped equations."""
        n = len(self.base)
        return eigenpairs([[-part for part in row[:n]] for row in self.slopes])

    def accelerations(self, values: Sequence[float]) -> Array:
        """Return the accelerations (n,) at coordinates and rates (2n,), computed exactly and then rounded."""
        x = [Fraction(value) for value in values]
        totals = zip(self.base, self.slopes, strict=True)
        return np.array([float(base + sum(map(_times, row, x), Fraction())) for base, row in totals])


def linear_equations(tape: Tape, accelerations: Sequence[Number], margins: Sequence[Number]) -> LinearEquations | None:
    """Return accelerations and event functions in affine form; None if one is not affine or depends on time."""
    coefficients = _coefficients(tape, [*accelerations, *margins])
    if coefficients is None or any(TIME_INDEX in each for each in coefficients):
        return None
    n, width = len(accelerations), len(tape.names) - 1
    rows = [[each.get(number + 1, Fraction()) for number in range(width)] for each in coefficients]
    slopes = np.array([[float(part) for part in row] for row in rows[n:]]).reshape(len(margins), width)
    return LinearEquations([each.get(CONSTANT_KEY, Fraction()) for each in coefficients[:n]], rows[:n], slopes)


def _times(one: Fraction, other: Fraction) -> Fraction:
    return one * other if one else one


def _coefficients(tape: Tape, numbers: Sequence[Number]) -> list[Affine] | None:
    known: dict[int, Affine | None] = {}
    for number in sorted(_needed(tape, numbers)):
        known[number] = _of_node(tape, number, known)
    forms = [known[n.id] if isinstance(n, Symbol) else {CONSTANT_KEY: Fraction(float(n))} for n in numbers]
    affine = [each for each in forms if each is not None]
    return affine if len(affine) == len(forms) else None


def _needed(tape: Tape, numbers: Sequence[Number]) -> set[int]:
    """Return the indices of all tape nodes on which the given numbers depend, directly or not."""
    waiting, visited = [number.id for number in numbers if isinstance(number, Symbol)], set[int]()
    while waiting:
        number = waiting.pop()
        if number not in visited:
            visited.add(number)
            operation, a, b = tape.nodes[number]
            if operation not in ("input", "constant"):
                waiting += [a] if b < 0 else [a, b]
    return visited


def _of_node(tape: Tape, number: int, known: dict[int, Affine | None]) -> Affine | None:
    """Return the affine coefficients of a node from those of its operands; None if the node is not affine."""
    operation, a, b = tape.nodes[number]
    if operation == "input":
        return {a: Fraction(1)}
    if operation == "constant":
        return {CONSTANT_KEY: Fraction(tape.constants[a])}
    one, other = known[a], known[b] if b >= 0 else {}
    return _result(operation, one, other) if one is not None and other is not None else None


def _result(operation: str, one: Affine, other: Affine) -> Affine | None:
    match operation:
        case "+" | "-":
            return _sum(one, other if operation == "+" else _scaled(other, Fraction(-1)))
        case "neg":
            return _scaled(one, Fraction(-1))
        case "*" if _is_constant(one) or _is_constant(other):
            number, factor = (other, one) if _is_constant(one) else (one, other)
            return _scaled(number, factor.get(CONSTANT_KEY, Fraction()))
        case "/" if _is_constant(other) and other:
            return _scaled(one, 1 / other[CONSTANT_KEY])
        case _:
            return None


def _is_constant(one: Affine) -> bool:
    return not one.keys() - {CONSTANT_KEY}


def _sum(one: Affine, other: Affine) -> Affine:
    total = {key: one.get(key, Fraction()) + other.get(key, Fraction()) for key in one.keys() | other.keys()}
    return {key: part for key, part in total.items() if part}


def _scaled(one: Affine, factor: Fraction) -> Affine:
    return {key: part * factor for key, part in one.items()} if factor else {}

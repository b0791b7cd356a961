"""Event functions of a contact mode, each zero at its event, and the code that evaluates them."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.exact.affine import LinearEquations
from sim2reason.simulation.engines.exact.dop853 import Rate
from sim2reason.simulation.engines.exact.native import core
from sim2reason.simulation.engines.exact.tape import ArrayMaths

ZERO_COEFFICIENT_TOL = 1e-12  # smaller coefficients count as zero
MAX_CONDITIONS = 4000  # largest number of combined conditions


class Condition(NamedTuple):
    """A linear condition base + Σ part·z ≥ least on free forces z, with the conditions that it combines, by index."""

    base: float
    parts: tuple[float, ...]
    of: frozenset[int]


def maximize_least(bases: Sequence[float], parts: Sequence[Sequence[float]]) -> tuple[float, frozenset[int]]:
    """Return the maximum over z of the least base + Σ parts·z, inf if unbounded, and the indices of the limiting terms.

    Fourier–Motzkin elimination: any two conditions in which a free force has opposite signs combine, with weights of
    sum 1, into one without it.
    """
    conditions = [Condition(b, tuple(p), frozenset({i})) for i, (b, p) in enumerate(zip(bases, parts, strict=True))]
    for index in range(len(parts[0]) if parts else 0):
        rising = [one for one in conditions if one.parts[index] > ZERO_COEFFICIENT_TOL]
        falling = [one for one in conditions if one.parts[index] < -ZERO_COEFFICIENT_TOL]
        kept = [one for one in conditions if abs(one.parts[index]) <= ZERO_COEFFICIENT_TOL]
        conditions = [*kept, *(_combined(one, other, index) for one in rising for other in falling)][:MAX_CONDITIONS]
    smallest = min(conditions, key=lambda one: one.base, default=Condition(float("inf"), (), frozenset()))
    return smallest.base, smallest.of


def _combined(one: Condition, other: Condition, index: int) -> Condition:
    up, down = one.parts[index], -other.parts[index]
    first, second = down / (up + down), up / (up + down)
    parts = tuple(first * a + second * b for a, b in zip(one.parts, other.parts, strict=True))
    return Condition(first * one.base + second * other.base, parts, one.of | other.of)


class Margin(NamedTuple):
    """An event function: the distance, force or time that remains until an event.

    kind: ``spare`` of an idle row · ``force`` of an acting row · ``normal`` force of a contact · ``slip`` speed of a
    sliding contact · ``grip`` of a sticking contact, on a side · ``gap`` of a collision pair · ``reach`` of a straight
    line segment · ``limit`` of a coordinate · ``burn`` time of an engine · ``border`` of a region, of a force, on a
    side · ``brace``: all margins of undetermined forces.
    """

    kind: str
    number: int  # of the row, contact, rough contact, pair, segment, limit, engine, force or half spring
    side: int = 0  # the direction in which a contact begins to slip, or the border of a region


class StopReason(NamedTuple):
    """The duration of a contact mode and the event functions that end it; none if the requested time was reached."""

    elapsed: float
    due: tuple[Margin, ...]


ENDS = frozenset({"reach", "limit", "normal"})
"""The kinds of event functions whose events end the simulated motion."""


@dataclass(frozen=True)
class Formulas:
    """The generated code of one contact mode: rates for the integrator, forces for samples, event functions.

    If the motion leaves forces undetermined, the conditions on them are `braced`: they count as one margin, the last
    one, which states how well all can be met at once.
    """

    rate: Rate
    write_forces: Callable[[], Callable[[Any], Callable[..., tuple[Any, ...]]]]  # generated on demand
    code: Callable[..., tuple[float, ...]]  # of margins, then of the values and changes of braced margins
    watched: tuple[Margin, ...]
    held: Callable[..., tuple[float, ...]] | None  # violation of the acting rows, if constraints are redundant
    passing: tuple[int, ...]  # the indices of margins of straight segments whose ends may pass each other
    closing: Callable[..., tuple[float, ...]]  # Δr·Δv of these, then the distances
    cost: int  # operations of an attempted step
    find_linear: Callable[[], LinearEquations | None]
    braced: tuple[Margin, ...] = ()

    @cached_property
    def _force_code(self) -> Callable[..., tuple[Any, ...]]:
        return self.write_forces()(ArrayMaths if core is None else math)

    def forces(self, times: Array, values: Array) -> Array:
        """Return accelerations, constraint, normal and friction forces, (k, m), at times (m,) and values (m, 2n).

        Their code is generated on demand. Where a force has no value, it is infinite or NaN.
        """
        if core is not None and isinstance(self._force_code, core.Program):
            found = np.empty((self._force_code.outputs, len(times)))
            self._force_code.sample(np.ascontiguousarray(times), np.ascontiguousarray(values), found)
            return found
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            columns = self._force_code(times, tuple(values.T))
        found = np.empty((len(columns), len(times)))
        for number, column in enumerate(columns):
            found[number] = column
        return found

    @cached_property
    def linear(self) -> LinearEquations | None:
        """Return the equations in linear form; None if they are nonlinear or leave forces undetermined."""
        return None if self.braced or self.held else self.find_linear()

    def margins(self, time: float, values: Sequence[float]) -> tuple[float, ...]:
        """Return all event functions in the order of `watched`."""
        outputs = self.code(time, values)
        return (*outputs[: len(self.watched) - 1], self._brace(outputs)[0]) if self.braced else outputs

    def due(self, margin: Margin, time: float, values: Sequence[float]) -> tuple[Margin, ...]:
        """Return the event functions that are zero; several if `margin` combines those of undetermined forces."""
        if margin.kind != "brace":
            return (margin,)
        return tuple(self.braced[i] for i in sorted(self._brace(self.code(time, values))[1]))

    def _brace(self, found: tuple[float, ...]) -> tuple[float, frozenset[int]]:
        first, count = len(self.watched) - 1, len(self.braced)
        bases, parts = found[first : first + count], found[first + count :]
        width = len(parts) // count
        return maximize_least(bases, [parts[i * width : (i + 1) * width] for i in range(count)])

"""Margins that an engine watches while a mode lasts, and the code that evaluates them."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from sim2reason.base.lazy import cached_property
from sim2reason.simulation.engines.exact.affine import LinearEquations
from sim2reason.simulation.engines.exact.dop853 import Rate

FAINT = 1e-12  # a part that is none
MOST = 4000  # combinations that are followed


class Condition(NamedTuple):
    """base + Σ part·z ≥ least, and which of the given conditions were combined into it."""

    base: float
    parts: tuple[float, ...]
    of: frozenset[int]


def greatest_least(bases: Sequence[float], parts: Sequence[Sequence[float]]) -> tuple[float, frozenset[int]]:
    """Return the greatest value, over all z, of the least margin, and which margins set it; infinity if nothing does.

    Fourier and Motzkin's elimination: any two conditions in which a free force has opposite signs combine, with
    weights of sum 1, into one without it.
    """
    found = [Condition(b, tuple(p), frozenset({i})) for i, (b, p) in enumerate(zip(bases, parts, strict=True))]
    for place in range(len(parts[0]) if parts else 0):
        rising = [one for one in found if one.parts[place] > FAINT]
        falling = [one for one in found if one.parts[place] < -FAINT]
        kept = [one for one in found if abs(one.parts[place]) <= FAINT]
        found = [*kept, *(_combined(one, other, place) for one in rising for other in falling)][:MOST]
    least = min(found, key=lambda one: one.base, default=Condition(float("inf"), (), frozenset()))
    return least.base, least.of


def _combined(one: Condition, other: Condition, place: int) -> Condition:
    up, down = one.parts[place], -other.parts[place]
    first, second = down / (up + down), up / (up + down)
    parts = tuple(first * a + second * b for a, b in zip(one.parts, other.parts, strict=True))
    return Condition(first * one.base + second * other.base, parts, one.of | other.of)


class Margin(NamedTuple):
    """What is left until something happens.

    kind: ``spare`` of an idle row · ``force`` of a row that acts · ``normal`` force of a contact · ``slip`` speed of
    one that slides · ``grip`` of one that sticks, on a side · ``gap`` of a meeting · ``reach`` of a straight piece of
    line · ``limit`` of a coordinate · ``burn`` time of an engine · ``border`` of a region, of a force, on a side ·
    ``brace``: all margins of forces that the motion leaves open.
    """

    kind: str
    number: int  # of the row, contact, rough contact, meeting, run, limit, engine, force or half spring
    side: int = 0  # to which a contact begins to slip; which border of a region


class StopReason(NamedTuple):
    """How long a mode lasted, and what is due then; nothing if it lasted as long as was asked for."""

    elapsed: float
    due: tuple[Margin, ...]


ENDS = frozenset({"reach", "limit", "normal"})
"""What ends the motion that is described."""


@dataclass(frozen=True)
class Formulas:
    """The code of one mode: rates for the integrator, all forces for samples, margins.

    Where the motion leaves forces open, the conditions that they must meet are `braced`: they count as one margin,
    the last one, which tells how well all can be met at once.
    """

    rate: Rate
    write_forces: Callable[[], Callable[[Any], Callable[..., tuple[Any, ...]]]]  # of `math` or `numpy`, if it is asked
    code: Callable[..., tuple[float, ...]]  # of margins, then of what braced ones are and how they change
    watched: tuple[Margin, ...]
    held: Callable[..., tuple[float, ...]] | None  # by how much rows that act are off, if something is held twice
    passing: tuple[int, ...]  # the margins of straight pieces whose ends may pass each other aside
    closing: Callable[..., tuple[float, ...]]  # Δr·Δv of these, then themselves
    cost: int  # operations of a step that is tried
    find_linear: Callable[[], LinearEquations | None]
    braced: tuple[Margin, ...] = ()

    @cached_property
    def sampled_forces(self) -> Callable[..., tuple[Any, ...]]:
        """For arrays of samples: a, rows, normal, friction. Few motions are asked for them."""
        return self.write_forces()(np)

    @cached_property
    def linear(self) -> LinearEquations | None:
        """Return the equations in linear form; None if they are nonlinear or leave forces undetermined."""
        return None if self.braced or self.held else self.find_linear()

    def margins(self, time: float, values: Sequence[float]) -> tuple[float, ...]:
        """Return all margins, in the order of `watched`."""
        found = self.code(time, values)
        return (*found[: len(self.watched) - 1], self._brace(found)[0]) if self.braced else found

    def due(self, margin: Margin, time: float, values: Sequence[float]) -> tuple[Margin, ...]:
        """Return what a margin that is used up stands for."""
        if margin.kind != "brace":
            return (margin,)
        return tuple(self.braced[i] for i in sorted(self._brace(self.code(time, values))[1]))

    def _brace(self, found: tuple[float, ...]) -> tuple[float, frozenset[int]]:
        first, count = len(self.watched) - 1, len(self.braced)
        bases, parts = found[first : first + count], found[first + count :]
        width = len(parts) // count
        return greatest_least(bases, [parts[i * width : (i + 1) * width] for i in range(count)])

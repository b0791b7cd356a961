"""What one mode of a mechanism whose equations change is followed by: the code that is written for it."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from sim2reason.lazy import cached_property
from sim2reason.simulation.engines.exact.affine import LinearEquations
from sim2reason.simulation.engines.exact.bracing import greatest_least
from sim2reason.simulation.engines.exact.dop853 import Rate
from sim2reason.simulation.engines.exact.margins import Margin


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
        """All margins, in the order of `watched`."""
        found = self.code(time, values)
        return (*found[: len(self.watched) - 1], self._brace(found)[0]) if self.braced else found

    def due(self, margin: Margin, time: float, values: Sequence[float]) -> tuple[Margin, ...]:
        """What a margin that is used up stands for."""
        if margin.kind != "brace":
            return (margin,)
        return tuple(self.braced[i] for i in sorted(self._brace(self.code(time, values))[1]))

    def _brace(self, found: tuple[float, ...]) -> tuple[float, frozenset[int]]:
        first, count = len(self.watched) - 1, len(self.braced)
        bases, parts = found[first : first + count], found[first + count :]
        width = len(parts) // count
        return greatest_least(bases, [parts[i * width : (i + 1) * width] for i in range(count)])

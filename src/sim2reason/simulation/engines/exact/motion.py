"""A motion as the exact engine finds it: pieces between events, of constant acceleration or integrated."""

from dataclasses import dataclass
from functools import cached_property
from math import nan

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.simulation.engines.exact.balance import Balance
from sim2reason.simulation.engines.exact.flow import Flow, sampled
from sim2reason.simulation.engines.exact.lengths import RowKind
from sim2reason.simulation.engines.exact.linear import Row
from sim2reason.simulation.trace import Event


@dataclass(slots=True)
class Segment:
    """From `start` on one mode: q + vτ + aτ²/2 with constant multipliers (NaN where they are not determined).

    Where the equations change `flow` has the motion and the forces, and the rest only says how it begins.
    """

    start: float  # s
    q: Row  # (n,), at the start of the segment
    v: Row
    found: Balance
    kinds: tuple[RowKind, ...]
    flow: Flow | None = None

    @property
    def a(self) -> Row:
        """Accelerations at the start of the segment."""
        return self.found.a

    @property
    def tension(self) -> Row:
        """The forces of the rows at the start of the segment, N."""
        return self.found.rows

    @property
    def normal(self) -> Row:
        """Normal forces at the start of the segment, N."""
        return self.found.normal

    @property
    def friction(self) -> Row:
        """Friction forces at the start of the segment, N."""
        return self.found.friction


@dataclass(frozen=True)
class Motion:
    """Segments in order of time, the events between them, and where and why it ends."""

    mechanism: Mechanism
    segments: tuple[Segment, ...]
    events: tuple[Event, ...]
    end: float  # s
    cut: str = ""  # the kind of the event that ended it early

    @cached_property
    def _widths(self) -> tuple[int, int, int]:
        """How many coordinates, lines that are rows, and contacts there are."""
        mechanism = self.mechanism
        return len(mechanism.coordinates), len(mechanism.constraints), len(mechanism.faces)

    @cached_property
    def _starts(self) -> Array:
        """Of the segments, s."""
        return np.array([segment.start for segment in self.segments])

    @cached_property
    def _table(self) -> Array:
        """A row for each segment: q, v, a, forces of lines, normal forces, friction."""
        lines = self._widths[1]
        rows = [
            (*s.q, *s.v, *s.found.a, *s.found.rows[:lines], *s.found.normal, *s.found.friction) for s in self.segments
        ]
        return np.array(rows)

    @cached_property
    def knots(self) -> Array:
        """The instants between which everything is smooth and simple: beginnings of segments and of steps, s."""
        found = [segment.start for segment in self.segments]
        found += [step.time for segment in self.segments if segment.flow for step in segment.flow.steps]
        return np.unique([*found, self.end])

    def state(self, times: Array) -> State:
        """The motion at any times ≥ 0, s, shape (m,); after the end the last segment just goes on."""
        starts = self._starts
        at = np.maximum(np.searchsorted(starts, times, side="right") - 1, 0)
        n, lines, faces = self._widths
        table = self._table[at]
        since = (times - starts[at])[:, None]
        q0, v0, a = table[:, :n], table[:, n : 2 * n], table[:, 2 * n : 3 * n]
        gained = since * a
        q, v = q0 + since * (v0 + 0.5 * gained), v0 + gained
        forces = table[:, 3 * n :].T
        for number, segment in enumerate(self.segments):
            if segment.flow is not None and segment.flow.steps:
                here = at == number
                if here.any():
                    self._fill(segment, times[here], here, (q, v, a, forces))
        contacts = list(self.mechanism.contacts)
        names = [line.name for line in self.mechanism.constraints]
        tension = dict(zip(names, forces[:lines], strict=True))
        return State(
            mechanism=self.mechanism,
            times=times,
            q=q,
            v=v,
            a=a,
            constraint_tension=tension,
            normal=dict(zip(contacts, forces[lines : lines + faces], strict=True)),
            friction=dict(zip(contacts, forces[lines + faces :], strict=True)),
        )

    def _fill(
        self, segment: Segment, times: Array, here: np.ndarray, arrays: tuple[Array, Array, Array, Array]
    ) -> None:
        """What an integrated segment has at some times."""
        flow, (n, lines, _) = segment.flow, self._widths
        assert flow is not None
        within = np.minimum(times, flow.time)
        values = sampled(flow, within)
        with np.errstate(divide="ignore", invalid="ignore"):  # what has no value is not a number
            found = flow.formulas.sampled_forces(within, list(values.T))
        columns = np.empty((len(found), len(within)))
        for number, column in enumerate(found):
            columns[number] = column
        q, v, a, forces = arrays
        q[here], v[here], a[here] = values[:, :n], values[:, n:], columns[:n].T
        rows = columns[n : n + len(segment.kinds)][:lines]
        found_forces = np.concatenate([rows, columns[n + len(segment.kinds) :]])
        known = [*segment.found.rows[:lines], *segment.found.normal, *segment.found.friction]
        found_forces[np.isnan(known)] = nan
        forces[:, here] = found_forces

"""The recorded motion between events, and the log of events."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from math import nan
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from sim2reason.base.records import cached_property
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array, Dynamics, State
from sim2reason.simulation.engines.exact.balance import Balance
from sim2reason.simulation.engines.exact.flow import Flow, sampled
from sim2reason.simulation.engines.exact.lengths import RowKind
from sim2reason.simulation.engines.exact.linear import ContactMode, RoughContact, Row
from sim2reason.simulation.engines.exact.native import core
from sim2reason.simulation.engines.exact.native_flow import NativeFlow
from sim2reason.simulation.trace import EVENT_KINDS, Event, sorted_unique

if TYPE_CHECKING:
    from sim2reason.simulation.engines.exact.core import _core

REPEATED_IMPACT_TIME = 5e-3  # s; repeated impacts of one body, or jerks of one string, within this time end the motion
DUPLICATE_WINDOW = 8  # latest events that are compared to avoid duplicates
SIMULTANEITY_TOL = 1e-11  # s; events closer than this are simultaneous
BEGINS = {"string": "taut", "prop": "land", "foot": "land"}  # kind of the event at which a constraint begins to act
STOPS = {"string": "slack", "prop": "leave", "foot": "leave"}  # kind of the event at which a constraint ceases to act
ORDER = {kind: place for place, kind in enumerate(EVENT_KINDS)}  # rank of simultaneous events


Hits = dict[str, tuple[float, tuple[str, ...]]]
"""The time and the subjects of the last hit of each body, or jerk of each row."""
LogState = tuple[list[Event], int, str, Hits]
"""The list of events and their number, the kind of the last one if it ended the motion, and the last hits."""


class EventLog:
    """The events of a motion, the last impact of each body, and the kind of the event that ended the motion."""

    def __init__(self, mechanism: Mechanism) -> None:
        """Start with no events."""
        self._mechanism = mechanism
        self.events: list[Event] = []
        self.cut = ""
        self._hits: Hits = {}

    @property
    def state(self) -> LogState:
        """Return what `restore` takes to return to the present state."""
        return self.events, len(self.events), self.cut, self._hits

    def restore(self, state: LogState) -> None:
        """Return to an earlier state."""
        events, count, self.cut, self._hits = state
        self.events = events[:count]

    def record(self, time: float, kind: str, *subjects: str) -> None:
        """Record an event unless it is already recorded, since a body may enter several regions at one instant.

        Collisions are always recorded, since two bodies that touch others may collide more than once at an instant.
        """
        event = Event(time, kind, subjects)
        if kind == "collision" or event not in self.events[-DUPLICATE_WINDOW:]:
            self.events.append(event)

    def end(self, time: float, kind: str, *subjects: str) -> None:
        """Record an event that ends the motion."""
        self.record(time, kind, *subjects)
        self.cut = self.cut or kind

    def lift(self, time: float, contacts: Iterable[int]) -> None:
        """Record that bodies leave their faces, which ends the motion."""
        for number in contacts:
            self.end(time, "lift", self._mechanism.faces[number].subject)

    def record_impact(self, time: float, names: Iterable[str], subjects: tuple[str, ...]) -> None:
        """Store the time and subjects of an impact on the named bodies or rows."""
        self._hits = self._hits | dict.fromkeys(names, (time, subjects))  # a new one, as `state` has the old one

    def previous_impact_time(self, time: float, names: Iterable[str]) -> float | None:
        """End the motion at the previous impact if one of `names` is struck again too soon; return its time, else None.

        Alternating impacts could continue without end.
        """
        recent = [self._hits[name] for name in names if name in self._hits]
        early = min((hit for hit in recent if SIMULTANEITY_TOL < time - hit[0] < REPEATED_IMPACT_TIME), default=None)
        if early is None:
            return None
        self.events = [event for event in self.events if event.time <= early[0]]
        self.end(early[0], "crowd", *early[1])
        return early[0]

    def record_jerks(self, time: float, kinds: list[RowKind], rows: Iterable[int]) -> None:
        """Record the constraints that became tight with a jerk."""
        for number in sorted(rows):
            self.record(time, BEGINS[kinds[number].kind], kinds[number].name)

    def changed(
        self, time: float, kinds: list[RowKind], modes: tuple[ContactMode, ContactMode], rows: set[int], *, first: bool
    ) -> None:
        """Record the constraints that begin or cease to act between two modes; those in `rows` with a jerk."""
        before, after = modes
        for number, kind in enumerate(kinds):
            if kind.both:
                continue
            if number in rows or (after.acting[number] and not before.acting[number]):
                self.record(time, BEGINS[kind.kind], kind.name)
            elif before.acting[number] and not after.acting[number] and not first:
                self.record(time, STOPS[kind.kind], kind.name)

    def record_friction_changes(
        self, time: float, grips: tuple[RoughContact, ...], modes: tuple[ContactMode, ContactMode]
    ) -> None:
        """Record the contacts that begin to stick or to slip."""
        for grip, was, now in zip(grips, modes[0].rubbing, modes[1].rubbing, strict=True):
            if was != now:
                self.record(time, "slip" if now else "stick", self._mechanism.faces[grip.contact].subject)

    def sorted(self) -> tuple[Event, ...]:
        """Return all events in order of time."""
        return tuple(sorted(self.events, key=lambda event: (event.time, ORDER[event.kind])))


@dataclass(slots=True)
class Segment:
    """A motion segment of one contact mode: q + vτ + aτ²/2 with constant forces (NaN if undetermined).

    If the equations change, `flow` holds the motion and forces, and the other fields hold the initial values.
    """

    start: float  # s
    q: Row  # (n,), at the start of the segment
    v: Row
    found: Balance
    kinds: tuple[RowKind, ...]
    flow: Flow | None = None

    @property
    def a(self) -> Row:
        """Return the accelerations at the start of the segment, (n,)."""
        return self.found.a

    @property
    def tension(self) -> Row:
        """Return the constraint forces at the start of the segment, N."""
        return self.found.rows

    @property
    def normal(self) -> Row:
        """Return the normal forces at the start of the segment, N."""
        return self.found.normal

    @property
    def friction(self) -> Row:
        """Return the friction forces at the start of the segment, N."""
        return self.found.friction


@dataclass(frozen=True)
class Motion:
    """The motion segments in order of time, the events between them, and the end time with its cause."""

    mechanism: Mechanism
    segments: tuple[Segment, ...]
    events: tuple[Event, ...]
    end: float  # s
    cut: str = ""  # the kind of the event that ended it early

    def through(self, time: float) -> "Motion":
        """Return the motion truncated at a time, s."""
        if time >= self.end:
            return self
        segments = tuple(segment for segment in self.segments if segment.start < time)
        return Motion(self.mechanism, segments, tuple(e for e in self.events if e.time <= time), time)

    @cached_property
    def _widths(self) -> tuple[int, int, int]:
        """Return the numbers of coordinates, constrained lines and contacts."""
        mechanism = self.mechanism
        return len(mechanism.coordinates), len(mechanism.constraints), len(mechanism.faces)

    @cached_property
    def _starts(self) -> Array:
        """Return the start times of the segments, s."""
        return np.array([segment.start for segment in self.segments])

    @cached_property
    def _table(self) -> Array:
        """Return a table with a row for each segment: q, v, a, line forces, normal forces, friction."""
        lines = self._widths[1]
        rows = [
            (*s.q, *s.v, *s.found.a, *s.found.rows[:lines], *s.found.normal, *s.found.friction) for s in self.segments
        ]
        return np.array(rows)

    @cached_property
    def knots(self) -> Array:
        """Return the start times of segments and of integrator steps, between which the motion is smooth, s."""
        instants = [segment.start for segment in self.segments]
        instants += [time for segment in self.segments if segment.flow for time in segment.flow.step_times]
        linear = (stretch for segment in self.segments if segment.flow for stretch in segment.flow.stretches)
        instants += [time for stretch in linear for time in stretch.knots.tolist()]
        return sorted_unique(np.array([*(time for time in instants if time <= self.end), self.end]))

    def state(self, times: Array) -> State:
        """Return the motion at times ≥ 0, s, shape (m,); the last segment is extrapolated beyond the end."""
        return State(self.mechanism, times, self._kinematics, self._dynamics)

    def _belonging(self, times: Array) -> NDArray[np.intp]:
        """Return the index of the segment that contains each instant."""
        if len(self.segments) == 1:
            return np.zeros(len(times), np.intp)
        return np.maximum(np.searchsorted(self._starts, times, side="right") - 1, 0)

    def _flows(self, at: NDArray[np.intp]) -> Iterator[tuple[Segment, Flow, NDArray[np.bool_]]]:
        """Yield each integrated segment that contains given instants, with its flow and a mask of these instants."""
        numbers: list[int] = at.tolist()
        for number in dict.fromkeys(numbers):
            segment = self.segments[number]
            if segment.flow is not None and segment.flow.moves:
                yield segment, segment.flow, at == number

    @cached_property
    def _integrations(self) -> "tuple[_core.Integration | None, ...] | None":
        """Return the native integration of each segment, None for closed forms; None if Python integrated a part."""
        found = list["_core.Integration | None"]()
        for segment in self.segments:
            run = segment.flow.integration if isinstance(segment.flow, NativeFlow) else None
            if run is None and segment.flow is not None and segment.flow.moves:
                return None
            found.append(run or None)
        return None if core is None else tuple(found)

    def _kinematics(self, times: Array) -> tuple[Array, Array]:
        """Return coordinates and their rates at the given times."""
        n, lone = self._widths[0], len(self.segments) == 1  # whose one row NumPy repeats by itself
        flow = self.segments[0].flow if lone else None
        if flow is not None and flow.moves:
            values = sampled(flow, np.minimum(times, flow.time))
            return values[:, :n], values[:, n:]
        if core is not None and self._integrations is not None:
            q, v = np.empty((len(times), n)), np.empty((len(times), n))
            core.sample_segments(self._starts, self._table, self._integrations, np.ascontiguousarray(times), q, v)
            return q, v
        at = self._belonging(times)
        table = self._table if lone else self._table[at]
        since = (times - (self._starts if lone else self._starts[at]))[:, None]
        q0, v0 = table[:, :n], table[:, n : 2 * n]
        gained = since * table[:, 2 * n : 3 * n]
        q, v = q0 + since * (v0 + 0.5 * gained), v0 + gained
        for _, flow, here in self._flows(at):
            values = sampled(flow, np.minimum(times[here], flow.time))
            q[here], v[here] = values[:, :n], values[:, n:]
        return q, v

    def _dynamics(self, times: Array, q: Array, v: Array) -> Dynamics:
        """Return accelerations and constraint forces at the given times."""
        at = self._belonging(times)
        n, lines, faces = self._widths
        table = self._table[at]
        a, forces = table[:, 2 * n : 3 * n], table[:, 3 * n :].T
        for segment, flow, here in self._flows(at):
            samples = flow.formulas.forces(
                np.minimum(times[here], flow.time), np.concatenate([q[here], v[here]], axis=1)
            )
            a[here] = samples[:n].T
            rows = samples[n : n + len(segment.kinds)][:lines]
            borne = np.concatenate([rows, samples[n + len(segment.kinds) :]])
            borne[np.isnan([*segment.found.rows[:lines], *segment.found.normal, *segment.found.friction])] = nan
            forces[:, here] = borne
        names = [line.name for line in self.mechanism.constraints]
        contacts = list(self.mechanism.contacts)
        return Dynamics(
            a,
            dict(zip(names, forces[:lines], strict=True)),
            dict(zip(contacts, forces[lines : lines + faces], strict=True)),
            dict(zip(contacts, forces[lines + faces :], strict=True)),
        )


MAX_RECENT_STATES, MAX_RECENT_INSTANTS = 32, 130  # number of states that a sampler caches, and of instants of each


class Sampler:
    """The function that gives a motion at some instants, with a cache of recent short states.

    Searches for the same moment, and quantities at the same instants, then share what is computed from a state.
    """

    __slots__ = ("_motion", "_recent")

    def __init__(self, motion: Motion) -> None:
        """Store the motion."""
        self._motion = motion
        self._recent: dict[bytes, State] = {}

    def __call__(self, times: Array) -> State:
        """Return the motion at times ≥ 0, s, shape (m,)."""
        if len(times) > MAX_RECENT_INSTANTS:
            return self._motion.state(times)
        key = times.tobytes()
        state = self._recent.get(key)
        if state is None:
            if len(self._recent) >= MAX_RECENT_STATES:
                self._recent.clear()
            state = self._recent[key] = self._motion.state(times)
        return state

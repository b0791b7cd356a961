"""The record of a simulated motion, the same from every engine."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Protocol

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.lazy import cached_property
from sim2reason.record import counted
from sim2reason.registry import Registry

SHOWN = 10  # events that the text of a trace lists
AT_ONCE = 1e-9  # of a time: what comes earlier than something by no more comes with it


EVENT_KINDS: Mapping[str, str] = {
    "collision": "two bodies meet, or one meets the room",
    "taut": "a slack string is stretched",
    "land": "a foot or a prop is pressed again",
    "slack": "a string has no tension any more",
    "leave": "a foot or a prop is pressed no more",
    "stick": "what slides stops",
    "slip": "what rests begins to slide, or what slides reverses",
    "enter": "a body enters the region of a field",
    "exit": "it leaves it",
    "burn-out": "a rocket has burnt its fuel",
    "turn": "the speed of a coordinate passes through zero: nothing else changes",
    "reach": "two neighbouring sites of a string meet",
    "limit": "a coordinate comes to an end of its range",
    "lift": "a resting body leaves its face",
    "crowd": "impacts are too close together to tell apart",
    "indeterminate": "nothing holds a massless part any more",
}
"""What each kind of event is, in the order in which simultaneous ones are told. The last five end a motion."""

ENDINGS: Mapping[str, str] = {
    "indeterminate": "nothing holds a massless part",
    "lift": "a body leaves its face",
    "crowd": "impacts follow each other too closely to tell apart",
    "reach": "two points of a string meet",
    "limit": "something comes to the end of its travel",
    "statistics": "a sample stands out",
    "certificate": "two engines part",
}
"""Why a motion is followed no longer, in words, by what cut it."""


IMPACTS = frozenset({"collision", "taut", "land"})
"""Kinds of events at which velocities change at once, so that forces and accelerations are infinite."""


def in_order(times: Array) -> Array:
    """Return instants, (n,), in ascending order without repeats; `np.unique` takes five times as long for so few."""
    found: Array = np.sort(times)
    return found[np.append(found[1:] != found[:-1], True)] if len(found) else found


@dataclass(frozen=True, slots=True)
class Event:
    """Something of one of the `EVENT_KINDS` that happens at an instant, to `subjects` in the order of engines."""

    time: float  # s
    kind: str
    subjects: tuple[str, ...]

    @property
    def changes_motion(self) -> bool:
        """Whether forces, velocities or their equations change: all events do that but turns."""
        return self.kind != "turn"


def happened(events: Iterable[Event], until: float) -> tuple[Event, ...]:
    """What happens before a time, s, and not just then, in order; turns change nothing and are left out."""
    return tuple(event for event in events if event.time < until * (1.0 - AT_ONCE) and event.changes_motion)


@dataclass(frozen=True)
class Trace:
    """A motion, its events in order of time, and until when it may be used."""

    engine: str
    state: State
    events: tuple[Event, ...]
    stable_until: float  # s; samples after it are there to be looked at, not to be asked about
    cut: str = ""  # why it ends before the duration that was asked for: an event's kind, "statistics", "certificate"
    sample: "Callable[[Array], State]" = field(repr=False, compare=False, default=lambda _: _unsampled())
    # the same motion at any other times, up to `stable_until`; before t = 0 is not defined
    knots: "Callable[[], Array]" = field(repr=False, compare=False, default=lambda: np.zeros(0))
    # instants, s, between which the motion is one smooth piece: ends of the engine's own steps; none if it has none
    tolerance: float = 0.0  # what a step may err by, relative, if the caller was content with that
    record: object = field(repr=False, compare=False, default=None)
    # what the engine itself has of the motion, as far as it followed it; None if it keeps nothing else

    def __repr__(self) -> str:
        """Return the engine, the numbers of coordinates, samples and events, and the time until which it is valid."""
        count = counted(len(self.mechanism.coordinates), "coordinate")
        samples, events = counted(len(self.state.times), "sample"), counted(len(self.events), "event")
        until = f"valid until {self.stable_until:.6g} {self.mechanism.units.time}"
        return f"<Trace by the {self.engine} engine: {count}, {samples}, {events}, {until}>"

    def __str__(self) -> str:
        """Return the same with a line for each of the first events, and the reason if the motion ends early."""
        unit, more = self.mechanism.units.time, len(self.events) - SHOWN
        events = [f"  {e.time:.6g} {unit}: {e.kind} ({', '.join(e.subjects)})" for e in self.events[:SHOWN]]
        rest = [f"  and {counted(more, 'more event')}"] if more > 0 else []
        end = [f"  ends because {ending(self)}"] if self.cut else []
        return "\n".join([repr(self)[1:-1], *events, *rest, *end])

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism that moves."""
        return self.state.mechanism

    def story(self, until: float | None) -> tuple[tuple[str, tuple[str, ...]], ...]:
        """What happens to whom before a time, s, in order; without one, as long as it may be used."""
        end = self.stable_until if until is None else until
        return tuple((event.kind, event.subjects) for event in happened(self.events, end))

    def through(self, time: float) -> "Trace":
        """The same motion recorded no longer than to the second sample after a time, s."""
        times = self.state.times
        count = int(np.searchsorted(times, time, side="right")) + 2
        if count >= len(times):
            return self
        return self.until(float(times[count - 1]))

    def until(self, time: float) -> "Trace":
        """The same motion as if it had been followed no longer than to a time, s."""
        times = self.state.times
        if time >= times[-1]:
            return self
        shorter = self.stable_until > time
        return replace(
            self,
            state=self.sample(np.append(times[times < time], time)),
            events=tuple(event for event in self.events if event.time <= time),
            stable_until=time if shorter else self.stable_until,
            cut="" if shorter else self.cut,
        )

    @cached_property
    def _instants(self) -> dict[float, State]:
        """What was looked at before."""
        return {}

    def at(self, time: float) -> State:
        """The motion at one instant, s; several readers look at the same ones."""
        found = self._instants.get(time)
        if found is None:
            found = self._instants[time] = self.sample(np.array([time]))
        return found

    @cached_property
    def scan(self) -> State:
        """The motion at the engine's own knots, on both sides of every event, and at instants between them.

        Between two neighbours nothing turns more than once, so that whoever looks for an instant need not look closer.
        """
        end = min(self.stable_until, float(self.state.times[-1]))
        events = np.array([event.time for event in self.events])
        borders = np.concatenate([[0.0, end], self.knots(), events, np.nextafter(events, 0.0)])
        borders = in_order(borders[(borders >= 0.0) & (borders <= end)])
        if len(borders) < 2:
            return self.sample(borders)
        pieces = min(max(PER_STEP, -(-LEAST // (len(borders) - 1))), max(1, MOST // len(borders)))
        shares = np.arange(pieces) / pieces
        inner = borders[:-1, None] + np.diff(borders)[:, None] * shares
        return self.sample(in_order(np.append(inner.ravel(), end)))


def ending(trace: Trace) -> str:
    """Return the reason why the description of a motion ends, with the names concerned; empty if nothing ended it."""
    why = ENDINGS.get(trace.cut, trace.cut)
    last = next((event for event in reversed(trace.events) if event.kind == trace.cut), None)
    return f"{why} ({', '.join(last.subjects)})" if last is not None else why


PER_STEP, LEAST, MOST = 4, 64, 8000  # instants of a scan: in each step, at least, at most


def _unsampled() -> State:
    raise ValueError("this trace was read from a file: it holds only its samples")


FINEST = 1e-11  # relative: what a step of an integrator errs by, unless a caller is content with less


class Engine(Protocol):
    """What simulates a mechanism."""

    def __call__(self, mechanism: Mechanism, times: Array, tolerance: float = FINEST) -> Trace:
        """The motion at `times` (m,), strictly increasing from 0, in seconds.

        `tolerance` is what a step may err by, relative to the state; an engine that can't choose does its best.
        """
        ...


ENGINES: Registry[Engine] = Registry("simulation.engines")

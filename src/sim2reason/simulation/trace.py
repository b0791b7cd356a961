"""The record of a simulated motion, common to all engines: its channels and events, and limits for engines."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import NamedTuple, Protocol

import numpy as np

from sim2reason.base.records import Memo, cached_property, format_count
from sim2reason.base.registry import Registry
from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.quantities import QUANTITIES, Quantity

MAX_LISTED_EVENTS = 10  # largest number of events in the text of a trace
EVENT_TIME_RTOL = 1e-9  # relative: events with a smaller difference of time are simultaneous


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
"""Descriptions of the kinds of events, in the order of simultaneous events. The last five end a motion."""

ENDINGS: Mapping[str, str] = {
    "indeterminate": "nothing holds a massless part",
    "lift": "a body leaves its face",
    "crowd": "impacts follow each other too closely to tell apart",
    "reach": "two points of a string meet",
    "limit": "something comes to the end of its travel",
    "statistics": "a sample stands out",
    "certificate": "two engines part",
}
"""Phrases for the reason why a motion ends, by the value of `Trace.cut`."""


IMPACTS = frozenset({"collision", "taut", "land"})
"""Kinds of events at which velocities jump, so that forces and accelerations are infinite."""


def sorted_unique(times: Array) -> Array:
    """Return instants (n,) in ascending order without repeats, faster than `np.unique` for small arrays."""
    sorted_times: Array = np.sort(times)
    distinct = np.ones(len(sorted_times), np.bool_)
    np.not_equal(sorted_times[1:], sorted_times[:-1], out=distinct[:-1])
    return sorted_times[distinct]


@dataclass(frozen=True, slots=True)
class Event:
    """An event of one of the `EVENT_KINDS` at an instant; `subjects` are in the order used by the engines."""

    time: float  # s
    kind: str
    subjects: tuple[str, ...]

    @property
    def changes_motion(self) -> bool:
        """Return whether forces, velocities or their equations change, as in all events but turns."""
        return self.kind != "turn"


def events_before(events: Iterable[Event], until: float) -> tuple[Event, ...]:
    """Return the events before a time, s, in order, without turns and without events at that time."""
    return tuple(event for event in events if event.time < until * (1.0 - EVENT_TIME_RTOL) and event.changes_motion)


@dataclass(frozen=True)
class Trace(Memo):
    """A simulated motion: its states at recorded times, its events, and the time until which it is valid.

    Attributes:
        engine: Name of the engine.
        state: The motion at the recorded instants: `times` (n,), and q, v and a (n, number of coordinates).
        events: Events in order of time, each with its time, its kind and its subjects.
        stable_until: Time, s, until which the motion is valid; later samples are for plots only.
        cut: Why the motion ends before the requested duration: the kind of an event, ``statistics`` or ``certificate``;
            empty if it does not.
        sample: Function that gives the motion at other times (m,), s, from 0 to `stable_until`.
        knots: Function that gives the instants, s, between which the motion is smooth; empty if there are none.
        tolerance: Relative step tolerance, if the caller chose one; otherwise 0.
        record: Data of the engine itself, or None.
        mechanism: The mechanism that moves.
        scan: The motion at instants so close together that no quantity turns more than once between two of them.

    Examples:
        >>> import sim2reason
        >>> scene = sim2reason.parse_scene("A 2 kg block is released from rest on a frictionless 30-degree incline.")
        >>> trace = sim2reason.simulate(scene, duration=1.0)
        >>> trace
        <Trace by the exact engine: 1 coordinate, 101 samples, 0 events, valid until 1 s>
        >>> trace.at(0.25).v.round(6)
        array([[-1.225]])
    """

    engine: str
    state: State
    events: tuple[Event, ...]
    stable_until: float
    cut: str = ""
    sample: "Callable[[Array], State]" = field(repr=False, compare=False, default=lambda _: _unsampled())
    knots: "Callable[[], Array]" = field(repr=False, compare=False, default=lambda: np.zeros(0))
    tolerance: float = 0.0
    record: object = field(repr=False, compare=False, default=None)

    def __repr__(self) -> str:
        """Return the engine, the numbers of coordinates, samples and events, and the time until which it is valid."""
        count = format_count(len(self.mechanism.coordinates), "coordinate")
        samples, events = format_count(len(self.state.times), "sample"), format_count(len(self.events), "event")
        until = f"valid until {self.stable_until:.6g} {self.mechanism.units.time}"
        return f"<Trace by the {self.engine} engine: {count}, {samples}, {events}, {until}>"

    def __str__(self) -> str:
        """Return the line of `repr`, a line for each of the first events, and the reason if the motion ends early."""
        unit, more = self.mechanism.units.time, len(self.events) - MAX_LISTED_EVENTS
        events = [f"  {e.time:.6g} {unit}: {e.kind} ({', '.join(e.subjects)})" for e in self.events[:MAX_LISTED_EVENTS]]
        rest = [f"  and {format_count(more, 'more event')}"] if more > 0 else []
        end = [f"  ends because {ending(self)}"] if self.cut else []
        return "\n".join([repr(self)[1:-1], *events, *rest, *end])

    @property
    def mechanism(self) -> Mechanism:
        """Return the mechanism that moves."""
        return self.state.mechanism

    def story(self, until: float | None) -> tuple[tuple[str, tuple[str, ...]], ...]:
        """Return the kind and the subjects of each event before a time that changes the motion.

        Args:
            until: Time, s; None: as long as the motion is valid.

        Returns:
            The kind and the subjects of each event, in order.
        """
        end = self.stable_until if until is None else until
        return tuple((event.kind, event.subjects) for event in events_before(self.events, end))

    def through(self, time: float) -> "Trace":
        """Return the motion recorded up to the second sample after a time.

        Args:
            time: Time, s.

        Returns:
            A shorter trace, or this trace if it ends before.
        """
        times = self.state.times
        count = int(np.searchsorted(times, time, side="right")) + 2
        if count >= len(times):
            return self
        return self.until(float(times[count - 1]))

    def until(self, time: float) -> "Trace":
        """Return the motion recorded up to a time, as a simulation of that duration would.

        Args:
            time: Time, s.

        Returns:
            A shorter trace, or this trace if it ends before.
        """
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
        """Return the cached states at single instants requested before, by time."""
        return {}

    def at(self, time: float) -> State:
        """Return the motion at one instant, cached for further calls.

        Args:
            time: Time, s, from 0 to `stable_until`.

        Returns:
            A state with one instant: q, v and a have the shape (1, number of coordinates).

        Raises:
            ValueError: The trace was read from a file, which has only its samples.
        """
        state = self._instants.get(time)
        if state is None:
            state = self._instants[time] = self.sample(np.array([time]))
        return state

    @cached_property
    def scan(self) -> State:
        """Return the motion at the ends of the engine's steps, on both sides of every event, and at instants between.

        No quantity turns more than once between two neighbours, so that searches need no finer steps.
        """
        end = min(self.stable_until, float(self.state.times[-1]))
        borders = np.append(self.knots(), (0.0, end))
        if self.events:
            events = np.array([event.time for event in self.events])
            borders = np.concatenate([borders, events, np.nextafter(events, 0.0)])
        borders = sorted_unique(borders[(borders >= 0.0) & (borders <= end)])
        if len(borders) < 2:
            return self.sample(borders)
        pieces = min(
            max(PER_STEP, -(-MIN_SCAN_SAMPLES // (len(borders) - 1))), max(1, MAX_SCAN_SAMPLES // len(borders))
        )
        times = np.empty((len(borders) - 1) * pieces + 1)
        times[:-1] = (borders[:-1, None] + (borders[1:] - borders[:-1])[:, None] * _shares(pieces)).ravel()
        times[-1] = end
        return self.sample(sorted_unique(times))


@lru_cache(maxsize=128)
def _shares(pieces: int) -> Array:
    """Return the starts of equal parts of an interval of length 1."""
    return np.arange(pieces) / pieces


def ending(trace: Trace) -> str:
    """Return why a motion ends, with the names of the bodies concerned; empty if no event ended it."""
    why = ENDINGS.get(trace.cut, trace.cut)
    last = next((event for event in reversed(trace.events) if event.kind == trace.cut), None)
    return f"{why} ({', '.join(last.subjects)})" if last is not None else why


PER_STEP, MIN_SCAN_SAMPLES, MAX_SCAN_SAMPLES = 4, 64, 8000  # instants of a scan: per step, at least, at most


def _unsampled() -> State:
    raise ValueError("this trace was read from a file: it holds only its samples")


DEFAULT_STEP_RTOL = 1e-11  # relative step tolerance of an integrator, unless the caller chooses a larger one


class Engine(Protocol):
    """A function that simulates a mechanism."""

    def __call__(self, mechanism: Mechanism, times: Array, tolerance: float = DEFAULT_STEP_RTOL) -> Trace:
        """Return the motion at `times` (m,), strictly increasing from 0, in seconds.

        `tolerance` is the relative tolerance of a step; an engine without this choice ignores it.
        """
        ...


ENGINES: Registry[Engine] = Registry("simulation.engines")


class Channel(NamedTuple):
    """A quantity, by its registered name, of one subject, such as a body or a part of a string."""

    subject: str
    quantity: str


def channels(mechanism: Mechanism) -> Iterator[tuple[Channel, Quantity]]:
    """Yield each channel of a mechanism with its quantity, in the order of the registry of quantities."""
    for name, quantity in QUANTITIES.items():
        for subject in quantity.subjects(mechanism):
            yield Channel(subject, name), quantity


OPERATIONS = 40_000_000  # arithmetic operations for one motion, each about 30 ns of Python on a machine of 2024


class Budget:
    """The arithmetic operations that remain for one engine and one motion."""

    __slots__ = ("all", "left")

    def __init__(self, operations: int = OPERATIONS) -> None:
        """Start with the full number of operations."""
        self.all = self.left = operations

    def spend(self, operations: int) -> None:
        """Subtract operations from the budget; raise SimulationError if none remain."""
        self.left -= operations
        if self.left < 0:
            raise SimulationError(
                f"it takes more than {self.all // 1_000_000} million operations; simulate a shorter time"
            )

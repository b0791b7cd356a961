"""Comparison of two engines on one motion: the largest difference of each channel and the time until which they agree.

Events are matched first: same kind and subjects, at times that differ by at most τ = 1e-4 of the
duration, in the same order unless they concern different subjects. Then the samples are compared, except
those near an event, where a small error of the event time causes a large error of a speed.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sim2reason.base.records import cached_property, format_count
from sim2reason.errors import SimulationError, UnsupportedError
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array, Dynamics, State
from sim2reason.simulation.quantities import QUANTITIES, Quantity
from sim2reason.simulation.trace import ENDINGS, ENGINES, Channel, Event, Trace

Flags = NDArray[np.bool_]

SMOOTH_RTOL = 1e-4  # relative tolerance of a motion without events that change the forces
EVENTFUL_RTOL = 1e-3  # relative tolerance of a motion with such events
EVENT_TIME_RTOL = 1e-4  # events are simultaneous if their times differ by less than this fraction of the duration
CHANGES = frozenset({"collision", "taut", "slack", "stick", "slip"})  # events that permit the tolerance EVENTFUL
RECORDED, WITNESS = "exact", "mujoco"


class Match(NamedTuple):
    """An event that both engines recorded."""

    event: Event
    apart: float  # s, the time of the witness minus the recorded time


@dataclass(frozen=True)
class Certificate:
    """The agreement of two engines on a motion.

    Times are in the unit of the mechanism, s by default. A channel is a quantity of a subject.

    Attributes:
        engines: Names of the engine that recorded the motion and of its witness.
        tolerance: Relative difference that is allowed.
        stable_until: Time until which the engines agree.
        reason: Why that is before the end of the motion: the kind of an event, or the channel on which they disagree.
        matched: Events that both engines have, with the differences in time.
        blind: Intervals around events in which samples were not compared.
        agreement: Greatest difference of each channel that recipes ask for, relative to the scene's largest value of
            the quantity.
        until: Time from which each channel is not to be trusted.
        others: Function that compares the other channels; called when one of them is first needed.

    Examples:
        >>> import sim2reason
        >>> scene = sim2reason.parse_scene("A 2 kg block is released from rest on a frictionless 30-degree incline.")
        >>> trace, certificate = sim2reason.certify(scene, duration=1.0)
        >>> print(certificate)
        Certificate: exact and mujoco agree until t = 1 within 0.0001 on ... channels
          largest difference: ... of the scale, ... of e1.blocks.0
          0 events matched
    """

    engines: tuple[str, str]
    tolerance: float
    stable_until: float
    reason: str
    matched: tuple[Match, ...] = ()
    blind: tuple[tuple[float, float], ...] = ()
    agreement: Mapping[Channel, float] = field(default_factory=dict[Channel, float])
    until: Mapping[Channel, float] = field(default_factory=dict[Channel, float])
    others: Callable[[], Mapping[Channel, float]] = field(default=dict[Channel, float], repr=False, compare=False)

    def __repr__(self) -> str:
        """Return the engines, the time until which they agree, the tolerance, and the number of channels compared."""
        channels, until = format_count(len(self.agreement), "channel"), f"until t = {self.stable_until:.6g}"
        return f"<Certificate: {' and '.join(self.engines)} agree {until} within {self.tolerance:g} on {channels}>"

    def __str__(self) -> str:
        """Return the line of `repr`, the largest difference, the matched events and the reason for an early end."""
        lines = [repr(self)[1:-1]]
        if self.agreement:
            worst = max(self.agreement, key=lambda channel: self.agreement[channel])
            size = f"{self.agreement[worst]:.1e} of the scale"
            lines.append(f"  largest difference: {size}, {worst.quantity} of {worst.subject}")
        lines.append(f"  {format_count(len(self.matched), 'event')} matched")
        end = [f"  ends because {ENDINGS.get(self.reason, self.reason)}"] if self.reason else []
        return "\n".join([*lines, *end])

    @cached_property
    def _until_of_others(self) -> Mapping[Channel, float]:
        return self.others()

    def trusted(self, channel: Channel) -> float:
        """Return the time until which both engines agree on a channel.

        Args:
            channel: The channel.

        Returns:
            The time; negative if the channel was not compared.
        """
        until = self.until.get(channel)
        return min(self.stable_until, self._until_of_others.get(channel, -1.0) if until is None else until)

    def covers(self, channel: Channel, time: float) -> bool:
        """Return whether both engines agree on a channel at a time.

        Args:
            channel: The channel.
            time: The time.

        Returns:
            Whether the time is before `trusted` and in no blind interval.
        """
        if any(start <= time <= stop for start, stop in self.blind):
            return False
        return time <= self.trusted(channel)

    def document(self) -> dict[str, object]:
        """Return the certificate as plain JSON values.

        Returns:
            A mapping with the fields by name; `agreement` and `until` together are ``channels``.
        """
        return {
            "engines": list(self.engines),
            "tolerance": self.tolerance,
            "stable_until": self.stable_until,
            "reason": self.reason,
            "matched": [[m.event.kind, list(m.event.subjects), m.event.time, m.apart] for m in self.matched],
            "blind": [list(interval) for interval in self.blind],
            "channels": [[*channel, worst, self.until[channel]] for channel, worst in self.agreement.items()],
        }


def certify(mechanism: Mechanism, times: Array) -> tuple[Trace, Certificate]:
    """Simulate a mechanism with both engines and compare the two motions.

    Args:
        mechanism: The mechanism.
        times: Instants (n,), strictly increasing from 0.

    Returns:
        The trace of the exact engine, cut where the engines part, and the certificate. If the witness cannot simulate
        the mechanism, the certificate ends at 0 and its reason is that of the witness.

    Raises:
        UnsupportedError, SimulationError, SceneError: The exact engine cannot simulate the mechanism.
    """
    return certify_trace(ENGINES[RECORDED](mechanism, times))


def certify_trace(recorded: Trace) -> tuple[Trace, Certificate]:
    """Simulate a recorded motion with the second engine and compare the two, as `certify` does."""
    try:
        witness = ENGINES[WITNESS](recorded.mechanism, recorded.state.times)
    except (SimulationError, UnsupportedError) as error:
        certificate = Certificate((RECORDED, WITNESS), SMOOTH_RTOL, 0.0, f"no witness: {error}")
    else:
        certificate = compare(recorded, witness)
    return truncated(recorded, certificate), certificate


def truncated(trace: Trace, certificate: Certificate) -> Trace:
    """Return the trace, truncated at the time until which its certificate is valid."""
    if certificate.stable_until >= trace.stable_until:
        return trace
    return replace(trace, stable_until=certificate.stable_until, cut="certificate")


def compare(recorded: Trace, witness: Trace) -> Certificate:
    """Compare two traces of one mechanism, sampled at the same times."""
    times = recorded.state.times
    near = EVENT_TIME_RTOL * float(times[-1])
    first = recorded if recorded.stable_until <= witness.stable_until + near else witness
    end, reason = first.stable_until, first.cut
    matched, parted = _match(_events_to_match(recorded.events), _events_to_match(witness.events), near)
    if parted is not None and parted.time < float(times[-1]) - near and parted.time <= end + near:
        end, reason = min(end, parted.time), f"only one engine sees: {_event_text(parted)}"
    changes = any(m.event.kind in CHANGES for m in matched)
    blind = tuple(_around(match, near) for match in matched)
    if parted is not None and parted.time >= float(times[-1]) - near:  # one engine may see it just after the end
        blind += ((parted.time - near, parted.time + near),)
    compared = (times <= end) & ~_inside(times, blind)
    table = _Table(recorded.state, witness.state, times <= end, compared, EVENTFUL_RTOL if changes else SMOOTH_RTOL)
    stable, worst = table.first_over()
    if worst is not None and stable < end:
        end, reason = stable, f"the engines disagree on the {worst.quantity} of {worst.subject}"
    until = {channel: min(end, time) for channel, time in table.until.items()}
    engines = (recorded.engine, witness.engine)
    return Certificate(engines, table.tolerance, end, reason, matched, blind, table.agreement, until, table.others)


def _event_text(event: Event) -> str:
    return f"{event.kind} of {', '.join(event.subjects)} at {event.time:.6g} s"


# ---- events


def _events_to_match(events: Iterable[Event]) -> list[Event]:
    """Return the events that both engines must record: those that change the motion."""
    return [event for event in events if event.changes_motion]


def _match(recorded: list[Event], witness: list[Event], near: float) -> tuple[tuple[Match, ...], Event | None]:
    """Return the events that both engines recorded, and the first event without a counterpart in the same order."""
    left, matched, single = list(witness), list[Match](), list[Event]()
    for event in recorded:
        counterpart = next((other for other in left if _same(event, other, near)), None)
        if counterpart is None:
            single.append(event)
            continue
        before = left[: left.index(counterpart)]
        if any(set(event.subjects) & set(other.subjects) for other in before):
            single.append(event)
            continue
        left.remove(counterpart)
        matched.append(Match(event, counterpart.time - event.time))
    single = sorted([*single, *left], key=lambda event: event.time)
    if not single:
        return tuple(matched), None
    kept = tuple(match for match in matched if match.event.time <= single[0].time + near)
    return kept, single[0]


def _same(a: Event, b: Event, near: float) -> bool:
    return a.kind == b.kind and a.subjects == b.subjects and abs(a.time - b.time) <= near


def _around(match: Match, near: float) -> tuple[float, float]:
    width = max(2.0 * abs(match.apart), near)
    return (match.event.time - width, match.event.time + width)


def _inside(times: Array, intervals: Iterable[tuple[float, float]]) -> Flags:
    inside = np.zeros(len(times), dtype=bool)
    for start, stop in intervals:
        inside |= (times >= start) & (times <= stop)
    return inside


# ---- samples


class _Table:
    """The relative differences of all channels between two motions, at the compared samples."""

    def __init__(self, recorded: State, witness: State, living: Flags, heard: Flags, tolerance: float) -> None:
        """Store both motions; `living` marks the samples that set a channel's scale, `heard` the compared ones."""
        self.tolerance = tolerance
        self.agreement: dict[Channel, float] = {}
        self.until: dict[Channel, float] = {}
        self._over: dict[Channel, float] = {}
        self._times, self._living, self._compared_samples = recorded.times, living, heard
        self._end = float(recorded.times[-1])
        self._both = _concatenate(recorded, witness)
        self._compare_all(drawn=True)

    def others(self) -> Mapping[Channel, float]:
        """Return the time, s, of the first disagreement of each channel about which recipes draw no questions."""
        known, self.until = self.until, {}
        self._compare_all(drawn=False)
        disagreements, self.until = self.until, known
        return disagreements

    def _compare_all(self, *, drawn: bool) -> None:
        mechanism = self._both.mechanism
        movable = [body.mass for body in mechanism.bodies if self._both.began[body.name].steps]
        heaviest = max(movable, default=0.0) or 1.0  # a fixed star's mass would hide every momentum of its planets
        for name, quantity in QUANTITIES.items():
            if quantity.drawn_by_recipes == drawn and (subjects := quantity.subjects(mechanism)):
                self._compare(quantity, [Channel(subject, name) for subject in subjects], heaviest)

    def _compare(self, quantity: Quantity, members: list[Channel], heaviest: float) -> None:
        """Compare one quantity for all its subjects at once, in arrays (subjects, samples, components)."""
        values = np.array([quantity.evaluate(self._both, channel.subject) for channel in members])
        if values.ndim == 2:
            values = values[:, :, None]
        n = values.shape[1] // 2
        ours, theirs = values[:, :n], values[:, n:]
        size = np.sqrt(np.add.reduce(ours * ours, axis=2))
        floor = quantity.floor * heaviest if quantity.heavy else quantity.floor  # a smaller scale would be rounding's
        scale = max(float(np.fmax.reduce(size[:, self._living], axis=None, initial=0.0)), floor)
        deviation = np.sqrt(np.add.reduce((ours - theirs) ** 2, axis=2))[:, self._compared_samples] / scale
        silent = np.isfinite(size[:, self._compared_samples]) & np.isnan(deviation)
        above, worst = deviation > self.tolerance, np.fmax.reduce(deviation, axis=1, initial=0.0).tolist()
        parted, silenced = bool(above.any()), bool(silent.any())
        for row, channel in enumerate(members):
            over = self._first(above[row]) if parted else self._end
            self.until[channel] = min(over, self._first(silent[row])) if silenced else over
            if not quantity.drawn_by_recipes:  # what only people ask ends no motion from which recipes draw
                continue
            self.agreement[channel] = worst[row]
            if over < self._end:
                self._over[channel] = over

    def _first(self, bad: Flags) -> float:
        """Return the last compared time before the first sample marked as bad, s; the end time if none is."""
        if not bad.any():
            return self._end
        first = int(bad.argmax())
        return float(self._times[self._compared_samples][first - 1]) if first else 0.0

    def first_over(self) -> tuple[float, Channel | None]:
        """Return the earliest time at which a channel exceeds the tolerance, s, and that channel."""
        channel = min(self._over, key=lambda channel: self._over[channel], default=None)
        return (self._end, None) if channel is None else (self._over[channel], channel)


def _concatenate(a: State, b: State) -> State:
    """Return two motions concatenated in time, so that each quantity is evaluated only once."""

    def forces(x: Mapping[str, Array], y: Mapping[str, Array]) -> dict[str, Array]:
        return {name: np.concatenate([x[name], y[name]]) for name in x}

    return State.of(
        a.mechanism,
        np.concatenate([a.times, b.times]),
        (np.concatenate([a.q, b.q]), np.concatenate([a.v, b.v])),
        Dynamics(
            np.concatenate([a.a, b.a]),
            forces(a.constraint_tension, b.constraint_tension),
            forces(a.normal, b.normal),
            forces(a.friction, b.friction),
        ),
    )

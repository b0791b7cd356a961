"""Moments of a motion: a time, the start, or the first time that something happens, with their phrases."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from sim2reason.quantities import QUANTITIES
from sim2reason.simulation.trace import Trace

SCAN = 64  # samples in the search for the first crossing; motions are piecewise parabolas, so none is missed
STEPS = 60  # halvings of an interval: below any double's resolution


class Moment(Protocol):
    """A point of a motion."""

    @property
    def subjects(self) -> tuple[str, ...]:
        """The bodies that it speaks of."""
        ...

    def time(self, trace: Trace) -> float | None:
        """When it comes, in seconds; None if it does not come while the motion is described."""
        ...

    def side(self, time: float) -> float:
        """The instant at which quantities are read: at the moment, or just before it."""
        ...

    def phrases(self, mentions: Mapping[str, str], *, released: bool) -> tuple[str, ...]:
        """How a question speaks of it, *when …*."""
        ...


@dataclass(frozen=True, slots=True)
class _At:
    @property
    def subjects(self) -> tuple[str, ...]:
        """None."""
        return ()

    def side(self, time: float) -> float:
        """The moment itself."""
        return time


@dataclass(frozen=True, slots=True)
class AtTime(_At):
    """A stated time after the start."""

    after: float  # s, as spoken

    def time(self, trace: Trace) -> float | None:
        """The time itself, while the motion is described."""
        return self.after if self.after <= trace.stable_until else None

    def phrases(self, mentions: Mapping[str, str], *, released: bool) -> tuple[str, ...]:
        """As in: 0.80 s after release."""
        del mentions
        said = say_seconds(self.after)
        if released:
            return (f"{said} after release", f"{said} after the release", f"{said} after the start")
        return (f"at t = {said}", f"at the time t = {said}", f"at the instant t = {said}")


@dataclass(frozen=True, slots=True)
class AtStart(_At):
    """Just after the start."""

    def time(self, trace: Trace) -> float | None:
        """Zero."""
        del trace
        return 0.0

    def phrases(self, mentions: Mapping[str, str], *, released: bool) -> tuple[str, ...]:
        """As in: just after release."""
        del mentions
        if released:
            return ("just after release", "immediately after release", "at the instant of release")
        return ("just after t = 0", "immediately after t = 0", "at t = 0")


@dataclass(frozen=True, slots=True)
class Moved(_At):
    """The first time that a body is a stated distance from its starting point."""

    body: str
    distance: float  # m, as spoken

    @property
    def subjects(self) -> tuple[str, ...]:
        """The body."""
        return (self.body,)

    def time(self, trace: Trace) -> float | None:
        """By scanning and halving; None if it never gets that far while the motion is described."""

        def excess(times: np.ndarray) -> np.ndarray:
            moved = QUANTITIES["displacement"].evaluate(trace.sample(times), self.body)
            return np.linalg.norm(moved, axis=1) - self.distance

        return first_crossing(excess, trace.stable_until)

    def phrases(self, mentions: Mapping[str, str], *, released: bool) -> tuple[str, ...]:
        """As in: when the block is first 0.50 m from its starting point."""
        del released
        body, said = mentions[self.body], say_metres(self.distance)
        return (
            f"when {body} is first {said} from its starting point",
            f"at the moment when {body} is first {said} from its starting point",
            f"as soon as {body} is {said} from its starting point",
        )


@dataclass(frozen=True, slots=True)
class Collided:
    """The first collision of two bodies, just before or just after it."""

    a: str
    b: str
    after: bool

    @property
    def subjects(self) -> tuple[str, ...]:
        """The two bodies."""
        return (self.a, self.b)

    def time(self, trace: Trace) -> float | None:
        """The time of the event."""
        pair = {self.a, self.b}
        return next((e.time for e in trace.events if e.kind == "collision" and set(e.subjects) == pair), None)

    def side(self, time: float) -> float:
        """Events belong to what follows them, so just before is the next smaller number."""
        return time if self.after else float(np.nextafter(time, 0.0))

    def phrases(self, mentions: Mapping[str, str], *, released: bool) -> tuple[str, ...]:
        """As in: just after the first collision of A and B."""
        del released
        both, side = pair(mentions[self.a], mentions[self.b]), "after" if self.after else "before"
        return (
            f"just {side} the first collision of {both}",
            f"just {side} {both} collide for the first time",
            f"immediately {side} the first collision of {both}",
        )


@dataclass(frozen=True, slots=True)
class Stopped(_At):
    """The first time that a body that was moving comes to rest, be it for an instant."""

    body: str

    @property
    def subjects(self) -> tuple[str, ...]:
        """The body."""
        return (self.body,)

    def time(self, trace: Trace) -> float | None:
        """The first event that ends the motion of its one coordinate."""
        coordinate = f"{self.body}.slide"
        for event in trace.events:
            turned = event.kind == "turn" and coordinate in event.subjects
            if event.time > 0.0 and (turned or (event.kind in ("stick", "slip") and self.body in event.subjects)):
                return event.time if self._rests(trace, event.time) else None
        return None

    def _rests(self, trace: Trace, time: float) -> bool:
        state = trace.sample(np.array([time]))
        return float(np.linalg.norm(QUANTITIES["velocity"].evaluate(state, self.body)[0])) < 1e-9

    def phrases(self, mentions: Mapping[str, str], *, released: bool) -> tuple[str, ...]:
        """As in: when the block first comes to rest."""
        del released
        body = mentions[self.body]
        return (
            f"when {body} first comes to rest",
            f"at the moment when {body} first comes to rest",
            f"when {body} comes to rest for the first time",
        )


def pair(one: str, other: str) -> str:
    """Two bodies as one phrase: *pucks A and B*, *block A and wedge W*."""
    noun, _, letter = one.rpartition(" ")
    same, _, second = other.rpartition(" ")
    return f"{noun}s {letter} and {second}" if noun == same and noun != "the" else f"{one} and {other}"


def say_seconds(value: float) -> str:
    """Two significant digits and the unit."""
    return f"{two_digits(value)} s"


def say_metres(value: float) -> str:
    """Two significant digits and the unit."""
    return f"{two_digits(value)} m"


def two_digits(value: float) -> str:
    """A positive number with two significant digits, never in scientific notation."""
    rounded = float(f"{value:.1e}")
    places = max(0, 1 - int(np.floor(np.log10(rounded))))
    return f"{rounded:.{places}f}"


def spoken(value: float) -> float:
    """A positive number as it will be said."""
    return float(two_digits(value))


def first_crossing(excess: "Callable[[np.ndarray], np.ndarray]", end: float) -> float | None:
    """The first time in (0, end] at which a function that starts below zero reaches zero; None if it does not."""
    low, high = 0.0, end
    for _ in range(STEPS):  # each round narrows the interval by the number of samples
        times = np.linspace(low, high, SCAN)
        above = np.flatnonzero(excess(times) >= 0.0)
        if len(above) == 0:
            return None
        first = int(above[0])
        if first == 0:
            return low if low > 0.0 else None
        low, high = float(times[first - 1]), float(times[first])
        if high - low <= 4e-16 * end:
            break
    return high

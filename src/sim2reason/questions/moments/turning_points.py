"""Moments of extreme speed and height, and of stops."""

from collections.abc import Iterator
from dataclasses import dataclass
from math import hypot, inf
from typing import ClassVar

import numpy as np

from sim2reason.questions.choices import REST_SPEED_RTOL, rest_speed
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.crossings import Passage, crossings
from sim2reason.questions.moments.extrema import TurningPoint, goes_straight_up
from sim2reason.questions.moments.occurrence import Occurrence, Verb
from sim2reason.questions.recurrence import ends_at_rest, has_known_continuation
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array, State, row_lengths
from sim2reason.scenes.dsl.vectors import add, scale
from sim2reason.simulation.quantities.kinematics import Acceleration, Displacement, Velocity
from sim2reason.simulation.quantities.subjects.bodies import (
    DIRECTION_TOL,
    Bodies,
    ancestor_chain,
    extended,
    moves_on_slider,
    point_directions,
)
from sim2reason.simulation.trace import Event, Trace

SPEED_RTOL = 1e-6  # relative: smaller differences of speeds are rounding


@MOMENTS.register("fastest")
@dataclass(frozen=True, slots=True)
class Fastest(Passage):
    """The first time that a body has its greatest speed, in a periodic motion or one that ends at rest."""

    label = "greatest speed"
    drawn_by_recipes = False
    of = Bodies()
    hangs_on = "velocity"
    verb = Verb("reaches its greatest speed", "reach its greatest speed")

    def excess(self, state: State) -> Array:
        """Return −v·a, the negative rate of half the squared speed, m²/s³, (n,)."""
        velocity, acceleration = (quantity.evaluate(state, self.name) for quantity in (Velocity, Acceleration))
        return -np.einsum("ij,ij->i", velocity, acceleration)

    def time(self, trace: Trace) -> float | None:
        """Return the time of greatest speed, s; None if a greater speed may follow."""
        if not has_known_continuation(trace):
            return None
        greatest = float(row_lengths(Velocity.evaluate(trace.scan, self.name)).max())
        for time in crossings(trace, self.excess):
            if float(np.linalg.norm(Velocity.evaluate(trace.at(time), self.name))) >= (1.0 - SPEED_RTOL) * greatest:
                return time
        return None


TOUCH_SPEED_RTOL = 0.1  # of the greatest speed: a sampled minimum below may touch zero between samples


@MOMENTS.register("stopped")
@dataclass(frozen=True, slots=True)
class Stopped(Occurrence):
    """The first time that a moving body comes to rest, if only for an instant."""

    label = "rest"
    own = True
    kinds = ("turn", "stick", "slip")
    of = Bodies()
    part = True
    verb = Verb("comes to rest", "come to rest")
    may_touch: ClassVar[bool] = True  # whether it counts as well where a speed touches zero and nothing turns back
    again: ClassVar[Verb] = Verb("comes to rest again", "come to rest again")
    top: ClassVar[Verb] = Verb("reaches its greatest height", "reach its greatest height")

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the bodies that ride on no other body, with their phrases."""
        mechanism = words.mechanism
        called = words.subject_phrases(cls.of).items()
        return {name: phrase for name, phrase in called if not moves_on_slider(mechanism, name)}

    def subject(self, words: Words) -> str:
        """Return the phrase for the subject; its centre for a slipping, rolling body, which may spin on."""
        name = words.subject_phrases(self.of)[self.name]
        if not _spins_on(words.mechanism, self.name):
            return name
        point = self.of.point(words.mechanism, self.name, name)
        return f"the centre of {name}" if point == name else point

    def does(self, words: Words) -> Verb:
        """Return the verb: *reaches its greatest height* or *comes to rest*, with *again* after a start from rest."""
        if self._is_top(words):
            return self.top
        return self.verb if _starts(words.mechanism, self.name) else self.again

    def count(self, words: Words) -> int | None:
        """Return the number of the stop; None for the top of a flight, which is unique."""
        return None if self._is_top(words) else Occurrence.count(self, words)

    def _is_top(self, words: Words) -> bool:
        """Return whether the stop is the top of a vertical flight."""
        return self.most > 0 and self.number == 1 and goes_straight_up(words.mechanism, self.name)

    @classmethod
    def seen_as(cls, name: str, words: Words) -> set[str]:
        """Return the names under which the trace records a stop of the body: coordinates and contacts of any body."""
        del name
        return {c.name for c in words.mechanism.coordinates} | words.mechanism.contacts.keys()

    def time(self, trace: Trace) -> float | None:
        """Return the time of the stop, s, or of an earlier instant of zero speed without an event; None if none."""
        if self.number > 1:
            return self._later(trace)
        event = Occurrence.time(self, trace)
        before = trace.stable_until if event is None else event
        return next((time for time in self._instant_stop_times(trace, before)), event) if self.may_touch else event

    def _later(self, trace: Trace) -> float | None:
        """Return the time of a later stop, s, including instants of zero speed without an event."""
        end = trace.stable_until
        times = [e.time for e in trace.events if 0.0 < e.time <= end and self.is_this(e, trace)]
        touched = self._instant_stop_times(trace, end) if self.may_touch else ()
        near = REST_SPEED_RTOL * float(trace.scan.times[-1])
        times += [time for time in touched if all(abs(time - event.time) > near for event in trace.events)]
        return sorted(times)[self.number - 1] if len(times) >= self.number else None

    def _instant_stop_times(self, trace: Trace, before: float) -> Iterator[float]:
        """Yield the times before `before`, s, at which the body's speed is zero without an event."""
        times, speeds = trace.scan.times, row_lengths(Velocity.evaluate(trace.scan, self.name))
        early = speeds[times < before * (1.0 - TOUCH_SPEED_RTOL)]
        lowest = early[1:-1][(early[1:-1] <= early[:-2]) & (early[1:-1] < early[2:])]
        if not len(lowest) or float(lowest.min()) > TOUCH_SPEED_RTOL * float(speeds.max()):
            return

        def gains(state: State) -> Array:
            return np.einsum("ij,ij->i", Velocity.evaluate(state, self.name), Acceleration.evaluate(state, self.name))

        for time in crossings(trace, gains):
            if time >= before * (1.0 - REST_SPEED_RTOL):
                return
            fastest = float(speeds[times <= time].max())  # so far: how long it is followed decides nothing
            if float(np.linalg.norm(Velocity.evaluate(trace.at(time), self.name))) <= REST_SPEED_RTOL * fastest:
                yield time

    def is_this(self, event: Event, trace: Trace) -> bool:
        """Return whether the body comes to rest at an event."""
        if event.kind not in self.kinds:
            return False
        times, speeds = trace.scan.times, row_lengths(Velocity.evaluate(trace.scan, self.name))
        slowest = rest_speed(trace, speeds)
        before = speeds[times < event.time - REST_SPEED_RTOL * times[-1]]  # the scan knows both sides of an event, too
        moved = len(before) > 0 and float(before[-1]) > slowest
        return moved and float(speeds[np.searchsorted(times, event.time)]) <= slowest


def _spins_on(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body with a size slides and rotates independently of the sliding."""
    kinds = {coordinate.kind for coordinate in mechanism.body[name].coordinates}
    face = mechanism.contacts.get(name)
    return kinds == {"slide", "hinge"} and extended(mechanism, name) and (face is None or face.friction < inf)


def _starts(mechanism: Mechanism, name: str) -> bool:
    """Return whether the body's centre of mass moves at the start."""
    speeds = {coordinate.name: coordinate.speed for coordinate in mechanism.coordinates}
    ways = point_directions(mechanism, name, mechanism.body[name].center)
    return hypot(*add(*(scale(speeds[number], direction) for number, direction in ways.items()))) > DIRECTION_TOL


@MOMENTS.register("halted")
@dataclass(frozen=True, slots=True)
class Halted(Stopped):
    """The last of several stops of a body, at which friction brings it to rest for good."""

    label = "rest for good"
    kinds = ("stick",)
    most = 0
    may_touch = False
    verb = again = Verb("comes to rest for good", "come to rest for good")

    def is_this(self, event: Event, trace: Trace) -> bool:
        """Return whether an event is the last stop of the body, after an earlier one, from which it stays at rest."""
        if not Stopped.is_this(self, event, trace) or not ends_at_rest(trace):
            return False
        times, speeds = trace.scan.times, _speeds(trace, self.name)
        return (
            bool((speeds[times >= event.time] <= rest_speed(trace, speeds)).all())
            and Stopped(self.name).time(trace) != event.time
        )


def _speeds(trace: Trace, name: str) -> Array:
    return row_lengths(Velocity.evaluate(trace.scan, name))


@MOMENTS.register("highest_point")
@dataclass(frozen=True, slots=True)
class HighestPoint(TurningPoint):
    """The first time that a body is at the highest point of its path."""

    label = "highest point"
    verb = Verb("reaches the highest point of its path", "reach the highest point of its path")
    local_verb = Verb("stops rising", "stop rising")

    def extent(self, state: State) -> Array:
        """Return the height above the starting point, m, (n,)."""
        return Displacement.evaluate(state, self.name)[:, 2]

    def excess(self, state: State) -> Array:
        """Return the downward velocity, m/s, (n,)."""
        return -Velocity.evaluate(state, self.name)[:, 2]


HINGE_REST_RTOL = 1e-3  # of its greatest speed: a slower hinge is at rest


@MOMENTS.register("lowest_point")
@dataclass(frozen=True, slots=True)
class LowestPoint(TurningPoint):
    """The first time that a body is at the lowest point of its path."""

    label = "lowest point"
    verb = Verb("passes through the lowest point of its path", "pass through the lowest point of its path")
    local_verb = Verb("stops falling", "stop falling")

    def comes(self, study: SimulatedScene) -> bool:
        """Return whether the body is still moving at its lowest point, unlike one on an arm that reverses there."""
        if not super(LowestPoint, self).comes(study):  # slots make another class of this one, which super() misses
            return False
        time, hinges = study.time(self), _hinges(study.mechanism, self.name)
        assert time is not None
        turning, fastest = (
            np.abs(state.v[:, hinges]).max(axis=0) for state in (study.trace.at(time), study.trace.scan)
        )
        return not hinges or bool(np.any(turning > HINGE_REST_RTOL * fastest))

    def extent(self, state: State) -> Array:
        """Return the depth below the starting point, m, (n,)."""
        return -Displacement.evaluate(state, self.name)[:, 2]

    def excess(self, state: State) -> Array:
        """Return the upward velocity, m/s, (n,)."""
        return Velocity.evaluate(state, self.name)[:, 2]


def _hinges(mechanism: Mechanism, name: str) -> list[int]:
    """Return the coordinates of the innermost rotating body among the body itself and its carriers."""
    each = ([c for c in body.coordinates if c.kind == "hinge"] for body in ancestor_chain(mechanism, name))
    return [mechanism.number[c.name] for c in next(filter(None, each), ())]

"""Turning points of a body's motion, and extremes of its speed and height."""

from collections.abc import Iterator
from dataclasses import dataclass
from math import hypot, inf
from typing import ClassVar

import numpy as np

from sim2reason.questions.choices import STILL, still
from sim2reason.questions.crossing import crossings
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.occurrence import Occurrence, Verb
from sim2reason.questions.moments.parts.passage import Passage
from sim2reason.questions.moments.parts.turning_points import TurningPoint, goes_straight_up
from sim2reason.questions.recurrence import ends_at_rest, nothing_new
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.vectors import add, scale
from sim2reason.simulation.quantities.kinematics import Acceleration, Displacement, Velocity
from sim2reason.simulation.quantities.subjects.bodies import Bodies
from sim2reason.simulation.quantities.subjects.paths import EVEN, chain, extended, rides, ways_of
from sim2reason.simulation.trace import Event, Trace

AS_FAST = 1e-6  # relative: what is slower by less is as fast


@MOMENTS.register("fastest")
@dataclass(frozen=True, slots=True)
class Fastest(Passage):
    """The first time that a body has its greatest speed, in a motion that repeats itself or ends at rest."""

    label = "greatest speed"
    drawn_by_recipes = False
    of = Bodies()
    hangs_on = "velocity"
    verb = Verb("reaches its greatest speed", "reach its greatest speed")

    def excess(self, state: State) -> Array:
        """Return −v·a, by how much half the squared speed falls per second, in m²/s³, (n,)."""
        velocity, acceleration = (found.evaluate(state, self.name) for found in (Velocity, Acceleration))
        return -np.einsum("ij,ij->i", velocity, acceleration)

    def time(self, trace: Trace) -> float | None:
        """Return when the speed first stops growing at its greatest value, s; None if it may grow later, too."""
        if not nothing_new(trace):
            return None
        greatest = float(np.linalg.norm(Velocity.evaluate(trace.scan, self.name), axis=1).max())
        for time in crossings(trace, self.excess):
            if float(np.linalg.norm(Velocity.evaluate(trace.at(time), self.name))) >= (1.0 - AS_FAST) * greatest:
                return time
        return None


SLOW = 0.1  # of the greatest speed: between instants of a scan, one that touches zero is seen to fall below that


@MOMENTS.register("stopped")
@dataclass(frozen=True, slots=True)
class Stopped(Occurrence):
    """The first time that a body that was moving comes to rest, be it for an instant."""

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
        """Bodies that ride on nothing, so that rest means one thing."""
        mechanism = words.mechanism
        called = words.called(cls.of).items()
        return {name: said for name, said in called if not rides(mechanism, name)}

    def subject(self, words: Words) -> str:
        """What slips as it rolls may go on spinning while its centre is at rest, which then is what is spoken of."""
        name = words.called(self.of)[self.name]
        if not _spins_on(words.mechanism, self.name):
            return name
        point = self.of.point(words.mechanism, self.name, name)
        return f"the centre of {name}" if point == name else point

    def does(self, words: Words) -> Verb:
        """It reaches its greatest height, or comes to rest again, where it is at rest at the start."""
        if self._is_top(words):
            return self.top
        return self.verb if _starts(words.mechanism, self.name) else self.again

    def count(self, words: Words) -> int | None:
        """Return no number for the top of a flight, which is reached once."""
        return None if self._is_top(words) else Occurrence.count(self, words)

    def _is_top(self, words: Words) -> bool:
        """Return whether it is the first stop of a body that goes straight up."""
        return self.most > 0 and self.number == 1 and goes_straight_up(words.mechanism, self.name)

    @classmethod
    def seen_as(cls, name: str, words: Words) -> set[str]:
        """Return the names under which events report the stop of a body: coordinates and contacts of any body."""
        del name
        return {c.name for c in words.mechanism.coordinates} | words.mechanism.contacts.keys()

    def time(self, trace: Trace) -> float | None:
        """Return the time of the stop, s, or of an earlier instant at which the body's speed only touches zero."""
        if self.number > 1:
            return self._later(trace)
        event = Occurrence.time(self, trace)
        before = trace.stable_until if event is None else event
        return next((time for time in self._touches(trace, before)), event) if self.may_touch else event

    def _later(self, trace: Trace) -> float | None:
        """Return the time of a later stop, s, instants at which the speed only touches zero counted as well."""
        end = trace.stable_until
        times = [e.time for e in trace.events if 0.0 < e.time <= end and self.is_this(e, trace)]
        touched = self._touches(trace, end) if self.may_touch else ()
        near = STILL * float(trace.scan.times[-1])
        times += [time for time in touched if all(abs(time - event.time) > near for event in trace.events)]
        return sorted(times)[self.number - 1] if len(times) >= self.number else None

    def _touches(self, trace: Trace, before: float) -> Iterator[float]:
        """Yield the times before `before`, s, at which the body's speed touches zero without an event."""
        times, speeds = trace.scan.times, np.linalg.norm(Velocity.evaluate(trace.scan, self.name), axis=1)
        early = speeds[times < before * (1.0 - SLOW)]
        lowest = early[1:-1][(early[1:-1] <= early[:-2]) & (early[1:-1] < early[2:])]
        if not len(lowest) or float(lowest.min()) > SLOW * float(speeds.max()):
            return

        def gains(state: State) -> Array:
            return np.einsum("ij,ij->i", Velocity.evaluate(state, self.name), Acceleration.evaluate(state, self.name))

        for time in crossings(trace, gains):
            if time >= before * (1.0 - STILL):
                return
            fastest = float(speeds[times <= time].max())  # so far: how long it is followed decides nothing
            if float(np.linalg.norm(Velocity.evaluate(trace.at(time), self.name))) <= STILL * fastest:
                yield time

    def is_this(self, event: Event, trace: Trace) -> bool:
        """Return whether the body is at rest then, and was not before."""
        if event.kind not in self.kinds:
            return False
        times, speeds = trace.scan.times, np.linalg.norm(Velocity.evaluate(trace.scan, self.name), axis=1)
        slowest = still(trace, speeds)
        before = speeds[times < event.time - STILL * times[-1]]  # the scan knows both sides of an event, too
        moved = len(before) > 0 and float(before[-1]) > slowest
        return moved and float(speeds[np.searchsorted(times, event.time)]) <= slowest


def _spins_on(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body that has a size turns and slides, and no face lets the one go only with the other."""
    kinds = {coordinate.kind for coordinate in mechanism.body[name].coordinates}
    face = mechanism.contacts.get(name)
    return kinds == {"slide", "hinge"} and extended(mechanism, name) and (face is None or face.friction < inf)


def _starts(mechanism: Mechanism, name: str) -> bool:
    """Whether its centre of mass moves at the start, by whatever coordinate, its own or one of what carries it."""
    speeds = {coordinate.name: coordinate.speed for coordinate in mechanism.coordinates}
    ways = ways_of(mechanism, name, mechanism.body[name].center)
    return hypot(*add(*(scale(speeds[number], way) for number, way in ways.items()))) > EVEN


@MOMENTS.register("halted")
@dataclass(frozen=True, slots=True)
class Halted(Stopped):
    """The last stop of a body that friction brings to rest for good, where it has had others."""

    label = "rest for good"
    kinds = ("stick",)
    most = 0
    may_touch = False
    verb = again = Verb("comes to rest for good", "come to rest for good")

    def is_this(self, event: Event, trace: Trace) -> bool:
        """Return whether it stops then, has stopped before, and nothing ever moves again."""
        if not Stopped.is_this(self, event, trace) or not ends_at_rest(trace):
            return False
        times, speeds = trace.scan.times, _speeds(trace, self.name)
        return (
            bool((speeds[times >= event.time] <= still(trace, speeds)).all())
            and Stopped(self.name).time(trace) != event.time
        )


def _speeds(trace: Trace, name: str) -> Array:
    return np.linalg.norm(Velocity.evaluate(trace.scan, name), axis=1)


@MOMENTS.register("highest_point")
@dataclass(frozen=True, slots=True)
class HighestPoint(TurningPoint):
    """The first time that a body is at the highest point of its path."""

    label = "highest point"
    verb = Verb("reaches the highest point of its path", "reach the highest point of its path")
    local_verb = Verb("stops rising", "stop rising")

    def extent(self, state: State) -> Array:
        """Return its height from where it began."""
        return Displacement.evaluate(state, self.name)[:, 2]

    def excess(self, state: State) -> Array:
        """Return how fast it falls."""
        return -Velocity.evaluate(state, self.name)[:, 2]


STANDS = 1e-3  # of its greatest speed: a hinge that turns more slowly stands still


@MOMENTS.register("lowest_point")
@dataclass(frozen=True, slots=True)
class LowestPoint(TurningPoint):
    """The first time that a body is at the lowest point of its path."""

    label = "lowest point"
    verb = Verb("passes through the lowest point of its path", "pass through the lowest point of its path")
    local_verb = Verb("stops falling", "stop falling")

    def comes(self, study: Study) -> bool:
        """Whether it passes through it: an arm that rocks to one side of its axle turns back where it is lowest."""
        if not super(LowestPoint, self).comes(study):  # slots make another class of this one, which super() misses
            return False
        time, hinges = study.time(self), _hinges(study.mechanism, self.name)
        assert time is not None
        turning, fastest = (
            np.abs(state.v[:, hinges]).max(axis=0) for state in (study.trace.at(time), study.trace.scan)
        )
        return not hinges or bool(np.any(turning > STANDS * fastest))

    def extent(self, state: State) -> Array:
        """Return its depth from where it began."""
        return -Displacement.evaluate(state, self.name)[:, 2]

    def excess(self, state: State) -> Array:
        """Return how fast it rises."""
        return Velocity.evaluate(state, self.name)[:, 2]


def _hinges(mechanism: Mechanism, name: str) -> list[int]:
    """Return the coordinates with which the first body turns that turns at all, of itself and those that carry it."""
    each = ([c for c in body.coordinates if c.kind == "hinge"] for body in chain(mechanism, name))
    return [mechanism.number[c.name] for c in next(filter(None, each), ())]

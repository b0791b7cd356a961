"""The first time that a body that was moving comes to rest."""

from collections.abc import Iterator
from dataclasses import dataclass
from math import hypot, inf
from typing import ClassVar

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.dsl.vectors import add, scale
from sim2reason.quantities.kinematics import Acceleration, Velocity
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.paths import EVEN, extended, rides, ways_of
from sim2reason.questions.choices import STILL, still
from sim2reason.questions.crossing import crossings
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.free_motion import goes_straight_up
from sim2reason.questions.moments.parts.occurrence import Occurrence
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Event, Trace

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
        """Its coordinates turn back, it sticks or slips itself; or something else does that it is tied to."""
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
        """Whether the body is at rest then, and was not before."""
        if event.kind not in self.kinds:
            return False
        times, speeds = trace.scan.times, np.linalg.norm(Velocity.evaluate(trace.scan, self.name), axis=1)
        slowest = still(trace, speeds)
        before = speeds[times < event.time - STILL * times[-1]]  # the scan knows both sides of an event, too
        moved = len(before) > 0 and float(before[-1]) > slowest
        return moved and float(speeds[np.searchsorted(times, event.time)]) <= slowest


def _spins_on(mechanism: Mechanism, name: str) -> bool:
    """Whether a body that has a size turns and slides, and no face lets the one go only with the other."""
    kinds = {coordinate.kind for coordinate in mechanism.body[name].coordinates}
    face = mechanism.contacts.get(name)
    return kinds == {"slide", "hinge"} and extended(mechanism, name) and (face is None or face.friction < inf)


def _starts(mechanism: Mechanism, name: str) -> bool:
    """Whether its centre of mass moves at the start, by whatever coordinate, its own or one of what carries it."""
    speeds = {coordinate.name: coordinate.speed for coordinate in mechanism.coordinates}
    ways = ways_of(mechanism, name, mechanism.body[name].center)
    return hypot(*add(*(scale(speeds[number], way) for number, way in ways.items()))) > EVEN

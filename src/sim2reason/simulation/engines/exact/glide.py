"""The motion of a mechanism whose equations never change: between two events every length is a quadratic of time."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import repeat
from math import hypot, inf

from sim2reason.dsl.mechanism import Inextensible, Meeting
from sim2reason.dsl.points import relative
from sim2reason.dsl.triples import Number, Triple, minus
from sim2reason.dsl.vectors import Vector, inner
from sim2reason.simulation.engines.exact.approach import STILL, Approach, crossing, halt
from sim2reason.simulation.engines.exact.assembly import Assembly
from sim2reason.simulation.engines.exact.balance import Balance
from sim2reason.simulation.engines.exact.lengths import Phase
from sim2reason.simulation.engines.exact.linear import Row
from sim2reason.simulation.engines.exact.margins import Margin, StopReason
from sim2reason.simulation.engines.exact.problem import Gradient
from sim2reason.simulation.engines.exact.system import TOUCHING, Instant, Near, System

Steps = tuple[tuple[int, Vector], ...]  # (number of a coordinate or face, direction)
TIE = 1e-11  # s; events that are no further apart are simultaneous


@dataclass(slots=True)
class _Pair:
    """A meeting whose separation is `apart` + Σ axis·q."""

    meeting: Meeting
    apart: Vector
    slides: Steps
    lifts: Steps

    def approach(self, q: Row, v: Row, a: Row) -> Approach:
        """Their relative motion."""
        return Approach(self.at(q), _carried(self.slides, v), _carried(self.slides, a), self.meeting.distance)

    def at(self, q: Row) -> Vector:
        """From the first to the second."""
        start, moved = self.apart, _carried(self.slides, q)
        return (start[0] + moved[0], start[1] + moved[1], start[2] + moved[2])

    def hit(self, q: Row, v: Row, a: Row) -> float:
        """The time at which they touch next, or infinity."""
        near = self.approach(q, v, a)
        normal = self.meeting.normal
        if normal is None:
            return near.hit()
        gap, rate = inner(normal, near.apart) - near.distance, inner(normal, near.velocity)
        resting = gap <= TOUCHING and abs(rate) <= STILL
        return inf if resting else crossing(gap, rate, inner(normal, near.acceleration))


def _carried(slides: Steps, values: Row) -> Vector:
    x = y = z = 0.0
    for number, axis in slides:
        value = values[number]
        x, y, z = x + axis[0] * value, y + axis[1] * value, z + axis[2] * value
    return (x, y, z)


class SteadyEquations:
    """Equations that are those of the start for ever, and the propagator that follows from that."""

    def __init__(self, system: System) -> None:
        """Assemble everything once."""
        self.system, self.size, self.count = system, system.size, system.count
        rest = [0.0] * self.size
        assembly = Assembly(system.mechanism, system.phase, (rest, rest, 0.0), math, system.frames)
        rows = assembly.rows(system.starts)
        self._loads = system.loads(assembly)
        self._rows = tuple(system.gradient(row) for row in rows)
        self._spare = [float(row.value) for row in rows]
        self._targets = [float(row.target) for row in rows]
        laws = [system.mechanism.line[kind.name].law for kind in system.kinds(system.phase)]
        self._reels = [law.reel if isinstance(law, Inextensible) else 0.0 for law in laws]
        self._pairs = tuple(self._pair(meeting) for meeting in system.mechanism.meetings)
        self._runs = [(run.value, _sparse(run.along)) for run in system.runs.values()]

    def _pair(self, meeting: Meeting) -> _Pair:
        other = self.system.frames.center(meeting.b)
        if meeting.a is None:
            return _Pair(meeting, _plain(other.place), _steps({}, other.gradient), _steps({}, other.lift))
        one = self.system.frames.center(meeting.a)
        apart = minus(other.place, one.place)
        slides, lifts = _steps(one.gradient, other.gradient), _steps(one.lift, other.lift)
        return _Pair(meeting, _plain(apart), slides, lifts)

    def instant(self, time: float, q: Row, v: Row, phase: Phase) -> Instant:
        """The same as ever, but for what is left of each margin; a pair that sticks together is a row of its own."""
        spare, rates = list[float](), list[float]()
        for row, reel, room in zip(self._rows, self._reels, self._spare, strict=True):
            spare.append(room - row.rate(q) - reel * time)
            rates.append(row.rate(v) + reel)
        slips = [grip.slip.rate(v) for grip in self.system.grips]
        pairs = tuple(map(self._near, self._pairs, phase.stuck, repeat(q), repeat(v)))
        rows, targets = self._rows, self._targets
        for near, stuck in zip(pairs, phase.stuck, strict=True):
            if stuck:
                rows, targets = (*rows, near.closing(self.size, self.count)), [*targets, near.bias]
                spare.append(near.gap)
                rates.append(-near.rate)
        return Instant(time, q, v, self._loads, rows, spare, rates, targets, slips, pairs)

    @staticmethod
    def _near(pair: _Pair, stuck: bool, q: Row, v: Row) -> Near:  # noqa: FBT001 - one of several in a map
        """How a pair stands; with its gradient where it touches or sticks together."""
        meeting, apart, velocity = pair.meeting, pair.at(q), _carried(pair.slides, v)
        if meeting.normal is None:
            r = hypot(*apart)
            way = (apart[0] / r, apart[1] / r, apart[2] / r)
            gap, rate = r - meeting.distance, inner(way, velocity)
            bias = (inner(velocity, velocity) - rate * rate) / r
        else:
            way, bias = meeting.normal, 0.0
            gap, rate = inner(way, apart) - meeting.distance, inner(way, velocity)
        if not stuck and gap > TOUCHING:
            return Near(meeting, gap, rate, bias, {}, {})
        along = {number: inner(axis, way) for number, axis in pair.slides}
        return Near(meeting, gap, rate, bias, along, {number: inner(axis, way) for number, axis in pair.lifts})

    # ---- the next event

    def glide(self, instant: Instant, found: Balance, duration: float) -> StopReason:
        """How long the mode lasts, and what is due then."""
        due = [*self._changes(instant, found), *self._finishes(instant, found)]
        soonest = min((time for time, _ in due), default=inf)
        if soonest >= duration:
            return StopReason(
                duration, tuple(m for time, m in due if time <= duration + TIE and m.kind in ("reach", "limit"))
            )
        return StopReason(soonest, tuple(margin for time, margin in due if time <= soonest + TIE))

    def _changes(self, instant: Instant, found: Balance) -> list[tuple[float, Margin]]:
        """When rows are used up, contacts stop sliding, pairs meet."""
        due: list[tuple[float, Margin]] = []
        for number in range(len(self._rows)):
            if not found.mode.acting[number]:
                spare, rate = instant.spare[number], -instant.rates[number]
                if spare > TOUCHING or abs(rate) > STILL:
                    time = crossing(spare, rate, -instant.rows[number].rate(found.a))
                    due.append((time, Margin("spare", number)))
        for number, grip in enumerate(self.system.grips):
            if found.mode.rubbing[number]:
                due.append((halt(instant.slips[number], grip.slip.rate(found.a)), Margin("slip", number)))
        for number, pair in enumerate(self._pairs):
            due.append((pair.hit(instant.q, instant.v, found.a), Margin("gap", number)))
        return due

    def _finishes(self, instant: Instant, found: Balance) -> list[tuple[float, Margin]]:
        """When the description ends."""
        due: list[tuple[float, Margin]] = []
        for number, (length, run) in enumerate(self._runs):
            time = crossing(length + run.rate(instant.q), run.rate(instant.v), run.rate(found.a))
            due.append((time, Margin("reach", number)))
        for number, limit in enumerate(self.system.limits):
            k, sign = limit.coordinate, limit.sign
            time = crossing(limit.room + sign * instant.q[k], sign * instant.v[k], sign * found.a[k])
            due.append((time, Margin("limit", number)))
        return due


def _sparse(along: Mapping[int, Number]) -> Gradient:
    """A gradient of which nothing but the rate is asked."""
    return Gradient([], [], tuple([(number, float(part)) for number, part in sorted(along.items()) if part]))


def _steps(one: Mapping[int, Triple], other: Mapping[int, Triple]) -> Steps:
    return tuple((number, _plain(axis)) for number, axis in relative(one, other).items())


def _plain(vector: Triple) -> Vector:
    """Whoever computes a mechanism with NumPy passes its scalars on, which are slow."""
    return (float(vector[0]), float(vector[1]), float(vector[2]))

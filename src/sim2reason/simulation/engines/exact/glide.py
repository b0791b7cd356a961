"""The motion of a mechanism whose equations never change: between two events every length is a quadratic of time."""

import math
from collections.abc import Mapping
from math import hypot, inf
from typing import NamedTuple

from sim2reason.dsl.mechanism import Inextensible, Meeting
from sim2reason.dsl.triples import Triple, minus, times
from sim2reason.dsl.vectors import Vector, inner
from sim2reason.simulation.engines.exact.approach import STILL, Approach, crossing, halt
from sim2reason.simulation.engines.exact.assembly import Assembly
from sim2reason.simulation.engines.exact.balance import Balance
from sim2reason.simulation.engines.exact.lengths import Phase, relative
from sim2reason.simulation.engines.exact.linear import Row
from sim2reason.simulation.engines.exact.margins import Margin, Stop
from sim2reason.simulation.engines.exact.problem import Gradient, gradient
from sim2reason.simulation.engines.exact.system import TOUCHING, Instant, Near, System

Steps = tuple[tuple[int, Vector], ...]  # (number of a coordinate or face, direction)
TIE = 1e-11  # s; events that are no further apart are simultaneous


class _Pair(NamedTuple):
    """A meeting whose separation is `apart` + Σ axis·q."""

    meeting: Meeting
    apart: Vector
    slides: Steps
    lifts: Steps

    def approach(self, q: Row, v: Row, a: Row) -> Approach:
        """Their relative motion."""
        start, moved = self.apart, _carried(self.slides, q)
        apart = (start[0] + moved[0], start[1] + moved[1], start[2] + moved[2])
        return Approach(apart, _carried(self.slides, v), _carried(self.slides, a), self.meeting.distance)

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
        self._rest = [0.0] * self.size
        at_rest = (self._rest, self._rest, 0.0)
        self._start = system.numbers(Assembly(system.mechanism, system.phase, at_rest, math, system.frames))
        laws = [system.mechanism.line[kind.name].law for kind in system.kinds(system.phase)]
        self._reels = [law.reel if isinstance(law, Inextensible) else 0.0 for law in laws]
        self._pairs = tuple(self._pair(meeting) for meeting in system.mechanism.meetings)
        self._runs = [(length, self._run(*sites)) for sites, length in system.runs.items()]

    def _pair(self, meeting: Meeting) -> _Pair:
        other = self.system.frames.center(meeting.b)
        if meeting.a is None:
            return _Pair(meeting, _plain(other.place), _steps({}, other.gradient), _steps({}, other.lift))
        one = self.system.frames.center(meeting.a)
        apart = minus(other.place, one.place)
        slides, lifts = _steps(one.gradient, other.gradient), _steps(one.lift, other.lift)
        return _Pair(meeting, _plain(apart), slides, lifts)

    def _run(self, first: str, last: str) -> Gradient:
        """How a straight piece of line grows."""
        one, other = self.system.frames.site(first), self.system.frames.site(last)
        apart = minus(other.place, one.place)
        way = times(1.0 / hypot(*apart), apart)
        along = [0.0] * self.size
        for number, axis in _steps(one.gradient, other.gradient):
            along[number] = inner(axis, way)
        return gradient(along, [0.0] * self.count)

    def instant(self, time: float, q: Row, v: Row, phase: Phase) -> Instant:
        """The same as ever, but for what is left of each margin; a pair that sticks together is a row of its own."""
        start = self._start
        spare, rates = list[float](), list[float]()
        for row, reel, room in zip(start.rows, self._reels, start.spare, strict=True):
            spare.append(room - row.rate(q) - reel * time)
            rates.append(row.rate(v) + reel)
        slips = [grip.slip.rate(v) for grip in self.system.grips]
        pairs = tuple(self._nearness(pair, q, v) for pair in self._pairs)
        rows, targets = start.rows, start.targets
        for near, stuck in zip(pairs, phase.stuck, strict=True):
            if stuck:
                rows, targets = (*rows, near.closing), [*targets, near.bias]
                spare.append(near.gap)
                rates.append(-near.rate)
        return Instant(
            time,
            q,
            v,
            start.mass,
            start.lifted,
            start.heave,
            start.force,
            start.press,
            rows,
            spare,
            rates,
            targets,
            slips,
            pairs,
            start.weightless,
        )

    def _nearness(self, pair: _Pair, q: Row, v: Row) -> Near:
        near = pair.approach(q, v, self._rest)
        normal = pair.meeting.normal
        if normal is None:
            r = hypot(*near.apart)
            way, gap, rate, bias = times(1.0 / r, near.apart), r - near.distance, near.rate, near.bend / r
        else:
            way, gap, rate, bias = normal, inner(normal, near.apart) - near.distance, inner(normal, near.velocity), 0.0
        along, lift = [0.0] * self.size, [0.0] * self.count
        for number, axis in pair.slides:
            along[number] = -inner(axis, way)
        for number, axis in pair.lifts:
            lift[number] = -inner(axis, way)
        return Near(pair.meeting, gap, rate, bias, gradient(along, lift))

    # ---- the next event

    def glide(self, instant: Instant, found: Balance, duration: float) -> Stop:
        """How long the mode lasts, and what is due then."""
        due = [*self._changes(instant, found), *self._finishes(instant, found)]
        soonest = min((time for time, _ in due), default=inf)
        if soonest >= duration:
            return Stop(
                duration, tuple(m for time, m in due if time <= duration + TIE and m.kind in ("reach", "limit"))
            )
        return Stop(soonest, tuple(margin for time, margin in due if time <= soonest + TIE))

    def _changes(self, instant: Instant, found: Balance) -> list[tuple[float, Margin]]:
        """When rows are used up, contacts stop sliding, pairs meet."""
        due: list[tuple[float, Margin]] = []
        for number in range(len(self._start.rows)):
            if not found.mode.acting[number]:
                spare, rate = instant.spare[number], -instant.rates[number]
                if spare > TOUCHING or abs(rate) > STILL:
                    time = crossing(spare, rate, -instant.rows[number].rate(found.a))
                    due.append((time, Margin("spare", number)))
        for number, grip in enumerate(self.system.grips):
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


def _steps(one: Mapping[int, Triple], other: Mapping[int, Triple]) -> Steps:
    return tuple((number, _plain(axis)) for number, axis in relative(one, other).items())


def _plain(vector: Triple) -> Vector:
    """Whoever computes a mechanism with NumPy passes its scalars on, which are slow."""
    return (float(vector[0]), float(vector[1]), float(vector[2]))

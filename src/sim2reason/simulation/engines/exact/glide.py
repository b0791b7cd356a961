"""Motions in which every length is a quadratic function of time, and their next event in closed form."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import repeat
from math import hypot, inf, sqrt

import numpy as np

from sim2reason.scenes.dsl.mechanism import CollisionPair, Inextensible
from sim2reason.scenes.dsl.vectors import Number, Triple, Vector, inner, outer, relative, subtract_triples
from sim2reason.simulation.engines.exact.assembly import Assembly
from sim2reason.simulation.engines.exact.balance import Balance
from sim2reason.simulation.engines.exact.lengths import SwitchState
from sim2reason.simulation.engines.exact.linear import Gradient, Row
from sim2reason.simulation.engines.exact.margins import Margin, StopReason
from sim2reason.simulation.engines.exact.system import CONTACT_DISTANCE, Instant, PairState, System

REST_RATE = 1e-9  # m/s, rad/s or m/s²; slower motion counts as rest
ROUND_OFF_TOL = 1e-12  # threshold of round-off


def crossing(c: float, b: float, a: float) -> float:
    """Return the first time at which the event function c + bτ + aτ²/2 reaches zero, in s, or infinity.

    A margin within `CONTACT_DISTANCE` of zero counts as zero: its event is due at once if it decreases, else when it
    returns. Roots are computed in the form without cancellation.
    """
    if c <= CONTACT_DISTANCE:
        if b < -REST_RATE or (b <= REST_RATE and a < -REST_RATE):
            return 0.0
        return -2.0 * b / a if b > REST_RATE and a < -ROUND_OFF_TOL else inf
    square = b * b - 2.0 * a * c
    if square < 0.0 or (b >= 0.0 and a >= 0.0):
        return inf
    return 2.0 * c / (sqrt(square) - b) if b < 0.0 else (b + sqrt(square)) / -a


def stopping_time(speed: float, acceleration: float) -> float:
    """Return the time at which a speed passes through zero, s, or infinity; a coordinate at rest does not stop."""
    return -speed / acceleration if speed * acceleration < 0.0 else inf


@dataclass(slots=True)
class Approach:
    """Relative motion of two bodies at an instant: separation, velocity and acceleration."""

    apart: Vector
    velocity: Vector
    acceleration: Vector
    distance: float  # of the centres at contact

    @property
    def gap(self) -> float:
        """Return the gap between the two bodies, m."""
        return hypot(*self.apart) - self.distance

    @property
    def rate(self) -> float:
        """Return the rate of change of the gap, m/s."""
        return inner(self.apart, self.velocity) / hypot(*self.apart)

    @property
    def second(self) -> float:
        """Return the second derivative of the gap, r̈ = (D·G + W² − ṙ²)/r, m/s²."""
        return (inner(self.apart, self.acceleration) + self.bend) / hypot(*self.apart)

    @property
    def bend(self) -> float:
        """Return the square of the relative speed perpendicular to the line of centres, m²/s²."""
        return inner(self.velocity, self.velocity) - self.rate**2

    @property
    def touching(self) -> bool:
        """Return whether the gap is closed."""
        return self.gap <= CONTACT_DISTANCE

    def hit(self) -> float:
        """Return the time until the gap next closes, s, or infinity."""
        resting = self.touching and abs(self.rate) <= REST_RATE
        if self._is_straight():
            r = hypot(*self.apart)
            pull = inner(self.apart, self.acceleration) / r
            return inf if resting else crossing(self.gap, self.rate, pull)
        if self.touching and self.rate < -REST_RATE:
            return 0.0
        return _first_root(self._polynomial(), 2 if resting else int(self.touching))

    def _is_straight(self) -> bool:
        """Return whether both vectors point along the line of centres."""
        r = hypot(*self.apart)  # cross products are accurate where differences of squares are round-off
        return all(
            hypot(*outer(self.apart, w)) <= ROUND_OFF_TOL * r * (1.0 + hypot(*w))
            for w in (self.velocity, self.acceleration)
        )

    def _polynomial(self) -> Row:
        """Return the coefficients of |D + Wτ + Gτ²/2|² − distance², lowest power first."""
        d, w, g = self.apart, self.velocity, self.acceleration
        square = self.gap * (hypot(*d) + self.distance)
        return [square, 2.0 * inner(d, w), inner(w, w) + inner(d, g), inner(w, g), 0.25 * inner(g, g)]


def _first_root(coefficients: Row, touching: int) -> float:
    """Return the first positive time at which a polynomial, positive before, reaches zero.

    `touching` is the number of roots at time zero, which are divided out.
    """
    left = coefficients[touching:]
    while len(left) > 1 and abs(left[-1]) <= ROUND_OFF_TOL**2:
        left = left[:-1]
    if len(left) <= 3:
        c, b, a = (*left, 0.0, 0.0)[:3]
        return _quadratic(c, b, a)
    roots = np.roots(left[::-1])
    real = [float(root.real) for root in roots if abs(root.imag) <= 1e-7 * abs(root) and root.real > 0.0]
    return min((_polished(left, root) for root in real), default=inf)


def _quadratic(c: float, b: float, a: float) -> float:
    """Return the first positive root of c + bτ + aτ², which is positive at zero."""
    square = b * b - 4.0 * a * c
    if square < 0.0 or (b >= 0.0 and a >= 0.0):
        return inf
    return 2.0 * c / (sqrt(square) - b) if b < 0.0 else (b + sqrt(square)) / (-2.0 * a)


def _polished(coefficients: Row, root: float) -> float:
    """Return the root improved by Newton's method, because eigenvalues of a companion matrix lose digits."""
    for _ in range(3):
        value = slope = 0.0
        for coefficient in reversed(coefficients):
            slope = slope * root + value
            value = value * root + coefficient
        if slope == 0.0:
            break
        root -= value / slope
    return root


Steps = tuple[tuple[int, Vector], ...]  # (index of a coordinate or face, direction)
SIMULTANEITY_TOL = 1e-11  # s; events closer than this are simultaneous


@dataclass(slots=True)
class _Pair:
    """A collision pair with the separation `apart` + Σ axis·q."""

    meeting: CollisionPair
    apart: Vector
    slides: Steps
    lifts: Steps

    def approach(self, q: Row, v: Row, a: Row) -> Approach:
        """Return the relative motion of the pair."""
        return Approach(self.at(q), _carried(self.slides, v), _carried(self.slides, a), self.meeting.distance)

    def at(self, q: Row) -> Vector:
        """Return the vector from the first body to the second, m."""
        start, moved = self.apart, _carried(self.slides, q)
        return (start[0] + moved[0], start[1] + moved[1], start[2] + moved[2])

    def hit(self, q: Row, v: Row, a: Row) -> float:
        """Return the time until the next contact, s, or infinity."""
        near = self.approach(q, v, a)
        normal = self.meeting.normal
        if normal is None:
            return near.hit()
        gap, rate = inner(normal, near.apart) - near.distance, inner(normal, near.velocity)
        resting = gap <= CONTACT_DISTANCE and abs(rate) <= REST_RATE
        return inf if resting else crossing(gap, rate, inner(normal, near.acceleration))


def _carried(slides: Steps, values: Row) -> Vector:
    x = y = z = 0.0
    for number, axis in slides:
        value = values[number]
        x, y, z = x + axis[0] * value, y + axis[1] * value, z + axis[2] * value
    return (x, y, z)


class ConstantEquations:
    """Equations of motion that are constant in time, with their closed-form solution."""

    def __init__(self, system: System) -> None:
        """Assemble the constant equations once."""
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

    def _pair(self, meeting: CollisionPair) -> _Pair:
        other = self.system.frames.center(meeting.b)
        if meeting.a is None:
            return _Pair(meeting, _python_floats(other.place), _steps({}, other.gradient), _steps({}, other.lift))
        one = self.system.frames.center(meeting.a)
        offset = subtract_triples(other.place, one.place)
        slides, lifts = _steps(one.gradient, other.gradient), _steps(one.lift, other.lift)
        return _Pair(meeting, _python_floats(offset), slides, lifts)

    def instant(self, time: float, q: Row, v: Row, phase: SwitchState) -> Instant:
        """Return the equations at one instant, constant except for distances to events and rows of stuck pairs."""
        spare, rates = list[float](), list[float]()
        for row, reel, room in zip(self._rows, self._reels, self._spare, strict=True):
            spare.append(room - row.rate(q) - reel * time)
            rates.append(row.rate(v) + reel)
        slips = [grip.slip.rate(v) for grip in self.system.grips]
        pairs = tuple(map(self._pair_state, self._pairs, phase.stuck, repeat(q), repeat(v)))
        rows, targets = self._rows, self._targets
        for near, stuck in zip(pairs, phase.stuck, strict=True):
            if stuck:
                rows, targets = (*rows, near.closing(self.size, self.count)), [*targets, near.bias]
                spare.append(near.gap)
                rates.append(-near.rate)
        return Instant(time, q, v, self._loads, rows, spare, rates, targets, slips, pairs)

    @staticmethod
    def _pair_state(pair: _Pair, stuck: bool, q: Row, v: Row) -> PairState:  # noqa: FBT001 - one of several in a map
        """Return the gap of a collision pair with its rates, and with its gradient if the bodies touch or stick."""
        meeting, offset, velocity = pair.meeting, pair.at(q), _carried(pair.slides, v)
        if meeting.normal is None:
            r = hypot(*offset)
            direction = (offset[0] / r, offset[1] / r, offset[2] / r)
            gap, rate = r - meeting.distance, inner(direction, velocity)
            bias = (inner(velocity, velocity) - rate * rate) / r
        else:
            direction, bias = meeting.normal, 0.0
            gap, rate = inner(direction, offset) - meeting.distance, inner(direction, velocity)
        if not stuck and gap > CONTACT_DISTANCE:
            return PairState(meeting, gap, rate, bias, {}, {})
        along = {number: inner(axis, direction) for number, axis in pair.slides}
        return PairState(
            meeting, gap, rate, bias, along, {number: inner(axis, direction) for number, axis in pair.lifts}
        )

    # ---- the next event

    def glide(self, instant: Instant, found: Balance, duration: float) -> StopReason:
        """Return the duration of the contact mode and the event functions that end the mode."""
        due = [*self._changes(instant, found), *self._finishes(instant, found)]
        soonest = min((time for time, _ in due), default=inf)
        if soonest >= duration:
            return StopReason(
                duration,
                tuple(m for time, m in due if time <= duration + SIMULTANEITY_TOL and m.kind in ("reach", "limit")),
            )
        return StopReason(soonest, tuple(margin for time, margin in due if time <= soonest + SIMULTANEITY_TOL))

    def _changes(self, instant: Instant, found: Balance) -> list[tuple[float, Margin]]:
        """Return the times, s, at which constraints tighten, sliding stops or pairs collide, with event functions."""
        due: list[tuple[float, Margin]] = []
        for number in range(len(self._rows)):
            if not found.mode.acting[number]:
                spare, rate = instant.spare[number], -instant.rates[number]
                if spare > CONTACT_DISTANCE or abs(rate) > REST_RATE:
                    time = crossing(spare, rate, -instant.rows[number].rate(found.a))
                    due.append((time, Margin("spare", number)))
        for number, grip in enumerate(self.system.grips):
            if found.mode.rubbing[number]:
                due.append((stopping_time(instant.slips[number], grip.slip.rate(found.a)), Margin("slip", number)))
        for number, pair in enumerate(self._pairs):
            due.append((pair.hit(instant.q, instant.v, found.a), Margin("gap", number)))
        return due

    def _finishes(self, instant: Instant, found: Balance) -> list[tuple[float, Margin]]:
        """Return the times, s, of events that end the motion, each with its event function."""
        due: list[tuple[float, Margin]] = []
        for number, (length, run) in enumerate(self._runs):
            time = crossing(length + run.rate(instant.q), run.rate(instant.v), run.rate(found.a))
            due.append((time, Margin("reach", number)))
        for number, limit in enumerate(self.system.limits):
            k, sign = limit.coordinate, limit.sign
            time = crossing(limit.initial_travel + sign * instant.q[k], sign * instant.v[k], sign * found.a[k])
            due.append((time, Margin("limit", number)))
        return due


def _sparse(along: Mapping[int, Number]) -> Gradient:
    """Return a gradient in sparse form alone, from which only rates of change can be computed."""
    return Gradient([], [], tuple([(number, float(part)) for number, part in sorted(along.items()) if part]))


def _steps(one: Mapping[int, Triple], other: Mapping[int, Triple]) -> Steps:
    return tuple((number, _python_floats(axis)) for number, axis in relative(one, other).items())


def _python_floats(vector: Triple) -> Vector:
    """Return the vector with Python floats, as NumPy scalars are slow."""
    return (float(vector[0]), float(vector[1]), float(vector[2]))

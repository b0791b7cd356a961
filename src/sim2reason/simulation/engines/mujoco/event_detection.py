"""Detection of events between impacts, by event functions that decrease to zero as bodies move.

Gradients are MuJoCo's own, computed once: in a mechanism whose strings do not bend they are constant.
Each margin is extrapolated as a quadratic function of time from its value, rate and second derivative. This is exact
except for pairs that collide in two dimensions under unequal accelerations; then the step to the predicted instant
ends slightly early, and the next one approaches it.
"""

from math import inf
from typing import NamedTuple

import numpy as np

from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.mechanism import Inextensible, Line
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.mujoco.compiled_model import CompiledModel, Flags

TOUCHING = 1e-8  # m; smaller distances count as contact
REST_RATE = 1e-7  # m/s or m/s²; slower motion counts as rest: round-off and the solver's tolerance
STRAIGHT = 1e-18  # m²/s² or m²/s⁴; smaller components perpendicular to the line of centres count as zero
DEPTH = 1e-11  # m; bodies with a smaller overlap only touch
COINCIDENCE_DISTANCE = 1e-5  # m; sites that are closer may be about to coincide
BENDING_LENGTH_TOL = 1e-6  # m; largest difference between a string's length and that of a straight one
ZERO_GRADIENT_TOL = 1e-9  # smaller entries of a gradient are round-off


class Margins(NamedTuple):
    """Event functions with their rates and second derivatives, (k,) each."""

    value: Array
    rate: Array
    second: Array

    def used_up(self) -> Array:
        """Return the time until each event function reaches zero, s; infinity if it never does."""
        f, b, c = self
        near = f <= TOUCHING
        root = np.sqrt(np.maximum(b * b - 2.0 * c * f, 0.0))
        with np.errstate(divide="ignore", invalid="ignore"):
            times = np.where(b < 0.0, 2.0 * f / (root - b), (b + root) / -c)
            back = -2.0 * b / c
        times = np.where((b * b < 2.0 * c * f) | ((b >= 0.0) & (c >= 0.0)), inf, times)
        at_once = (b < -REST_RATE) | ((b <= REST_RATE) & (c < -REST_RATE))
        later = np.where((b > REST_RATE) & (c < 0.0), back, inf)
        return np.where(near, np.where(at_once, 0.0, later), times)


class Encounter(NamedTuple):
    """The relative motion of the pairs that may collide: separations (p, 3), their rates and Jacobians."""

    apart: Array
    velocity: Array
    acceleration: Array
    distance: Array  # of the centres at contact, (p,)

    @property
    def gaps(self) -> Margins:
        """Return each gap, or in a plane (r² − d²)/2d, as an event function quadratic in time, with its derivatives.

        In a plane the gap is not quadratic, but (|D|² − d²)/2d is; it has the same zero, and the same rate there.
        """
        d, w, g, r = self.apart, self.velocity, self.acceleration, np.linalg.norm(self.apart, axis=1)
        along, pull = (d * w).sum(axis=1), (d * g).sum(axis=1)
        bend = (w * w).sum(axis=1) - (along / r) ** 2
        turn = (g * g).sum(axis=1) - (pull / r) ** 2
        straight = (bend <= STRAIGHT) & (turn <= STRAIGHT)
        touch = self.distance
        square = Margins(0.5 * (r**2 / touch - touch), along / touch, ((w * w).sum(axis=1) + pull) / touch)
        line = Margins(r - touch, along / r, (bend + pull) / r)
        return Margins(*(np.where(straight, x, y) for x, y in zip(line, square, strict=True)))


class EventDetector:
    """The event functions of one mechanism: string slack, travel limits, line lengths and gaps between bodies."""

    def __init__(self, model: CompiledModel) -> None:
        """Read the initial geometry.

        Raises:
            SceneError: two sites of a string coincide, or two bodies overlap.
        """
        self._model = model
        mechanism = model.mechanism
        self.slack: Array = np.array([slack_of(string) for string in mechanism.strings])
        self._strings = model.gradients[: len(mechanism.strings)]
        self.ends: list[tuple[str, tuple[str, ...]]] = []
        self._offsets: Array = np.zeros(0)
        self._ends: Array = np.zeros((0, model.size))
        self._read_runs()
        self._read_limits()
        self._read_pairs()

    def _end(self, kind: str, subjects: tuple[str, ...], offset: float, gradient: Array) -> None:
        self.ends.append((kind, subjects))
        self._offsets = np.append(self._offsets, offset)
        self._ends = np.vstack([self._ends, gradient])

    def _read_runs(self) -> None:
        mechanism, seen = self._model.mechanism, set[tuple[str, str]]()
        for line in mechanism.lines:
            for first, last in zip(line.through, line.through[1:], strict=False):
                if (first, last) in seen:
                    continue
                seen.add((first, last))
                (start, moves), (stop, moved) = self._model.site(first), self._model.site(last)
                apart, gradient = stop - start, moved - moves
                length = float(np.linalg.norm(apart))
                if np.abs(gradient).max(initial=0.0) <= ZERO_GRADIENT_TOL:
                    continue
                if length <= TOUCHING:
                    message = f"sites {first} and {last} coincide at the start"
                    raise SceneError(line.name, message, "leave some string between")
                self._end("reach", (first, last), length, apart @ gradient / length)

    def _read_limits(self) -> None:
        for number, coordinate in zip(self._model.coordinates, self._model.mechanism.coordinates, strict=True):
            unit = np.zeros(self._model.size)
            unit[number] = 1.0
            if coordinate.lower > -inf:
                self._end("limit", (coordinate.name,), -coordinate.lower, unit)
            if coordinate.upper < inf:
                self._end("limit", (coordinate.name,), coordinate.upper, -unit)

    def _read_pairs(self) -> None:
        pairs = self._model.mechanism.meetings
        self._apart = np.zeros((len(pairs), 3))
        self._moves = np.zeros((len(pairs), 3, self._model.size))
        self._distance = np.array([pair.distance for pair in pairs])
        for number, pair in enumerate(pairs):
            (a, a_moves), (b, b_moves) = self._model.center(pair.names[0]), self._model.center(pair.b)
            self._apart[number], self._moves[number] = b - a, b_moves - a_moves
            if np.linalg.norm(b - a) < pair.distance - TOUCHING:
                raise SceneError(pair.names[0], f"it overlaps {pair.b} at the start", "move them apart")

    def finish(self, q: Array, v: Array, a: Array) -> Margins:
        """Return the event functions of the events that end the motion."""
        return Margins(self._offsets + self._ends @ q, self._ends @ v, self._ends @ a)

    def strings(self, q: Array, v: Array, a: Array) -> Margins:
        """Return the event functions of the strings: the lengths by which they may still grow."""
        return Margins(self.slack - self._strings @ q, -self._strings @ v, -self._strings @ a)

    def approach(self, q: Array, v: Array, a: Array) -> Encounter:
        """Return the relative motion of the collision pairs."""
        return Encounter(self._apart + self._moves @ q, self._moves @ v, self._moves @ a, self._distance)

    def closing(self, q: Array) -> Array:
        """Return the gradients of the gaps, (pairs, joints)."""
        apart = self._apart + self._moves @ q
        unit = apart / np.linalg.norm(apart, axis=1)[:, None]
        return np.einsum("pi,pij->pj", unit, self._moves)

    def next_change(self, q: Array, v: Array, a: Array, loose: Flags, sliding: Array) -> float:
        """Return the time until a string becomes taut, a pair collides, or a rough contact stops sliding, s."""
        soonest = inf
        if loose.any():
            soonest = float(self.strings(q, v, a).used_up()[loose].min())
        if len(self._distance):
            soonest = min(soonest, float(self.approach(q, v, a).gaps.used_up().min()))
        rubs = self._model.rubs
        return min(soonest, float(_stops(sliding * v[rubs], sliding * a[rubs]).min(initial=inf)))

    def too_far(self, q: Array, v: Array, duration: float) -> float:
        """Return the time by which a step of this duration ends too late, s, as two bodies overlap; 0 if none do."""
        if not len(self._distance):
            return 0.0
        gaps = self.approach(q, v, np.zeros(len(v))).gaps
        worst = int(gaps.value.argmin())
        depth, rate = -float(gaps.value[worst]), float(gaps.rate[worst])
        if depth <= DEPTH:
            return 0.0
        return depth / -rate if 0.0 < depth < -rate * duration else 0.5 * duration

    def bent(self) -> bool:
        """Return whether a string is longer than its initial gradient predicts, so that it bends over a site.

        Strings about to end are skipped, since one of their segments may have passed through zero length.
        """
        model = self._model
        if np.all(np.abs(model.lengths - model.bare @ model.q) <= BENDING_LENGTH_TOL):
            return False
        return bool(np.all(self.finish(model.q, model.v, model.v).value > COINCIDENCE_DISTANCE))


def slack_of(line: Line) -> float:
    """Return the initial slack of a string, m."""
    return line.law.slack if isinstance(line.law, Inextensible) else 0.0


def _stops(speed: Array, acceleration: Array) -> Array:
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(acceleration < 0.0, np.where(speed > 0.0, -speed / acceleration, 0.0), inf)

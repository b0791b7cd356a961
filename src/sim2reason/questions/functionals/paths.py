"""Distances travelled, angles and areas swept, reversals of the direction of motion, and motion on circles."""

from collections.abc import Sequence
from math import degrees

import numpy as np

from sim2reason.questions.choices import rest_speed
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.aggregates import EventCount, Integral
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.angles import Deflected, Orbited, TurnedThrough
from sim2reason.questions.moments.crossings import crossings
from sim2reason.questions.moments.extrema import Apsis
from sim2reason.questions.moments.turning_points import LowestPoint, Stopped
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Inextensible, Mechanism
from sim2reason.scenes.dsl.state import Array, State, row_lengths
from sim2reason.simulation.quantities.kinematics import AngleTurned, AngularVelocity, Displacement, Velocity
from sim2reason.simulation.quantities.relative import DistanceBetween
from sim2reason.simulation.quantities.subjects.bodies import (
    Bodies,
    TurningBodies,
    ancestor_chain,
    can_move,
    center_path,
    moves_on_slider,
)
from sim2reason.simulation.quantities.subjects.interactions import Pairs, members
from sim2reason.simulation.trace import Channel, Trace


def circles(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body turns about a single fixed axle, or is held by a string to a fixed point."""
    kinds = [c.kind for body in ancestor_chain(mechanism, name) for c in body.coordinates]
    return kinds == ["hinge"] or _hangs(mechanism, name)


def _hangs(mechanism: Mechanism, name: str) -> bool:
    """Return whether the only line is a string from a fixed point to the body."""
    if len(mechanism.lines) != 1 or not isinstance(mechanism.lines[0].law, Inextensible):
        return False
    ends = [mechanism.site[site].body for site in mechanism.lines[0].through]
    return len(ends) == 2 and set(ends) == {None, name}


def leaves_circle(trace: Trace, end: float) -> bool:
    """Return whether a string goes slack before a time, s, so that its body leaves the circle."""
    return any(event.kind == "slack" and event.time <= end for event in trace.events)


def is_given_by_geometry(moment: Moment, words: Words) -> bool:
    """Return whether geometry alone gives a body's position on its circle at a moment, as at the end of a swing."""
    known = isinstance(moment, Deflected | LowestPoint | TurnedThrough)
    return known or (words.released and isinstance(moment, Stopped))


MIN_ANGLE_EXCESS = 0.02  # of the angle: least excess over the net angle that is worth asking for


@functional
class AngleSwept(Integral):
    """The total angle, in both senses, through which a body turns about one axle."""

    name, unit, least = "total angle", "deg", 0.1
    of = TurningBodies()
    phrase = "the total angle through which {body} turns"
    how = "through what angle does {body} turn altogether, to and fro, {when}?"

    def rate(self, state: State, name: str) -> Array:
        """Return the angular speed |ω|, degrees per second, (n,)."""
        return degrees(1.0) * row_lengths(AngularVelocity.evaluate(state, name))

    def present(self, words: Words, name: str) -> bool:
        """Return whether the body turns on one hinge and does not roll, so that the engine records its reversals."""
        mechanism = words.mechanism
        hinges = [c for c in mechanism.body[name].coordinates if c.kind == "hinge"]
        return len(hinges) == 1 and mechanism.body[name].parent is None and name in AngleTurned().subjects(mechanism)

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """Return phrases for the interval; none where geometry alone gives the angle."""
        return () if is_given_by_geometry(moment, words) else super().when(moment, words, name)

    def worth(self, study: SimulatedScene, name: str, end: float) -> bool:
        """Return whether the body turns back, so that the total exceeds the net angle."""
        total = self.value(study.trace, name, end) or 0.0
        net = abs(float(AngleTurned.evaluate(study.trace.at(end), name)[0]))
        return total - net > MIN_ANGLE_EXCESS * total and super().worth(study, name, end)

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Return the channel of the angular velocity."""
        del mechanism
        return (Channel(name, AngularVelocity.name),)


@functional
class AreaSwept(Integral):
    """The area swept out by the line from a fixed body to one that it attracts, as in Kepler's second law."""

    name, unit, least = "area swept", "m^2", 1e-4
    of = Pairs()
    phrase = "the area that the line between {pair} sweeps out"
    how = "how large an area does the line between {pair} sweep out {when}?"
    weight = 0.3

    def rate(self, state: State, name: str) -> Array:
        """Return the magnitude ½|r × v| of the areal velocity, the area swept per unit time, (n,)."""
        return row_lengths(_areal_velocity(state, name))

    def worth(self, study: SimulatedScene, name: str, end: float) -> bool:
        """Return whether the line turns in one sense only, as otherwise the sign of areas is ambiguous."""
        scan = study.trace.scan
        swept = _areal_velocity(scan, name)[scan.times <= end]
        return super().worth(study, name, end) and bool((swept @ swept.mean(axis=0) >= 0.0).all())

    def present(self, words: Words, name: str) -> bool:
        """Return whether one body of the pair is fixed and attracts the other."""
        pulls = any({pull.a, pull.b} == set(members(name)) for pull in words.mechanism.attractions)
        return pulls and sum(can_move(words.mechanism, body) for body in members(name)) == 1

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """Return phrases for intervals that end with an event of the orbit; a stated time would need no gravitation."""
        return super().when(moment, words, name) if isinstance(moment, Orbited | Apsis) and moment.name == name else ()

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Return the channels of both velocities and the distance."""
        del mechanism
        velocities = (Channel(body, Velocity.name) for body in members(name))
        return (Channel(name, DistanceBetween.name), *velocities)


def _areal_velocity(state: State, name: str) -> Array:
    """Return the areal velocity ½ r × v, (n, 3)."""
    a, b = members(name)
    separation = state.vector(state.frames.center(b).place) - state.vector(state.frames.center(a).place)
    parting = Velocity.evaluate(state, b) - Velocity.evaluate(state, a)
    return 0.5 * np.cross(separation, parting)


@functional
class DistanceTravelled(Integral):
    """The length of the path of a body along a line, or on a circle."""

    name, unit, least = "distance travelled", "m", 1e-3
    of, center = Bodies(), True
    phrase = "the total distance that {body} travels{ground}"
    how = "how far does {body} travel in all{ground} {when}?"
    indirect = "how far {body} travels in all{ground}"
    weight = 2.0

    def rate(self, state: State, name: str) -> Array:
        """Return the speed, m/s, (n,)."""
        return row_lengths(Velocity.evaluate(state, name))

    def corners(self, trace: Trace, name: str) -> list[float]:
        """Return the times, s, at which a body on a line reverses; none on a circle, where the engine records them."""
        path = center_path(trace.mechanism, name)
        if not path.straight:
            return []
        return trace.memoize(("reversals", name), lambda: _reversal_times(trace, name, np.array(path.ways[0])))

    def present(self, words: Words, name: str) -> bool:
        """Return whether the body moves along a line or on a circle."""
        return center_path(words.mechanism, name).straight or circles(words.mechanism, name)

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """Return phrases for the interval; none on a circle where geometry alone gives the arc."""
        is_trivial = circles(words.mechanism, name) and is_given_by_geometry(moment, words)
        return () if is_trivial else super().when(moment, words, name)

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Return the channels of the body's velocity and displacement."""
        del mechanism
        return (Channel(name, Velocity.name), Channel(name, Displacement.name))

    def worth(self, study: SimulatedScene, name: str, end: float) -> bool:
        """Return whether the distance exceeds the displacement and, on a circle, the body stays on it."""
        if circles(study.mechanism, name) and leaves_circle(study.trace, end):
            return False
        path = self.value(study.trace, name, end) or 0.0
        direct = float(np.linalg.norm(Displacement.evaluate(study.trace.at(end), name)[0]))
        return path - direct > MIN_ANGLE_EXCESS * path and super().worth(study, name, end)


def _reversal_times(trace: Trace, name: str, direction: Array) -> list[float]:
    senses = (direction, -direction)
    return [time for sense in senses for time in crossings(trace, lambda s, x=sense: Velocity.evaluate(s, name) @ x)]


@functional
class Reversals(EventCount):
    """The number of times that a body on a line reverses its direction of motion."""

    name = "number of reversals"
    of = Bodies()
    phrase = "the number of times that {body} reverses its direction of motion"
    how = "how many times does {body} reverse its direction of motion {when}?"
    indirect = "how many times {body} reverses its direction of motion"
    weight = 2.0

    def present(self, words: Words, name: str) -> bool:
        """Return whether the body moves along one fixed line."""
        return center_path(words.mechanism, name).straight and not moves_on_slider(words.mechanism, name)

    def times(self, trace: Trace, name: str) -> Sequence[float]:
        """Return the times, s, at which the velocity changes sign on the line.

        Halts without a reversal do not count.
        """
        direction = np.array(center_path(trace.mechanism, name).ways[0])
        speeds = Velocity.evaluate(trace.scan, name) @ direction
        clear = np.flatnonzero(np.abs(speeds) > rest_speed(trace, speeds))
        times, speeds = trace.scan.times[clear], speeds[clear]
        (before,) = np.nonzero(speeds[1:] * speeds[:-1] < 0.0)
        shares = speeds[before] / (speeds[before] - speeds[before + 1])
        return (times[before] + shares * (times[before + 1] - times[before])).tolist()

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Return the channel of the body's velocity."""
        del mechanism
        return (Channel(name, Velocity.name),)

"""Moments given by angles of lines, of bodies on axles and of orbits."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from sim2reason.questions.moments import MOMENTS, Clause
from sim2reason.questions.moments.crossings import Passage, Threshold
from sim2reason.questions.moments.occurrence import Verb, when_phrases
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words, rounded_as_written
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.quantities.kinematics import AngleTurned
from sim2reason.simulation.quantities.positions import Deflection, deflection_at_start
from sim2reason.simulation.quantities.subjects.bodies import TurningBodies, center_path
from sim2reason.simulation.quantities.subjects.interactions import Pairs, members
from sim2reason.simulation.quantities.subjects.rotating_parts import SwingingLines
from sim2reason.simulation.trace import Channel, Trace

STRAIGHT_UP = 180.0  # degrees
MIN_SWING_ANGLE = 10.0  # degrees: least amplitude of a swing, and least distance from its ends


@MOMENTS.register("deflected")
@dataclass(frozen=True, slots=True)
class Deflected(Threshold):
    """The first time that a swinging line makes a stated angle with the downward vertical."""

    label = "deflection"
    of = SwingingLines()
    verb = Verb("makes", "make")
    hangs_on = "deflection"
    unit = "deg"

    @classmethod
    def drawn(cls, name: str, trace: Trace, rng: np.random.Generator) -> float | None:
        """Return a random angle within the swing, a multiple of 5° (10° from 100° on); None if there is none."""
        angles = Deflection.evaluate(trace.scan, name)
        low, high = float(np.nanmin(angles)), float(np.nanmax(angles))
        if high - low < MIN_SWING_ANGLE:
            return None
        angle = rounded_as_written(5.0 * max(1, round((low + rng.uniform(0.15, 0.85) * (high - low)) / 5.0)))
        return angle if low < angle < high else None

    @property
    def revealed_channels(self) -> tuple[Channel, ...]:
        """Return the channels of the line's angle and of its rotation, which the angle determines."""
        return (*self.channels, Channel(self.name, "angle turned"))

    def excess(self, state: State) -> Array:
        """Return by how many degrees the line is beyond the angle, positive on the far side of the start, (n,)."""
        beyond = Deflection.evaluate(state, self.name) - self.value
        return beyond if deflection_at_start(state, self.name) < self.value else -beyond

    def mirrored_values(self, trace: Trace) -> Sequence[float] | None:
        """Return the angle, in degrees, that differs from the initial one by the inverse factor; None above 180°."""
        start = deflection_at_start(trace.state, self.name)
        other = start * start / self.value
        return (other,) if 0.0 < other < STRAIGHT_UP else None

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return phrases such as *when the string first makes an angle of 20° with the downward vertical*."""
        line, angle = self.subject(words), f"an angle of {words.say(self.value, self.unit)} with the downward vertical"
        return (
            f"when {line} first makes {angle}",
            f"at the moment when {line} first makes {angle}",
            f"when {line} makes {angle} for the first time",
        )

    def clause(self, words: Words) -> Clause | None:
        """Return the clause, such as *the string first makes an angle of 20° with the downward vertical*."""
        angle = f"an angle of {words.say(self.value, self.unit)} with the downward vertical"
        return Clause(self.subject(words), "does", f"first make {angle}", f"first makes {angle}")


FULL_TURN_DEGREES = 360
ORBIT_ANGLES = (90, 180, FULL_TURN_DEGREES)  # degrees


@MOMENTS.register("orbited")
@dataclass(frozen=True, slots=True)
class Orbited(Passage):
    """The moment when the line from a fixed body to one that it attracts has turned through 90°, 180° or 360°."""

    label = "orbit"
    of = Pairs()
    hangs_on = "distance"
    pronoun = ""
    verb = Verb("has completed one orbit", "completed one orbit", "has")

    degrees: int = FULL_TURN_DEGREES

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the pairs of a fixed body and one that it attracts, with their phrases."""
        mechanism = words.mechanism
        drawn = {frozenset((pull.a, pull.b)) for pull in mechanism.attractions}
        phrases: dict[str, str] = {}
        for name, phrase in words.subject_phrases(cls.of).items():
            still = [body for body in members(name) if not center_path(mechanism, body).ways]
            if len(still) == 1 and frozenset(members(name)) in drawn:
                phrases[name] = phrase
        return phrases

    @classmethod
    def found(cls, study: SimulatedScene, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Return the moments at which each orbiting body has turned through 90°, 180° and 360°, if they occur."""
        del rng
        return [
            moment
            for name in cls.candidates(words)
            for part in ORBIT_ANGLES
            if (moment := cls(name, part)).comes(study)
        ]

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """Yield every fraction of an orbit of every body that a sentence names."""
        del trace
        for name in cls.candidates(words):
            if cls(name).ends(words)[1] in text:
                yield from (cls(name, part) for part in ORBIT_ANGLES)

    @property
    def requires_return(self) -> bool:
        """Return whether the angle is a full turn, which a body on a hyperbola never completes."""
        return self.degrees == FULL_TURN_DEGREES

    def ends(self, words: Words) -> tuple[str, str]:
        """Return the phrases for the fixed body and the orbiting body."""
        a, b = members(self.name)
        center, planet = (b, a) if center_path(words.mechanism, a).ways else (a, b)
        return words.mentions[center], words.mentions[planet]

    def _arm(self, state: State) -> tuple[Array, Array, Array]:
        """Return the line between the bodies, m, (n, 3), its initial value, m, and the initial rate of change, m/s."""
        a, b = members(self.name)
        now = state.vector(state.frames.center(b).place) - state.vector(state.frames.center(a).place)
        began = np.subtract(state.began.center(b).place, state.began.center(a).place)
        rates = {body: np.zeros(3) for body in (a, b)}
        for body in (a, b):
            for coordinate in state.mechanism.body[body].coordinates:
                rates[body] += coordinate.speed * np.array(coordinate.axis)
        return now, began, rates[b] - rates[a]

    def excess(self, state: State) -> Array:
        """Return a product of the line's present and initial vectors, (n,), that rises through zero at the angle."""
        now, began, rate = self._arm(state)
        spin = np.cross(began, rate)
        sine = np.cross(began, now) @ spin
        return {90: -(now @ began), 180: -sine, FULL_TURN_DEGREES: sine}[self.degrees]

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return the phrases for the moment, such as *when planet A has completed one orbit*."""
        center, planet = self.ends(words)
        done = (
            f"{planet} {self.verb.told}" if self.degrees == FULL_TURN_DEGREES else self._swept(center, planet, "has ")
        )
        return when_phrases(done)

    def clause(self, words: Words) -> Clause | None:
        """Return the clause, such as *planet A has completed one orbit*."""
        center, planet = self.ends(words)
        if self.degrees == FULL_TURN_DEGREES:
            return Clause(planet, "has", self.verb.asked, self.verb.told, "to complete one orbit")
        participle = f"turned through {self.degrees}°"
        return Clause(
            f"the line from {center} to {planet}",
            "has",
            participle,
            f"has {participle}",
            f"to turn through {self.degrees}°",
        )

    def _swept(self, center: str, planet: str, auxiliary: str) -> str:
        return f"the line from {center} to {planet} {auxiliary}turned through {self.degrees}°"


MAX_TURN_DEGREES = 330.0  # degrees


@MOMENTS.register("turned_through")
@dataclass(frozen=True, slots=True)
class TurnedThrough(Threshold):
    """The first time that a body on an axle has turned through a stated angle from its initial position."""

    label = "turned"
    of = TurningBodies()
    verb = Verb("has turned", "turned", "has")
    hangs_on = "angle turned"
    unit = "deg"

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the bodies on one axle that do not roll, with their phrases."""
        turning = AngleTurned().subjects(words.mechanism)
        return {name: phrase for name, phrase in words.subject_phrases(cls.of).items() if name in turning}

    @classmethod
    def drawn(cls, name: str, trace: Trace, rng: np.random.Generator) -> float | None:
        """Return a random angle below the greatest one, degrees, a multiple of 5 (10 from 100 on); None without one."""
        reached = float(np.abs(AngleTurned.evaluate(trace.scan, name)).max())
        angle = rounded_as_written(5.0 * max(1, round(rng.uniform(0.2, 0.9) * min(reached, MAX_TURN_DEGREES) / 5.0)))
        return angle if angle < reached else None

    @property
    def revealed_channels(self) -> tuple[Channel, ...]:
        """Return the channels of the angle turned and of the angle with the vertical."""
        return (*self.channels, Channel(self.name, "deflection"))

    def excess(self, state: State) -> Array:
        """Return by how many degrees the body has turned beyond the angle, in either sense, (n,)."""
        return np.abs(AngleTurned.evaluate(state, self.name)) - self.value

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return phrases such as *when the rod has turned through 30° from its starting position*."""
        turned = f"{self.subject(words)} has first turned through {self.said(words)} from its starting position"
        return when_phrases(turned)

    def clause(self, words: Words) -> Clause | None:
        """Return the clause, such as *the rod has first turned through 30° from its starting position*."""
        turned = f"first turned through {self.said(words)} from its starting position"
        takes = f"to turn through {self.said(words)} from its starting position for the first time"
        return Clause(self.subject(words), "has", turned, f"has {turned}", takes)

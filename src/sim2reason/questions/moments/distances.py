"""Moments given by distances, among them the shortest and longest distance of two bodies."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Self

import numpy as np

from sim2reason.questions.choices import only_falls
from sim2reason.questions.moments import MOMENTS, Clause
from sim2reason.questions.moments.crossings import Passage, acting_on, crossings, first_crossing
from sim2reason.questions.moments.extrema import Apsis, goes_straight_up
from sim2reason.questions.moments.occurrence import Verb, when_phrases
from sim2reason.questions.moments.reached import DistanceThreshold
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import ZERO, Mechanism
from sim2reason.scenes.dsl.state import Array, State, row_lengths
from sim2reason.scenes.dsl.structure import may_reverse
from sim2reason.simulation.quantities.kinematics import Acceleration, Displacement, Velocity
from sim2reason.simulation.quantities.relative import DistanceBetween
from sim2reason.simulation.quantities.subjects import Sense
from sim2reason.simulation.quantities.subjects.bodies import (
    AXES,
    OPPOSITE,
    RIGHT,
    UP,
    Bodies,
    center_path,
    moves_on_slider,
)
from sim2reason.simulation.trace import Trace

SELDOM = 0.05


@MOMENTS.register("away")
@dataclass(frozen=True, slots=True)
class Away(DistanceThreshold):
    """The first time that a body moving freely in a plane is a stated distance from its starting point."""

    label = "away"
    verb = Verb("is", "", "is")

    @classmethod
    def found(cls, study: SimulatedScene, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Return a moment with a random distance; none for a projectile, whose range and height are asked for instead.

        In fields that turn the velocity the moment is rare, as the angle of the velocity is more instructive.
        """
        mechanism = study.mechanism
        thrown = only_falls(mechanism) and mechanism.gravity != ZERO
        acting = [acts for name in cls.candidates(words) if (acts := acting_on(mechanism, name)) is not None]
        if thrown or (any(acts.turning for acts in acting) and rng.random() > SELDOM):
            return []
        return super(Away, cls).found(study, words, rng)

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the bodies with axes x and y in the text, with their phrases."""
        mechanism = words.mechanism
        called = words.subject_phrases(cls.of).items()
        return {n: s for n, s in called if _has_axes(words, n) and not center_path(mechanism, n).straight}

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return the phrases for the moment, such as *when the puck is first 0.50 m from its starting point*."""
        first = f"{self.subject(words)} is first {self.said(words)} from its starting point"
        return when_phrases(first)

    def clause(self, words: Words) -> Clause | None:
        """Return the clause, such as *the puck is first 0.50 m from its starting point*."""
        there = f"first {self.said(words)} from its starting point"
        return Clause(self.subject(words), "is", there, f"is {there}")


def _has_axes(words: Words, name: str) -> bool:
    own = words.mechanism.body[name].coordinates
    return len(own) > 1 and all(c.label in AXES for c in own)


@MOMENTS.register("closest")
@dataclass(frozen=True, slots=True)
class Closest(Apsis):
    """The first time that two bodies are closest to each other."""

    label = "closest approach"
    most = "least"
    verb = Verb("reach a minimum distance from each other", "reach a minimum distance from each other", "do")

    def extent(self, state: State) -> Array:
        """Return the negative distance of the two bodies, m, (n,)."""
        return -DistanceBetween.evaluate(state, self.name)

    def excess(self, state: State) -> Array:
        """Return the rate of separation of the two bodies, (n,)."""
        return self.receding(state)


@MOMENTS.register("farthest")
@dataclass(frozen=True, slots=True)
class Farthest(Apsis):
    """The first time that two bodies are farthest from each other."""

    label = "farthest apart"
    most = "greatest"
    verb = Verb("reach a maximum distance from each other", "reach a maximum distance from each other", "do")

    def extent(self, state: State) -> Array:
        """Return the distance of the two bodies, m, (n,)."""
        return DistanceBetween.evaluate(state, self.name)

    def excess(self, state: State) -> Array:
        """Return the rate of approach of the two bodies, (n,)."""
        return -self.receding(state)


ABOVE = {UP: "above", OPPOSITE[UP]: "below"}


@MOMENTS.register("moved")
@dataclass(frozen=True, slots=True)
class Moved(DistanceThreshold):
    """The moment when a body has moved a stated distance along a straight line.

    If the body may turn back, in a collision or in a text with symbols, the phrase states its distance from the
    starting point instead; with symbols also its side.
    """

    towards: int = 0  # 1 or −1: on which side of its starting point it is, along the sense of its line; 0: on either

    label = "moved"
    verb = Verb("has moved", "moved", "has")

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the bodies that move along one line and ride on no other body, with their phrases."""
        mechanism = words.mechanism
        called = words.subject_phrases(cls.of).items()
        return {
            n: phrase
            for n, phrase in called
            if center_path(mechanism, n).straight and not moves_on_slider(mechanism, n)
        }

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """Yield moments for all named subjects and distances, on either side of the start if the text has symbols."""
        for moment in super(Moved, cls).parsed(text, trace, words):  # slots make another class of this one
            sides = (1, -1) if words.symbolic and moment.sense(words.mechanism) is not None else ()
            yield from (moment, *(replace(moment, towards=side) for side in sides))

    def excess(self, state: State) -> Array:
        """Return by how many metres the displacement exceeds the distance, on its side if one is given, (n,)."""
        sense = self.sense(state.mechanism) if self.towards else None
        if sense is None:
            return super(Moved, self).excess(state)
        return self.towards * (Displacement.evaluate(state, self.name) @ np.array(sense.vector)) - self.value

    def time(self, trace: Trace) -> float | None:
        """Return the time of the moment, s; None after a reversal, unless a side is given or the body may collide."""
        crossing_time = first_crossing(trace, self.excess)
        return None if crossing_time is not None and self._turns_back(trace, crossing_time) else crossing_time

    def comes_later(self, trace: Trace) -> bool:
        """Return whether the body reaches the stated distance only after it has turned back."""
        crossing_time = first_crossing(trace, self.excess)
        return crossing_time is not None and self._turns_back(trace, crossing_time)

    def _turns_back(self, trace: Trace, until: float) -> bool:
        """Return whether the body reverses before a time, s, and neither a given side nor a collision permits that."""
        allowed = self.towards or _collides(trace.mechanism, self.name)
        return not allowed and _turns_back(trace, self.name, until)

    def in_symbols(self, trace: Trace) -> Self:
        """Return the moment with the side of the start on which the body is, if it may turn back."""
        sense, time = self.sense(trace.mechanism), self.time(trace)
        if sense is None or time is None or not may_reverse(trace.mechanism):
            return self
        ahead = float((Displacement.evaluate(trace.at(time), self.name) @ np.array(sense.vector))[0]) > 0.0
        return replace(self, towards=1 if ahead else -1)

    def sense(self, mechanism: Mechanism) -> Sense | None:
        """Return the direction of the body's line, if one of its senses has a name; else None."""
        senses = Bodies().senses(mechanism, self.name)
        return next(
            (s for s in senses if len(senses) == 1 and (s.axis or s.positive.partition(" ")[0] in OPPOSITE)), None
        )

    def told(self, words: Words, said: str) -> str:
        """Return a clause about the distance `said`: *A has moved $d$*, *A is the distance $d$ from its start*."""
        there = self._there(words, f"the distance {said}")
        predicate = f"is {there}" if self._may_return(words) else f"has {self._motion_participle(words)} {said}"
        return f"{self.subject(words)} {predicate}"

    def _motion_participle(self, words: Words) -> str:
        """Return the participle for the motion: *risen* for a body that goes straight up, else *moved*."""
        return "risen" if goes_straight_up(words.mechanism, self.name) else "moved"

    def _there(self, words: Words, said: str) -> str:
        """Return the position of the body: *0.50 m from its starting point*, *0.50 m above its starting point*."""
        sense, start = self.sense(words.mechanism) if self.towards else None, "its starting point"
        if sense is None:
            return f"{said} from {start}"
        if sense.axis:
            return f"{said} from {start} in the {'positive' if self.towards > 0 else 'negative'} {sense.axis} direction"
        first, _, rest = sense.positive.partition(" ")
        heading = first if self.towards > 0 else OPPOSITE[first]
        if first == RIGHT:
            return f"{said} to the {heading} of {start}"
        return f"{said} {heading} {rest} from {start}" if rest else f"{said} {ABOVE[heading]} {start}"

    def _may_return(self, words: Words) -> bool:
        """Return whether, as far as the text reveals, the body may turn back before it is the stated distance away."""
        return bool(self.towards) or _collides(words.mechanism, self.name) or (words.symbolic and words.turns_back)

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return phrases such as *after the block has moved 0.50 m*."""
        if self._may_return(words):
            there = f"{self.subject(words)} is {self._there(words, f'first {self.said(words)}')}"
            return when_phrases(there)
        moved = f"{self.subject(words)} has {self._motion_participle(words)} {self.said(words)}"
        return (f"after {moved}", f"when {moved}", f"at the moment when {moved}")

    def clause(self, words: Words) -> Clause | None:
        """Return the clause, such as *the block has moved 0.50 m*."""
        distance = self.said(words)
        if self._may_return(words):
            there = self._there(words, f"first {distance}")
            return Clause(self.subject(words), "is", there, f"is {there}")
        moved = self._motion_participle(words)
        takes = "rise" if moved == "risen" else "move"
        return Clause(
            self.subject(words), "has", f"{moved} {distance}", f"has {moved} {distance}", f"to {takes} {distance}"
        )


def _collides(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body can collide with another one or with a fixed obstacle."""
    return any(name in meeting.names for meeting in mechanism.meetings)


def _turns_back(trace: Trace, name: str, until: float) -> bool:
    """Return whether a body on a line reverses before a time, s."""
    direction = np.array(center_path(trace.mechanism, name).ways[0])
    before = (Velocity.evaluate(trace.scan, name) @ direction)[trace.scan.times <= until]
    last = float((Velocity.evaluate(trace.at(until), name) @ direction)[0])  # long motions have few samples
    least = min(last, float(np.minimum.reduce(before, initial=0.0)))
    greatest = max(last, float(np.maximum.reduce(before, initial=0.0)))
    return least * greatest < -1e-9 * max(-least, greatest) ** 2


RETURN_DISTANCE_RTOL = 1e-5  # of the greatest distance: largest distance from the starting point at a return
RETURN_SPEED_RTOL = 1e-3  # of the greatest speed: a slower body turns back at the starting point


@MOMENTS.register("returned")
@dataclass(frozen=True, slots=True)
class Returned(Passage):
    """The first time that a body returns to its starting point."""

    label = "return"
    drawn_by_recipes = False
    of = Bodies()
    hangs_on = "displacement"
    verb = Verb("returns to its starting point", "return to its starting point")

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the bodies that ride on no other body, so that their starting points are fixed, with their phrases."""
        called = words.subject_phrases(cls.of).items()
        return {
            name: cls.of.point(words.mechanism, name, phrase)
            for name, phrase in called
            if not moves_on_slider(words.mechanism, name)
        }

    def excess(self, state: State) -> Array:
        """Return r·v, half the rate of the squared distance from the start, m²/s, (n,)."""
        return np.einsum("ij,ij->i", Displacement.evaluate(state, self.name), Velocity.evaluate(state, self.name))

    def time(self, trace: Trace) -> float | None:
        """Return the time, s, at which the distance from the start is first zero again; None if it never is."""
        farthest = float(row_lengths(Displacement.evaluate(trace.scan, self.name)).max())
        fastest = float(row_lengths(Velocity.evaluate(trace.scan, self.name)).max())
        for time in crossings(trace, self.excess):
            there = trace.at(time)
            if float(np.linalg.norm(Displacement.evaluate(there, self.name))) <= RETURN_DISTANCE_RTOL * farthest:
                slow = float(np.linalg.norm(Velocity.evaluate(there, self.name))) <= RETURN_SPEED_RTOL * fastest
                return self._turn(trace, time) if slow else time
        return None

    def _turn(self, trace: Trace, near: float) -> float:
        """Return the time, s, of least speed close to a given time, which is a more accurate time of a reversal."""

        def gains(state: State) -> Array:
            return np.einsum("ij,ij->i", Velocity.evaluate(state, self.name), Acceleration.evaluate(state, self.name))

        return min(crossings(trace, gains), key=lambda time: abs(time - near), default=near)

"""The instant at which a body has moved a stated distance along a straight line, or is first so far from its start."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Self

import numpy as np

from sim2reason.dsl.constancy import may_turn_back
from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.quantities.kinematics import Displacement, Velocity
from sim2reason.quantities.subjects import Sense
from sim2reason.quantities.subjects.bodies import OPPOSITE, RIGHT, UP, Bodies
from sim2reason.quantities.subjects.paths import center_path, rides
from sim2reason.questions.crossing import first_crossing
from sim2reason.questions.moments import MOMENTS, Clause
from sim2reason.questions.moments.parts.distance import DistanceThreshold
from sim2reason.questions.moments.parts.free_motion import goes_straight_up
from sim2reason.questions.moments.parts.verbs import Verb, when_phrases
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace

ABOVE = {UP: "above", OPPOSITE[UP]: "below"}


@MOMENTS.register("moved")
@dataclass(frozen=True, slots=True)
class Moved(DistanceThreshold):
    """When a body has moved a stated distance along a straight line, without turning back.

    What collides may have turned back in a collision: it is spoken of by its distance from where it started. Symbols do
    not say either whether what may turn back does so before, nor on which side of its starting point it is then.
    """

    towards: int = 0  # 1 or −1: on which side of its starting point it is, along the sense of its line; 0: on either

    label = "moved"
    verb = Verb("has moved", "moved", "has")

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Bodies that move along one line and ride on nothing."""
        mechanism = words.mechanism
        called = words.called(cls.of).items()
        return {n: said for n, said in called if center_path(mechanism, n).straight and not rides(mechanism, n)}

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """On either side where symbols leave that open."""
        for moment in super(Moved, cls).parsed(text, trace, words):  # slots make another class of this one
            sides = (1, -1) if words.symbolic and moment.sense(words.mechanism) is not None else ()
            yield from (moment, *(replace(moment, towards=side) for side in sides))

    def excess(self, state: State) -> Array:
        """How much farther it is than the distance, on its side."""
        sense = self.sense(state.mechanism) if self.towards else None
        if sense is None:
            return super(Moved, self).excess(state)
        return self.towards * (Displacement.evaluate(state, self.name) @ np.array(sense.vector)) - self.value

    def time(self, trace: Trace) -> float | None:
        """When it is first so far away; if it has not turned back before, unless it may, or collides."""
        found = first_crossing(trace, self.excess)
        if found is None or self.towards or _collides(trace.mechanism, self.name):
            return found
        return None if _turns_back(trace, self.name, found) else found

    def in_symbols(self, trace: Trace) -> Self:
        """On the side on which it is in a motion, if it may turn back."""
        sense, time = self.sense(trace.mechanism), self.time(trace)
        if sense is None or time is None or not may_turn_back(trace.mechanism):
            return self
        ahead = float((Displacement.evaluate(trace.at(time), self.name) @ np.array(sense.vector))[0]) > 0.0
        return replace(self, towards=1 if ahead else -1)

    def sense(self, mechanism: Mechanism) -> Sense | None:
        """That of its line, if a side of it has a name."""
        senses = Bodies().senses(mechanism, self.name)
        return next(
            (s for s in senses if len(senses) == 1 and (s.axis or s.positive.partition(" ")[0] in OPPOSITE)), None
        )

    def told(self, words: Words, said: str) -> str:
        """Return a clause about the distance `said`: *A has moved $d$*, *A is the distance $d$ from its start*."""
        there = self._there(words, f"the distance {said}")
        return (
            f"{self.subject(words)} {f'is {there}' if self._may_return(words) else f'has {self._moved(words)} {said}'}"
        )

    def _moved(self, words: Words) -> str:
        """Return how it has gone: *risen* where it can only go up before it turns back, else *moved*."""
        return "risen" if goes_straight_up(words.mechanism, self.name) else "moved"

    def _there(self, words: Words, said: str) -> str:
        """Return where the body is: *0.50 m from its starting point*, *0.50 m to the left of its starting point*."""
        sense, start = self.sense(words.mechanism) if self.towards else None, "its starting point"
        if sense is None:
            return f"{said} from {start}"
        if sense.axis:
            return f"{said} from {start} in the {'positive' if self.towards > 0 else 'negative'} {sense.axis} direction"
        first, _, rest = sense.positive.partition(" ")
        way = first if self.towards > 0 else OPPOSITE[first]
        if first == RIGHT:
            return f"{said} to the {way} of {start}"
        return f"{said} {way} {rest} from {start}" if rest else f"{said} {ABOVE[way]} {start}"

    def _may_return(self, words: Words) -> bool:
        """Whether the way that it has gone may be longer than the distance, as far as a text tells."""
        return bool(self.towards) or _collides(words.mechanism, self.name) or (words.symbolic and words.turns_back)

    def phrases(self, words: Words) -> tuple[str, ...]:
        """As in: after the block has moved 0.50 m, when the cart is first 0.50 m from its starting point."""
        if self._may_return(words):
            there = f"{self.subject(words)} is {self._there(words, f'first {self.said(words)}')}"
            return when_phrases(there)
        moved = f"{self.subject(words)} has {self._moved(words)} {self.said(words)}"
        return (f"after {moved}", f"when {moved}", f"at the moment when {moved}")

    def clause(self, words: Words) -> Clause | None:
        """As in: the block has moved 0.50 m."""
        said = self.said(words)
        if self._may_return(words):
            there = self._there(words, f"first {said}")
            return Clause(self.subject(words), "is", there, f"is {there}")
        moved = self._moved(words)
        takes = "rise" if moved == "risen" else "move"
        return Clause(self.subject(words), "has", f"{moved} {said}", f"has {moved} {said}", f"to {takes} {said}")


def _collides(mechanism: Mechanism, name: str) -> bool:
    """Whether a body may meet another one, or what is fixed."""
    return any(name in meeting.names for meeting in mechanism.meetings)


def _turns_back(trace: Trace, name: str, until: float) -> bool:
    """Whether a body that moves along a line reverses before a time."""
    way = np.array(center_path(trace.mechanism, name).ways[0])
    speeds = (Velocity.evaluate(trace.scan, name) @ way)[trace.scan.times <= until]
    return bool(speeds.min(initial=0.0) * speeds.max(initial=0.0) < -1e-9 * float(np.abs(speeds).max(initial=0.0)) ** 2)

"""Outcomes for what swings."""

from dataclasses import dataclass
from math import inf

import numpy as np

from sim2reason.questions.outcomes import OUTCOMES, Swinging
from sim2reason.questions.outcomes.strings import GoesSlack
from sim2reason.questions.words import Words
from sim2reason.simulation.quantities.rotation import AngleTurned
from sim2reason.simulation.quantities.subjects.bodies import TurningBodies
from sim2reason.simulation.quantities.subjects.paths import turning_axes
from sim2reason.simulation.quantities.subjects.rods import SwingingLines
from sim2reason.simulation.trace import Trace

STILL = 1e-3  # of its greatest speed: what is slower where it goes neither up nor down turns back


@OUTCOMES.register("circles")
@dataclass(frozen=True, slots=True)
class Circles(Swinging):
    """The outcome that a body on a string swings right round with the string always taut; only people ask about it."""

    of = SwingingLines()
    tells = False
    drawn_by_recipes = False

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the strings of bodies that are set moving; none of those released, as no body falls over the top."""
        return {} if words.released else GoesSlack.candidates(words)

    def happens(self, trace: Trace) -> bool | None:
        """Return whether the body gets over the top before the string goes slack or the body turns back."""
        upright = {c.name for c in trace.mechanism.coordinates if c.axis[2] != 0.0}
        turned = [event.time for event in trace.events if event.kind == "turn" and event.subjects[0] in upright]
        slack = [event.time for event in trace.events if event.kind == "slack" and event.subjects[0] == self.name]
        fastest = float(np.linalg.norm(trace.scan.v, axis=1).max())
        back = [time for time in turned if np.linalg.norm(trace.at(time).v[0]) <= STILL * fastest]
        extremes = [time for time in turned if time not in back]
        end = min((*slack, *back), default=inf)
        over = extremes[1] if len(extremes) > 1 else inf  # the second of its lowest and its highest point
        return None if end == over else over < end

    def excess(self, trace: Trace) -> float:
        """Return the least tension, N."""
        return GoesSlack(self.name).excess(trace)

    def does(self, words: Words) -> tuple[str, ...]:
        """Return the clause *the string stays taut all the way round*."""
        return (f"{self.subject(words)} stays taut all the way round",)

    def does_not(self, words: Words) -> tuple[str, ...]:
        """Return the clause *the string does not stay taut all the way round*."""
        return (f"{self.subject(words)} does not stay taut all the way round",)


FULL = 360.0  # degrees


@OUTCOMES.register("goes_round")
@dataclass(frozen=True, slots=True)
class GoesRound(Swinging):
    """A rod or another body on an axle goes right round."""

    of = TurningBodies()

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """What swings under gravity on one axle, and is set moving; by falling alone nothing gets over the top."""
        if not any(words.mechanism.gravity) or words.mechanism.feet or words.released:
            return {}
        turning = AngleTurned().subjects(words.mechanism)
        return {name: said for name, said in words.called(cls.of).items() if name in turning}

    def happens(self, trace: Trace) -> bool | None:
        """Whether it has gone round before it turns back first, which takes long where it hardly gets over the top."""
        hinges = {name for name, _ in turning_axes(trace.mechanism, self.name)}
        back = next(
            (event.time for event in trace.events if event.kind == "turn" and event.subjects[0] in hinges), None
        )
        state = trace.state if back is None else trace.at(back)
        round_once = bool(np.abs(AngleTurned.evaluate(state, self.name)).max() >= FULL)
        return round_once or (None if back is None else False)

    def excess(self, trace: Trace) -> float:
        """The square of the least rate at which it turns: it grows as the energy that is left at the top does."""
        number = trace.mechanism.number
        hinges = [number[name] for name, _ in turning_axes(trace.mechanism, self.name)]
        return float(np.square(trace.scan.v[:, hinges].sum(axis=1)).min())

    def does(self, words: Words) -> tuple[str, ...]:
        """Return the verb phrase, such as *the rod makes a full turn*."""
        subject = self.subject(words)
        return (f"{subject} makes a full turn", f"{subject} goes right round")

    def does_not(self, words: Words) -> tuple[str, ...]:
        """Return the negated statement, such as *the rod does not make a full turn*."""
        subject = self.subject(words)
        return (f"{subject} does not make a full turn", f"{subject} does not go right round")

"""The instant at which a body has gone some of the way round another one that is fixed, or all of it."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from sim2reason.dsl.state import Array, State
from sim2reason.quantities.subjects.pairs import Pairs, members
from sim2reason.quantities.subjects.paths import center_path
from sim2reason.questions.moments import MOMENTS, Clause
from sim2reason.questions.moments.parts.passage import Passage
from sim2reason.questions.moments.parts.verbs import Verb, when_phrases
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace

ALL_ROUND = 360
PARTS = (90, 180, ALL_ROUND)  # degrees


@MOMENTS.register("orbited")
@dataclass(frozen=True, slots=True)
class Orbited(Passage):
    """When the line from a fixed body to one that it attracts has turned through 90°, 180° or all the way round."""

    label = "orbit"
    of = Pairs()
    hangs_on = "distance"
    pronoun = ""
    verb = Verb("has completed one orbit", "completed one orbit", "has")

    degrees: int = ALL_ROUND

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Pairs of which one attracts the other and is fixed."""
        mechanism = words.mechanism
        drawn = {frozenset((pull.a, pull.b)) for pull in mechanism.attractions}
        found: dict[str, str] = {}
        for name, said in words.called(cls.of).items():
            still = [body for body in members(name) if not center_path(mechanism, body).ways]
            if len(still) == 1 and frozenset(members(name)) in drawn:
                found[name] = said
        return found

    @classmethod
    def found(cls, study: Study, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Every part of each orbit."""
        del rng
        return [moment for name in cls.candidates(words) for part in PARTS if (moment := cls(name, part)).comes(study)]

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """Every part of an orbit of every body that is named."""
        del trace
        for name in cls.candidates(words):
            if cls(name).ends(words)[1] in text:
                yield from (cls(name, part) for part in PARTS)

    @property
    def comes_round(self) -> bool:
        """A hyperbola turns less than all the way round."""
        return self.degrees == ALL_ROUND

    def ends(self, words: Words) -> tuple[str, str]:
        """What is fixed, and what goes round."""
        a, b = members(self.name)
        center, planet = (b, a) if center_path(words.mechanism, a).ways else (a, b)
        return words.mentions[center], words.mentions[planet]

    def _arm(self, state: State) -> tuple[Array, Array, Array]:
        """From the one to the other: now, (n, 3), and at the start, with its rate then."""
        a, b = members(self.name)
        now = state.vector(state.frames.center(b).place) - state.vector(state.frames.center(a).place)
        began = np.subtract(state.began.center(b).place, state.began.center(a).place)
        rates = {body: np.zeros(3) for body in (a, b)}
        for body in (a, b):
            for coordinate in state.mechanism.body[body].coordinates:
                rates[body] += coordinate.speed * np.array(coordinate.axis)
        return now, began, rates[b] - rates[a]

    def excess(self, state: State) -> Array:
        """What changes its sign at the angle, and is below zero before; of a whole orbit only in its second half."""
        now, began, rate = self._arm(state)
        spin = np.cross(began, rate)
        sine = np.cross(began, now) @ spin
        return {90: -(now @ began), 180: -sine, ALL_ROUND: sine}[self.degrees]

    def phrases(self, words: Words) -> tuple[str, ...]:
        """As in: when planet A has completed one orbit."""
        center, planet = self.ends(words)
        done = f"{planet} {self.verb.told}" if self.degrees == ALL_ROUND else self._swept(center, planet, "has ")
        return when_phrases(done)

    def clause(self, words: Words) -> Clause | None:
        """As in: planet A has completed one orbit."""
        center, planet = self.ends(words)
        if self.degrees == ALL_ROUND:
            return Clause(planet, "has", self.verb.asked, self.verb.told, "to complete one orbit")
        asked = f"turned through {self.degrees}°"
        return Clause(
            f"the line from {center} to {planet}", "has", asked, f"has {asked}", f"to turn through {self.degrees}°"
        )

    def _swept(self, center: str, planet: str, auxiliary: str) -> str:
        return f"the line from {center} to {planet} {auxiliary}turned through {self.degrees}°"

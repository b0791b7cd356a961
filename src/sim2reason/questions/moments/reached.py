"""Moments at which a body reaches a distance, or a quantity a value."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from heapq import merge
from itertools import islice
from typing import Self

import numpy as np

from sim2reason.errors import TextError
from sim2reason.questions.accuracy import StatedResult
from sim2reason.questions.moments import Clause, Happening, Moment
from sim2reason.questions.moments.crossings import Threshold, crossings
from sim2reason.questions.moments.occurrence import when_phrases
from sim2reason.questions.query import Target, quantities_named, target_named, targets
from sim2reason.questions.structured import StructuredQuestion, moment_named, one_of, parse_amount
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words, round_number
from sim2reason.scenes.dsl.state import Array, State, row_lengths
from sim2reason.simulation.quantities.kinematics import Displacement
from sim2reason.simulation.quantities.subjects.bodies import Bodies
from sim2reason.simulation.trace import Channel, Trace

NEAREST, FARTHEST = 0.2, 0.9  # of the body's greatest distance: range of random distances
SHORTEST, LONGEST, TIED = 0.01, 9e4, 2.0  # m: range of distances, and the longest string


@dataclass(frozen=True, slots=True)
class DistanceThreshold(Threshold):
    """The base class of thresholds of a body's distance from its starting point."""

    of = Bodies()
    hangs_on = "displacement"
    unit = "m"

    @classmethod
    def drawn(cls, name: str, trace: Trace, rng: np.random.Generator) -> float | None:
        """Return a random fraction of the greatest distance, m; None if that is too short."""
        reached = float(row_lengths(Displacement.evaluate(trace.scan, name)).max())
        greatest = min(reached, TIED if trace.mechanism.strings else LONGEST)
        distance = rng.uniform(NEAREST, FARTHEST) * greatest
        return round_number(distance, NEAREST * greatest, FARTHEST * greatest) if distance >= SHORTEST else None

    def excess(self, state: State) -> Array:
        """Return by how many metres the displacement exceeds the distance, (n,)."""
        return row_lengths(Displacement.evaluate(state, self.name)) - self.value


SECOND_TIME_PREFIX = "second "  # before an equation such as *speed of A = 2 m/s*: the second time that it holds
_TIME_EQUATION = re.compile(r"(?:at\s+)?t\s*=")


@dataclass(frozen=True, slots=True)
class Reached(Happening):
    """The first or second time that a quantity passes through a value; drawn only by the mode that asks for times."""

    label = "reached"

    target: Target
    given: StatedResult
    number: int = 1  # 2 for the second time that it passes through the value, up or down

    @classmethod
    def found(cls, study: SimulatedScene, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Return no moments: only the mode that asks for times draws such moments, each with its value."""
        del study, words, rng
        return ()

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """Yield a moment for every quantity that a sentence names, with every number of its unit."""
        del trace
        for target, noun in targets(words).items():
            if noun.phrase in text:
                yield from (
                    cls(target, given) for given in StatedResult.find_in_text(text, words.units.spell(target.unit))
                )

    @property
    def subjects(self) -> tuple[str, ...]:
        """Return the subject of the quantity."""
        return (self.target.subject,)

    @property
    def channels(self) -> tuple[Channel, ...]:
        """Return the channel of the quantity."""
        return (Channel(self.target.subject, self.target.quantity),)

    @property
    def stated(self) -> tuple[tuple[float, str], ...]:
        """Return the value with its unit."""
        return ((self.given.value, self.target.unit),)

    @property
    def revealed_channels(self) -> tuple[Channel, ...]:
        """Return the channel of the quantity."""
        return self.channels

    def time(self, trace: Trace) -> float | None:
        """Return the time, s, of the first or second passage through the value, rising or falling; else None."""

        def excess(state: State) -> Array:
            return self.target.values(state) - self.given.value

        times = merge(crossings(trace, excess), crossings(trace, lambda state: -excess(state)))
        return next(islice(times, self.number - 1, None), None)

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return phrases such as *when the speed of A is 2.1 m/s for the first time*; none for an unnamed quantity."""
        if self.target not in targets(words) or self.number > 1:
            return ()
        first = f"{self._noun(words)} is {self._value_text()} for the first time"
        return when_phrases(first)

    def clause(self, words: Words) -> Clause | None:
        """Return a clause such as *the speed of A is 2.1 m/s for the first time*; None for an unnamed quantity."""
        if self.target not in targets(words) or self.number > 1:
            return None
        first = f"{self._value_text()} for the first time"
        return Clause(self._noun(words), "is", first, f"is {first}")

    def _noun(self, words: Words) -> str:
        return targets(words)[self.target].phrase

    def _value_text(self) -> str:
        sense = self.target.sense
        return self.given.text + (
            f" ({sense.positive} being positive)" if sense is not None and not sense.fixed else ""
        )


def stated(question: StructuredQuestion, equation: str, words: Words, field_name: str) -> tuple[Target, float]:
    """Return the target and the value in *velocity of the ball along y = 2 m/s*; TextError if there is no equation.

    The subject and the axis may be left out: then they are those of the question. The axis of a question is none of
    the quantity of a moment whose subject is named, nor of a quantity without components.
    """
    left, equals, right = equation.partition("=")
    left, _, along = (part.strip() for part in left.partition(" along "))
    if not equals:
        raise TextError(field_name, f"{equation!r} is no equation", "give one, such as: velocity = 2 m/s")
    known = quantities_named(words.mechanism)
    names = (name for name in known if f"{left} ".startswith(f"{name} of ") or left == name)  # which may hold an *of*
    name = max(names, key=len, default=left.partition(" of ")[0])
    find, of = one_of(field_name, name.strip(), known), left.removeprefix(name).removeprefix(" of ").strip()
    own = field_name == "when" and (bool(of) or not known[find].vector)
    named = replace(question, find=find, of=of or question.of, along=along or ("" if own else question.along))
    target = target_named(named, words)
    return target, parse_amount(field_name, right, words.units.spell(target.unit))


def moment_of(question: StructuredQuestion, words: Words) -> Moment:
    """Return the moment of a structured question, given by name or by a value that a quantity reaches.

    *second* before an equation is the second time that the quantity passes through the value.
    """
    if "=" not in question.when or _TIME_EQUATION.match(question.when):
        return moment_named(question, words)
    again = question.when.startswith(SECOND_TIME_PREFIX)
    target, value = stated(question, question.when.removeprefix(SECOND_TIME_PREFIX), words, "when")
    return Reached(target, StatedResult(f"{value:.15g}", words.units.spell(target.unit)), 2 if again else 1)

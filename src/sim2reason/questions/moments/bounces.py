"""Moments of impacts on the ground or walls, and of the bounces that follow."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf
from typing import Self

import numpy as np

from sim2reason.questions.moments import MOMENTS, Clause
from sim2reason.questions.moments.crossings import crossings
from sim2reason.questions.moments.occurrence import Occurrence, VelocityJump, Verb
from sim2reason.questions.moments.reached import DistanceThreshold
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words, ordinal_word, round_number
from sim2reason.scenes.dsl.mechanism import CollisionPair
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.quantities.kinematics import Velocity
from sim2reason.simulation.quantities.positions import Height
from sim2reason.simulation.quantities.subjects.bodies import DIRECTION_TOL, Bodies
from sim2reason.simulation.trace import Channel, Event, Trace

GROUND, WALL, WALLS = "the ground", "the wall", "a wall"


@MOMENTS.register("bounced")
@dataclass(frozen=True, slots=True)
class Bounced(VelocityJump):
    """The first or a later impact of a body on a fixed obstacle, just before or just after it."""

    label = "bounce"
    kinds = ("collision",)
    of = Bodies()
    most = 3
    verb = Verb("hits {what}", "hit {what}")

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the bodies that can hit only the ground, or only walls, with their phrases."""
        called = words.subject_phrases(cls.of).items()
        return {name: phrase for name, phrase in called if obstacle_phrase(words, name)}

    def is_this(self, event: Event, trace: Trace) -> bool:
        """Return whether an event is a collision of the body with a fixed obstacle."""
        del trace
        return event.kind == "collision" and event.subjects == (self.name,)

    def does(self, words: Words) -> Verb:
        """Return the verb phrase, such as *hits the ground*."""
        what = obstacle_phrase(words, self.name)
        return Verb(self.verb.told.format(what=what), self.verb.asked.format(what=what))


def obstacle_phrase(words: Words, name: str) -> str:
    """Return the phrase for the obstacle, such as *the ground* or *a wall*; empty for none or for several types."""
    met = [meeting for meeting in words.mechanism.meetings if meeting.names == (name,)]
    if met and all(_is_upright(meeting) for meeting in met):
        return GROUND
    if met and not any(_is_upright(meeting) for meeting in met):
        return WALL if len(met) == 1 else WALLS
    return ""


def _is_upright(meeting: CollisionPair) -> bool:
    """Return whether a body falls onto the obstacle."""
    return meeting.normal is not None and meeting.normal[2] > 1.0 - DIRECTION_TOL


@MOMENTS.register("landed")
@dataclass(frozen=True, slots=True)
class Landed(Occurrence):
    """The instant at which a flying body reaches the ground."""

    label = "landing"
    own = True
    kinds = ("limit",)
    of = Bodies()
    most = 0
    verb = Verb("reaches the ground", "reach the ground")

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the bodies that fly and cannot go below the ground, with their phrases."""
        phrases: dict[str, str] = {}
        for name, phrase in words.subject_phrases(cls.of).items():
            body = words.mechanism.body[name]
            down = any(c.axis[2] > 1.0 - DIRECTION_TOL and c.lower > -inf for c in body.coordinates)
            if down and len(body.coordinates) > 1 and body.parent is None and name not in words.mechanism.contacts:
                phrases[name] = phrase
        return phrases

    @classmethod
    def seen_as(cls, name: str, words: Words) -> set[str]:
        """Return the names of the body's coordinates, under which the trace records a landing."""
        return {c.name for c in words.mechanism.body[name].coordinates}

    @property
    def sided(self) -> bool | None:
        """Return False, for just before the impact."""
        return False

    def is_this(self, event: Event, trace: Trace) -> bool:
        """Return whether an event is the body's arrival at the ground, recorded for one of its coordinates."""
        return event.kind == "limit" and any(
            c.name == event.subjects[0] for c in trace.mechanism.body[self.name].coordinates
        )

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return the phrases for the moment, such as *just before the ball reaches the ground*."""
        lands = f"{self.subject(words)} {self.verb.told}"
        return (f"just before {lands}", f"immediately before {lands}", f"at the moment just before {lands}")

    def clause(self, words: Words) -> Clause | None:
        """Return the clause, such as *the ball reaches the ground*."""
        return self.verb.clause(self.subject(words), None)


HIGHEST = "the highest point after its {count} bounce"


@MOMENTS.register("top_after_bounce")
@dataclass(frozen=True, slots=True)
class TopAfterBounce(Occurrence):
    """The highest point that a body reaches after its first or a later bounce from the ground."""

    label = "highest point after a bounce"
    event = False
    drawn_by_recipes = False
    kinds = ("collision",)
    of = Bounced.of
    most = 3
    verb = Verb(
        "reaches the highest point after its {count} bounce", "reach the highest point after its {count} bounce"
    )

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the phrases of the bodies that bounce off the ground."""
        return {
            name: phrase for name, phrase in Bounced.candidates(words).items() if obstacle_phrase(words, name) == GROUND
        }

    @property
    def channels(self) -> tuple[Channel, ...]:
        """Return the one channel on which the moment depends: the body's velocity."""
        return (Channel(self.name, Velocity.name),)

    def time(self, trace: Trace) -> float | None:
        """Return the time, s, of the highest point between the numbered bounce and the next one; None without one."""
        bounce = Bounced(self.name, self.number).time(trace)
        following = Bounced(self.name, self.number + 1).time(trace)
        if bounce is None:
            return None

        def sinks(state: State) -> Array:
            return -Velocity.evaluate(state, self.name)[:, 2]

        top_time = next((time for time in crossings(trace, sinks) if time > bounce), None)
        return top_time if top_time is not None and (following is None or top_time < following) else None

    def does(self, words: Words) -> Verb:
        """Return the verb with the ordinal, as in *reaches the highest point after its second bounce*."""
        del words
        count = ordinal_word(self.number)
        return Verb(self.verb.told.format(count=count), self.verb.asked.format(count=count))

    @property
    def _count(self) -> int | None:
        return None


LOW, HIGH = 1.1, 1.6  # of the height of the top after the first bounce: range of random heights
MAX_BOUNCES = 200  # greatest number of bounces examined


@MOMENTS.register("stayed_below")
@dataclass(frozen=True, slots=True)
class StayedBelow(DistanceThreshold):
    """The first bounce after which a body no longer rises to a stated height above the ground."""

    label = "bounce to less than a height"
    event = True
    drawn_by_recipes = False
    verb = Verb("no longer rises as high as", "no longer rise as high as")

    @classmethod
    def found(cls, study: SimulatedScene, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Return a moment for each body, with a random height that it no longer reaches after one of its bounces."""
        drawn = ((name, cls.drawn(name, study.trace, rng)) for name in cls.candidates(words))
        moments = [cls(name, height) for name, height in drawn if height is not None]
        return [moment for moment in moments if study.time(moment) is not None]

    @classmethod
    def drawn(cls, name: str, trace: Trace, rng: np.random.Generator) -> float | None:
        """Return a random height, m, above the highest point after the first bounce; None without such a point."""
        top = TopAfterBounce(name).time(trace)
        if not top:
            return None
        height = float(Height.evaluate(trace.at(top), name)[0])
        return round_number(rng.uniform(LOW, HIGH) * height, LOW * height, HIGH * height)

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the phrases of the bodies that bounce off the ground."""
        return {
            name: phrase
            for name, phrase in words.subject_phrases(cls.of).items()
            if obstacle_phrase(words, name) == GROUND
        }

    @property
    def channels(self) -> tuple[Channel, ...]:
        """Return the one channel on which the moment depends: the height above the ground."""
        return (Channel(self.name, Height.name),)

    def time(self, trace: Trace) -> float | None:
        """Return the time, s, of the first bounce after which the body stays below the height; None without one."""
        for number in range(1, MAX_BOUNCES):
            top = TopAfterBounce(self.name, number).time(trace)
            if top is None:
                return None
            if float(Height.evaluate(trace.at(top), self.name)[0]) < self.value:
                return Bounced(self.name, number).time(trace)
        return None

    def does(self, words: Words) -> Verb:
        """Return the verb with the height, as in *no longer rises as high as 1.0 m*."""
        return Verb(f"{self.verb.told} {self.said(words)}", f"{self.verb.asked} {self.said(words)}")

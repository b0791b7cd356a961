"""Moments of collisions of two bodies."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from sim2reason.questions.moments import MOMENTS, Moment
from sim2reason.questions.moments.bounces import Bounced
from sim2reason.questions.moments.parts.occurrence import VelocityJump, Verb
from sim2reason.questions.moments.parts.turning_points import collides_once, moves_freely
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import CollisionPair
from sim2reason.scenes.dsl.state import State
from sim2reason.simulation.quantities.kinematics import Velocity
from sim2reason.simulation.quantities.subjects.pairs import PAIR_SEPARATOR, Pairs, members
from sim2reason.simulation.trace import Event, Trace

VELOCITY_RTOL = 1e-9  # relative: least change of a relative velocity


@MOMENTS.register("collided")
@dataclass(frozen=True, slots=True)
class Collided(VelocityJump):
    """The first or a later collision of two bodies, just before or just after it."""

    label = "collision"
    kinds = ("collision",)
    of = Pairs()
    most = 3
    pronoun = "they"
    verb = Verb("collide", "collide", "do")

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the pairs of bodies that can collide, with their phrases."""
        met = {PAIR_SEPARATOR.join(meeting.names) for meeting in words.mechanism.meetings}
        return {name: said for name, said in words.called(cls.of).items() if name in met}

    @classmethod
    def seen_as(cls, name: str, words: Words) -> set[str]:
        """Return the names of both bodies."""
        del words
        return set(members(name))

    @property
    def subjects(self) -> tuple[str, ...]:
        """Return the names of both bodies."""
        return members(self.name)

    def count(self, words: Words) -> int | None:
        """Return the ordinal of the collision for its phrase; None if the bodies can collide only once."""
        return None if self.number == 1 and collides_once(words.mechanism) else self.number

    def is_this(self, event: Event, trace: Trace) -> bool:
        """Return whether an event is a collision of the two bodies."""
        del trace
        return event.kind == "collision" and set(event.subjects) == set(self.subjects)

    def is_plain(self, study: SimulatedScene) -> bool:
        """Return whether the bodies approach in uniform relative motion, so that their collision time is trivial."""
        time = study.time(self)
        if time is None:
            return False
        times = np.array([0.0, 0.5 * time, np.nextafter(time, 0.0)])
        one, other = (Velocity.evaluate(study.trace.sample(times), body) for body in self.subjects)
        apart = one - other
        return bool(np.abs(apart - apart[0]).max() <= VELOCITY_RTOL * np.abs(apart).max())


STILL = 1e-9  # of the greatest speed: lower closing speeds are rounding
FEWEST = 2  # least number of collisions for which *the last one* makes sense


@MOMENTS.register("last_collision")
@dataclass(frozen=True, slots=True)
class LastCollision(Moment):
    """The moment just after the last collision, from which all bodies move freely and never meet again."""

    kind = "event"
    label = "last collision"
    event = True

    @classmethod
    def found(cls, study: SimulatedScene, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Return the moment if there are several collisions and a last one."""
        del words, rng
        several = sum(event.kind == "collision" for event in study.trace.events) >= FEWEST
        return [moment] if several and study.time(moment := cls()) is not None else []

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """Yield the only moment of this class."""
        del text, trace, words
        yield cls()

    @property
    def sided(self) -> bool | None:
        """Return True, for just after the collision."""
        return True

    def time(self, trace: Trace) -> float | None:
        """Return the time of the last recorded collision, s; None if another may follow."""
        times = [event.time for event in trace.events if event.kind == "collision"]
        return times[-1] if times and not trace.cut and _is_over(trace) else None

    def in_symbols(self, trace: Trace) -> Moment:
        """Return the last collision as a numbered one of its bodies, as without numbers several may be last."""
        if len({meeting.names for meeting in trace.mechanism.meetings}) < FEWEST:
            return self
        met = [frozenset(event.subjects) for event in trace.events if event.kind == "collision"]
        one, *other = next(held.names for held in trace.mechanism.meetings if frozenset(held.names) == met[-1])
        number = met.count(met[-1])
        return Collided(PAIR_SEPARATOR.join((one, *other)), number) if other else Bounced(one, number)

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return the phrases for the moment, such as *just after the last collision*."""
        del words
        return (
            "just after the last collision",
            "immediately after the last collision",
            "as soon as all collisions are over",
        )


def _is_over(trace: Trace) -> bool:
    """Return whether all bodies move freely at the end of the motion, and no two will collide."""
    end = trace.at(float(trace.state.times[-1]))
    fastest = float(np.abs(end.v).max(initial=0.0))
    if not moves_freely(trace.mechanism) or float(np.abs(end.a).max(initial=0.0)) > 0.0:
        return False
    return not any(_closes(end, meeting, STILL * fastest) for meeting in trace.mechanism.meetings)


def _closes(end: State, meeting: CollisionPair, still: float) -> bool:
    """Return whether two bodies in uniform motion will collide."""
    b = end.vector(end.frames.center(meeting.b).place)[0]
    apart, parting = b, Velocity.evaluate(end, meeting.b)[0]
    if meeting.a is not None:
        apart = b - end.vector(end.frames.center(meeting.a).place)[0]
        parting = parting - Velocity.evaluate(end, meeting.a)[0]
    if meeting.normal is not None:
        return float(np.dot(meeting.normal, parting)) < -still
    speed, along = float(np.linalg.norm(parting)), float(np.dot(apart, parting))
    if speed <= still or along >= 0.0:
        return False
    return float(np.dot(apart, apart)) - (along / speed) ** 2 <= meeting.distance**2

"""Collisions of two bodies."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from sim2reason.questions.moments import MOMENTS, Moment
from sim2reason.questions.moments.bounces import Bounced
from sim2reason.questions.moments.parts.occurrence import VelocityJump, Verb
from sim2reason.questions.moments.parts.turning_points import meets_once, moves_freely
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Meeting
from sim2reason.scenes.dsl.state import State
from sim2reason.simulation.quantities.kinematics import Velocity
from sim2reason.simulation.quantities.subjects.pairs import AND, Pairs, members
from sim2reason.simulation.trace import Event, Trace

SAME = 1e-9  # of a speed: what has changed by less has not


@MOMENTS.register("collided")
@dataclass(frozen=True, slots=True)
class Collided(VelocityJump):
    """The first collision of two bodies, or a later one, just before or just after it."""

    label = "collision"
    kinds = ("collision",)
    of = Pairs()
    most = 3
    pronoun = "they"
    verb = Verb("collide", "collide", "do")

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return those that may meet."""
        met = {AND.join(meeting.names) for meeting in words.mechanism.meetings}
        return {name: said for name, said in words.called(cls.of).items() if name in met}

    @classmethod
    def seen_as(cls, name: str, words: Words) -> set[str]:
        """Return each of the two."""
        del words
        return set(members(name))

    @property
    def subjects(self) -> tuple[str, ...]:
        """The two bodies."""
        return members(self.name)

    def count(self, words: Words) -> int | None:
        """Return the ordinal of the collision for its phrase; None if the bodies can collide only once."""
        return None if self.number == 1 and meets_once(words.mechanism) else self.number

    def is_this(self, event: Event, trace: Trace) -> bool:
        """Return whether the two collide."""
        del trace
        return event.kind == "collision" and set(event.subjects) == set(self.subjects)

    def is_plain(self, study: Study) -> bool:
        """Whether the two come together in free flight, so that no collision, force or field has a part in it."""
        time = study.time(self)
        if time is None:
            return False
        times = np.array([0.0, 0.5 * time, np.nextafter(time, 0.0)])
        one, other = (Velocity.evaluate(study.trace.sample(times), body) for body in self.subjects)
        apart = one - other
        return bool(np.abs(apart - apart[0]).max() <= SAME * np.abs(apart).max())


STILL = 1e-9  # of the largest speed: slower, nothing closes
FEWEST = 2  # collisions, for one to be the last


@MOMENTS.register("last_collision")
@dataclass(frozen=True, slots=True)
class LastCollision(Moment):
    """Just after the last collision, where all then move freely and never meet again."""

    kind = "event"
    label = "last collision"
    event = True

    @classmethod
    def found(cls, study: Study, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """One, if there are several collisions."""
        del words, rng
        several = sum(event.kind == "collision" for event in study.trace.events) >= FEWEST
        return [moment] if several and study.time(moment := cls()) is not None else []

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """It has no number or name of its own."""
        del text, trace, words
        yield cls()

    @property
    def sided(self) -> bool | None:
        """Just after it."""
        return True

    def time(self, trace: Trace) -> float | None:
        """Return when the last of those that were seen happens, if none can follow."""
        times = [event.time for event in trace.events if event.kind == "collision"]
        return times[-1] if times and not trace.cut and _is_over(trace) else None

    def in_symbols(self, trace: Trace) -> Moment:
        """Return that of those who meet: where several may, symbols leave open who does so last."""
        if len({meeting.names for meeting in trace.mechanism.meetings}) < FEWEST:
            return self
        met = [frozenset(event.subjects) for event in trace.events if event.kind == "collision"]
        one, *other = next(held.names for held in trace.mechanism.meetings if frozenset(held.names) == met[-1])
        number = met.count(met[-1])
        return Collided(AND.join((one, *other)), number) if other else Bounced(one, number)

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return the phrases for the moment, such as *just after the last collision*."""
        del words
        return (
            "just after the last collision",
            "immediately after the last collision",
            "as soon as all collisions are over",
        )


def _is_over(trace: Trace) -> bool:
    """Return whether at the end of what was recorded everything moves freely, and no two bodies will meet."""
    end = trace.at(float(trace.state.times[-1]))
    fastest = float(np.abs(end.v).max(initial=0.0))
    if not moves_freely(trace.mechanism) or float(np.abs(end.a).max(initial=0.0)) > 0.0:
        return False
    return not any(_closes(end, meeting, STILL * fastest) for meeting in trace.mechanism.meetings)


def _closes(end: State, meeting: Meeting, still: float) -> bool:
    """Whether two bodies in uniform motion will touch: flat faces as their gap shrinks, discs if they don't miss."""
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

"""Moments at which contacts change: collisions, the beginning and end of slipping, lift-off and landing."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from sim2reason.questions.choices import rest_speed
from sim2reason.questions.moments import MOMENTS, Clause, Moment
from sim2reason.questions.moments.bounces import Bounced
from sim2reason.questions.moments.extrema import collides_once, moves_freely
from sim2reason.questions.moments.occurrence import (
    Occurrence,
    SlipChange,
    VelocityJump,
    Verb,
    can_roll,
    slip_velocity,
)
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import CollisionPair, Mechanism, Prop
from sim2reason.scenes.dsl.state import State
from sim2reason.simulation.quantities.kinematics import Velocity
from sim2reason.simulation.quantities.subjects.bodies import Bodies
from sim2reason.simulation.quantities.subjects.interactions import PAIR_SEPARATOR, Contacts, Pairs, members
from sim2reason.simulation.trace import Event, Trace


@MOMENTS.register("began_to_slip")
@dataclass(frozen=True, slots=True)
class BeganToSlip(SlipChange):
    """The first time that a body that stuck to its face, or rolled on it, begins to slip."""

    label = "slip"
    kinds = ("slip",)
    verb = Verb("begins to slip", "begin to slip")

    def is_this(self, event: Event, trace: Trace) -> bool:
        """Return whether an event is the beginning of slip of this body, which did not slip just before."""
        return event.kind == "slip" and event.subjects[0] == self.name and not self.slipped(event, trace)


@MOMENTS.register("edge_landed")
@dataclass(frozen=True, slots=True)
class EdgeLanded(VelocityJump):
    """The landing of the next edge of a body that tumbles over its edges, just before or just after it."""

    label = "landing of an edge"
    drawn_by_recipes = False
    kinds = ("land",)
    of = Bodies()
    most = 3
    verb = Verb("lands on its next edge", "land on its next edge")

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the phrases of the bodies that stand on edges."""
        return {name: phrase for name, phrase in words.subject_phrases(cls.of).items() if _edges(words.mechanism, name)}

    @classmethod
    def seen_as(cls, name: str, words: Words) -> set[str]:
        """Return the names of the edges of a body."""
        return _edges(words.mechanism, name)

    def is_this(self, event: Event, trace: Trace) -> bool:
        """Return whether an edge of the body lands."""
        return event.kind == "land" and event.subjects[0] in _edges(trace.mechanism, self.name)


def _edges(mechanism: Mechanism, name: str) -> set[str]:
    return {foot.name for foot in mechanism.feet if mechanism.site[foot.site].body == name}


@MOMENTS.register("left_face")
@dataclass(frozen=True, slots=True)
class LeftFace(Occurrence):
    """The instant at which a body loses contact with its face, which ends the simulated motion."""

    label = "lift-off"
    own = True
    kinds = ("lift",)
    of = Contacts()
    most = 0
    verb = Verb("loses contact with {surface}", "lose contact with {surface}")

    def does(self, words: Words) -> Verb:
        """Return the verb phrase, such as *loses contact with the dome*."""
        surface = words.fills(self.of, self.name)["surface"]
        return Verb(self.verb.told.format(surface=surface), self.verb.asked.format(surface=surface))


@MOMENTS.register("lifted_off")
@dataclass(frozen=True, slots=True)
class LiftedOff(Occurrence):
    """The instant at which a rocket leaves the ground, if its thrust is less than its weight at first."""

    label = "lift-off of a rocket"
    own = True
    drawn_by_recipes = False
    kinds = ("leave",)
    of = Bodies()
    most = 0
    verb = Verb("leaves the ground", "leave the ground")

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the phrases of the bodies that burn fuel and stand on supports, which only push."""
        burns = {burn.body for burn in words.mechanism.burns}
        called = words.subject_phrases(cls.of).items()
        return {name: phrase for name, phrase in called if name in burns and cls.seen_as(name, words)}

    @classmethod
    def seen_as(cls, name: str, words: Words) -> set[str]:
        """Return the names of the supports on which a body stands: its lift-off is recorded as an event of these."""
        return _props(words.mechanism, name)

    def is_this(self, event: Event, trace: Trace) -> bool:
        """Return whether at this event a support under the body stops carrying load."""
        return event.kind in self.kinds and not _props(trace.mechanism, self.name).isdisjoint(event.subjects)


def _props(mechanism: Mechanism, name: str) -> set[str]:
    """Return the names of the supports, modelled as lines that only push, on which a body stands."""
    props = (line for line in mechanism.lines if isinstance(line.law, Prop))
    return {line.name for line in props if name in {mechanism.site[site].body for site in line.through}}


VERBS: Mapping[bool, Verb] = {
    True: Verb("begins to roll without slipping", "begin to roll without slipping"),
    False: Verb("stops sliding on {surface}", "stop sliding on {surface}"),
}


@MOMENTS.register("stopped_slipping")
@dataclass(frozen=True, slots=True)
class StoppedSlipping(SlipChange):
    """The first time that a body begins to roll without slipping, or stops sliding on a moving carrier."""

    label = "stick"
    kinds = ("stick",)

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the rolling bodies and those on moving carriers, with their phrases."""
        mechanism = words.mechanism
        called = words.subject_phrases(cls.of).items()
        return {n: phrase for n, phrase in called if can_roll(words, n) or mechanism.body[n].parent is not None}

    @classmethod
    def found(cls, study: SimulatedScene, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Return the moments worth asking about: none, as ambiguous, of a body whose slip reverses before its end."""
        moments = super(StoppedSlipping, cls).found(study, words, rng)
        return [moment for moment in moments if not moment.turned_back(study.trace)]

    def turned_back(self, trace: Trace) -> bool:
        """Return whether the body slips in both senses before it stops slipping."""
        time = self.time(trace)
        slips = slip_velocity(trace.scan, self.name)
        before = slips[trace.scan.times < (time or 0.0)]
        slight = rest_speed(trace, slips)
        return bool((before > slight).any() and (before < -slight).any())

    def _verb(self, words: Words) -> Verb:
        surface, verb = words.fills(self.of, self.name)["surface"], VERBS[can_roll(words, self.name)]
        return Verb(verb.told.format(surface=surface), verb.asked.format(surface=surface))

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return the phrases for the moment, such as *when the ball first begins to roll without slipping*."""
        return self._verb(words).phrases(self.subject(words), 1)

    def clause(self, words: Words) -> Clause | None:
        """Return the clause, such as *the ball first begins to roll without slipping*."""
        return self._verb(words).clause(self.subject(words), 1)


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
        return {name: phrase for name, phrase in words.subject_phrases(cls.of).items() if name in met}

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
        relative_velocity = one - other
        return bool(
            np.abs(relative_velocity - relative_velocity[0]).max() <= VELOCITY_RTOL * np.abs(relative_velocity).max()
        )


MIN_CLOSING_SPEED = 1e-9  # of the greatest speed: lower closing speeds are rounding
MIN_COLLISIONS = 2  # least number of collisions for which *the last one* makes sense


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
        several = sum(event.kind == "collision" for event in study.trace.events) >= MIN_COLLISIONS
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
        if len({meeting.names for meeting in trace.mechanism.meetings}) < MIN_COLLISIONS:
            return self
        met = [frozenset(event.subjects) for event in trace.events if event.kind == "collision"]
        one, *other = next(pair.names for pair in trace.mechanism.meetings if frozenset(pair.names) == met[-1])
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
    return not any(_closes(end, meeting, MIN_CLOSING_SPEED * fastest) for meeting in trace.mechanism.meetings)


def _closes(end: State, meeting: CollisionPair, still: float) -> bool:
    """Return whether two bodies in uniform motion will collide."""
    b = end.vector(end.frames.center(meeting.b).place)[0]
    separation, parting = b, Velocity.evaluate(end, meeting.b)[0]
    if meeting.a is not None:
        separation = b - end.vector(end.frames.center(meeting.a).place)[0]
        parting = parting - Velocity.evaluate(end, meeting.a)[0]
    if meeting.normal is not None:
        return float(np.dot(meeting.normal, parting)) < -still
    speed, along = float(np.linalg.norm(parting)), float(np.dot(separation, parting))
    if speed <= still or along >= 0.0:
        return False
    return float(np.dot(separation, separation)) - (along / speed) ** 2 <= meeting.distance**2

"""Base classes of turning points of a quantity, and tests for free motion."""

from abc import abstractmethod
from dataclasses import dataclass, replace
from math import inf
from typing import ClassVar, Self

import numpy as np

from sim2reason.questions.moments.crossings import Passage, crossings, jumps, rises_from_zero
from sim2reason.questions.moments.occurrence import Verb
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import CollisionPair, Coordinate, Elastic, Mechanism, Prop
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.vectors import inner
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.quantities.force_laws import Extension, ExtensionRate
from sim2reason.simulation.quantities.kinematics import Velocity
from sim2reason.simulation.quantities.relative import DistanceBetween
from sim2reason.simulation.quantities.subjects.bodies import DIRECTION_TOL, Bodies, can_move, center_path, parallel
from sim2reason.simulation.quantities.subjects.interactions import Pairs, Springs, members
from sim2reason.simulation.trace import Channel, Trace


def moves_freely(mechanism: Mechanism) -> bool:
    """Return whether bodies move freely between collisions, on frictionless contacts and without rotation."""
    acts = (mechanism.lines, mechanism.forces, mechanism.attractions, mechanism.burns, mechanism.feet)
    rubs = any(face.friction > 0.0 for face in mechanism.faces)
    return not any(acts) and not rubs and all(c.kind == "slide" for c in mechanism.coordinates)


def collides_once(mechanism: Mechanism) -> bool:
    """Return whether at most one collision can occur: that of two bodies with equal free acceleration.

    What accelerates them is the same for both, so that they never come together again.
    """
    if len(mechanism.meetings) != 1 or len(mechanism.meetings[0].names) != 2 or not moves_freely(mechanism):
        return False
    one, other = ([c.axis for c in mechanism.body[name].coordinates] for name in mechanism.meetings[0].names)
    return len(one) == len(other) and all(map(parallel, one, other))


def goes_straight_up(mechanism: Mechanism, name: str) -> bool:
    """Return whether an unguided body starts straight up, by its initial velocity or by an engine on the ground."""
    body = mechanism.body[name]
    lines = (line for line in mechanism.lines if not isinstance(line.law, Prop))
    tied = {mechanism.site[site].body for line in lines for site in line.through}
    struck = any(name in meeting.names and not _is_ground(meeting) for meeting in mechanism.meetings)
    pushed = any(force.body == name for force in mechanism.forces)
    if body.parent or name in mechanism.contacts or name in tied or struck or pushed:
        return False
    moved = [c for c in body.coordinates if c.speed or abs(c.axis[2]) > DIRECTION_TOL or len(body.coordinates) == 1]
    if len(moved) != 1 or any(c.kind != "slide" for c in body.coordinates):
        return False
    return _is_thrown(mechanism, moved[0]) or _takes_off(mechanism, moved[0])


def _is_ground(meeting: CollisionPair) -> bool:
    """Return whether a collision partner is the fixed ground below the body."""
    return meeting.a is None and meeting.normal is not None and meeting.normal[2] > 1.0 - DIRECTION_TOL


def _is_thrown(mechanism: Mechanism, coordinate: Coordinate) -> bool:
    """Return whether a body without an engine moves upwards at the start."""
    burns = any(burn.body == coordinate.body for burn in mechanism.burns)
    against = (
        parallel(coordinate.axis, (0.0, 0.0, 1.0))
        and inner(coordinate.axis, mechanism.gravity) * coordinate.speed < 0.0
    )
    return against and not burns and not mechanism.attractions


def _takes_off(mechanism: Mechanism, coordinate: Coordinate) -> bool:
    """Return whether an engine drives a body away from the ground on which it stands."""
    drives = [burn.direction for burn in mechanism.burns if burn.body == coordinate.body]
    stands = (coordinate.lower, coordinate.upper, coordinate.speed) == (0.0, inf, 0.0)
    return stands and bool(drives) and all(inner(coordinate.axis, drive) > 0.0 for drive in drives)


EXTREME_RTOL = 1e-6  # relative to the range of values: smaller differences are rounding


@dataclass(frozen=True, slots=True)
class Peak(Passage):
    """The base class of the first maximum of a function, if it is the greatest value of the simulated motion.

    A motion that begins at the maximum has no first maximum.

    Class data:
        above: a lower bound of the maximum, such as zero for an extension.
    """

    above: ClassVar[float] = -inf

    exceeded: bool = False  # whether it may be, later

    def first(self) -> Self:
        """Return the moment of the function's first maximum, even if it is exceeded later or lies at the start."""
        return replace(self, exceeded=True)

    @abstractmethod
    def extent(self, state: State) -> Array:
        """Return the function whose maximum is sought, (n,); `excess` is the negative of its rate."""

    def time(self, trace: Trace) -> float | None:
        """Return the time of the function's first maximum, s; None if exceeded later or if the rate jumps before."""
        if rises_from_zero(trace, self.excess) and not self.exceeded:
            return None
        reached = ((time, float(self.extent(trace.at(time))[0])) for time in crossings(trace, self.excess))
        first = next(((time, value) for time, value in reached if value > self.above), None)
        turned = first[0] if first is not None else inf
        struck = (at for at in jumps(trace, self.excess) if float(self.extent(trace.at(at))[0]) > self.above)
        earliest = min(turned, next(struck, inf))
        if first is None or self.exceeded or earliest < turned:
            return earliest if self.exceeded and earliest < inf else None
        everywhere = self.extent(trace.scan)
        greatest, smallest = float(everywhere.max()), float(everywhere.min())
        return first[0] if first[1] >= greatest - EXTREME_RTOL * (greatest - smallest) else None


CIRCULAR_ORBIT_RTOL = 1e-2  # relative: an orbit whose distance varies by less is a circle without apsides


@dataclass(frozen=True, slots=True)
class Apsis(Peak):
    """The base class of the moments when the distance of two attracting bodies is least or greatest.

    Class data:
        most: *least* or *greatest*, for the distance from a fixed body.
    """

    most: ClassVar[str]

    of = Pairs()
    hangs_on = "distance"
    pronoun = ""  # of several bodies it does not tell which

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the pairs of bodies that attract each other, with their phrases."""
        drawn = {frozenset((pull.a, pull.b)) for pull in words.mechanism.attractions}
        pairs = {
            name: phrase for name, phrase in words.subject_phrases(cls.of).items() if frozenset(members(name)) in drawn
        }
        rounds = {name: _one_round(words, name) for name in pairs}
        return {
            name: phrase if (one := rounds[name]) is None else words.mentions[one[0]] for name, phrase in pairs.items()
        }

    def does(self, words: Words) -> Verb:
        """Return the verb for both bodies, or for the moving one if the other is fixed."""
        one = _one_round(words, self.name)
        if one is None:
            return self.verb
        distance = f"its {self.most} distance from {words.mentions[one[1]]}"
        return Verb(f"reaches {distance}", f"reach {distance}")

    @property
    def requires_return(self) -> bool:
        """Return True, as bodies that escape have no further turning point."""
        return True

    def receding(self, state: State) -> Array:
        """Return the rate of separation r·v/r, m/s, (n,)."""
        a, b = members(self.name)
        frames = state.frames
        separation = state.vector(frames.center(b).place) - state.vector(frames.center(a).place)
        parting = Velocity.evaluate(state, b) - Velocity.evaluate(state, a)
        return np.einsum("ij,ij->i", separation, parting) / np.linalg.norm(separation, axis=1)

    def time(self, trace: Trace) -> float | None:
        """Return the time of the turning point, s; None for a circular orbit."""
        far = DistanceBetween.evaluate(trace.scan, self.name)
        round_it_goes = float(far.max() - far.min()) <= CIRCULAR_ORBIT_RTOL * float(far.max())
        return None if round_it_goes else Peak.time(self, trace)


def _one_round(words: Words, name: str) -> tuple[str, str] | None:
    """Return the moving body of a pair and the fixed one; None if both move."""
    a, b = members(name)
    if can_move(words.mechanism, a) and can_move(words.mechanism, b):
        return None
    return (a, b) if can_move(words.mechanism, a) else (b, a)


@dataclass(frozen=True, slots=True)
class SpringTurn(Peak):
    """The base class of the moments when a spring is stretched or compressed the most.

    Class data:
        local_verb: the verb if the spring may be stretched, or compressed, more at a later time.
    """

    own = True
    of = Springs()
    hangs_on = "extension rate"
    above = 0.0
    local_verb: ClassVar[Verb]

    @property
    def revealed_channels(self) -> tuple[Channel, ...]:
        """Return all channels of the spring, as their extreme values are asked for by other questions."""
        return tuple(
            Channel(self.name, quantity.name) for quantity in QUANTITIES.values() if quantity.of.name == self.of.name
        )

    def does(self, words: Words) -> Verb:
        """Return the verb, such as *reaches its maximum extension*; *a maximum* if several oscillations may overlap."""
        mechanism = words.mechanism
        alone = sum(isinstance(line.law, Elastic) for line in mechanism.lines) == 1
        swings = any(center_path(mechanism, body.name).bends for body in mechanism.bodies)
        return self.local_verb if swings or mechanism.meetings or not alone else self.verb

    @abstractmethod
    def sign(self) -> float:
        """Return 1 for a stretched spring, −1 for a compressed one."""

    def extent(self, state: State) -> Array:
        """Return the extension or compression, m, (n,)."""
        return self.sign() * Extension.evaluate(state, self.name)

    def excess(self, state: State) -> Array:
        """Return the negative rate of the extension or compression, m/s, (n,)."""
        return -self.sign() * ExtensionRate.evaluate(state, self.name)


@dataclass(frozen=True, slots=True)
class TurningPoint(Peak):
    """The base class of the moments when the height of a body is greatest or least.

    Class data:
        local_verb: the verb if collisions with other bodies may take the body higher, or deeper, later.
    """

    of = Bodies()
    hangs_on = "velocity"
    local_verb: ClassVar[Verb]

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the bodies that fly or swing, with their phrases, as slopes and lines have no highest point."""
        mechanism, phrases = words.mechanism, dict[str, str]()
        tied = {mechanism.site[site].body for line in mechanism.lines for site in line.through}
        for name, phrase in words.subject_phrases(cls.of).items():
            path = center_path(mechanism, name)
            led = name in mechanism.contacts or (path.straight and name in tied)
            if any(mechanism.gravity) and path.rises and not led:
                phrases[name] = cls.of.point(mechanism, name, phrase)
        return phrases

    def does(self, words: Words) -> Verb:
        """Return a verb such as *reaches the highest point of its path* or *stops rising*."""
        met = [meeting.names for meeting in words.mechanism.meetings if self.name in meeting.names]
        return self.local_verb if any(len(names) > 1 for names in met) else self.verb

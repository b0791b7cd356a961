"""Pairs of bodies as kinds of subjects."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from itertools import permutations

from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.quantities.subjects import Sense, Subject
from sim2reason.simulation.quantities.subjects.bodies import Bodies, can_move

PAIR_SEPARATOR = " & "


@dataclass(frozen=True)
class Pairs(Subject):
    """Pairs of bodies that can collide or attract each other, as subjects named ``a & b``."""

    name = slot = "pair"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of all collision pairs, then those of attracting pairs."""
        met = [PAIR_SEPARATOR.join(meeting.names) for meeting in mechanism.meetings if len(meeting.names) == 2]
        drawn = [PAIR_SEPARATOR.join((pull.a, pull.b)) for pull in mechanism.attractions]
        return tuple(dict.fromkeys([*met, *drawn]))

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return the phrases of pairs, such as *pucks A and B*, if both are named and one can move."""
        found: dict[str, str] = {}
        for name in self.names(mechanism):
            a, b = members(name)
            if a in mentions and b in mentions and (can_move(mechanism, a) or can_move(mechanism, b)):
                found[name] = pair(mentions[a], mentions[b])
        return found

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return whether the text gives the number `need`, such as the mass, of both bodies."""
        return all(Bodies().gives(need, mechanism, body, said) for body in members(name))

    def point(self, mechanism: Mechanism, name: str, phrase: str) -> str:
        """Return the phrase of the centres of the bodies, if they have a size."""
        wide = any(PAIR_SEPARATOR.join(met.names) == name and met.distance > 0.0 for met in mechanism.meetings)
        return f"the centres of {phrase}" if wide else phrase


def members(name: str) -> tuple[str, str]:
    """Return the names of the two bodies in the name of a pair."""
    a, _, b = name.partition(PAIR_SEPARATOR)
    return a, b


def pair(one: str, other: str) -> str:
    """Return the joint phrase of two bodies: *pucks A and B*, *block A and wedge W*."""
    noun, _, letter = one.rpartition(" ")
    same, _, second = other.rpartition(" ")
    return f"{noun}s {letter} and {second}" if noun == same and noun != "the" else f"{one} and {other}"


@dataclass(frozen=True)
class RelativeBodies(Subject):
    """Ordered pairs of moving bodies as subjects named ``a & b``: the first relative to the second."""

    name, slot = "body relative to another", "relative"

    def names(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of all ordered pairs of bodies whose centres of mass move."""
        moving = [name for name in mechanism.body if can_move(mechanism, name)]
        return tuple(PAIR_SEPARATOR.join(pair) for pair in permutations(moving, 2))

    def phrases(self, mechanism: Mechanism, mentions: Mapping[str, str]) -> dict[str, str]:
        """Return no phrases, since only structured questions are about relative quantities."""
        del mechanism, mentions
        return {}

    def gives(self, need: str, mechanism: Mechanism, name: str, said: Collection[str]) -> bool:
        """Return whether the text gives the number `need`, such as the mass, of both bodies."""
        return all(Bodies().gives(need, mechanism, body, said) for body in members(name))

    def senses(self, mechanism: Mechanism, name: str) -> list[Sense]:
        """Return the directions that the text can name for both bodies."""
        one, other = (Bodies().senses(mechanism, body) for body in members(name))
        return [sense for sense in one if sense in other]

"""Where the distance of two bodies that attract each other is least or greatest."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from sim2reason.dsl.state import Array, State
from sim2reason.quantities.kinematics import Velocity
from sim2reason.quantities.pairs import DistanceBetween
from sim2reason.quantities.subjects.bodies import moves
from sim2reason.quantities.subjects.pairs import Pairs, members
from sim2reason.questions.moments.parts.peak import Peak
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace

CIRCLE = 1e-2  # of their distance: what varies by less has neither a closest nor a farthest point


@dataclass(frozen=True, slots=True)
class Apsis(Peak):
    """Where the distance of two bodies that attract each other is least or greatest.

    Class data:
        most: which of the two it is, as the text says it of one that moves about another.
    """

    most: ClassVar[str]

    of = Pairs()
    hangs_on = "distance"
    pronoun = ""  # of several bodies it does not tell which

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Those that attract each other."""
        drawn = {frozenset((pull.a, pull.b)) for pull in words.mechanism.attractions}
        pairs = {name: said for name, said in words.called(cls.of).items() if frozenset(members(name)) in drawn}
        rounds = {name: _one_round(words, name) for name in pairs}
        return {name: said if (one := rounds[name]) is None else words.mentions[one[0]] for name, said in pairs.items()}

    def does(self, words: Words) -> Verb:
        """What both do; or one of them, where the other is fixed."""
        one = _one_round(words, self.name)
        if one is None:
            return self.verb
        distance = f"its {self.most} distance from {words.mentions[one[1]]}"
        return Verb(f"reaches {distance}", f"reach {distance}")

    @property
    def comes_round(self) -> bool:
        """What recedes for ever turns neither back nor towards."""
        return True

    def receding(self, state: State) -> Array:
        """How fast they part, m/s, (n,): r·v/r."""
        a, b = members(self.name)
        frames = state.frames
        apart = state.vector(frames.center(b).place) - state.vector(frames.center(a).place)
        parting = Velocity.evaluate(state, b) - Velocity.evaluate(state, a)
        return np.einsum("ij,ij->i", apart, parting) / np.linalg.norm(apart, axis=1)

    def time(self, trace: Trace) -> float | None:
        """When it turns; None of what goes round in a circle."""
        far = DistanceBetween.evaluate(trace.scan, self.name)
        round_it_goes = float(far.max() - far.min()) <= CIRCLE * float(far.max())
        return None if round_it_goes else Peak.time(self, trace)


def _one_round(words: Words, name: str) -> tuple[str, str] | None:
    """The body of a pair that moves, and the other, which is fixed; None where both move."""
    a, b = members(name)
    if moves(words.mechanism, a) and moves(words.mechanism, b):
        return None
    return (a, b) if moves(words.mechanism, a) else (b, a)

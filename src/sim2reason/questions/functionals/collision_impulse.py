"""The impulse that two bodies exert on each other in one collision."""

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.quantities.momentum import Momentum
from sim2reason.quantities.subjects.pairs import Pairs, members
from sim2reason.questions.functionals import Functional, functional
from sim2reason.questions.functionals.parts.encounter import encounter
from sim2reason.questions.functionals.parts.jump import BALANCE, is_loose, jumps
from sim2reason.questions.moments import Moment
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace


@functional
class CollisionImpulse(Functional):
    """The size of the impulse that each of two loose bodies gets from the other."""

    name, unit, kind, least = "impulse of a collision", "N s", "sum", 1e-3
    of, needs = Pairs(), ("mass",)
    phrase = "the magnitude of the impulse that {pair} exert on each other"
    how = "how large is the impulse that {pair} exert on each other {when}?"
    weight = 3.0

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """As in: in their second collision."""
        return encounter(moment, words, name)

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """m|Δv| of the one, if the other gets the opposite, so that nothing else strikes them at that instant."""
        one, other = (jumps(trace, lambda s, n=n: Momentum.evaluate(s, n), [end])[0] for n in members(name))
        size = float(np.linalg.norm(one))
        return size if float(np.linalg.norm(one + other)) <= BALANCE * size else None

    def present(self, words: Words, name: str) -> bool:
        """Two loose bodies, so that no string or axle takes part of it."""
        return all(is_loose(words.mechanism, body) for body in members(name))

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Both momenta."""
        del mechanism
        return tuple(Channel(body, Momentum.name) for body in members(name))

"""Where the length of a spring is greatest or least."""

from abc import abstractmethod
from dataclasses import dataclass
from typing import ClassVar

from sim2reason.dsl.mechanism import Elastic
from sim2reason.dsl.state import Array, State
from sim2reason.quantities import QUANTITIES
from sim2reason.quantities.springs import Extension, ExtensionRate
from sim2reason.quantities.subjects.paths import center_path
from sim2reason.quantities.subjects.springs import Springs
from sim2reason.questions.moments.parts.peak import Peak
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel


@dataclass(frozen=True, slots=True)
class SpringTurn(Peak):
    """Where a spring is stretched the most, or compressed the most.

    Class data:
        local_verb: what it does there if it may be stretched, or compressed, more at a later time.
    """

    own = True
    of = Springs()
    hangs_on = "extension rate"
    above = 0.0
    local_verb: ClassVar[Verb]

    @property
    def tells(self) -> tuple[Channel, ...]:
        """All of the spring: its own extremes are asked for as such, not at the moment when they are reached."""
        return tuple(Channel(self.name, found.name) for found in QUANTITIES.values() if found.of.name == self.of.name)

    def does(self, words: Words) -> Verb:
        """As in: reaches its maximum extension, and where more than one oscillation may take part, a maximum of it."""
        mechanism = words.mechanism
        alone = sum(isinstance(line.law, Elastic) for line in mechanism.lines) == 1
        swings = any(center_path(mechanism, body.name).bends for body in mechanism.bodies)
        return self.local_verb if swings or mechanism.meetings or not alone else self.verb

    @abstractmethod
    def sign(self) -> float:
        """1 for stretched, −1 for compressed."""

    def extent(self, state: State) -> Array:
        """How far it is stretched, or compressed."""
        return self.sign() * Extension.evaluate(state, self.name)

    def excess(self, state: State) -> Array:
        """How fast it comes back."""
        return -self.sign() * ExtensionRate.evaluate(state, self.name)

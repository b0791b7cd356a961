"""Where the length of a spring is greatest or least."""

from abc import abstractmethod
from dataclasses import dataclass

from sim2reason.dsl.state import Array, State
from sim2reason.quantities import QUANTITIES
from sim2reason.quantities.springs import Extension, ExtensionRate
from sim2reason.quantities.subjects.springs import Springs
from sim2reason.questions.moments.parts.peak import Peak
from sim2reason.simulation.channels import Channel


@dataclass(frozen=True, slots=True)
class SpringTurn(Peak):
    """Where a spring is stretched the most, or compressed the most."""

    own = True
    of = Springs()
    hangs_on = "extension rate"
    above = 0.0

    @property
    def tells(self) -> tuple[Channel, ...]:
        """All of the spring: its own extremes are asked for as such, not at the moment when they are reached."""
        return tuple(Channel(self.name, found.name) for found in QUANTITIES.values() if found.of.name == self.of.name)

    @abstractmethod
    def sign(self) -> float:
        """1 for stretched, −1 for compressed."""

    def extent(self, state: State) -> Array:
        """How far it is stretched, or compressed."""
        return self.sign() * Extension.evaluate(state, self.name)

    def excess(self, state: State) -> Array:
        """How fast it comes back."""
        return -self.sign() * ExtensionRate.evaluate(state, self.name)

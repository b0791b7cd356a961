"""The energy that a dashpot dissipates."""

from sim2reason.dsl.mechanism import Elastic, Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.quantities.springs import ExtensionRate
from sim2reason.quantities.subjects.springs import Springs
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.integral import Integral
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel


@functional
class DashpotHeat(Integral):
    """The energy that the dashpot beside a spring dissipates."""

    name, unit, least = "energy dissipated by a dashpot", "J", 1e-3
    of = Springs()
    phrase = "the energy that the dashpot beside {spring} dissipates"
    how = "how much energy does the dashpot beside {spring} dissipate {when}?"
    indirect = "how much energy the dashpot beside {spring} dissipates"
    weight = 5.0

    def rate(self, state: State, name: str) -> Array:
        """The force c·dl/dt times the rate dl/dt, W, (n,)."""
        return _damping(state.mechanism, name) * ExtensionRate.evaluate(state, name) ** 2

    def present(self, words: Words, name: str) -> bool:
        """A damped spring that acts both ways."""
        return _damping(words.mechanism, name) > 0.0

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """The rate."""
        del mechanism
        return (Channel(name, ExtensionRate.name),)


def _damping(mechanism: Mechanism, name: str) -> float:
    law = mechanism.line[name].law
    return law.damping if isinstance(law, Elastic) and not law.side else 0.0

"""Springs: extension, length, force and stored energy."""

import numpy as np

from sim2reason.scenes.dsl.mechanism import Elastic, Line, Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.quantities import Quantity, quantity
from sim2reason.simulation.quantities.subjects.lines import Springs


def _law(state: State, subject: str) -> tuple[Line, Elastic]:
    """Return a spring and its force law."""
    line = state.mechanism.line[subject]
    assert isinstance(line.law, Elastic)
    return line, line.law


@quantity
class Extension(Quantity):
    """The length of a spring minus its natural length: negative in compression."""

    name, unit, symbol = "extension", "m", "x"
    of, along = Springs(), True
    magnitude = "the amount by which {spring} is stretched or compressed"
    how = "by how much is {spring} stretched or compressed {when}?"
    indirect = "by how much {spring} is stretched or compressed"
    weight = 2.0
    floor = 0.01
    given = True
    order = 0

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return l − l₀ in m, (n,), including the length wound onto a pulley."""
        line, law = _law(state, subject)
        return state.free_length(line)[0] - law.length


@quantity
class SpringLength(Quantity):
    """The length of a spring."""

    name, unit, symbol = "spring length", "m", "l"
    of = Springs()
    magnitude = "the length of {spring}"
    how = "how long is {spring} {when}?"
    indirect = "how long {spring} is"
    needs = ("length",)
    given = True
    floor = 0.1
    panel, order = "spring length", 1

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the length end to end in m, (n,)."""
        return state.free_length(_law(state, subject)[0])[0]


@quantity
class ExtensionRate(Quantity):
    """The rate of change of the length of a spring."""

    name, unit, symbol = "extension rate", "m/s", "u"
    of, along = Springs(), True
    magnitude = "the magnitude of the rate at which the length of {spring} changes"
    how = "how fast is the length of {spring} changing {when}?"
    given = True
    weight = 0.05
    floor, least = 0.1, 1e-2
    order = 2

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return dl/dt in m/s, (n,)."""
        return state.free_length(_law(state, subject)[0])[1]


@quantity
class SpringForce(Quantity):
    """The force of a spring including its damping, positive in tension."""

    name, unit, symbol = "spring force", "N", "F"
    of, along = Springs(), True
    magnitude = "the magnitude of the force exerted by {spring}"
    how = "how large is the force exerted by {spring} {when}?"
    needs = ("stiffness",)
    given = True
    weight = 2.0
    floor, heavy = 0.1, True
    panel, order = "spring force", 3

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the spring has no dashpot, which would make the force ambiguous."""
        law = mechanism.line[name].law
        return isinstance(law, Elastic) and not law.damping

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return F = k (l − l₀) + c dl/dt in N, (n,)."""
        return state.tension[subject]


@quantity
class SpringEnergy(Quantity):
    """The energy stored in a spring."""

    name, unit, symbol = "spring energy", "J", "U"
    of = Springs()
    magnitude = "the energy stored in {spring}"
    how = "how much energy is stored in {spring} {when}?"
    needs = ("stiffness",)
    given = True
    weight = 0.6
    floor, heavy = 0.1, True
    panel, pooled, order = "energy", True, 4

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return ½ k (l − l₀)² in J, (n,)."""
        return 0.5 * _law(state, subject)[1].stiffness * Extension.evaluate(state, subject) ** 2


@quantity
class SpringStiffness(Quantity):
    """The stiffness of a spring, which the text gives; recorded, not asked."""

    name, unit, symbol = "stiffness", "N/m", "k"
    of = Springs()
    floor = 1.0

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the constant stiffness in N/m, (n,)."""
        return np.full(len(state.times), _law(state, subject)[1].stiffness)

"""Springs: how far they are stretched, with what force, and the energy that they store."""

import numpy as np

from sim2reason.scenes.dsl.mechanism import Elastic, Line, Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.quantities import Quantity, quantity
from sim2reason.simulation.quantities.subjects.lines import Springs


def _law(state: State, subject: str) -> tuple[Line, Elastic]:
    """Return a spring and its law."""
    line = state.mechanism.line[subject]
    assert isinstance(line.law, Elastic)
    return line, line.law


@quantity
class Extension(Quantity):
    """The length of a spring less its natural length: negative where it is compressed."""

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
        """Return the length l − l₀, what a pulley winds up included, (n,)."""
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
        """End to end, (n,)."""
        return state.free_length(_law(state, subject)[0])[0]


@quantity
class ExtensionRate(Quantity):
    """The rate at which a spring grows longer."""

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
        """dl/dt, (n,)."""
        return state.free_length(_law(state, subject)[0])[1]


@quantity
class SpringForce(Quantity):
    """The force of a spring, positive where it pulls; that of its damping included."""

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
        """Not beside a dashpot, of which a reader would have to guess whether it counts."""
        law = mechanism.line[name].law
        return isinstance(law, Elastic) and not law.damping

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """F = k (l − l₀) + c dl/dt, (n,)."""
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
        """½ k (l − l₀)², (n,)."""
        return 0.5 * _law(state, subject)[1].stiffness * Extension.evaluate(state, subject) ** 2


@quantity
class SpringStiffness(Quantity):
    """The stiffness of a spring, which the text gives; recorded, not asked."""

    name, unit, symbol = "stiffness", "N/m", "k"
    of = Springs()
    floor = 1.0

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Constant, (n,)."""
        return np.full(len(state.times), _law(state, subject)[1].stiffness)

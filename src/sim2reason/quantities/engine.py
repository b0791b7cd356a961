"""What an engine does that ejects mass: used in structured questions only, and never drawn."""

import numpy as np

from sim2reason.dsl.mechanism import Burn, Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.subjects.bodies import Bodies


class OfEngine(Quantity):
    """A quantity of a body that burns fuel."""

    of = Bodies()
    drawn_by_recipes = False
    floor = 0.1

    def subjects(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of the bodies with a single engine."""
        burning = [burn.body for burn in mechanism.burns]
        return tuple(name for name in self.of.names(mechanism) if burning.count(name) == 1)


@quantity
class Thrust(OfEngine):
    """The thrust of the engine while it burns."""

    name, unit, symbol = "thrust", "N", "F"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Rate times exhaust speed, (n,); zero after burnout."""
        burn = _burn(state.mechanism, subject)
        return np.where(state.times < burn.until, burn.rate * burn.exhaust, 0.0)


@quantity
class FuelLeft(OfEngine):
    """The mass of the fuel that is left."""

    name, unit, symbol = "fuel left", "kg", "m"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Rate times the time until burnout, (n,)."""
        burn = _burn(state.mechanism, subject)
        return burn.rate * np.maximum(burn.until - state.times, 0.0)


@quantity
class FuelBurnt(OfEngine):
    """The mass of the fuel that has been burnt."""

    name, unit, symbol = "fuel burnt", "kg", "m"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Rate times the time so far, (n,)."""
        burn = _burn(state.mechanism, subject)
        return burn.rate * np.minimum(state.times, burn.until)


def _burn(mechanism: Mechanism, name: str) -> Burn:
    return next(burn for burn in mechanism.burns if burn.body == name)

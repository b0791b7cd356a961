"""Motion of bodies relative to what carries them: used in structured questions only, and never drawn."""

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.paths import rides


class OfRider(Quantity):
    """A quantity of a body that slides along one line on a body that moves without turning."""

    of = Bodies()
    drawn_by_recipes = False
    floor = 0.1

    def subjects(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of the bodies."""
        return tuple(name for name in self.of.names(mechanism) if rides(mechanism, name) and _slides(mechanism, name))


@quantity
class RiderDisplacement(OfRider):
    """How far a body has gone along what carries it."""

    name, unit, symbol = "displacement relative to its carrier", "m", "s"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """q, which is zero at the start, (n,)."""
        return np.asarray(state.q[:, _number(state.mechanism, subject)])


@quantity
class RiderVelocity(OfRider):
    """How fast a body goes along what carries it."""

    name, unit, symbol = "speed relative to its carrier", "m/s", "v"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """q̇, (n,)."""
        return np.asarray(state.v[:, _number(state.mechanism, subject)])


@quantity
class RiderAcceleration(OfRider):
    """The acceleration of a body along what carries it, relative to that."""

    name, unit, symbol = "acceleration relative to its carrier", "m/s^2", "a"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """q̈, (n,)."""
        return np.asarray(state.a[:, _number(state.mechanism, subject)])


def _number(mechanism: Mechanism, name: str) -> int:
    return mechanism.number[mechanism.body[name].coordinates[0].name]


def _slides(mechanism: Mechanism, name: str) -> bool:
    carrier = mechanism.body[name].parent
    kinds = [c.kind for part in (name, carrier) if part is not None for c in mechanism.body[part].coordinates]
    return [c.kind for c in mechanism.body[name].coordinates] == ["slide"] and set(kinds) == {"slide"}

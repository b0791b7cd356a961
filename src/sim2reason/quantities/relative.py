"""Motion of bodies relative to what carries them: used in structured questions only, and never drawn."""

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.paths import rides


class OfRider(Quantity):
    """Base class of quantities of a body that slides along one line on a body that moves without turning."""

    of = Bodies()
    drawn_by_recipes = False
    floor = 0.1

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body slides along one line on a body that moves without turning."""
        return rides(mechanism, name) and _slides(mechanism, name)


@quantity
class RiderDisplacement(OfRider):
    """The displacement of a body relative to the body that carries it."""

    name, unit, symbol = "displacement relative to its carrier", "m", "s"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return q in m, which is zero at the start, (n,)."""
        return _own(state.q, state, subject)


@quantity
class RiderVelocity(OfRider):
    """The velocity of a body relative to the body that carries it."""

    name, unit, symbol = "speed relative to its carrier", "m/s", "v"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return q̇ in m/s, (n,)."""
        return _own(state.v, state, subject)


@quantity
class RiderAcceleration(OfRider):
    """The acceleration of a body relative to the body that carries it."""

    name, unit, symbol = "acceleration relative to its carrier", "m/s^2", "a"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return q̈ in m/s², (n,)."""
        return _own(state.a, state, subject)


def _own(values: Array, state: State, name: str) -> Array:
    """Return the column of a body's only coordinate, (n,), in the values of all coordinates, (n, coordinates)."""
    mechanism = state.mechanism
    return np.asarray(values[:, mechanism.number[mechanism.body[name].coordinates[0].name]])


def _slides(mechanism: Mechanism, name: str) -> bool:
    carrier = mechanism.body[name].parent
    kinds = [c.kind for part in (name, carrier) if part is not None for c in mechanism.body[part].coordinates]
    return [c.kind for c in mechanism.body[name].coordinates] == ["slide"] and set(kinds) == {"slide"}

"""Quantities of rocket engines; used in structured questions only, never drawn by recipes."""

import numpy as np

from sim2reason.scenes.dsl.mechanism import MassEjection, Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.quantities import Quantity, quantity
from sim2reason.simulation.quantities.kinematics import Velocity
from sim2reason.simulation.quantities.subjects.bodies import Bodies


class EngineQuantity(Quantity):
    """Base class of quantities of a body that burns fuel."""

    of = Bodies()
    drawn_by_recipes = False
    floor = 0.1

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body has a single engine."""
        return [burn.body for burn in mechanism.burns].count(name) == 1


@quantity
class Thrust(EngineQuantity):
    """The thrust of the engine while it burns."""

    name, unit, symbol = "thrust", "N", "F"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the burn rate times the exhaust speed in N, (n,); zero after burnout."""
        burn = _burn(state.mechanism, subject)
        return np.where(state.times < burn.until, burn.rate * burn.exhaust, 0.0)


@quantity
class ThrustPower(EngineQuantity):
    """The power of the thrust: the thrust times the component of the velocity along it."""

    name, unit, symbol = "power of the thrust", "W", "P"
    magnitude = "the magnitude of the power of the thrust on {body}"
    heavy, order = True, 22

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body has a single engine."""
        return self.fits(mechanism, name)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the power in W, (n,); zero after burnout."""
        along = Velocity.evaluate(state, subject) @ np.array(_burn(state.mechanism, subject).direction)
        return Thrust.evaluate(state, subject) * along


@quantity
class FuelBurnt(EngineQuantity):
    """The mass of the fuel that has been burnt."""

    name, unit, symbol = "fuel burnt", "kg", "m"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the burn rate times the elapsed burn time in kg, (n,)."""
        burn = _burn(state.mechanism, subject)
        return burn.rate * np.minimum(state.times, burn.until)


@quantity
class FuelLeft(EngineQuantity):
    """The mass of the fuel that is left."""

    name, unit, symbol = "fuel left", "kg", "m"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the initial fuel minus the fuel burnt since then, in kg, (n,)."""
        burn = _burn(state.mechanism, subject)
        return burn.rate * burn.until - FuelBurnt.evaluate(state, subject)


def _burn(mechanism: Mechanism, name: str) -> MassEjection:
    return next(burn for burn in mechanism.burns if burn.body == name)

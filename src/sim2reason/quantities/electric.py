"""Electric potential energy of charges in static fields."""

import numpy as np

from sim2reason.dsl.fields import Central, Push
from sim2reason.dsl.mechanism import Force, Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.dsl.triples import Number, Triple
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.subjects.bodies import Bodies

FAR = (1e3, 1e3, 1e3)  # m; anywhere but at a charge


@quantity
class ElectricPotentialEnergy(Quantity):
    """The electric potential energy of a charge less that at the start, where the field has a potential."""

    name, unit, symbol = "electric potential energy", "J", "U"
    of = Bodies()
    over = "the magnitude of the change in {body}'s electric potential energy"
    how = "by how much does the electric potential energy of {body} change {when}?"
    magnitude = f"{over} since the start"
    from_start = True
    needs = ("charge",)
    weight = 0.3
    floor, heavy = 0.1, True
    panel, pooled, order = "energy", True, 9

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether electric forces act on the body, and all of them have a potential everywhere."""
        return self.present(mechanism, name)

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Whether all such forces on it are static, without curl, and in no region, whose border would have one."""
        forces = _electric(mechanism, name)
        return bool(forces) and all(f.region is None and f.law.potential(FAR, np) is not None for f in forces)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Σ q(φ − φ₀), (n,); a magnetic field does no work."""
        now, began = state.frames.center(subject).place, state.began.center(subject).place
        total = np.zeros(len(state.times))
        for force in _electric(state.mechanism, subject):
            total = total + _potential(force, now) - _potential(force, began)
        return total


def _potential(force: Force, place: Triple) -> Number:
    """The potential energy, J; only of what is `present`."""
    found: Number = force.law.potential(place, np)
    assert found is not None
    return found


def _electric(mechanism: Mechanism, name: str) -> list[Force]:
    """The forces on a body that a charge at rest would feel, too."""
    return [force for force in mechanism.forces if force.body == name and isinstance(force.law, Push | Central)]

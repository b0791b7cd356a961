"""Forces of one kind on a charged body: of electric fields, of magnetic fields, and of a resisting medium."""

from typing import ClassVar

import numpy as np

from sim2reason.dsl.fields import Law, Magnetic, Push, Resistance
from sim2reason.dsl.mechanism import Force, Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.subjects.bodies import Bodies


class FieldForce(Quantity):
    """Base class of the sums of all forces of one kind on a body; used in structured questions only, and never drawn.

    Class data:
        law: the class of the laws of these forces.
    """

    law: ClassVar[type[Law]]
    unit, symbol = "N", "F"
    of, vector = Bodies(), True
    drawn_by_recipes = False
    floor, heavy = 0.1, True

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether there are such forces on the body, and none that acts in a region alone."""
        forces = acting(mechanism, name, self.law)
        return bool(forces) and all(force.region is None for force in forces)


def acting(mechanism: Mechanism, name: str, law: type[Law]) -> list[Force]:
    """Return the forces on a body whose laws are of a class."""
    return [force for force in mechanism.forces if force.body == name and isinstance(force.law, law)]


def _total(state: State, subject: str, law: type[Law]) -> Array:
    """Return the sum of the forces of a kind on a body, in N, (n, 3)."""
    center = state.frames.center(subject)
    total = np.zeros((len(state.times), 3))
    for force in acting(state.mechanism, subject, law):
        total = total + state.vector(force.law.force(center.place, center.velocity, state.times, np))
    return total


@quantity
class ElectricForce(FieldForce):
    """The force of the electric fields on a body."""

    name = "electric force"
    law = Push

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return q E in N, (n, 3)."""
        return _total(state, subject, Push)


@quantity
class MagneticForce(FieldForce):
    """The force of the magnetic fields on a body."""

    name = "magnetic force"
    law = Magnetic

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return q v × B in N, (n, 3)."""
        return _total(state, subject, Magnetic)


@quantity
class ResistingForce(FieldForce):
    """The force with which a medium resists the motion of a body."""

    name = "resisting force"
    law = Resistance

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the force of the medium in N, (n, 3), which is opposite to the velocity."""
        return _total(state, subject, Resistance)

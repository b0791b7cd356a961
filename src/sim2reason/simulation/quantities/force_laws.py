"""Forces of springs, fields and media, and the lengths and energies of springs."""

from typing import ClassVar

import numpy as np

from sim2reason.scenes.dsl.fields import Central, Law, Magnetic, Push, Resistance
from sim2reason.scenes.dsl.mechanism import Elastic, Force, Line, Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.vectors import Number, Triple
from sim2reason.simulation.quantities import Quantity, quantity
from sim2reason.simulation.quantities.subjects.bodies import Bodies
from sim2reason.simulation.quantities.subjects.interactions import Springs


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


BORDER_DISTANCE_TOL = 1e-9  # m; what is nearer to the border of a region is in it
FAR_POINT = (1e3, 1e3, 1e3)  # m; anywhere but at a charge


@quantity
class ElectricPotentialEnergy(Quantity):
    """The electric potential energy of a charge minus its initial value, if the field has a potential."""

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
        """Return whether all electric forces on the body are static, curl-free and not limited to a region."""
        forces = _electric(mechanism, name)
        return bool(forces) and all(f.region is None and f.law.potential(FAR_POINT, np) is not None for f in forces)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return Σ q(φ − φ₀) in J, (n,); a magnetic field does no work."""
        now, began = state.frames.center(subject).place, state.began.center(subject).place
        total = np.zeros(len(state.times))
        for force in _electric(state.mechanism, subject):
            total = total + _potential(force, now) - _potential(force, began)
        return total


def _potential(force: Force, position: Triple) -> Number:
    """Return the potential energy of a force in J; it must have a potential."""
    energy: Number = force.law.potential(position, np)
    assert energy is not None
    return energy


def _electric(mechanism: Mechanism, name: str) -> list[Force]:
    """Return the forces on a body that would also act on a charge at rest."""
    return [force for force in mechanism.forces if force.body == name and isinstance(force.law, Push | Central)]


class FieldForce(Quantity):
    """Base class of the total force of one kind on a body; for structured questions only, not drawn by recipes.

    Class data:
        law: the class of the laws of these forces.
    """

    law: ClassVar[type[Law]]
    unit, symbol = "N", "F"
    of, vector = Bodies(), True
    drawn_by_recipes = False
    floor, heavy = 0.1, True

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether there are such forces on the body."""
        return bool(forces_with_law(mechanism, name, self.law))


def forces_with_law(mechanism: Mechanism, name: str, law: type[Law]) -> list[Force]:
    """Return the forces on a body with laws of a given class."""
    return [force for force in mechanism.forces if force.body == name and isinstance(force.law, law)]


def _total(state: State, subject: str, law: type[Law]) -> Array:
    """Return the sum of the forces of one class on a body in N, (n, 3)."""
    center = state.frames.center(subject)
    total = np.zeros((len(state.times), 3))
    for force in forces_with_law(state.mechanism, subject, law):
        force_vectors = state.vector(force.law.force(center.place, center.velocity, state.times, np))
        total = total + force_vectors * _inside(force, state, center.place)[:, None]
    return total


def _inside(force: Force, state: State, position: Triple) -> Array:
    """Return whether a place is in the region of a force, its border included, (n,); true for a force without one."""
    if force.region is None:
        return np.ones(len(state.times), dtype=bool)
    margins = [state.vector((margin, 0.0, 0.0))[:, 0] for margin in force.region.margins(position, np)]
    return np.min(margins, axis=0) >= -BORDER_DISTANCE_TOL


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

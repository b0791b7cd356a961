"""Momentum, net force and energies of a body."""

from dataclasses import dataclass

from sim2reason.questions import Target
from sim2reason.solutions.algebra.expressions import Symbol, added, multiplied
from sim2reason.solutions.goals import GOALS, Goal, KnownMotion, VectorName, magnitude, modulus, write_answer
from sim2reason.solutions.goals.kinematics import ACCELERATIONS, DISPLACEMENTS, VELOCITIES, along_sense, squared

UP = (0.0, 0.0, 1.0)


@dataclass(frozen=True, slots=True)
class MassTimes(Goal):
    """The momentum of a body or the net force on it: mass times a vector."""

    noun: VectorName
    of: VectorName

    @property
    def uses(self) -> str:
        """Return the kind of vector that mass multiplies: velocity ``v`` for momentum, acceleration ``a`` for force."""
        return self.of.base

    def write(self, target: Target, known: KnownMotion) -> Symbol:
        """Write the magnitude of the vector, then m times it."""
        body, mass = target.subject, known.mass(target.subject).expression()
        mark = r"\text{net}" if self.noun.base == "F" else known.setting.subscript_of(body)
        whose = f"{self.noun.said} {'on' if self.noun.base == 'F' else 'of'} {known.setting.display_name(body)}"
        if target.sense is not None:
            formula = known.component(self.of.base, body, target.sense.vector).factored()
            what = along_sense(whose, target.sense)
        else:
            formula = magnitude(known.vector(self.of.base, body), known, self.of, body)
            what = f"the magnitude of the {whose}"
        return write_answer(known, multiplied(mass, formula), self.noun, mark, what)


@dataclass(frozen=True, slots=True)
class KineticEnergyGoal(Goal):
    """The kinetic energy of a body, ½ m v² with ½ I ω² for its rotation."""

    @property
    def uses(self) -> str:
        """Return ``v``: the energy is derived from the velocity."""
        return "v"

    @property
    def turns(self) -> bool:
        """Return True: the rotation of the body contributes to the energy."""
        return True

    def write(self, target: Target, known: KnownMotion) -> Symbol:
        """Write the speed, then the energy."""
        body, rim = target.subject, known.rim("v", target.subject)
        speed = magnitude(known.vector("v", body), known, VELOCITIES, body)
        formula = multiplied(known.mass(body).scaled(0.5).expression(), squared(speed))
        if rim:
            half = known.rim_inertia(body).scaled(0.5).expression()
            formula = added(formula, multiplied(half, squared(rim.expression())))
        noun, mark = VectorName.of("kinetic energy"), known.setting.subscript_of(body)
        return write_answer(known, formula, noun, mark, f"the kinetic energy of {known.setting.display_name(body)}")


@dataclass(frozen=True, slots=True)
class PotentialEnergyGoal(Goal):
    """The change in gravitational potential energy of a body, m g h, where h is its rise."""

    @property
    def uses(self) -> str:
        """Return ``s``: the energy is derived from the displacement."""
        return "s"

    def write(self, target: Target, known: KnownMotion) -> Symbol:
        """Write the rise, then the magnitude of the change in energy."""
        body = target.subject
        rise = known.component(DISPLACEMENTS.base, body, UP)
        formula = (known.mass(body) * known.gravity * rise).factored()
        noun, mark = VectorName.of("potential energy"), known.setting.subscript_of(body)
        size = modulus(formula, known.book, of_either_sign=True)
        what = f"the magnitude of the change in the potential energy of {known.setting.display_name(body)}"
        return write_answer(known, size, noun, mark, what)


GOALS.add("momentum", MassTimes(VectorName.of("momentum"), VELOCITIES))
GOALS.add("net force", MassTimes(VectorName.of("net force"), ACCELERATIONS))
GOALS.add("kinetic energy", KineticEnergyGoal())
GOALS.add("potential energy", PotentialEnergyGoal())

"""Momentum, energies, forces and springs: quantities that Newton's laws and the extensions of springs give."""

from collections.abc import Sequence
from dataclasses import dataclass

from sim2reason.questions import Target
from sim2reason.solutions.algebra.expressions import Expression, Number, Symbol, multiply_factors, sum_terms
from sim2reason.solutions.algebra.functions import Power
from sim2reason.solutions.goals import GOALS, Goal, KnownMotion, VectorName, magnitude, modulus, write_answer
from sim2reason.solutions.goals.kinematics import ACCELERATIONS, DISPLACEMENTS, VELOCITIES, along_sense, squared
from sim2reason.solutions.setting import ProblemContext, capitalized

UP_DIRECTION = (0.0, 0.0, 1.0)


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
        whose = f"{self.noun.noun} {'on' if self.noun.base == 'F' else 'of'} {known.setting.display_name(body)}"
        if target.sense is not None:
            formula = known.component(self.of.base, body, target.sense.vector).factored()
            what = along_sense(whose, target.sense)
        else:
            formula = magnitude(known.vector(self.of.base, body), known, self.of, body)
            what = f"the magnitude of the {whose}"
        return write_answer(known, multiply_factors(mass, formula), self.noun, mark, what)


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
        formula = multiply_factors(known.mass(body).scale(0.5).expression(), squared(speed))
        if rim:
            half = known.rim_inertia(body).scale(0.5).expression()
            formula = sum_terms(formula, multiply_factors(half, squared(rim.expression())))
        noun, mark = VectorName.for_quantity("kinetic energy"), known.setting.subscript_of(body)
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
        rise = known.component(DISPLACEMENTS.base, body, UP_DIRECTION)
        formula = (known.mass(body) * known.gravity * rise).factored()
        noun, mark = VectorName.for_quantity("potential energy"), known.setting.subscript_of(body)
        size = modulus(formula, known.book, of_either_sign=True)
        what = f"the magnitude of the change in the potential energy of {known.setting.display_name(body)}"
        return write_answer(known, size, noun, mark, what)


GOALS.add("momentum", MassTimes(VectorName.for_quantity("momentum"), VELOCITIES))
GOALS.add("net force", MassTimes(VectorName.for_quantity("net force"), ACCELERATIONS))
GOALS.add("kinetic energy", KineticEnergyGoal())
GOALS.add("potential energy", PotentialEnergyGoal())


@dataclass(frozen=True, slots=True)
class ForceGoal(Goal):
    """The tension of a string, or the normal force or friction on a body, by its letter."""

    kind: str

    @property
    def uses(self) -> str:
        """Return "": forces are derived without accelerations, velocities or displacements."""
        return ""

    def bodies(self, target: Target) -> Sequence[str]:
        """Return no bodies: a force is derived without the motion of a particular body."""
        del target
        return ()

    def force(self, target: Target, setting: ProblemContext) -> str:
        """Return the name of the unknown force, such as ``T2``: its letter with the index of string or contact."""
        if self.kind == "T":
            names = [line.name for line in setting.mechanism.constraints]
        else:
            names = [face.subject for face in setting.mechanism.faces]
        return f"{self.kind}{names.index(target.subject)}" if target.subject in names else ""

    def write(self, target: Target, known: KnownMotion) -> Symbol:
        """Return the symbol of the force, already known from Newton's laws."""
        return known.force(self.kind, target.subject)


GOALS.add("tension", ForceGoal("T"))
GOALS.add("normal force", ForceGoal("N"))
GOALS.add("friction force", ForceGoal("f"))


EXTENSION = VectorName.for_quantity("extension")
LENGTH = VectorName.for_quantity("spring length")
RATE = VectorName.for_quantity("extension rate")
FORCE = VectorName.for_quantity("spring force")
ENERGY = VectorName.for_quantity("spring energy")
_RATE = "rate of change of the length"
_CALLED = {  # what is positive, what is so where that is negative, and the modulus of both
    EXTENSION: ("extension", "compression", "extension or compression"),
    LENGTH: ("length",) * 3,
    RATE: (_RATE, "rate of decrease of the length", f"magnitude of the {_RATE}"),
    FORCE: ("tension", "compressive force", "magnitude of the force"),
    ENERGY: ("energy",) * 3,
}


@dataclass(frozen=True, slots=True)
class SpringGoal(Goal):
    """The extension, length, extension rate, force or energy of a spring."""

    noun: VectorName

    @property
    def uses(self) -> str:
        """Return the kind of vector needed: velocities ``v`` for a rate of extension, else displacements ``s``."""
        return "v" if self.noun is RATE else "s"

    def bodies(self, target: Target) -> Sequence[str]:
        """Return no bodies: the quantity depends on the length of the spring, not on a particular body."""
        del target
        return ()

    def lines(self, target: Target) -> Sequence[str]:
        """Return the name of the spring, whose length is needed."""
        return (target.subject,)

    def write(self, target: Target, known: KnownMotion) -> Symbol:
        """Write the quantity in terms of the spring's extension, signed if a sign is asked for."""
        formula = self._formula(target.subject, known)
        named, opposite, either = _CALLED[self.noun]
        if target.sense is None and self.noun not in (ENERGY, LENGTH):
            if known.book.in_symbols:
                formula, named = modulus(formula, known.book, of_either_sign=True), either
            elif known.book.value(formula) < 0.0:
                formula, named = -formula, opposite
        spring = known.setting.spring_phrases[target.subject]
        if isinstance(formula, Symbol) and self.noun is EXTENSION:
            step = known.book.begin_step("meaning")
            how = "compressed" if named == opposite else "stretched"
            step.add_text(f"{capitalized(spring)} is {how} by ${formula.latex()}$.")
            step.close()
        return write_answer(known, formula, self.noun, "", f"the {named} of {spring}")

    def _formula(self, line: str, known: KnownMotion) -> Expression:
        """Return the formula of the quantity in terms of the spring's extension."""
        if self.noun is RATE:
            return known.growth("v", line).expression()
        if self.noun is LENGTH:
            return (known.spring("length", line) + known.growth("s", line)).expression()
        extension = (known.spring("strain", line) + known.growth("s", line)).expression()
        if self.noun is EXTENSION:
            return extension
        stiffness = known.spring("stiffness", line).expression()
        if self.noun is ENERGY:
            return multiply_factors(Number(0.5), multiply_factors(stiffness, Power(extension, 2)))
        damping = known.spring("damping", line)
        pull = multiply_factors(stiffness, extension)
        return pull + multiply_factors(damping.expression(), known.growth("v", line).expression()) if damping else pull


for _noun in (EXTENSION, LENGTH, RATE, FORCE, ENERGY):
    GOALS.add(_noun.noun, SpringGoal(_noun))

"""Extension, length, force and energy of springs."""

from collections.abc import Sequence
from dataclasses import dataclass

from sim2reason.questions import Target
from sim2reason.solutions.algebra.expressions import Expression, Number, Symbol, multiplied
from sim2reason.solutions.algebra.functions import Power
from sim2reason.solutions.goals import GOALS, Goal, KnownMotion, VectorName, modulus, write_answer
from sim2reason.solutions.setting import capitalized

EXTENSION = VectorName.of("extension")
LENGTH = VectorName.of("spring length")
RATE = VectorName.of("extension rate")
FORCE = VectorName.of("spring force")
ENERGY = VectorName.of("spring energy")
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
            return multiplied(Number(0.5), multiplied(stiffness, Power(extension, 2)))
        damping = known.spring("damping", line)
        pull = multiplied(stiffness, extension)
        return pull + multiplied(damping.expression(), known.growth("v", line).expression()) if damping else pull


for _noun in (EXTENSION, LENGTH, RATE, FORCE, ENERGY):
    GOALS.add(_noun.said, SpringGoal(_noun))

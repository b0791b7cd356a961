"""How far springs are stretched, how hard they pull, and what they store."""

from collections.abc import Sequence
from dataclasses import dataclass

from sim2reason.questions import Target
from sim2reason.solutions.algebra.expressions import Expression, Number, Symbol, multiplied
from sim2reason.solutions.algebra.functions import Power
from sim2reason.solutions.goals import GOALS, Goal, Known, VectorName, finish

EXTENSION = VectorName.of("extension")
LENGTH = VectorName.of("spring length")
RATE = VectorName.of("extension rate")
FORCE = VectorName.of("spring force")
ENERGY = VectorName.of("spring energy")


@dataclass(frozen=True, slots=True)
class SpringGoal(Goal):
    """Something of a spring."""

    noun: VectorName

    @property
    def uses(self) -> str:
        """How long it is, or how fast that changes."""
        return "v" if self.noun is RATE else "s"

    def bodies(self, target: Target) -> Sequence[str]:
        """None by themselves."""
        del target
        return ()

    def lines(self, target: Target) -> Sequence[str]:
        """The spring."""
        return (target.subject,)

    def write(self, target: Target, known: Known) -> Symbol:
        """Of its extension; with a sign where one is asked for."""
        formula = self._formula(target.subject, known)
        if target.sense is None and self.noun not in (ENERGY, LENGTH) and known.book.value(formula) < 0.0:
            formula = -formula
        what = {
            EXTENSION: "its extension is",
            LENGTH: "its length is",
            RATE: "the rate of change of its length is",
            FORCE: "its force is",
            ENERGY: "its energy is",
        }[self.noun]
        return finish(known, formula, self.noun, "", f"of {known.setting.springs[target.subject]}, {what}")

    def _formula(self, line: str, known: Known) -> Expression:
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

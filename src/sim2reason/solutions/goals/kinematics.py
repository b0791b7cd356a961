"""Displacement, velocity and acceleration of a body."""

from dataclasses import dataclass

from sim2reason.quantities.subjects import Sense
from sim2reason.questions import Target
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.functions import Absolute
from sim2reason.solutions.goals import GOALS, Goal, Known, VectorName, finish, magnitude, modulus
from sim2reason.solutions.laws.either_way import reason_for_negative

DISPLACEMENTS = VectorName.of("displacement")
VELOCITIES = VectorName.of("velocity")
ACCELERATIONS = VectorName.of("acceleration")


def along_sense(whose: str, sense: Sense) -> str:
    """Return what a component of a vector is called; of a vector along a line, which sense is positive."""
    if sense.fixed:
        return f"the {sense.axis} component of the {whose}"
    return f"the {whose} (taking {sense.positive} as positive)"


@dataclass(frozen=True, slots=True)
class VectorGoal(Goal):
    """A vector of a body: its component along a sense, or its size."""

    noun: VectorName

    @property
    def uses(self) -> str:
        """The vector."""
        return self.noun.base

    def write(self, target: Target, known: Known) -> Symbol:
        """Components, then what is asked."""
        body, base = target.subject, self.noun.base
        whose, carrier = f"{self.noun.said} of {known.setting.called(body)}", known.setting.mechanism.body[body].parent
        mark = known.setting.mark(body)
        if target.sense is not None:
            formula = known.component(base, body, target.sense.vector).factored()
            return finish(known, formula, self.noun, mark, along_sense(whose, target.sense))
        lone = None if known.book.in_symbols else known.lone(base, body)
        if lone is not None and lone:
            whose = f"{whose} relative to the ground" if carrier is not None and lone.symbol is None else whose
            formula = modulus(lone.factored(), known.book)
        else:
            formula = magnitude(known.vector(base, body), known, self.noun, body)
        if isinstance(formula, Absolute) and (
            why := reason_for_negative(known.setting, known.book, formula.inside, body)
        ):
            what = f"{why}, so the magnitude of the {whose} is"
            return finish(known, -formula.inside, self.noun, mark, what)
        return finish(known, formula, self.noun, mark, f"so the magnitude of the {whose} is")


for _name, _noun in {"displacement": DISPLACEMENTS, "velocity": VELOCITIES, "acceleration": ACCELERATIONS}.items():
    GOALS.add(_name, VectorGoal(_noun))

"""What collisions cost and give."""

from collections.abc import Sequence
from dataclasses import dataclass

from sim2reason.quantities.subjects.pairs import members
from sim2reason.questions import Target
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol, added
from sim2reason.solutions.goals import GOALS, Goal, Known, Struck, VectorName, finish
from sim2reason.solutions.goals.sums import IMPULSES
from sim2reason.solutions.writing.steps import UnsolvedError

LOSS = VectorName.of("energy lost in a collision")


@dataclass(frozen=True, slots=True)
class CollisionGoal(Goal):
    """The loss (or the impulse) of the last collision of some bodies, or of all that there are.

    The kinetic energy that two bodies lose is that of their motion along the normal in the frame of their centre of
    mass, (1 − e²) of it; see any textbook, such as Kleppner and Kolenkow, An Introduction to Mechanics, § 6.3.
    """

    noun: VectorName
    of: str  # whose collisions: pair, body, whole
    several: bool

    @property
    def uses(self) -> str:
        """Velocities."""
        return "v"

    def bodies(self, target: Target) -> Sequence[str]:
        """Those that collide, but for all."""
        return members(target.subject) if self.of == "pair" else (target.subject,) if self.of == "body" else ()

    def write(self, target: Target, known: Known) -> Symbol:
        """One formula, or a sum of names."""
        own = {*self.bodies(target)}
        held = [struck for struck in known.impacts if not own or {*struck.bodies} == own]
        if not held:
            raise UnsolvedError("there is no such collision")
        held = held if self.several else held[-1:]
        what = "the kinetic energy lost" if self.noun is LOSS else "the magnitude of the impulse"
        if len(held) == 1:
            return finish(known, self._one(held[0]), self.noun, "", f"{self._law(held[0])} {what} is")
        whole: Expression = ZERO
        for number, struck in enumerate(held, start=1):
            formula = self._one(struck)
            step, name = known.book.open("sum"), known.book.fresh(self.noun.base, str(number))
            law = f"{self._law(struck)} {what} in {struck.told}" if number == 1 else f"In {struck.told} it"
            step.say(f"{law} is {step.result(name, formula, self.noun.unit, law=True)}.")
            step.close()
            whole = added(whole, name)
        return finish(known, whole, self.noun, "", f"{what} in all is")

    def _law(self, struck: Struck) -> str:
        return struck.loses if self.noun is LOSS else struck.pushes

    def _one(self, struck: Struck) -> Expression:
        return struck.lost if self.noun is LOSS else struck.push


GOALS.add("energy lost in a collision", CollisionGoal(LOSS, "pair", several=False))
GOALS.add("energy lost in collisions", CollisionGoal(LOSS, "whole", several=True))
GOALS.add("impulse of a collision", CollisionGoal(IMPULSES, "pair", several=False))
GOALS.add("impulse of an impact", CollisionGoal(IMPULSES, "body", several=False))
GOALS.add("total impulse of impacts", CollisionGoal(IMPULSES, "body", several=True))

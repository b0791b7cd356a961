"""The distance of two bodies."""

from collections.abc import Sequence
from dataclasses import dataclass

from sim2reason.questions import Target
from sim2reason.simulation.quantities.subjects.pairs import members
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.goals import GOALS, Components, Goal, Known, VectorName, finish, magnitude


@dataclass(frozen=True, slots=True)
class DistanceGoal(Goal):
    """The size of the difference of two places."""

    @property
    def uses(self) -> str:
        """Displacements."""
        return "s"

    def bodies(self, target: Target) -> Sequence[str]:
        """Both."""
        return members(target.subject)

    def write(self, target: Target, known: Known) -> Symbol:
        """Return how far apart they were, and how far each has come since."""
        one, other = members(target.subject)
        apart, a, b = known.apart(one, other), known.vector("s", one), known.vector("s", other)
        parts: Components = (apart[0] + b[0] - a[0], apart[1] + b[1] - a[1], apart[2] + b[2] - a[2])
        noun = VectorName.of("distance", "position")
        formula = magnitude(parts, known, noun, other, relative_to=known.setting.called(one))
        return finish(known, formula, noun, r"\text{rel}", "so the distance is")


GOALS.add("distance", DistanceGoal())

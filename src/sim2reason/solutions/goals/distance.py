"""Distance between two bodies."""

from collections.abc import Sequence
from dataclasses import dataclass

from sim2reason.questions import Target
from sim2reason.simulation.quantities.subjects.interactions import members
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.goals import GOALS, Components, Goal, KnownMotion, VectorName, magnitude, write_answer


@dataclass(frozen=True, slots=True)
class DistanceGoal(Goal):
    """The distance between two bodies."""

    @property
    def uses(self) -> str:
        """Return ``s``: the distance is derived from displacements."""
        return "s"

    def bodies(self, target: Target) -> Sequence[str]:
        """Return the two bodies of the subject."""
        return members(target.subject)

    def write(self, target: Target, known: KnownMotion) -> Symbol:
        """Write the initial separation and the displacements since, then the distance."""
        one, other = members(target.subject)
        apart, a, b = known.apart(one, other), known.vector("s", one), known.vector("s", other)
        parts: Components = (apart[0] + b[0] - a[0], apart[1] + b[1] - a[1], apart[2] + b[2] - a[2])
        noun = VectorName.of("distance", "position")
        formula = magnitude(parts, known, noun, other, relative_to=known.setting.display_name(one))
        return write_answer(known, formula, noun, r"\text{rel}", "so the distance is")


GOALS.add("distance", DistanceGoal())

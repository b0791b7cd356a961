"""Distance and relative speed of two bodies."""

from collections.abc import Sequence
from dataclasses import dataclass

from sim2reason.quantities.subjects.pairs import members
from sim2reason.questions import Target
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.goals import GOALS, Components, Goal, Known, VectorName, finish, magnitude
from sim2reason.solutions.goals.kinematics import VELOCITIES


@dataclass(frozen=True, slots=True)
class RelativeSpeedGoal(Goal):
    """The size of the difference of two velocities."""

    @property
    def uses(self) -> str:
        """Velocities."""
        return "v"

    def bodies(self, target: Target) -> Sequence[str]:
        """Both."""
        return members(target.subject)

    def write(self, target: Target, known: Known) -> Symbol:
        """Their difference, component by component."""
        one, other = members(target.subject)
        a, b = known.vector("v", one), known.vector("v", other)
        parts: Components = (b[0] - a[0], b[1] - a[1], b[2] - a[2])
        noun, apart = VectorName.of("relative speed", "velocity"), known.setting.called(one)
        formula = magnitude(parts, known, noun, other, relative_to=apart)
        return finish(known, formula, VELOCITIES, r"\text{rel}", "so the relative speed is")


GOALS.add("relative speed", RelativeSpeedGoal())

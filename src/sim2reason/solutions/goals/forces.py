"""Tensions, normal forces and friction forces, which Newton's laws give directly."""

from collections.abc import Sequence
from dataclasses import dataclass

from sim2reason.questions import Target
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.goals import GOALS, Goal, KnownMotion
from sim2reason.solutions.setting import ProblemContext


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

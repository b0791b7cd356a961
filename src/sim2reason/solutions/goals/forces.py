"""Tensions, normal forces and frictions: Newton's laws give them at once."""

from collections.abc import Sequence
from dataclasses import dataclass

from sim2reason.questions import Target
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.goals import GOALS, Goal, Known
from sim2reason.solutions.setting import Setting


@dataclass(frozen=True, slots=True)
class ForceGoal(Goal):
    """A force of a line or a face, by its letter."""

    kind: str

    @property
    def uses(self) -> str:
        """Nothing."""
        return ""

    def bodies(self, target: Target) -> Sequence[str]:
        """Return None by themselves."""
        del target
        return ()

    def force(self, target: Target, setting: Setting) -> str:
        """Return its number among lines or faces."""
        if self.kind == "T":
            names = [line.name for line in setting.mechanism.constraints]
        else:
            names = [face.subject for face in setting.mechanism.faces]
        return f"{self.kind}{names.index(target.subject)}" if target.subject in names else ""

    def write(self, target: Target, known: Known) -> Symbol:
        """It is known by then."""
        return known.force(self.kind, target.subject)


GOALS.add("tension", ForceGoal("T"))
GOALS.add("normal force", ForceGoal("N"))
GOALS.add("friction force", ForceGoal("f"))

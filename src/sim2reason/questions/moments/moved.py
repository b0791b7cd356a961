"""The instant at which a body has moved a stated distance along a straight line."""

from dataclasses import dataclass

import numpy as np

from sim2reason.quantities.kinematics import Velocity
from sim2reason.quantities.subjects.paths import center_path, rides
from sim2reason.questions.crossing import first_crossing
from sim2reason.questions.moments import MOMENTS, Clause
from sim2reason.questions.moments.parts.distance import DistanceThreshold
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace


@MOMENTS.register("moved")
@dataclass(frozen=True, slots=True)
class Moved(DistanceThreshold):
    """When a body has moved a stated distance along a straight line, without turning back."""

    label = "moved"
    verb = Verb("has moved", "moved", "has")

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Bodies that move along one line and ride on nothing."""
        mechanism = words.mechanism
        called = words.called(cls.of).items()
        return {n: said for n, said in called if center_path(mechanism, n).straight and not rides(mechanism, n)}

    def time(self, trace: Trace) -> float | None:
        """When it is so far away, if it has not turned back before."""
        found = first_crossing(trace, self.excess)
        return found if found is not None and not _turns_back(trace, self.name, found) else None

    def phrases(self, words: Words) -> tuple[str, ...]:
        """As in: after the block has moved 0.50 m."""
        moved = f"{self.subject(words)} has moved {self.said(words)}"
        return (f"after {moved}", f"when {moved}", f"at the moment when {moved}")

    def clause(self, words: Words) -> Clause | None:
        """As in: the block has moved 0.50 m."""
        said = self.said(words)
        return Clause(self.subject(words), "has", f"moved {said}", f"has moved {said}", f"to move {said}")


def _turns_back(trace: Trace, name: str, until: float) -> bool:
    """Whether a body that moves along a line reverses before a time."""
    way = np.array(center_path(trace.mechanism, name).ways[0])
    speeds = (Velocity.evaluate(trace.scan, name) @ way)[trace.scan.times <= until]
    return bool(speeds.min(initial=0.0) * speeds.max(initial=0.0) < -1e-9 * float(np.abs(speeds).max(initial=0.0)) ** 2)

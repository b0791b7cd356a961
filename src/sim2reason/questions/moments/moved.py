"""The instant at which a body has moved a stated distance along a straight line, or is first so far from its start."""

from dataclasses import dataclass, replace
from typing import Self

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
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
    """When a body has moved a stated distance along a straight line, without turning back.

    What collides may have turned back in a collision; and symbols do not say whether what may turn back does so before.
    Then it is spoken of by its distance from where it started.
    """

    returned: bool = False  # whether it may have turned back

    label = "moved"
    verb = Verb("has moved", "moved", "has")

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Bodies that move along one line and ride on nothing."""
        mechanism = words.mechanism
        called = words.called(cls.of).items()
        return {n: said for n, said in called if center_path(mechanism, n).straight and not rides(mechanism, n)}

    def time(self, trace: Trace) -> float | None:
        """When it is first so far away; if it has not turned back before, unless it may, or collides."""
        found = first_crossing(trace, self.excess)
        if found is None or self.returned or _collides(trace.mechanism, self.name):
            return found
        return None if _turns_back(trace, self.name, found) else found

    def in_symbols(self) -> Self:
        """Also after it has turned back."""
        return replace(self, returned=True)

    def _may_return(self, words: Words) -> bool:
        """Whether the way that it has gone may be longer than the distance, as far as a text tells."""
        return _collides(words.mechanism, self.name) or (words.symbolic and words.turns_back)

    def phrases(self, words: Words) -> tuple[str, ...]:
        """As in: after the block has moved 0.50 m, when the cart is first 0.50 m from its starting point."""
        if self._may_return(words):
            there = f"{self.subject(words)} is first {self.said(words)} from its starting point"
            return (f"when {there}", f"at the moment when {there}", f"at the instant at which {there}")
        moved = f"{self.subject(words)} has moved {self.said(words)}"
        return (f"after {moved}", f"when {moved}", f"at the moment when {moved}")

    def clause(self, words: Words) -> Clause | None:
        """As in: the block has moved 0.50 m."""
        said = self.said(words)
        if self._may_return(words):
            there = f"first {said} from its starting point"
            return Clause(self.subject(words), "is", there, f"is {there}")
        return Clause(self.subject(words), "has", f"moved {said}", f"has moved {said}", f"to move {said}")


def _collides(mechanism: Mechanism, name: str) -> bool:
    """Whether a body may meet another one, or what is fixed."""
    return any(name in meeting.names for meeting in mechanism.meetings)


def _turns_back(trace: Trace, name: str, until: float) -> bool:
    """Whether a body that moves along a line reverses before a time."""
    way = np.array(center_path(trace.mechanism, name).ways[0])
    speeds = (Velocity.evaluate(trace.scan, name) @ way)[trace.scan.times <= until]
    return bool(speeds.min(initial=0.0) * speeds.max(initial=0.0) < -1e-9 * float(np.abs(speeds).max(initial=0.0)) ** 2)

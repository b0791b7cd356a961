"""When a motion has come round: the body and all that carries it are where they were, and move as they did."""

from dataclasses import dataclass
from itertools import islice
from math import pi

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.quantities.subjects.paths import center_path, chain
from sim2reason.questions.choices import apart, at
from sim2reason.questions.crossing import crossings
from sim2reason.simulation.trace import Trace

SAME = 1e-5  # of the greatest excursion and of the greatest speed
MOST = 12  # instants that are tried


@dataclass(frozen=True, slots=True)
class Repetition:
    """The first time that a body moves as it did at the start, where it was then; turned right round is turned back."""

    name: str

    def time(self, trace: Trace) -> float | None:
        """When that is, s; None if it does not happen while the motion is described, or at an event."""
        mechanism = trace.mechanism
        names = [c.name for body in chain(mechanism, self.name) for c in body.coordinates]
        numbers = [mechanism.number[name] for name in names]
        hinges = np.array([mechanism.coordinates[number].kind == "hinge" for number in numbers], dtype=np.bool_)
        speeds = np.array([mechanism.coordinates[number].speed for number in numbers])
        moves = bool(speeds.any())
        way = speeds if moves else at(trace, 0.0).a[0, numbers]
        if not numbers or not way.any():
            return None

        def excess(state: State) -> Array:
            """How far it has gone the way that it went at first, or how fast it goes it."""
            q, v = state.q[:, numbers], state.v[:, numbers]
            return (np.where(hinges, np.sin(q), q) if moves else v) @ way

        scan = trace.scan
        far = float(np.abs(scan.q[:, numbers]).max())
        fast = float(np.abs(scan.v[:, numbers]).max())
        for time in islice(crossings(trace, excess), MOST):
            state = at(trace, time)
            gone = state.q[0, numbers]
            gone = np.where(hinges, np.remainder(gone + pi, 2.0 * pi) - pi, gone)
            changed = state.v[0, numbers] - speeds
            if float(np.abs(gone).max()) <= SAME * far and float(np.abs(changed).max()) <= SAME * fast:
                return time if apart(time, trace) else None
        return None


def attracted_by(mechanism: Mechanism, name: str) -> str:
    """The fixed body about which another one goes, drawn by it; empty if there is none."""
    for pull in mechanism.attractions:
        for one, other in ((pull.a, pull.b), (pull.b, pull.a)):
            if one == name and not center_path(mechanism, other).ways:
                return other
    return ""

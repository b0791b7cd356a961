"""A motion to and fro between the places where it turns back."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from sim2reason.simulation.trace import Trace
from sim2reason.solutions.algebra.expressions import Expression
from sim2reason.solutions.algebra.functions import summed
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.goals import Stretch
from sim2reason.solutions.oscillations.linear_way import LinearWay
from sim2reason.solutions.writing.steps import UnsolvedError

EARLY = 1e-6  # of the stretch: what turns back at its end does not count
SCAN = 2001


def turning_times(trace: Trace, coordinate: int, until: float) -> list[float]:
    """Return when a coordinate turns back before a time, s, by the engine."""
    times = np.linspace(0.0, until, SCAN)
    speeds = trace.sample(times).v[:, coordinate]
    moving = np.flatnonzero(np.abs(speeds) > EARLY * float(np.abs(speeds).max()))
    times, speeds = times[moving], speeds[moving]
    found: list[float] = []
    for n in np.flatnonzero(speeds[:-1] * speeds[1:] < 0.0):
        share = speeds[n] / (speeds[n] - speeds[n + 1])
        found.append(float(times[n] + share * (times[n + 1] - times[n])))
    return found


@dataclass(frozen=True, slots=True)
class Travelled(Stretch):
    """A motion to and fro between places of a free coordinate, whatever acts on the way."""

    way: LinearWay
    places: Sequence[Expression]

    def path(self, body: str) -> Expression:
        """The sum of all ways without their signs."""
        return summed(self.paths(body))

    def paths(self, body: str) -> Sequence[Expression]:
        """Return the distance that a body travels between each two successive places."""
        own, book, found = self.way.moving([body]), self.way.book, list[Expression]()
        if len(own) != 1 or len(self.way.motion.ratios[own[0]]) != 1:
            raise UnsolvedError("its path is no line of its own")
        (part,) = self.way.motion.ratios[own[0]].values()
        for one, other in pairwise(self.places):
            apart = other - one
            length = apart if book.value(apart) >= 0.0 else -apart
            found.append(length * abs(part) if abs(part) != 1.0 else length)
        return found


class Rubbing(Travelled):
    """Swings with friction of one size."""

    def force(self, kind: str, name: str) -> Polynomial:
        """µN: its work is that along the whole path."""
        if kind != "f":
            return super().force(kind, name)
        newton = self.way.newton
        number = next(n for n, face in enumerate(self.way.mechanism.faces) if face.subject == name)
        row = newton.normal(number)
        found = (row.inertia - row.forces.without((f"N{number}",))).put({f"q{k}": NIL for k in self.way.motion.ratios})
        return newton.coefficient(number) * found

    def slipped(self, body: str) -> Polynomial:
        """The whole path."""
        return Polynomial.of(self.path(body))

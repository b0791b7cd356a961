"""The balance of momentum."""

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from sim2reason.scenes.dsl.mechanism import Mechanism, X, Y, Z
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.vectors import Vector, inner
from sim2reason.testing.checks import Check, check
from sim2reason.testing.powers import edges, integrals, intervals, momentum, movable, push
from sim2reason.testing.report import Finding
from sim2reason.testing.specimens import Specimen, Specimens

CLOSE = 1e-8  # of the largest momentum that is there or exchanged


@check
class MomentumCheck(Check):
    """Momentum grows by the impulse of what acts, and impacts between free bodies leave their sum as it is."""

    name = "momentum"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Along every way in which a body slides in the room; not where feet, engines or glue act."""
        for found in specimens.moving:
            mechanism = found.study.mechanism
            if not (mechanism.feet or mechanism.burns or any(hit.sticks for hit in mechanism.meetings)):
                yield from self._impulses(found)
                yield from self._impacts(found)

    def _impulses(self, found: Specimen) -> Iterator[Finding]:
        trace = found.study.trace
        ways = list(movable(trace.mechanism))

        def pushing(state: State) -> Array:
            return np.array([push(state, way) for way in ways])

        for start, stop in intervals(trace, found.end) if ways else ():
            pushes, sizes = integrals(trace, start, stop, pushing, _least(trace.mechanism))
            ends = trace.sample(edges(start, stop))
            for way, impulse, size in zip(ways, map(float, pushes), map(float, sizes), strict=True):
                before, after = momentum(ends, way)
                scale = max(abs(before), abs(after), size, _least(trace.mechanism))
                if np.isfinite(impulse) and abs(after - before - impulse) > CLOSE * scale:
                    gained = f"from {start:.4g} to {stop:.4g} s it grows by {after - before:.9g} kg m/s"
                    yield found.finding(
                        self.name,
                        f"the momentum of {way.body} and what it carries grows by the impulse of what acts",
                        f"{gained}, the impulse is {impulse:.9g} N s",
                        "see that each law tells truly whether it is constant, and depends on its arguments alone",
                    )
                    return

    def _impacts(self, found: Specimen) -> Iterator[Finding]:
        trace = found.study.trace
        free = free_directions(trace.mechanism)
        for (_, time), (after, _) in pairwise(intervals(trace, found.end)) if free else ():
            state = trace.sample(np.array([edges(0.0, time)[1], after]))
            for direction in free:
                ways = [c for c in movable(trace.mechanism) if abs(inner(c.axis, direction)) > 1.0 - 1e-12]
                parts = [momentum(state, way) * inner(way.axis, direction) for way in ways]
                old, new = np.sum(parts, axis=0)
                if abs(new - old) > CLOSE * max(float(np.abs(parts).max()), _least(trace.mechanism)):
                    yield found.finding(
                        self.name,
                        "an impact between free bodies leaves the sum of their momenta as it is",
                        f"at {time:.6g} s it goes from {old:.9g} to {new:.9g} kg m/s",
                        "see what meets there",
                    )
                    return


def free_directions(mechanism: Mechanism) -> list[Vector]:
    """Return the directions in which everything can move and nothing fixed can push or pull at an impact."""
    roots = [body for body in mechanism.bodies if body.parent is None]
    held = any(mechanism.site[site].body is None for line in mechanism.lines for site in line.through)
    rough = any(face.friction > 0.0 for face in mechanism.faces)
    if held or rough or any(hit.a is None for hit in mechanism.meetings):
        return []
    own = {body.name: [c for c in movable(mechanism) if c.body == body.name] for body in roots}
    return [
        axis
        for axis in (X, Y, Z)
        if all(any(abs(inner(c.axis, axis)) > 1.0 - 1e-12 for c in own[body.name]) for body in roots)
    ]


def _least(mechanism: Mechanism) -> float:
    """A momentum that is small for a mechanism: of its heaviest body, or of 1 kg, at a decimetre a second, kg m/s."""
    return 0.1 * (max((body.mass for body in mechanism.bodies if body.coordinates), default=0.0) or 1.0)

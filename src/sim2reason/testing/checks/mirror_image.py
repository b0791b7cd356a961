"""The mirror image."""

from collections.abc import Iterator

import numpy as np

from sim2reason.errors import SimulationError, UnsupportedError
from sim2reason.simulation.certify import RECORDED
from sim2reason.simulation.trace import ENGINES, Trace
from sim2reason.testing.checks import Check, check
from sim2reason.testing.mirror import mirrored
from sim2reason.testing.report import Finding
from sim2reason.testing.specimens import Specimen, Specimens

CLOSE = 1e-9  # of the largest value, or of 1 in SI units


@check
class MirrorImageCheck(Check):
    """The mirror image, left and right exchanged, moves as the mirror image does."""

    name = "mirror image"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Coordinates and their rates, while the motion is described."""
        for found in specimens.moving:
            what = self._parted(found)
            if what:
                remedy = "let laws of force depend on their arguments alone"
                yield found.finding(self.name, "the mirror image moves as the mirror image", what, remedy)

    def _parted(self, found: Specimen) -> str:
        """Return where the two motions part, in words; empty if they do not."""
        trace = found.study.trace
        try:
            image = ENGINES[RECORDED](mirrored(trace.mechanism), trace.state.times)
        except (SimulationError, UnsupportedError) as error:
            return f"it is refused: {error}"
        end = min(found.end, image.stable_until)
        if found.end - end > CLOSE * found.end:
            return f"it ends at {end:.6g} s ({image.cut}), not at {found.end:.6g} s"
        return _apart(trace, image, end)


def _apart(trace: Trace, image: Trace, end: float) -> str:
    times = trace.state.times
    clear = [abs(times - event.time) > 1e-6 * end for event in trace.events]
    within = np.logical_and.reduce([times <= end, *clear])
    for what, mine, its in (("q", trace.state.q, image.state.q), ("its rate", trace.state.v, image.state.v)):
        for number, coordinate in enumerate(trace.mechanism.coordinates):
            one, other = mine[within, number], its[within, number]
            gap = np.abs(one - other)
            if gap.max(initial=0.0) > CLOSE * max(1.0, float(np.abs(one).max(initial=0.0))):
                worst = int(gap.argmax())
                where = f"{what} of {coordinate.name} at {times[within][worst]:.4g} s"
                return f"{where}: {other[worst]:.9g} in place of {one[worst]:.9g}"
    return ""

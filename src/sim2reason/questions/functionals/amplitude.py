"""How far a body on a straight line oscillates to each side."""

import numpy as np

from sim2reason.quantities.kinematics import Displacement
from sim2reason.quantities.subjects.paths import center_path
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace


@functional
class OscillationAmplitude(Extreme):
    """Half the distance between the two ends of the path of a body on a straight line; asked for by people alone."""

    name = "amplitude"
    quantity = Displacement
    phrase = "the amplitude of the motion of {body}"
    weight = 0.0

    def present(self, words: Words, name: str) -> bool:
        """On a straight line."""
        return center_path(words.mechanism, name).straight

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Half the range of the places along the line, m; None where the body does not turn back at both ends."""
        scan = trace.scan
        way = np.array(center_path(scan.mechanism, name).ways[0])
        ends = [event.time for event in trace.events if event.kind == "turn" and event.time <= end]
        places = Displacement.evaluate(scan, name)[scan.times <= end] @ way
        turned = [float(Displacement.evaluate(trace.at(time), name)[0] @ way) for time in ends]
        return 0.5 * float(np.ptp([*places, *turned])) if len(places) > 1 else None

    def loose_value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return the same."""
        return self.value(trace, name, end)

"""The amplitude of an oscillation along a straight line."""

import numpy as np

from sim2reason.quantities.kinematics import Displacement, Velocity
from sim2reason.quantities.subjects.paths import center_path
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace

STILL = 1e-6  # relative: a slower body is at rest


@functional
class OscillationAmplitude(Extreme):
    """Half the distance, in m, between the ends of the path of a body on a straight line; never drawn by recipes."""

    name = "amplitude"
    quantity = Displacement
    phrase = "the amplitude of the motion of {body}"
    drawn_by_recipes = False

    def present(self, words: Words, name: str) -> bool:
        """Return whether the body moves along a straight line."""
        return center_path(words.mechanism, name).straight

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return half the distance between the ends of the path, m; None unless the body is at rest at both ends."""
        way = np.array(center_path(trace.mechanism, name).ways[0])
        turns = [event.time for event in trace.events if event.kind == "turn" and event.time <= end]
        at_turns, within = trace.sample(np.array([0.0, *turns, end])), trace.scan.times <= end
        moving, turning = (np.abs(Velocity.evaluate(state, name) @ way) for state in (trace.scan, at_turns))
        places, ends = (Displacement.evaluate(state, name) @ way for state in (trace.scan, at_turns))
        rests = ends[turning <= STILL * moving[within].max()]
        places = places[within]
        found = float(np.ptp(rests)) if len(rests) else 0.0
        return 0.5 * found if found > 0.0 and found >= (1.0 - STILL) * float(np.ptp(places)) else None

    def loose_value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return the value itself: a reader takes nothing else for it."""
        return self.value(trace, name, end)

"""How far a body travels in all, to and fro."""

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.quantities.kinematics import Displacement, Velocity
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.paths import center_path
from sim2reason.questions.crossing import crossings
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.circles import circles, is_told_by_angles, leaves_circle
from sim2reason.questions.functionals.parts.integral import Integral
from sim2reason.questions.moments import Moment
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace

DIFFERS = 0.02  # of the path: what is less longer than the way as the crow flies is not worth asking


@functional
class DistanceTravelled(Integral):
    """The length of the path of a body along a line, or on a circle."""

    name, unit, least = "distance travelled", "m", 1e-3
    of, center = Bodies(), True
    phrase = "the total distance that {body} travels{ground}"
    how = "how far does {body} travel in all{ground} {when}?"
    indirect = "how far {body} travels in all{ground}"
    weight = 2.0

    def rate(self, state: State, name: str) -> Array:
        """The speed, (n,)."""
        return np.linalg.norm(Velocity.evaluate(state, name), axis=1)

    def corners(self, trace: Trace, name: str) -> list[float]:
        """Where a body on a line turns back; on a circle a coordinate does, and the engine says when."""
        path = center_path(trace.mechanism, name)
        if not path.straight:
            return []
        way = np.array(path.ways[0])
        senses = (way, -way)
        return [
            time for sense in senses for time in crossings(trace, lambda s, x=sense: Velocity.evaluate(s, name) @ x)
        ]

    def present(self, words: Words, name: str) -> bool:
        """What moves along a line or on a circle."""
        return center_path(words.mechanism, name).straight or circles(words.mechanism, name)

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """On a circle not where geometry alone gives the arc."""
        told = circles(words.mechanism, name) and is_told_by_angles(moment, words)
        return () if told else super().when(moment, words, name)

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Its velocity, and where that leads."""
        del mechanism
        return (Channel(name, Velocity.name), Channel(name, Displacement.name))

    def worth(self, study: Study, name: str, end: float) -> bool:
        """Whether it is longer than the displacement, which is asked for otherwise, and on one circle if on any."""
        if circles(study.mechanism, name) and leaves_circle(study.trace, end):
            return False
        path = self.value(study.trace, name, end) or 0.0
        direct = float(np.linalg.norm(Displacement.evaluate(study.trace.at(end), name)[0]))
        return path - direct > DIFFERS * path and super().worth(study, name, end)

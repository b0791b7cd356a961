"""The impulse of all forces on a body."""

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.quantities.momentum import Momentum
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.paths import is_welded_part
from sim2reason.questions.choices import only_falls
from sim2reason.questions.functionals import Functional, functional
from sim2reason.questions.functionals.parts.jump import is_smooth
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace

DIFFERS = 0.02  # of the momentum at the end: what differs by less is that momentum


@functional
class NetImpulse(Functional):
    """The size of the impulse of the net force: by how much the momentum changes, as a vector."""

    name, unit, kind, least = "impulse of the net force", "N s", "sum", 1e-3
    of, needs, center = Bodies(), ("mass",), False
    phrase = "the magnitude of the impulse of the net force on {body}"
    weight = 0.02

    def present(self, words: Words, name: str) -> bool:
        """Return whether a body has constant mass and is not part of a larger rigid body."""
        mechanism = words.mechanism
        return all(burn.body != name for burn in mechanism.burns) and not is_welded_part(mechanism, name)

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """|p − p₀|."""
        return float(np.linalg.norm(_momentum(trace, name, end) - _momentum(trace, name, 0.0)))

    def worth(self, study: Study, name: str, end: float) -> bool:
        """Whether it is not the momentum at the end, or at the start, nor a weight times a time."""
        if only_falls(study.mechanism) and is_smooth(study.trace, end):
            return False
        change = self.value(study.trace, name, end) or 0.0
        sizes = [float(np.linalg.norm(_momentum(study.trace, name, time))) for time in (0.0, end)]
        return all(abs(change - size) > DIFFERS * size for size in sizes)

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Its momentum."""
        del mechanism
        return (Channel(name, Momentum.name),)


def _momentum(trace: Trace, name: str, time: float) -> np.ndarray:
    return Momentum.evaluate(trace.at(time), name)[0]

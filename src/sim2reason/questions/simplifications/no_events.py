"""What happens on the way is overlooked."""

from collections.abc import Iterable

import numpy as np

from sim2reason.dsl.constancy import changing
from sim2reason.dsl.state import Array, Dynamics, State
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import OtherReading, simplification
from sim2reason.questions.simplifications.parts.asked import asked_until
from sim2reason.questions.study import Study
from sim2reason.simulation.trace import Trace, happened


@simplification
class NoEvents(OtherReading):
    """The motion is taken to go on as it begins, whatever happens on the way: stops, slips, collisions."""

    name = "no events"
    reason = "the motion is taken to go on as it begins"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where forces are constant and something happens before the moment."""
        end = asked_until(query, study)
        changes = any(event.time > 0.0 for event in happened(study.trace.events, end))
        return [""] if changes and not changing(study.mechanism) else []

    def read(self, study: Study) -> Study:
        """With the accelerations and forces of the start."""
        return Study(study.scene, _continued(study.trace))


def _continued(trace: Trace) -> Trace:
    """The motion with the accelerations and forces that it has at the start."""
    first = trace.sample(np.zeros(1))

    def sample(times: Array) -> State:
        t = times[:, None]
        repeated = np.zeros(len(times), dtype=int)
        kinematics = first.q + first.v * t + 0.5 * first.a * t * t, first.v + first.a * t
        dynamics = Dynamics(
            first.a[repeated],
            {name: values[repeated] for name, values in first.constraint_tension.items()},
            {name: values[repeated] for name, values in first.normal.items()},
            {name: values[repeated] for name, values in first.friction.items()},
        )
        return State.of(first.mechanism, times, kinematics, dynamics)

    times = trace.state.times
    end = float(times[-1])
    return Trace(trace.engine, sample(times), (), end, "", sample, lambda: np.array([0.0, end]))

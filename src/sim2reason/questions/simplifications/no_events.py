"""What happens on the way is overlooked."""

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from sim2reason.dsl.constancy import changing
from sim2reason.dsl.frames import start
from sim2reason.dsl.state import Array, State
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import Simplification, simplification
from sim2reason.questions.simplifications.parts.asked import asked_until
from sim2reason.questions.study import Study
from sim2reason.simulation.trace import Trace


@simplification
class NoEvents(Simplification):
    """The motion is taken to go on as it begins, whatever happens on the way: stops, slips, collisions."""

    name = "no events"
    reason = "the motion is taken to go on as it begins"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where forces are constant and something happens before the moment."""
        end = asked_until(query, study)
        happened = any(0.0 < event.time < end and event.kind != "turn" for event in study.trace.events)
        return [""] if happened and not changing(study.mechanism, start(study.mechanism)) else []

    def simplified(self, study: Study, subject: str, until: float) -> Study:
        """With the accelerations and forces of the start."""
        del subject, until
        return Study(study.scene, _continued(study.trace))


def _continued(trace: Trace) -> Trace:
    """The motion with the accelerations and forces that it has at the start."""
    first = trace.sample(np.zeros(1))

    def sample(times: Array) -> State:
        t = times[:, None]
        repeated = np.zeros(len(times), dtype=int)
        return replace(
            first,
            times=times,
            q=first.q + first.v * t + 0.5 * first.a * t * t,
            v=first.v + first.a * t,
            a=first.a[repeated],
            constraint_tension={name: values[repeated] for name, values in first.constraint_tension.items()},
            normal={name: values[repeated] for name, values in first.normal.items()},
            friction={name: values[repeated] for name, values in first.friction.items()},
        )

    times = trace.state.times
    end = float(times[-1])
    return Trace(trace.engine, sample(times), (), end, "", sample, lambda: np.array([0.0, end]))

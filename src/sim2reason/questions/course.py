"""Which way everything has moved by the time that an answer is known."""

import numpy as np

from sim2reason.questions.study import Study

TURNING = 1e-6  # of the mean speed: what is slower turns
STILL = 1e-9  # of the largest: a coordinate that has changed by less, or begins to, has not


def ways(study: Study, time: float) -> tuple[float, ...]:
    """Return which way each coordinate has changed by a time, or begins to, and whether it turns then.

    In between, a magnitude passes through zero, or a pendulum that turns becomes one that goes over the top, and
    between them takes for ever.
    """
    start, end = study.trace.at(0.0), study.trace.at(time)
    changes = end.q[0] - start.q[0] if time else start.a[0]
    largest = np.abs(changes).max()
    turns = np.abs(end.v[0]) * time <= TURNING * largest if time else np.zeros(len(changes), dtype=bool)
    return (*np.sign(np.where(np.abs(changes) > STILL * largest, changes, 0.0)).tolist(), *turns.tolist())

"""Whether a motion comes back to where it began, so that nothing new ever happens in it."""

from math import copysign

import numpy as np

from sim2reason.dsl.fields import Magnetic, Push
from sim2reason.dsl.mechanism import Inextensible, Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.questions.choices import at
from sim2reason.questions.crossing import Excess, crossings
from sim2reason.simulation.trace import Trace

SAME = 1e-6  # of the largest value: what differs by less is the same


def is_autonomous(mechanism: Mechanism) -> bool:
    """Whether time has no part in the equations: no engine, no winch, no field that changes with time."""
    reeled = any(isinstance(line.law, Inextensible) and line.law.reel for line in mechanism.lines)
    steady = all(f.law.profile.steady for f in mechanism.forces if isinstance(f.law, Push | Magnetic))
    return steady and not reeled and not mechanism.burns


def first_return(trace: Trace) -> float | None:
    """The time, s, at which all coordinates and velocities first are what they were at the start: then all repeats.

    None if they do not return while the motion is described, or if time has a part in the equations.
    """
    if not is_autonomous(trace.mechanism) or not trace.mechanism.coordinates:
        return None
    start, scan = at(trace, 0.0), trace.scan
    places = np.abs(scan.q).max(axis=0, initial=0.0)
    speeds = np.abs(scan.v).max(axis=0, initial=0.0)
    leader = int(np.argmax(np.abs(start.v[0])))
    if not speeds[leader] > 0.0 or not np.abs(start.v[0]).max() > SAME * speeds.max():
        leader = int(np.argmax(np.abs(start.a[0])))
        excess = _back_at_rest(leader, start)
    else:
        excess = _back_at_start(leader, start)
    for time in crossings(trace, excess):
        here = at(trace, time)
        alike = np.abs(here.q[0] - start.q[0]) <= SAME * places.max()
        if alike.all() and (np.abs(here.v[0] - start.v[0]) <= SAME * speeds.max()).all():
            return time
    return None


def _back_at_start(number: int, start: State) -> Excess:
    """How far a coordinate is ahead of its start, in the direction in which it began to move."""
    way = copysign(1.0, float(start.v[0, number]))

    def ahead(state: State) -> Array:
        return way * (state.q[:, number] - start.q[0, number])

    return ahead


def _back_at_rest(number: int, start: State) -> Excess:
    """How fast a coordinate moves in the direction in which it began to: it comes back against that and stops."""
    way = copysign(1.0, float(start.a[0, number]))

    def forwards(state: State) -> Array:
        return way * state.v[:, number]

    return forwards

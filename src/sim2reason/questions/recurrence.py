"""Whether a motion comes back to where it began, so that nothing new ever happens in it."""

from math import copysign, pi

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
    start = at(trace, 0.0)
    spans = np.abs(trace.scan.q).max(axis=0), np.abs(trace.scan.v).max(axis=0)
    number = int(np.argmax(np.abs(start.v[0])))
    if np.abs(start.v[0]).max() > SAME * spans[1].max():
        ways = [_back_at_start(number, start, turn) for turn in _turns(trace.mechanism, number)]
    else:
        ways = [_back_at_rest(int(np.argmax(np.abs(start.a[0]))), start)]
    times = sorted(time for excess in ways for time in crossings(trace, excess))
    return next((time for time in times if _alike(at(trace, time), start, spans)), None)


def _alike(here: State, start: State, spans: tuple[Array, Array]) -> bool:
    """Whether an instant has the places and velocities of the start, whole turns aside."""
    apart = here.q[0] - start.q[0]
    for number, coordinate in enumerate(here.mechanism.coordinates):
        turn = _turns(here.mechanism, number)[-1]
        if turn and coordinate.kind == "hinge":
            apart[number] -= turn * round(apart[number] / turn)
    return bool((np.abs(apart) <= SAME * spans[0].max()).all()) and bool(
        (np.abs(here.v[0] - start.v[0]) <= SAME * spans[1].max()).all()
    )


def _turns(mechanism: Mechanism, number: int) -> tuple[float, ...]:
    """After what angles, rad, a coordinate is where it was; a hinge after a whole turn, unless a line is wound up."""
    winds = any(line.wheels for line in mechanism.lines)
    return (0.0, 2.0 * pi) if mechanism.coordinates[number].kind == "hinge" and not winds else (0.0,)


def _back_at_start(number: int, start: State, turn: float) -> Excess:
    """How far a coordinate is ahead of its start, and of a turn from there, in the direction in which it began."""
    way = copysign(1.0, float(start.v[0, number]))

    def ahead(state: State) -> Array:
        return way * (state.q[:, number] - start.q[0, number]) - turn

    return ahead


def _back_at_rest(number: int, start: State) -> Excess:
    """How fast a coordinate moves in the direction in which it began to: it comes back against that and stops."""
    way = copysign(1.0, float(start.a[0, number]))

    def forwards(state: State) -> Array:
        return way * state.v[:, number]

    return forwards

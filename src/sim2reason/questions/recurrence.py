"""Whether a motion, of all or of one body, comes back to where it began, so that nothing new happens afterwards."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import islice
from math import pi

import numpy as np

from sim2reason.dsl.fields import Magnetic, Push
from sim2reason.dsl.mechanism import Inextensible, Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.quantities.subjects.paths import chain
from sim2reason.questions.choices import apart, at
from sim2reason.questions.crossing import crossings
from sim2reason.simulation.trace import Trace

SAME, ERRS = 1e-6, 100.0  # of the greatest excursion and speed, or times what a step errs by: less is no difference
MOST = 12  # instants that are tried


@dataclass(frozen=True, slots=True)
class Repetition:
    """The first time that a body, and all that carries it, is where it was at the start and moves as it did then."""

    name: str

    def time(self, trace: Trace) -> float | None:
        """When that is, s; None if it does not happen while the motion is described, or at an event."""
        mechanism = trace.mechanism
        names = [c.name for body in chain(mechanism, self.name) for c in body.coordinates]
        time = _first_return(trace, [mechanism.number[name] for name in names])
        return time if time is not None and apart(time, trace) else None


def is_autonomous(mechanism: Mechanism) -> bool:
    """Whether time has no part in the equations: no engine, no winch, no field that changes with time."""
    reeled = any(isinstance(line.law, Inextensible) and line.law.reel for line in mechanism.lines)
    steady = all(f.law.profile.steady for f in mechanism.forces if isinstance(f.law, Push | Magnetic))
    return steady and not reeled and not mechanism.burns


def first_return(trace: Trace) -> float | None:
    """The time, s, at which all coordinates and velocities first are what they were at the start: then all repeats.

    None if they do not return while the motion is described, or if time has a part in the equations.
    """
    mechanism = trace.mechanism
    return _first_return(trace, range(len(mechanism.coordinates))) if is_autonomous(mechanism) else None


def _first_return(trace: Trace, numbers: Sequence[int]) -> float | None:
    """When some coordinates and their velocities are what they were, whole turns of hinges aside.

    Then a sum of the coordinates that grows at the start, or of the velocities of what begins at rest, does so again.
    """
    mechanism, start, number = trace.mechanism, at(trace, 0.0), list(numbers)
    hinges = np.array([mechanism.coordinates[n].kind == "hinge" for n in number], dtype=np.bool_)
    far, fast = (float(np.abs(held[:, number]).max(initial=0.0)) for held in (trace.scan.q, trace.scan.v))
    speeds = start.v[0, number]
    moves = bool((np.abs(speeds) > SAME * fast).any())
    way = speeds if moves else start.a[0, number]
    if not way.any():
        return None
    turned = hinges & (not any(line.wheels for line in mechanism.lines))  # unless a line is wound up

    def gone(state: State) -> Array:
        """How far from the start."""
        return state.q[:, number] - start.q[0, number]

    def excess(state: State) -> Array:
        """How far it has gone the way that it went at first, or how fast it goes it."""
        return (np.where(turned, np.sin(gone(state)), gone(state)) if moves else state.v[:, number]) @ way

    def alike(here: State) -> bool:
        off = np.where(turned, np.remainder(gone(here) + pi, 2.0 * pi) - pi, gone(here))
        changed = here.v[:, number] - speeds
        same = max(SAME, ERRS * trace.tolerance)
        return float(np.abs(off).max()) <= same * far and float(np.abs(changed).max()) <= same * fast

    return next((time for time in islice(crossings(trace, excess), MOST) if alike(at(trace, time))), None)

"""The recorded steps of MuJoCo, and interpolation between them."""

from dataclasses import dataclass, field

import numpy as np

from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array, Dynamics, State


@dataclass
class Recorder:
    """The recorded states; at an event there are two at one time, just before and just after."""

    mechanism: Mechanism
    times: list[float] = field(default_factory=list[float])
    motion: list[Array] = field(default_factory=list[Array])  # concatenated q, v and a, (3n,)
    forces: list[Array] = field(default_factory=list[Array])  # concatenated tension, normal force and friction

    def add(self, time: float, motion: Array, forces: Array) -> None:
        """Append the state at the end of a step."""
        self.times.append(time)
        self.motion.append(motion)
        self.forces.append(forces)

    def state(self, times: Array) -> State:
        """Return the motion at `times`, s, by cubic Hermite interpolation; the last interval is extrapolated."""
        knots, motion = np.array(self.times), np.array(self.motion)
        first = np.maximum(np.searchsorted(knots, times, side="right") - 1, 0)
        last = np.minimum(first + 1, len(knots) - 1)
        n = len(self.mechanism.coordinates)
        q, v, a = _between(motion[first], motion[last], knots[first], knots[last], times, n)
        forces = np.array(self.forces)[first].T
        k, c = len(self.mechanism.strings), len(self.mechanism.contacts)
        tension = {string.name: forces[i] for i, string in enumerate(self.mechanism.strings)}
        names = list(self.mechanism.contacts)
        normal = dict(zip(names, forces[k : k + c], strict=True))
        friction = dict(zip(names, forces[k + c :], strict=True))
        return State.of(self.mechanism, times, (q, v), Dynamics(a, tension, normal, friction))


def _between(first: Array, last: Array, start: Array, stop: Array, times: Array, n: int) -> tuple[Array, Array, Array]:
    """Return q, v and a, interpolated between the values at both ends of a step."""
    span, since = (stop - start)[:, None], (times - start)[:, None]
    inside = span > 0.0
    h = np.where(inside, span, 1.0)
    q0, v0, a0 = first[:, :n], first[:, n : 2 * n], first[:, 2 * n :]
    q1, v1, a1 = last[:, :n], last[:, n : 2 * n], last[:, 2 * n :]
    mean = (q1 - q0) / h
    bend = np.where(inside, (3.0 * mean - 2.0 * v0 - v1) / h, 0.5 * a0)
    twist = np.where(inside, (v0 + v1 - 2.0 * mean) / h**2, 0.0)
    q = q0 + since * (v0 + since * (bend + since * twist))
    v = v0 + since * (2.0 * bend + 3.0 * since * twist)
    return q, v, np.where(inside, a0 + since / h * (a1 - a0), a0)

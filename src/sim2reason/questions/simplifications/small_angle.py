"""A swing is taken to be as harmonic as a small one."""

from collections.abc import Iterable

import numpy as np

from sim2reason.dsl.constancy import changing
from sim2reason.dsl.mobility import weighs
from sim2reason.dsl.state import Array, Dynamics, State
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import OtherReading, simplification
from sim2reason.questions.study import Study
from sim2reason.simulation.rest.equilibrium import Rest, equilibrium
from sim2reason.simulation.rest.oscillation import Oscillations, oscillations
from sim2reason.simulation.trace import Trace

FITS = 1e-3  # of the largest displacement: what the modes leave of how a motion starts


@simplification
class SmallAngle(OtherReading):
    """A swing is taken to be harmonic about its equilibrium, however wide it is."""

    name = "small angle"
    common = True
    reason = "the angle is taken as small"
    sound_if_same = True  # then it is small

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where weight drives a motion whose equations change."""
        del query
        mechanism = study.mechanism
        return [""] if weighs(mechanism) and changing(mechanism) else []

    def read(self, study: Study) -> Study | None:
        """The motion in normal modes; None where there are none, or where it is harmonic anyway."""
        rest = equilibrium(study.mechanism)
        if rest is None or rest.linear:
            return None
        modes = oscillations(rest)
        trace = _harmonic(study.trace, rest, modes) if modes is not None else None
        return Study(study.scene, trace) if trace is not None else None


def _harmonic(trace: Trace, rest: Rest, modes: Oscillations) -> Trace | None:
    """Q = q₀ + Σ s (a cos ωt + b sin ωt) with the place and the speeds of the start; forces are not known."""
    first = trace.sample(np.zeros(1))
    gone, speeds = first.q[0] - rest.coordinates, first.v[0]
    omega, shapes = modes.frequencies, modes.shapes
    inverse = np.asarray(np.linalg.pinv(shapes), dtype=np.float64)
    a, b = inverse @ gone, inverse @ speeds
    if max(np.abs(shapes @ a - gone).max(), np.abs(shapes @ b - speeds).max()) > FITS * max(np.abs(gone).max(), FITS):
        return None

    def sample(times: Array) -> State:
        c, s = np.cos(np.outer(times, omega)), np.sin(np.outer(times, omega))
        unknown = np.full(len(times), np.nan)
        q, v = rest.coordinates + (c * a + s * (b / omega)) @ shapes.T, (c * b - s * (a * omega)) @ shapes.T
        dynamics = Dynamics(
            -((c * a + s * (b / omega)) * omega**2) @ shapes.T,
            dict.fromkeys(first.constraint_tension, unknown),
            dict.fromkeys(first.normal, unknown),
            dict.fromkeys(first.friction, unknown),
        )
        return State.of(first.mechanism, times, (q, v), dynamics)

    end = float(trace.state.times[-1])
    return Trace(trace.engine, sample(trace.state.times), (), end, "", sample, lambda: np.linspace(0.0, end, 33))

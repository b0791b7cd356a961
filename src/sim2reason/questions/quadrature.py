"""Integrals over a motion, on the engine's steps and between events."""

from collections.abc import Callable, Iterable

import numpy as np
from numpy.polynomial.legendre import leggauss

from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.trace import Trace, in_order

POINTS = 6  # of Gaussian quadrature per interval: exact up to degree 11, without points at the ends
_NODES, _WEIGHTS = leggauss(POINTS)


def borders(trace: Trace, end: float) -> Array:
    """Return times, s, from 0 to `end`, between which the motion is smooth and no coordinate reverses."""
    events = [event.time for event in trace.events]
    found = in_order(np.concatenate([[0.0, end], trace.knots(), events]))
    return found[(found >= 0.0) & (found <= end)]


def integral(trace: Trace, rate: Callable[[State], Array], end: float, corners: Iterable[float] = ()) -> float:
    """Return ∫ rate dt from 0 to `end`, s, by Gaussian quadrature; NaN if the rate, (n,), is NaN anywhere."""
    limits = borders(trace, end)
    inner = [time for time in corners if 0.0 < time < end]
    if inner:
        limits = in_order(np.append(limits, inner))
    if len(limits) < 2:
        return 0.0
    widths = np.diff(limits)
    times = limits[:-1, None] + widths[:, None] * (0.5 + 0.5 * _NODES)
    values = rate(trace.sample(times.ravel())).reshape(times.shape)
    return float((values @ (0.5 * _WEIGHTS)) @ widths)

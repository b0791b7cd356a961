"""Integrals over a motion, on the engine's own steps and between events."""

from collections.abc import Callable, Iterable

import numpy as np
from numpy.polynomial.legendre import leggauss

from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.trace import Trace, in_order

POINTS = 6  # of Gauss's rule in each piece: exact for polynomials to the 11th degree, and no end of a piece is one
_NODES, _WEIGHTS = leggauss(POINTS)


def borders(trace: Trace, end: float) -> Array:
    """Instants, s, from 0 to `end`, between which the motion is one smooth piece and no coordinate turns back."""
    events = [event.time for event in trace.events]
    found = in_order(np.concatenate([[0.0, end], trace.knots(), events]))
    return found[(found >= 0.0) & (found <= end)]


def integral(trace: Trace, rate: Callable[[State], Array], end: float, corners: Iterable[float] = ()) -> float:
    """∫ rate dt from 0 to `end`, s; NaN where the rate, (n,), is. Jumps do no harm between pieces, nor at `corners`."""
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

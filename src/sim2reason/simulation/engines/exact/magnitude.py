"""Estimate of the size of small motions, for which the integrator's usual absolute tolerance is too coarse."""

from math import sqrt

from sim2reason.simulation.engines.exact.dop853 import Rate, Values

SMALL = 1e-3  # m or rad: what moves by more has size 1
NONE = 1e-12  # m or rad: what moves by less is at rest, but for rounding
STEP = 1e-8  # m or rad: of the differences that derivatives are taken by


def magnitude(rate: Rate, time: float, values: Values, first: Values) -> float:
    """Return how far what is small moves, in m or rad, as far as one instant tells; 1 if it is not small.

    Where forces depend on place, motions have a time of their own, τ = 1/√|∂a/∂q|. In this time speed and acceleration
    lead as far as v τ and a τ². For a circular orbit that is the radius, for an oscillation the amplitude.
    """
    n = len(values) // 2
    stiffest = 0.0
    for number in range(n):
        moved = list(values)
        moved[number] += STEP
        there = rate(time, tuple(moved))
        stiffest = max(stiffest, *(abs(after - now) / STEP for after, now in zip(there[n:], first[n:], strict=True)))
    if not stiffest > 0.0:
        return 1.0
    speed, acceleration = (max(map(abs, part), default=0.0) for part in (values[n:], first[n:]))
    size = max(speed / sqrt(stiffest), acceleration / stiffest)
    return size if NONE < size < SMALL else 1.0

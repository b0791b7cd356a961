"""How long a motion is followed at first."""

from collections.abc import Iterable
from math import inf, pi, sqrt

from sim2reason.dsl.entity import Entity
from sim2reason.dsl.mechanism import GRAVITY, Elastic, Mechanism

HORIZON = 2.0  # s, on Earth
MANY, FEW = 100, 40  # oscillations of the stiffest spring that engines can't follow at first, and that they can


def horizon(entities: Iterable[Entity], gravity: float) -> float:
    """As long as the slowest of some entities wants where gravity is as strong, in m/s²; in the units of their text.

    Where none wants anything, as long as something falls as far as it does on Earth in 2 s.
    """
    wanted = (entity.horizon(gravity) for entity in entities)
    usual = HORIZON * sqrt(GRAVITY / gravity) if gravity else HORIZON
    return max((duration for duration in wanted if duration is not None), default=usual)


def within_oscillations(duration: float, mechanism: Mechanism) -> float:
    """A duration, s, or that of some oscillations if it has more of them than an engine follows with ease."""
    period = stiffest_period(mechanism)
    return duration if duration <= MANY * period else FEW * period


def stiffest_period(mechanism: Mechanism) -> float:
    """How long an oscillation takes on the stiffest spring of what is lightest at its ends, s; infinite without any."""
    shortest = inf
    for line in mechanism.lines:
        if isinstance(line.law, Elastic) and line.law.acts == "both":
            ends = line.circle or tuple(mechanism.site[site].body for site in (line.through[0], line.through[-1]))
            masses = [mechanism.body[body].mass for body in ends if body is not None]
            shortest = min([shortest, *(2.0 * pi * sqrt(mass / line.law.stiffness) for mass in masses if mass > 0.0)])
    return shortest

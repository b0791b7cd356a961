"""The default duration of a simulation."""

from collections.abc import Iterable
from math import inf, pi, sqrt

from sim2reason.scenes.dsl.entity import Entity
from sim2reason.scenes.dsl.mechanism import GRAVITY, Elastic, Mechanism

HORIZON = 2.0  # s, on Earth
MAX_OSCILLATIONS, SIMULATED_OSCILLATIONS = (
    100,
    40,
)  # oscillations of the stiffest spring: the limit for long motions, and the number simulated instead


def horizon(entities: Iterable[Entity], gravity: float) -> float:
    """Return the longest duration that any entity asks for under `gravity`, m/s², in the text's unit of time.

    If no entity asks for any, it is the time of a fall from the height from which a body falls for 2 s on Earth.
    """
    wanted = (entity.horizon(gravity) for entity in entities)
    usual = HORIZON * sqrt(GRAVITY / gravity) if gravity else HORIZON
    return max((duration for duration in wanted if duration is not None), default=usual)


def within_oscillations(duration: float, mechanism: Mechanism) -> float:
    """Return `duration`, s, or some periods of the stiffest spring if `duration` has too many for the engines."""
    period = stiffest_period(mechanism)
    return duration if duration <= MAX_OSCILLATIONS * period else SIMULATED_OSCILLATIONS * period


def stiffest_period(mechanism: Mechanism) -> float:
    """Return the shortest period of a body on a spring with its other end fixed, s; infinite without springs."""
    shortest = inf
    for line in mechanism.lines:
        if isinstance(line.law, Elastic) and line.law.acts == "both":
            ends = line.circle or tuple(mechanism.site[site].body for site in (line.through[0], line.through[-1]))
            masses = [mechanism.body[body].mass for body in ends if body is not None]
            shortest = min([shortest, *(2.0 * pi * sqrt(mass / line.law.stiffness) for mass in masses if mass > 0.0)])
    return shortest

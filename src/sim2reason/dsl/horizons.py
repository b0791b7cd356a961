"""How long a motion is followed at first."""

from collections.abc import Iterable
from math import sqrt

from sim2reason.dsl.entity import Entity
from sim2reason.dsl.mechanism import GRAVITY

HORIZON = 2.0  # s, on Earth


def horizon(entities: Iterable[Entity], gravity: float) -> float:
    """As long as the slowest of some entities wants where gravity is as strong, in m/s²; in the units of their text.

    Where none wants anything, as long as something falls as far as it does on Earth in 2 s.
    """
    wanted = (entity.horizon(gravity) for entity in entities)
    usual = HORIZON * sqrt(GRAVITY / gravity) if gravity else HORIZON
    return max((duration for duration in wanted if duration is not None), default=usual)

"""Flights between impacts, and the impacts."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.polynomials import Polynomial


@dataclass
class Leg:
    """A flight: when it begins (None at t = 0), with which rates, and where, by coordinate."""

    begins: Symbol | None
    speeds: Mapping[int, Polynomial]
    places: dict[int, Polynomial] = field(default_factory=dict[int, Polynomial])
    after: "Impact | None" = None


@dataclass(frozen=True)
class Impact:
    """A collision of the motion: its number among all, when it is, and whose."""

    number: int
    time: float  # s
    bodies: tuple[str, ...]
    meeting: int

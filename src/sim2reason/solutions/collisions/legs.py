"""Data of free flights and collisions."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.polynomials import Polynomial


@dataclass
class Flight:
    """A free flight: its start time (None for t = 0), and its initial velocities and positions by coordinate."""

    begins: Symbol | None
    speeds: Mapping[int, Polynomial]
    places: dict[int, Polynomial] = field(default_factory=dict[int, Polynomial])
    after: "Impact | None" = None


@dataclass(frozen=True)
class Impact:
    """A collision: its index in the motion, time in s and bodies, and the index of this pair in the mechanism."""

    number: int
    time: float  # s
    bodies: tuple[str, ...]
    meeting: int

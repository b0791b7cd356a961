"""What a model is asked for: rows, points, and what is switched on or off."""

from dataclasses import dataclass

from sim2reason.dsl.state import Array
from sim2reason.record import record


@record()
class Row:
    """A one-sided row (or one that acts both ways): J·q̈ ≤ target, spare ≥ 0, used up at `rate`."""

    kind: str  # string, rod, prop, foot, hold, stuck
    name: str
    gradient: Array  # (joints,)
    spare: float
    rate: float
    target: float
    follows: int = -1

    @property
    def both(self) -> bool:
        """Whether it acts both ways."""
        return self.kind in ("rod", "hold", "stuck")


@record()
class Moving:
    """A point: where it is, its velocity, its acceleration at q̈ = 0, and its Jacobian (3, joints)."""

    place: Array
    velocity: Array
    bias: Array
    jacobian: Array


@dataclass
class Situation:
    """What is switched on or off: forces in regions, engines, pairs that stick together, springs that act one way."""

    inside: list[list[bool]]
    burning: list[bool]
    stuck: list[bool]
    strained: list[bool]

    def copy(self) -> "Situation":
        """The same, to be kept."""
        inside = [list(each) for each in self.inside]
        return Situation(inside, list(self.burning), list(self.stuck), list(self.strained))

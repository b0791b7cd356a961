"""The linear complementarity problem of one instant: its known quantities and its unknowns.

For forces x is the acceleration, for impulses the velocity after the impact:

    M x + Σ λ J − Σ f S = F,   λ ≥ 0,   J x ≤ target,   λ (target − J x) = 0
    N = M_z x + Σ λ J_z − F_z              (the row of the rise z of a contact, which stays zero)
    |f| ≤ µ_s N while S x = 0, else f = −µN sign(S x)

A row J is that of a string, a prop, a foot, or two-sided: a rod, a pair that sticks together. S is the slip of a rough
contact. A mode says which rows act and which contacts stick; it makes the problem linear.
"""

from dataclasses import dataclass, field
from math import inf
from typing import NamedTuple

from sim2reason.simulation.budget import Budget
from sim2reason.simulation.engines.exact.linear import Row


@dataclass(slots=True)
class Gradient:
    """How a length changes with the coordinates, and with the rises of the contacts."""

    along: Row  # (n,)
    lift: Row  # (c,)
    terms: tuple[tuple[int, float], ...]  # the entries of `along` that are not zero

    def rate(self, values: Row) -> float:
        """The rate of change, from velocities or accelerations."""
        total = 0.0
        for number, factor in self.terms:
            total += factor * values[number]
        return total


def gradient(along: Row, lift: Row) -> Gradient:
    """A gradient with its terms."""
    return Gradient(along, lift, tuple([(number, part) for number, part in enumerate(along) if part]))


@dataclass(frozen=True, slots=True)
class RoughContact:
    """A rough contact: its number among the contacts, the gradient of its slip, and its coefficients of friction."""

    contact: int
    slip: Gradient
    friction: float
    coordinate: int = -1  # where the slip is the rate of one coordinate and nothing else
    both: bool = False  # the face holds both ways, so that a negative normal force rubs as well
    holds: float = 0.0  # the coefficient of static friction

    @property
    def never(self) -> bool:
        """Whether its friction has no bound, so that it never slips; what rounding leaves of its slip is none."""
        return self.friction == inf

    def side(self, slip: float, least: float = 0.0) -> int:
        """The side to which it slips at a speed of which `least` is still none."""
        return 0 if self.never else (slip > least) - (slip < -least)


class Mode(NamedTuple):
    """Which rows act, and how each rough contact rubs: 0 sticks, ±1 slips to that side."""

    acting: tuple[bool, ...]
    rubbing: tuple[int, ...]


@dataclass(slots=True)
class Problem:
    """One instant's loads, rows and rough contacts."""

    mass: list[Row]
    lifted: list[Row]
    force: Row
    press: Row
    rows: tuple[Gradient, ...]
    targets: Row
    grips: tuple[RoughContact, ...]
    sliding: tuple[int, ...]  # the side to which a contact slips already, which no search may change; else 0
    held: tuple[bool, ...]  # the rows that act whatever the sign of λ
    follows: tuple[int, ...]  # the row with which each row acts or not, or −1
    guided: tuple[int, ...]  # the contacts that hold both ways
    budget: Budget = field(default_factory=Budget)  # of the motion that it is an instant of
    load: float = field(init=False)  # the largest of what is given to act

    def __post_init__(self) -> None:
        """Find the largest load."""
        self.load = max(map(abs, (*self.force, *self.press)), default=0.0)


class Forces(NamedTuple):
    """The multipliers of one solution, or of one way to change it."""

    rows: Row
    friction: Row
    normal: Row


@dataclass(slots=True)
class Solution:
    """x and what acts, for one mode; `spare` are force patterns that could be added without effect."""

    mode: Mode
    x: Row
    forces: Forces
    spare: list[Forces]
    loose: bool  # a massless part that nothing holds: its x means nothing
    consistent: bool = True

"""Ends of the stages of a motion with constant accelerations."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.polynomials import Polynomial


@dataclass(frozen=True, slots=True)
class End:
    """The end of a stage: a known time, a distance moved by a coordinate, or the instant at which it comes to rest."""

    time: Symbol | None = None
    coordinate: int = -1
    distance: Polynomial | None = None  # in the sense of the coordinate; None: it comes to rest
    what: str = ""  # in words
    slip: Mapping[int, Polynomial] = field(default_factory=dict[int, Polynomial])  # whose sum of rates comes to zero
    turned: int | None = None  # the face on which the body slips the other way from then on

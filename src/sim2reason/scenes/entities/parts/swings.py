"""What entities that swing share: how far they are turned at the start, and for how long they are followed."""

from math import pi, sqrt
from typing import Annotated

from annotated_types import Ge, Le

from sim2reason.scenes.authoring import Measure, Range, placing, starting

Deflection = Annotated[float, Ge(0), Le(180), Measure("deflection", "deg", r"\theta", decimals=0), Range(10.0, 150.0)]
TILTED = "an angle of {angle} with the downward vertical"
AT_FIRST = placing("initially {start}.", "at the start {start}.", "to begin with, {start}.")
SENT_OFF = starting(
    "at t = 0 {bob} is set moving {sent} at speed {speed}.",
    "at t = 0 {bob} starts moving {sent} at speed {speed}.",
    "at t = 0 {bob} is launched {sent} with a speed of {speed}.",
    topic="start",
)
PERIODS = 1.5  # of a small swing that the motion is followed for


def swings(length: float, gravity: float) -> float | None:
    """Return how long, in s, to follow a bob that swings at a distance `length`, m, from a fixed point.

    None if `gravity`, in m/s², is zero, since nothing swings then.
    """
    return PERIODS * 2.0 * pi * sqrt(length / gravity) if gravity else None

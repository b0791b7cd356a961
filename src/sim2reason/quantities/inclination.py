"""Angles of lines that swing with the vertical."""

from math import degrees

import numpy as np

from sim2reason.dsl.frames import Frames
from sim2reason.dsl.mechanism import Inextensible, Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.dsl.triples import cross, minus, product
from sim2reason.dsl.vectors import unit
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.subjects.swinging_lines import SwingingLines, pointer

SLACK = 1e-6  # of its length: by what a string must be shorter than it may be


@quantity
class Deflection(Quantity):
    """The angle of a string or rod, or of the line from an axle to a centre of mass, with the downward vertical."""

    name, unit, symbol = "deflection", "deg", "θ"
    of = SwingingLines()
    magnitude = "the angle that {line} makes with the downward vertical"
    how = "what angle does {line} make with the downward vertical {when}?"
    given = True
    weight = 3.0
    floor, least = 1.0, 0.1
    panel, order = "angle with the vertical", 0

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """From 0 to 180 degrees, (n,); NaN while a string is slack, since it points nowhere."""
        return np.where(_slack(state, subject), np.nan, _angle(state.frames, state.mechanism, subject))


def deflection_at_start(state: State, subject: str) -> float:
    """The angle at the start of the motion, in degrees."""
    return float(_angle(state.began, state.mechanism, subject))


def _angle(frames: Frames, mechanism: Mechanism, subject: str) -> Array:
    """By the sine and the cosine, so that small angles lose no digits."""
    (top, start), (bottom, end) = pointer(mechanism, subject)
    arm = minus(frames[bottom].point(end).place, frames[top].point(start).place)
    down = unit(mechanism.gravity)
    across = cross(down, arm)
    return degrees(1.0) * np.arctan2(np.sqrt(product(across, across)), product(down, arm))


def _slack(state: State, subject: str) -> Array:
    """Whether a string is slack, (n,): shorter than it may be."""
    line = state.mechanism.line.get(subject)
    if line is None or not isinstance(line.law, Inextensible):
        return np.zeros(len(state.times), dtype=bool)
    whole = state.began.length(line) + line.law.slack - line.law.reel * state.times
    return state.length(line)[0] < whole * (1.0 - SLACK)

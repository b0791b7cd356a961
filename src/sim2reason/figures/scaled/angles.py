"""Angles at corners, with their values."""

from cmath import rect
from math import radians, tan

from sim2reason.figures.shapes import SMALL, Arc, LabelRequest, Sketch, width

ANGLE_ARC = 0.75  # units, the least radius of an arc


def corner_angle(at: complex, turn: tuple[float, float], text: str, subject: str) -> Sketch:
    """Draw an arc between two directions, given in degrees, with a label; small angles get larger arcs."""
    middle, half = rect(1.0, radians(0.5 * sum(turn))), radians(0.5 * abs(turn[1] - turn[0]))
    wide = 0.5 * width(text, SMALL)
    room = (0.5 * SMALL + 0.09) / tan(half) - 0.1  # where a text of this height fits in
    near = max(ANGLE_ARC, room)
    beyond = wide * abs(middle.real) + 0.5 * SMALL * abs(middle.imag) + 0.1
    places = tuple(at + middle * (near + beyond + 0.1 * n) for n in range(8))
    return Sketch(
        [Arc(at, near, *sorted(turn), weight="thin")], [LabelRequest(text, places, subject, SMALL, name=False)]
    )

"""Validation of initial speeds against rods, feet and perfectly rough faces.

A two-sided constraint has no jerk at the start, unlike a string: no impulse could have caused inconsistent speeds.
"""

import math
from math import inf

from sim2reason.errors import SceneError
from sim2reason.scenes.dsl.frames import Frames
from sim2reason.scenes.dsl.mechanism import Mechanism, Rigid
from sim2reason.scenes.dsl.vectors import dot

ROUNDING = 1e-9  # fraction of the largest speed, or of 1 m/s
TOUCHING = 1e-9  # m


def check_speeds(mechanism: Mechanism) -> None:
    """Raise SceneError if initial speeds change the length of a rod or make a nonslipping contact slip."""
    speeds = [float(coordinate.speed) for coordinate in mechanism.coordinates]
    never = [face for face in mechanism.faces if face.friction == inf]
    rods = [line for line in mechanism.lines if isinstance(line.law, Rigid)]
    if not any(speeds) or not (rods or never or mechanism.feet):
        return
    small = ROUNDING * max(1.0, *map(abs, speeds))
    frames = Frames(mechanism, [0.0] * len(speeds), speeds, math)
    for rod in rods:
        rate = _parting(frames, *rod.through)
        if abs(rate) > small:
            problem = f"its ends begin to part at {rate:.6g} m/s, and it is rigid"
            raise SceneError(rod.name, problem, "let both begin with the same speed along it")
    for face in never:
        slip = sum(factor * speeds[mechanism.number[name]] for name, factor in face.slip)
        if abs(slip) > small:
            problem = f"it begins to slip at {slip:.6g} m/s where it never slips"
            raise SceneError(face.subject, problem, "let it begin without slipping, or give a coefficient of friction")
    _check_feet(mechanism, frames, small)


def _parting(frames: Frames, first: str, last: str) -> float:
    try:
        return float(frames.distance(first, last).rate)
    except ZeroDivisionError:  # they coincide, which engines refuse for itself
        return 0.0


def _check_feet(mechanism: Mechanism, frames: Frames, small: float) -> None:
    for foot in mechanism.feet:
        point = frames.site(foot.site)
        stands = abs(dot(foot.normal, point.place) - foot.height) <= TOUCHING
        slip = dot(foot.along, point.velocity)
        if stands and abs(dot(foot.normal, point.velocity)) <= small < abs(slip):
            problem = f"it stands, and yet begins to slip at {slip:.6g} m/s"
            raise SceneError(foot.name, problem, "let it begin at rest")

"""The exact engine: closed forms between events, for strings, wheels, faces with friction, and collisions.

A mechanism whose mass matrix and gradients are constant moves with constant acceleration from event to
event. `equations` turns it into numbers, `balance` and `impulses` find what acts, by the one search in
`modes`, `events` tells what comes next, and `engine` goes from event to event.
"""

from sim2reason.simulation.engines.exact.engine import motion, simulate
from sim2reason.simulation.engines.exact.motion import Motion, Segment

__all__ = ["Motion", "Segment", "motion", "simulate"]

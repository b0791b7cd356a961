"""Tests for bodies that move on one circle about a fixed point."""

from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.angles import Deflected, TurnedThrough
from sim2reason.questions.moments.turning_points import LowestPoint, Stopped
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Inextensible, Mechanism
from sim2reason.simulation.quantities.subjects.paths import chain
from sim2reason.simulation.trace import Trace


def circles(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body turns about a single fixed axle, or is held by a string to a fixed point."""
    kinds = [c.kind for body in chain(mechanism, name) for c in body.coordinates]
    return kinds == ["hinge"] or _hangs(mechanism, name)


def _hangs(mechanism: Mechanism, name: str) -> bool:
    """Return whether the only line is a string from a fixed point to the body."""
    if len(mechanism.lines) != 1 or not isinstance(mechanism.lines[0].law, Inextensible):
        return False
    ends = [mechanism.site[site].body for site in mechanism.lines[0].through]
    return len(ends) == 2 and set(ends) == {None, name}


def leaves_circle(trace: Trace, end: float) -> bool:
    """Return whether a string goes slack before a time, s, so that its body leaves the circle."""
    return any(event.kind == "slack" and event.time <= end for event in trace.events)


def is_given_by_geometry(moment: Moment, words: Words) -> bool:
    """Return whether geometry alone gives a body's position on its circle at a moment, as at the end of a swing."""
    known = isinstance(moment, Deflected | LowestPoint | TurnedThrough)
    return known or (words.released and isinstance(moment, Stopped))

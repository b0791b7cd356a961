"""Reasons why an event that has not occurred by the end of a motion is known never to occur."""

import numpy as np

from sim2reason.dsl.constancy import changing
from sim2reason.quantities.subjects.pairs import members
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.moments.parts.passage import Threshold
from sim2reason.questions.moments.parts.reached import Reached
from sim2reason.questions.recurrence import ends_at_rest, first_return, flies_off, is_autonomous
from sim2reason.simulation.trace import Trace, ending

EVENTLESS = 1e3  # times the time of the last event: where nothing bends, nothing new comes after it
PLACES = ("displacement", "extension", "spring length", "deflection", "angle turned")  # given by coordinates alone
BOTH = 2  # times that a motion turns back: once on each side
TURNED = 1e-3  # of the greatest excursion: what comes back has not turned all the way round


def why_never(moment: Moment | None, trace: Trace) -> str:
    """Return a clause explaining why a moment, or the repetition of a motion, never occurs; empty if it may yet occur.

    A motion whose description ends before the moment never reaches the moment.
    """
    unit = trace.mechanism.units.time
    until, last = f"{trace.stable_until:.6g} {unit}", f"{_last_change(trace):.6g} {unit}"
    if trace.cut:
        return f"it does not happen before {until}, where the description of the motion ends: {ending(trace)}"
    if moment is not None and moment.ahead is not None:
        return ""
    period = _period(trace)
    reasons = {
        "what moves turns back before it has moved so far": isinstance(moment, Moved) and moment.comes_later(trace),
        f"everything is at rest for good from {last} on": ends_at_rest(trace),
        f"the motion repeats itself every {period or 0.0:.6g} {unit}": period is not None
        and trace.stable_until > (getattr(moment, "number", 1) + 1) * period,
        "it has turned back on both sides, and has no energy to come any farther": confined(moment, trace),
        "what it is about flies off for ever": flies_away(moment, trace),
        f"it has not by {until}, and from {last} on no acceleration changes any more": not changing(trace.mechanism)
        and trace.stable_until > EVENTLESS * max(_last_change(trace), _own(trace)),
    }
    return next((f"it never happens: {reason}" for reason, holds in reasons.items() if holds), "")


def confined(moment: Moment | None, trace: Trace) -> bool:
    """Return whether a motion along one coordinate has turned back on both sides and so never reaches a place.

    A force that depends on that coordinate alone has a potential, and all other forces take energy away. At a turning
    point the energy equals the potential there, so that the motion never passes a turning point again.
    """
    mechanism = trace.mechanism
    placed = isinstance(moment, Threshold) or (isinstance(moment, Reached) and moment.target.quantity in PLACES)
    if not placed or len(mechanism.coordinates) != 1 or not is_autonomous(mechanism) or mechanism.meetings:
        return False
    turns = [event for event in trace.events if event.kind == "turn" and event.time <= trace.stable_until]
    return len(turns) >= BOTH and all(event.kind == "turn" for event in trace.events)


def flies_away(moment: Moment | None, trace: Trace) -> bool:
    """Return whether a moment never occurs because the bodies that take part in the moment fly off for ever.

    If only one of two moving bodies flies off, the other may still go round and overtake it again and again.
    """
    if moment is None or not moment.comes_round:
        return False
    named = {name for subject in moment.subjects for name in members(subject)}
    bodies = (body for body in trace.mechanism.bodies if body.coordinates and (not named or body.name in named))
    flying = [flies_off(trace, body.name) for body in bodies]
    return all(flying) if moment.subjects else any(flying)


def _last_change(trace: Trace) -> float:
    """Return the time of the last event, s; 0 if there is none."""
    return max((event.time for event in trace.events), default=0.0)


def _own(trace: Trace) -> float:
    """Return the time, s, in which the initial accelerations double the initial velocities, at least 1 s."""
    start = trace.at(0.0)
    speeds, rates = np.abs(start.v[0]).max(initial=0.0), np.abs(start.a[0]).max(initial=0.0)
    return float(max(1.0, speeds / rates if rates else 0.0))


def _period(trace: Trace) -> float | None:
    """Return the period of a motion, s; None if there is none, or if a hinge makes whole turns in a period."""
    period = first_return(trace)
    if period is None:
        return None
    gone = np.abs(trace.at(period).q[0] - trace.at(0.0).q[0])
    far = np.abs(trace.scan.q - trace.at(0.0).q).max(axis=0)
    return period if bool((gone <= TURNED * far).all()) else None

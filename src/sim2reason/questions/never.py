"""Why what has not come by the end of a motion is known never to come."""

import numpy as np

from sim2reason.dsl.constancy import changing
from sim2reason.quantities.subjects.pairs import members
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.parts.passage import Threshold
from sim2reason.questions.moments.parts.reached import Reached
from sim2reason.questions.recurrence import ends_at_rest, first_return, flies_off, is_autonomous
from sim2reason.simulation.trace import Trace, ending

EVENTLESS = 1e3  # times the time of the last event: where nothing bends, nothing new comes after it
PLACES = ("displacement", "extension", "spring length", "deflection", "angle turned")  # given by coordinates alone
BOTH = 2  # times that a motion turns back: once on each side
TURNED = 1e-3  # of the greatest excursion: what comes back has not turned all the way round


def why_never(moment: Moment | None, trace: Trace) -> str:
    """Why a moment, or the repetition of a motion, that has not come by the end of a motion never comes, in a clause.

    Empty if it may come yet. It comes in no motion whose description ends before it.
    """
    unit = trace.mechanism.units.time
    until, last = f"{trace.stable_until:.6g} {unit}", f"{_last_change(trace):.6g} {unit}"
    if trace.cut:
        return f"it does not happen before {until}, where the description of the motion ends: {ending(trace)}"
    if moment is not None and moment.ahead is not None:
        return ""
    period = _period(trace)
    reasons = {
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
    """Whether a place is never reached since a motion of one coordinate has turned back on both sides of its start.

    A force that hangs on that coordinate alone has a potential, and whatever else acts takes energy away: where it has
    turned back its energy was the potential there, so that it never passes that place again.
    """
    mechanism = trace.mechanism
    placed = isinstance(moment, Threshold) or (isinstance(moment, Reached) and moment.target.quantity in PLACES)
    if not placed or len(mechanism.coordinates) != 1 or not is_autonomous(mechanism) or mechanism.meetings:
        return False
    turns = [event for event in trace.events if event.kind == "turn" and event.time <= trace.stable_until]
    return len(turns) >= BOTH and all(event.kind == "turn" for event in trace.events)


def flies_away(moment: Moment | None, trace: Trace) -> bool:
    """Whether a moment never comes since bodies that it is about fly off for ever.

    Of two that move, while one flies off the other may go round, and overtake it again and again.
    """
    if moment is None or not moment.comes_round:
        return False
    named = {name for subject in moment.subjects for name in members(subject)}
    bodies = (body for body in trace.mechanism.bodies if body.coordinates and (not named or body.name in named))
    flying = [flies_off(trace, body.name) for body in bodies]
    return all(flying) if moment.subjects else any(flying)


def _last_change(trace: Trace) -> float:
    """When the last event was, s; the start without any."""
    return max((event.time for event in trace.events), default=0.0)


def _own(trace: Trace) -> float:
    """How long the motion takes to show what it does where nothing happens: till velocities are doubled, or 1 s."""
    start = trace.at(0.0)
    speeds, rates = np.abs(start.v[0]).max(initial=0.0), np.abs(start.a[0]).max(initial=0.0)
    return float(max(1.0, speeds / rates if rates else 0.0))


def _period(trace: Trace) -> float | None:
    """After which all is where it was, s; not where a hinge has gone all the way round, which counts its turns."""
    period = first_return(trace)
    if period is None:
        return None
    gone = np.abs(trace.at(period).q[0] - trace.at(0.0).q[0])
    far = np.abs(trace.scan.q - trace.at(0.0).q).max(axis=0)
    return period if bool((gone <= TURNED * far).all()) else None

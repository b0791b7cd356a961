"""What is worth asking about a motion."""

from collections.abc import Callable, Iterable
from math import hypot, inf

import numpy as np

from sim2reason.questions.targets import Target
from sim2reason.scenes.dsl.constancy import bending, changing
from sim2reason.scenes.dsl.frames import start
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.quantities import QUANTITIES, Quantity
from sim2reason.simulation.trace import AT_ONCE, Trace

CROSSINGS = "enter", "exit"
CLEAR = 1e-3  # of the duration: how far a time stays away from events
SPRUNG = 2  # bodies on springs, at most, whose oscillation along a line a short formula describes
LEVEL = 1e-9  # of an axle: the level part of its direction, with less of which it is upright
STILL, ROUNDING = 1e-7, 1e-9  # of the greatest speed of its own, and of anything's: what is slower stands still


def pick(
    targets: Iterable[Target], rng: np.random.Generator, worth: Callable[[Target], bool] = lambda _: True
) -> Target | None:
    """A target that is worth asking, by the weight of its quantity, which all its targets share; None without any."""
    left = [target for target in targets if QUANTITIES[target.quantity].drawn_by_recipes]
    while left:
        names = [target.quantity for target in left]
        weights = np.array([t.share * QUANTITIES[t.quantity].weight / names.count(t.quantity) for t in left])
        chosen = left.pop(int(rng.choice(len(left), p=weights / weights.sum())))
        if worth(chosen):
            return chosen
    return None


def apart(time: float, trace: Trace) -> bool:
    """Whether a time stays away from every event that changes anything, so that before and after can't be mistaken."""
    clear = CLEAR * float(trace.state.times[-1])
    return all(abs(time - event.time) > clear for event in trace.events if event.changes_motion)


def still(trace: Trace, speeds: Array) -> float:
    """Return the speed below which something with these `speeds` (n,) at the instants of the scan counts as at rest.

    What never moves has speeds, too, as rounding leaves them.
    """
    fastest = float(np.abs(trace.scan.v).max(initial=0.0))
    return max(STILL * float(np.abs(speeds).max(initial=0.0)), ROUNDING * fastest)


def bears_from(trace: Trace) -> float:
    """From when on all that a text gives can have a bearing, s; infinite if it never has.

    Where bodies can collide, that is when all have that ever do; where fuel burns, the end of it; where a field has
    borders, the first crossing of one; where what swings on a string leaves its circle, when the string goes slack.
    """
    mechanism, waits = trace.mechanism, [burn.until for burn in trace.mechanism.burns]
    if mechanism.meetings:
        first: dict[str, float] = {}
        for event in trace.events:
            if event.kind == "collision":
                first = dict.fromkeys(event.subjects, event.time) | first
        waits += first.values()
    if any(force.region is not None for force in mechanism.forces):
        waits.append(next((event.time for event in trace.events if event.kind in CROSSINGS), inf))
    slack = next((event for event in trace.events if event.kind == "slack"), None)
    if slack is not None and bending(mechanism.line[slack.subjects[0]], start(mechanism)):
        waits.append(slack.time)
    return max(waits, default=0.0)


def least(mechanism: Mechanism, quantity: Quantity) -> float:
    """The smallest answer of a quantity; less in proportion, of what grows with mass, where all bodies are light."""
    return quantity.least * min(1.0, max(body.mass for body in mechanism.bodies)) if quantity.heavy else quantity.least


def has_met(trace: Trace, time: float, *, just_after: bool = False) -> bool:
    """Whether, where bodies can collide, some have before a time, or `just_after` it; else collisions do not bear."""
    if not trace.mechanism.meetings:
        return True
    end = time * (1.0 + (AT_ONCE if just_after else -AT_ONCE))
    return any(event.kind == "collision" and event.time <= end for event in trace.events)


def has_formula_of_time(mechanism: Mechanism) -> bool:
    """Return whether a short formula tells where everything is at any time.

    That is so where accelerations are constant or depend on time or velocity alone, and where springs move one or two
    bodies along lines or level circles. Where forces depend on positions otherwise, turning points are worth asking
    about.
    """
    coordinates = mechanism.coordinates
    if mechanism.burns or mechanism.forces or not changing(mechanism):
        return True
    swings = any(one.kind == "hinge" and hypot(*one.axis[:2]) > LEVEL for one in coordinates)
    if len(coordinates) > SPRUNG or mechanism.attractions or swings:
        return False
    frames = start(mechanism)
    return not any(bending(line, frames) for line in mechanism.lines)


def only_falls(mechanism: Mechanism) -> bool:
    """Return whether nothing but weight acts, so that everything has the acceleration that the text gives it."""
    forces = (mechanism.lines, mechanism.contacts, mechanism.forces, mechanism.attractions, mechanism.burns)
    return not any(forces) and all(c.kind == "slide" for c in mechanism.coordinates)

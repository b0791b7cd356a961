"""Selection of what is worth asking: changing values, lasting values, and moments."""

from collections.abc import Callable, Iterable
from math import hypot, inf

import numpy as np

from sim2reason.questions.moments import Moment
from sim2reason.questions.query import Target
from sim2reason.questions.study import Study
from sim2reason.scenes.dsl.constancy import bending, changing
from sim2reason.scenes.dsl.frames import start
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.quantities import QUANTITIES, Quantity
from sim2reason.simulation.trace import AT_ONCE, Event, Trace

CLEARLY = 0.05  # relative: what changes by less is paid at any moment
CONSTANT_RTOL = 1e-6  # relative: what changes by less does not change
ENDINGS = frozenset({"reach", "limit"})  # events of which texts say that they do not come
SHARES = np.array([0.07, 0.3, 0.6, 0.93])  # of a stretch between two events: where a value is looked at
SEVERAL = 2  # of those instants, of eight: a value that differs at one of them alone has settled
Values = Callable[[Array], Array]
"""A value at some instants, s: (n,) to (n,); NaN where there is none."""


def hangs_on(moment: Moment, trace: Trace, time: float, values: Values) -> bool:
    """Whether a value is clearly another one elsewhere between the events next to a moment, or jumps at the moment.

    Else whoever asks for it at another moment gives the same answer, so that the moment decorates the question.
    """
    here = float(values(np.array([moment.side(time)]))[0])
    before, after = _between(trace, time)
    others = np.concatenate([before + SHARES * (time - before), time + SHARES * (after - time)])
    sides = np.array([np.nextafter(time, 0.0), time] if moment.event else [])

    def differing(instants: Array) -> int:
        return int(np.sum(np.abs(values(instants) - here) > CLEARLY * abs(here)))

    ends = [0, len(others) - 1]  # which most often differ: the rest need not be looked at then
    found = differing(others[ends])
    if found < SEVERAL:
        found += differing(np.delete(others, ends))
    return found >= SEVERAL or (len(sides) > 0 and differing(sides) > 0)


def lasts(target: Target, trace: Trace) -> bool:
    """Return whether a quantity never changes: not while the motion is described, nor, as nothing stops, after that.

    What rubs against something and does not begin at rest may stop later on.
    """
    if QUANTITIES[target.quantity].timeless:
        return True
    mechanism = trace.mechanism
    still = not any(coordinate.speed for coordinate in mechanism.coordinates)
    rubs = any(0.0 < face.friction < inf for face in mechanism.faces)
    if any(map(_changes_something, trace.events)) or (rubs and not still):
        return False
    values = target.values(trace.sample(np.append(0.0, SHARES * trace.stable_until)))
    return bool(np.all(np.abs(values - values[0]) <= CONSTANT_RTOL * abs(values[0])))


def _between(trace: Trace, time: float) -> tuple[float, float]:
    """Return the events next to a time, or where the motion that is described begins and ends, s."""
    times = [event.time for event in trace.events if _changes_something(event)]
    before = max((found for found in times if found < time * (1.0 - AT_ONCE)), default=0.0)
    after = min((found for found in times if found > time * (1.0 + AT_ONCE)), default=trace.stable_until)
    return before, max(time, min(after, trace.stable_until))


def _changes_something(event: Event) -> bool:
    return event.changes_motion and event.kind not in ENDINGS


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


DISTINCT_RTOL = 2e-3  # relative: what rounds to the same three digits
JUMP = 1e-5  # relative: what differs by more on both sides of an event jumps there


def changed(study: Study, moment: Moment) -> Callable[[Target], bool]:
    """Return a predicate: is the value of a quantity at a moment worth asking for?

    It must be neither zero nor stated, and differ from the initial value and from that at other moments. At an event
    whose words name no side of it, it must not jump either.
    """
    time, trace = study.time(moment), study.trace
    if time is None:
        return lambda _: False
    start, here = trace.at(0.0), trace.at(moment.side(time))
    sides = [trace.at(float(np.nextafter(time, 0.0)))] if moment.event and moment.sided is None else []

    def differs(target: Target) -> bool:
        value = target.value(here)
        if not is_something(value, target, study):
            return False
        known = [target.value(start), *(number for number, unit in moment.stated if unit == target.unit)]
        if any(
            abs(value - said) <= DISTINCT_RTOL * abs(value) for said in (*known, *(-number for number in known[1:]))
        ):
            return False
        if any(abs(value - target.value(side)) > JUMP * abs(value) for side in sides):
            return False
        return hangs_on(moment, trace, time, lambda times: target.values(trace.sample(times)))

    return differs


def is_something(value: float, target: Target, study: Study) -> bool:
    """Return whether a value is large enough to be asked for; negative ones never are."""
    return value > least(study.mechanism, QUANTITIES[target.quantity])  # NaN is no more

"""Whether a value hangs on the moment at which it is asked for, or lasts."""

from collections.abc import Callable
from math import inf

import numpy as np

from sim2reason.questions.moments import Moment
from sim2reason.questions.targets import Target
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.trace import AT_ONCE, Event, Trace

CLEARLY = 0.05  # relative: what changes by less is paid at any moment
SAME = 1e-6  # relative: what changes by less does not change
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
    return bool(np.all(np.abs(values - values[0]) <= SAME * abs(values[0])))


def _between(trace: Trace, time: float) -> tuple[float, float]:
    """Return the events next to a time, or where the motion that is described begins and ends, s."""
    times = [event.time for event in trace.events if _changes_something(event)]
    before = max((found for found in times if found < time * (1.0 - AT_ONCE)), default=0.0)
    after = min((found for found in times if found > time * (1.0 + AT_ONCE)), default=trace.stable_until)
    return before, max(time, min(after, trace.stable_until))


def _changes_something(event: Event) -> bool:
    return event.changes_motion and event.kind not in ENDINGS

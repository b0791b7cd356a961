"""Tests of whether the value of a quantity at a moment is worth asking for."""

from collections.abc import Callable

import numpy as np

from sim2reason.questions.choices import least
from sim2reason.questions.constancy import hangs_on
from sim2reason.questions.moments import Moment
from sim2reason.questions.study import Study
from sim2reason.questions.targets import Target
from sim2reason.simulation.quantities import QUANTITIES

SAME = 2e-3  # relative: what rounds to the same three digits
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
        if any(abs(value - said) <= SAME * abs(value) for said in (*known, *(-number for number in known[1:]))):
            return False
        if any(abs(value - target.value(side)) > JUMP * abs(value) for side in sides):
            return False
        return hangs_on(moment, trace, time, lambda times: target.values(trace.sample(times)))

    return differs


def is_something(value: float, target: Target, study: Study) -> bool:
    """Return whether a value is large enough to be asked for; negative ones never are."""
    return value > least(study.mechanism, QUANTITIES[target.quantity])  # NaN is no more

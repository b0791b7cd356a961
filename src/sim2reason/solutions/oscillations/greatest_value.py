"""The greatest value that is asked for: of what, and when the motion takes it."""

import numpy as np

from sim2reason.quantities.kinematics import Velocity
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.functionals.parts.extreme import Extreme
from sim2reason.questions.kinds.parts.stretch_kind import StretchQuery
from sim2reason.questions.targets import Target
from sim2reason.solutions.setting import Setting

FINE, LEVELS = 64, 4  # parts of what is searched for a greatest value, and how often


def greatest_target(setting: Setting) -> Target | None:
    """The quantity whose greatest value is asked for."""
    query = setting.query
    if not isinstance(query, StretchQuery):
        return None
    held = FUNCTIONALS[query.functional]
    return Target(held.quantity.name, query.name, held.sense) if isinstance(held, Extreme) else None


def time_of_greatest(setting: Setting) -> float:
    """When the motion takes the greatest value that is asked for, s, near enough for Newton's method."""
    query, trace, low, high = setting.query, setting.study.trace, 0.0, setting.time
    assert isinstance(query, StretchQuery)
    functional, best = FUNCTIONALS[query.functional], high
    assert isinstance(functional, Extreme)
    for level in range(LEVELS):
        times = np.linspace(low, high, FINE * (8 if level == 0 else 1) + 1)
        best = float(times[int(np.argmax(functional.height(trace.sample(times), query.name)))])
        width = 2.0 * (times[1] - times[0])
        low, high = max(0.0, best - width), min(setting.time, best + width)
    return best


def is_slow_at_greatest(setting: Setting, body: str) -> bool:
    """Return whether a body is slower than half its greatest speed when the motion takes the greatest value."""
    times = np.append(np.linspace(0.0, setting.time, FINE * LEVELS), time_of_greatest(setting))
    *speeds, then = np.linalg.norm(Velocity.evaluate(setting.study.trace.sample(times), body), axis=1)
    return bool(then < 0.5 * max(speeds))

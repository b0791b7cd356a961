"""What a question takes for granted about the stretch of a motion that follows the moment it asks about."""

import numpy as np

from sim2reason.quantities.kinematics import Velocity
from sim2reason.questions.ordinary.presumptions import EVEN, STEADY, Case, named

SOON, LATE = 0.01, 0.9  # of the stretch up to the next event, or to the end of the known motion
UP = {"up": 1.0, "down": -1.0}


def goes_then(case: Case, way: str) -> bool:
    """Return whether a body goes up, or down, after an instant, while what is asked for keeps its value."""
    name, trace, target = named(case.who, case.words), case.followed.study.trace, case.query.target
    began = float(np.nextafter(case.then, np.inf))
    later = [event.time for event in trace.events if event.time > began * (1.0 + EVEN) and event.changes_motion]
    end = min([*later, trace.stable_until])
    if not name or target is None or end <= began:
        return False
    states = [trace.at(began + share * (end - began)) for share in (SOON, LATE)]
    moves = all(float(Velocity.evaluate(state, name)[0, 2]) * UP[way] > 0.0 for state in states)
    answer = case.followed.answer or 0.0
    return moves and all(bool(np.isclose(target.value(state), answer, rtol=STEADY, atol=0.0)) for state in states)

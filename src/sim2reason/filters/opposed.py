"""Drops a scene of strings and pulleys in which every body accelerates downwards, so that nothing is lifted."""

from collections.abc import Iterator

from sim2reason.dsl.constancy import changing
from sim2reason.filters import FILTERS, Candidate, SceneFilter
from sim2reason.quantities.kinematics import Acceleration
from sim2reason.questions import Study

STILL = 1e-6  # m/s²
SEVERAL = 2  # parts of a scene


class Opposed(SceneFilter):
    """Just after the start no weight rises, and those of several entities descend, so that none works against another.

    A row of blocks that runs down one slope is of one entity. Springs and what swings are not looked at.
    """

    def scene_reason(self, study: Study) -> str:
        """Return a reason if no body accelerates upwards just after the start."""
        if not study.mechanism.strings or changing(study.mechanism):
            return ""
        up = _accelerations(study)
        down = {name.partition(".")[0] for name, upwards in up.items() if upwards < -STILL}
        rises = any(upwards > STILL for upwards in up.values())
        return "all that has a weight runs down together" if len(down) >= SEVERAL and not rises else ""

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield the vertical direction in which each accelerated body initially accelerates."""
        moving = {name: up for name, up in _accelerations(candidate.study).items() if abs(up) > STILL}
        yield from (f"{name} is accelerated {'up' if up > 0.0 else 'down'}" for name, up in moving.items())


def _accelerations(study: Study) -> dict[str, float]:
    """Return the vertical accelerations of all bodies with mass just after the start, in m/s², positive upwards."""
    state = study.trace.at(0.0)
    heavy = [body.name for body in state.mechanism.bodies if body.mass > 0.0]
    return {name: float(Acceleration.evaluate(state, name)[0, 2]) for name in heavy}


FILTERS.add("opposed", Opposed())

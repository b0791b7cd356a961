"""Drops a question whose answer hangs on digits that the text does not give."""

from math import sqrt

import numpy as np

from sim2reason.dsl.model import Parameter
from sim2reason.dsl.scene import Scene
from sim2reason.errors import SceneError, SimulationError, UnsupportedError
from sim2reason.filters import FILTERS, Candidate
from sim2reason.simulation.certify import RECORDED
from sim2reason.simulation.trace import ENGINES, Trace

SHIFT = 1e-3  # relative
WORST = 20.0  # the condition number κ = √Σ(Δa/a)² / SHIFT


class Precision:
    """A small shift of the stated numbers moves the answer too far, or changes the order of events: chaos."""

    needs_witness = False
    order = 2

    def reason(self, candidate: Candidate) -> str:
        """Shift each stated number by one part in a thousand and solve again."""
        answer, ask = candidate.question.answer, candidate.question.ask
        if answer == 0.0:
            return "no number of digits is relative to zero"
        time = ask.time(candidate.trace)
        before = _story(candidate.trace, time)
        total = 0.0
        for parameter in candidate.scene.parameters:
            if not shiftable(candidate.scene, parameter):
                continue
            shifted = solved(candidate.scene, parameter, candidate.trace)
            when = ask.time(shifted) if shifted is not None else None
            new = ask.answer_at(when, shifted) if shifted is not None else None
            if shifted is None or new is None or _story(shifted, when) != before:
                return f"a small shift of {parameter.path} changes the order of events"
            total += ((new - answer) / answer) ** 2
        condition = sqrt(total) / SHIFT
        return f"the condition number is {condition:.1f}" if not condition <= WORST else ""


def shiftable(scene: Scene, parameter: Parameter) -> bool:
    """Whether a number is said in the text as a number; zeros and what a word tells are not."""
    if parameter.hidden or not parameter.value:
        return False
    owner, _, name = parameter.path.rpartition(".")
    body = scene.bodies.get(owner)
    return not (body is not None and body.told_by_word(name))


def solved(scene: Scene, parameter: Parameter, trace: Trace) -> Trace | None:
    """The motion with one number shifted, or None if there is none; shifted down where up is not valid."""
    times = np.array([0.0, float(trace.state.times[-1])])
    for factor in (1.0 + SHIFT, 1.0 - SHIFT):
        try:
            shifted = scene.having(parameter.path, (parameter.value or 0.0) * factor)
        except (SceneError, ValueError):
            continue
        try:
            return ENGINES[RECORDED](shifted.mechanism, times)
        except (SceneError, SimulationError, UnsupportedError):
            return None
    return None


def _story(trace: Trace, time: float | None) -> list[tuple[str, tuple[str, ...]]]:
    """What happens before a moment, in order; turns change nothing and are left out."""
    end = time if time is not None else trace.stable_until
    return [(e.kind, e.subjects) for e in trace.events if e.time < end * (1.0 - 1e-9) and e.kind != "turn"]


FILTERS.add("precision", Precision())

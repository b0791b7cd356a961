"""Drops a question whose answer hangs on digits that the text does not give."""

from math import sqrt

from sim2reason.dsl.model import Parameter
from sim2reason.dsl.scene import Scene
from sim2reason.errors import SceneError
from sim2reason.filters import FILTERS, Candidate
from sim2reason.questions import KINDS, Study
from sim2reason.simulation.trace import Trace

SHIFT = 1e-3  # relative
BEYOND = 1.1  # times the moment that is asked about: what comes later than that has shifted too far
WORST = 20.0  # the condition number κ = √Σ(Δa/a)² / SHIFT


class Precision:
    """A small shift of the stated numbers moves the answer too far, or changes the order of events: chaos."""

    needs_witness = False
    order = 2

    def reason(self, candidate: Candidate) -> str:
        """Shift each stated number by one part in a thousand and solve again."""
        answer, query, study = candidate.question.answer, candidate.question.query, candidate.study
        if answer == 0.0:
            return "no number of digits is relative to zero"
        kind = KINDS[query.kind]
        time = kind.time(query, study)
        before = _story(study.trace, time)
        until = None if time is None else BEYOND * time
        total = 0.0
        for parameter in study.scene.parameters:
            if not shiftable(study.scene, parameter):
                continue
            other = shifted(study, parameter, until)
            new = kind.answer(query, other) if other is not None else None
            if other is None or new is None or _story(other.trace, kind.time(query, other)) != before:
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


def shifted(study: Study, parameter: Parameter, until: float | None = None) -> Study | None:
    """The motion with one number shifted, to a time, or None if there is none; shifted down where up is not valid."""
    for factor in (1.0 + SHIFT, 1.0 - SHIFT):
        try:
            scene = study.scene.having(parameter.path, (parameter.value or 0.0) * factor)
        except (SceneError, ValueError):
            continue
        return study.variant(scene, until)
    return None


def _story(trace: Trace, time: float | None) -> list[tuple[str, tuple[str, ...]]]:
    """What happens before a moment, in order; turns change nothing and are left out."""
    end = time if time is not None else trace.stable_until
    return [(e.kind, e.subjects) for e in trace.events if e.time < end * (1.0 - 1e-9) and e.kind != "turn"]


FILTERS.add("precision", Precision())
